#!/usr/bin/env python3
"""Writes vase.glb: a glazed vase with a painted band, a ring of brass and a wooden stand, as a glTF 2.0 file that holds all it needs: triangles, a PNG
for the glaze's colour, colours of vertices for the wood. glTF has y up."""
import json
import math
import os
import struct
import zlib

AROUND = 40
# radius and height of the vase, from the inside of its mouth down its outside
PROFILE = ((0.20, 1.62), (0.235, 1.66), (0.27, 1.64), (0.24, 1.5), (0.25, 1.36), (0.4, 1.12), (0.52, 0.86), (0.52, 0.62), (0.42, 0.36), (0.3, 0.16), (0.32, 0.08))
RING = [(0.262 + 0.03 * math.cos(a), 1.43 + 0.03 * math.sin(a)) for a in (math.pi / 2 - k * math.pi / 6 for k in range(13))]
STAND = ((0.0, 0.08), (0.5, 0.08), (0.54, 0.06), (0.54, 0.0), (0.0, 0.0))
SIZE = 128


def smooth(points, count):
    """Catmull and Rom's cubic through all points, `count` steps between two."""
    for i in range(len(points) - 1):
        p = [points[max(0, min(len(points) - 1, i + k))] for k in (-1, 0, 1, 2)]
        for n in range(count):
            t = n / count
            yield tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(*p))
    yield points[-1]


def lathe(profile):
    """Positions, normals, coordinates and triangles of a profile that turns about y; the surface is to the left of who walks along it downwards, outside."""
    rows = list(profile)
    positions, normals, places, triangles = [], [], [], []
    for r, (radius, height) in enumerate(rows):
        before, after = rows[max(r - 1, 0)], rows[min(r + 1, len(rows) - 1)]
        along = (after[0] - before[0], after[1] - before[1])
        length = math.hypot(*along) or 1
        for k in range(AROUND + 1):
            a = 2 * math.pi * k / AROUND
            positions.append((radius * math.sin(a), height, radius * math.cos(a)))
            normals.append((-along[1] / length * math.sin(a), along[0] / length, -along[1] / length * math.cos(a)))
            places.append((k / AROUND, r / (len(rows) - 1)))
    for r in range(len(rows) - 1):
        for k in range(AROUND):
            a, b = r * (AROUND + 1) + k, (r + 1) * (AROUND + 1) + k
            triangles += [a, b, b + 1, a, b + 1, a + 1]
    return positions, normals, places, triangles


def glaze(x, y):
    """A pixel of the glaze: celadon, and a band of blue waves between lines; row 0 is the mouth."""
    u, v = x / SIZE, y / SIZE
    slope = 0.045 * 2 * math.pi * 5 * math.cos(2 * math.pi * 5 * u)
    lines = ((v - 0.56 - 0.045 * math.sin(2 * math.pi * 5 * u)) / math.hypot(1, slope), 0.02), (v - 0.46, 0.01), (v - 0.67, 0.01)
    blue = max(min(1, max(0, 0.5 + (width - abs(off)) * SIZE)) for off, width in lines)
    shade = 1 - 0.25 * max(0, v - 0.8) / 0.2
    return bytes(round(shade * (a + (b - a) * blue)) for a, b in zip((176, 201, 178), (24, 52, 120)))


def png():
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = b''.join(b'\0' + b''.join(glaze(x, y) for x in range(SIZE)) for y in range(SIZE))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', SIZE, SIZE, 8, 2, 0, 0, 0)) + chunk(b'IDAT', zlib.compress(rows, 9))
            + chunk(b'IEND', b''))


binary, views, accessors, primitives = b'', [], [], []


def view(data):
    global binary
    binary += bytes(-len(binary) % 4)
    views.append({'buffer': 0, 'byteOffset': len(binary), 'byteLength': len(data)})
    binary += data
    return len(views) - 1


def accessor(rows, kind, code='f', component=5126):
    flat = [x for row in rows for x in row]
    made = {'bufferView': view(struct.pack(f'<{len(flat)}{code}', *flat)), 'componentType': component, 'count': len(rows), 'type': kind}
    if kind == 'VEC3':
        made.update(min=[min(c) for c in zip(*rows)], max=[max(c) for c in zip(*rows)])
    accessors.append(made)
    return len(accessors) - 1


def primitive(profile, material, colors=None):
    positions, normals, places, triangles = lathe(profile)
    made = {'attributes': {'POSITION': accessor(positions, 'VEC3'), 'NORMAL': accessor(normals, 'VEC3'), 'TEXCOORD_0': accessor(places, 'VEC2')},
            'indices': accessor([(i,) for i in triangles], 'SCALAR', 'H', 5123), 'material': material}
    if colors:
        made['attributes']['COLOR_0'] = accessor([colors(p) for p in positions], 'VEC4')
    primitives.append(made)


def grain(p):
    ring = 0.5 + 0.5 * math.sin(40 * p[0] + 3 * math.sin(5 * p[2]))
    return (0.16 + 0.14 * ring, 0.075 + 0.07 * ring, 0.03 + 0.03 * ring, 1)


primitive(list(smooth(PROFILE, 3)), 0)
primitive(RING, 1)
primitive(STAND, 2, grain)
picture = view(png())
document = {
    'asset': {'version': '2.0', 'generator': 'vase.py'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}], 'meshes': [{'primitives': primitives}],
    'materials': [
        {'name': 'Glaze', 'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}, 'metallicFactor': 0, 'roughnessFactor': 0.5},
         'extensions': {'KHR_materials_clearcoat': {'clearcoatFactor': 1, 'clearcoatRoughnessFactor': 0.1}}},
        {'name': 'Brass', 'pbrMetallicRoughness': {'baseColorFactor': [0.887, 0.789, 0.434, 1], 'roughnessFactor': 0.3}},
        {'name': 'Wood', 'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0.6}}],
    'extensionsUsed': ['KHR_materials_clearcoat'], 'textures': [{'source': 0}], 'images': [{'bufferView': picture, 'mimeType': 'image/png'}],
    'accessors': accessors, 'bufferViews': views, 'buffers': [{'byteLength': len(binary)}]}
text = json.dumps(document, separators=(',', ':')).encode()
text += b' ' * (-len(text) % 4)
binary += bytes(-len(binary) % 4)
chunks = struct.pack('<I4s', len(text), b'JSON') + text + struct.pack('<I4s', len(binary), b'BIN\0') + binary
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'vase.glb'), 'wb') as file:
    file.write(struct.pack('<4sII', b'glTF', 2, 12 + len(chunks)) + chunks)
