#!/usr/bin/env python3
"""Makes tiles.png: 64 x 64 pixels of glazed tiles that repeat without a seam. Red is also their height, for BumpMap."""
import os
import struct
import zlib

SIZE, TILE, GROUT = 64, 32, 2
GROUT_COLOR = (9, 8, 7)
TILE_COLORS = ((30, 74, 92), (208, 194, 160), (208, 194, 160), (170, 48, 14))


def speckle(x, y):
    """A number in [-1, 1) for a pixel, always the same."""
    h = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    h = ((h ^ h >> 13) * 1274126177) & 0xFFFFFFFF
    return ((h ^ h >> 16) & 255) / 128 - 1


def pixel(x, y):
    inside = min(x % TILE, y % TILE, TILE - 1 - x % TILE, TILE - 1 - y % TILE) - GROUT + 1  # pixels from the grout
    weight = max(0, min(1, inside / 3))
    tile = TILE_COLORS[x // TILE + 2 * (y // TILE)]
    glaze = 5 * weight * speckle(x, y)
    return bytes(round(max(0, min(255, g + weight * (t - g) + glaze))) for g, t in zip(GROUT_COLOR, tile))


def chunk(kind, data):
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))


rows = b''.join(b'\0' + b''.join(pixel(x, y) for x in range(SIZE)) for y in range(SIZE))
png = (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', SIZE, SIZE, 8, 2, 0, 0, 0))
       + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b''))
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'tiles.png'), 'wb') as file:
    file.write(png)
