#!/usr/bin/env python3
"""Makes the pictures of the sample engine beside it: bricks.png, weave.png, mosaic.png, each repeating without a seam.

The colours below are those of a screen; matc takes the bytes of a picture for linear light, so linear ones are written."""
import os
import struct
import zlib


def noise(x, y, seed=0):
    """A number in [-1, 1) for a pixel, always the same."""
    h = (x * 374761393 + y * 668265263 + seed * 2246822519) & 0xFFFFFFFF
    h = ((h ^ h >> 13) * 1274126177) & 0xFFFFFFFF
    return ((h ^ h >> 16) & 255) / 128 - 1


def bricks(x, y):
    row = y // 16
    x = (x + 16 * (row % 2)) % 64
    if y % 16 < 2 or x % 32 < 2:
        return [70 + 8 * noise(x, y)] * 3
    tone = 1 + 0.18 * noise(x // 32, row) + 0.08 * noise(x, y)
    return [c * tone for c in (118, 44, 30)]


def weave(x, y):
    over = (x // 8 + y // 8) % 2
    along, across = (x, y) if over else (y, x)
    shade = 0.55 + 0.45 * (1 - abs(across % 8 - 3.5) / 4) + 0.06 * noise(along, across, 1)
    return [c * shade for c in ((96, 84, 120) if over else (62, 66, 108))]


def mosaic(x, y):
    if x % 16 < 1 or y % 16 < 1:
        return [24, 22, 20]
    colors = ((20, 70, 92), (206, 190, 150), (168, 56, 20), (30, 96, 70))
    color = colors[int(2 + 2 * noise(x // 16, y // 16, 3)) % 4]
    return [c + 5 * noise(x, y, 2) for c in color]


def linear(color):
    return bytes(round(255 * (max(0, min(255, c)) / 255) ** 2.2) for c in color)


def chunk(kind, data):
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))


def write(pixel, size=64):
    rows = b''.join(b'\0' + b''.join(linear(pixel(x, y)) for x in range(size)) for y in range(size))
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), pixel.__name__ + '.png')
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', size, size, 8, 2, 0, 0, 0))
                   + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b''))


for picture in (bricks, weave, mosaic):
    write(picture)
