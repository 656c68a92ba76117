#!/usr/bin/env python3
"""Writes the meshes of these scenes into this folder: vessels, a car's shell, a landscape. OBJ has y up, so (x, y, z) of a scene is (x, z, -y) here."""
import math

AROUND = 40


def write(name, vertices, faces):
    with open(name, "w") as out:
        for x, y, z in vertices:
            out.write(f"v {x:.3f} {z:.3f} {-y:.3f}\n")
        for face in faces:
            out.write("f " + " ".join(str(i + 1) for i in face) + "\n")


def grid(rows, columns, closed):
    """Quads between rows of points, counterclockwise where rows go up and columns to the left; `closed`: the last column is beside the first."""
    for row in range(rows - 1):
        for i in range(columns if closed else columns - 1):
            k = (i + 1) % columns
            yield (row * columns + i, row * columns + k, (row + 1) * columns + k, (row + 1) * columns + i)


def spline(points, count):
    """Through all points, `count` steps between two: Catmull and Rom's cubic."""
    result = []
    for i in range(len(points) - 1):
        p = [points[max(0, min(len(points) - 1, i + k))] for k in (-1, 0, 1, 2)]
        for n in range(count):
            t = n / count
            result.append(tuple((2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t ** 3) / 2
                                for a, b, c, d in zip(*p)))
    return result + [points[-1]]


def lathe(name, profile):
    """Of (radius, height), from the middle of the foot around the outside to the middle inside."""
    angles = [2 * math.pi * i / AROUND for i in range(AROUND)]
    write(name, [(r * math.cos(a), r * math.sin(a), h) for r, h in profile for a in angles], grid(len(profile), AROUND, True))


def loft(name, sections):
    """Of (x, half width, bottom, top) from the rear to the front: rounded rectangles across x, closed at both ends."""
    vertices = []
    for x, half, bottom, top in sections:
        for i in range(AROUND):
            c, s = math.cos(2 * math.pi * i / AROUND), math.sin(2 * math.pi * i / AROUND)
            vertices.append((x, half * math.copysign(abs(c) ** 0.5, c), (top + bottom) / 2 + (top - bottom) / 2 * math.copysign(abs(s) ** 0.5, s)))
    write(name, vertices, grid(len(sections), AROUND, True))


def noise(x, y):
    """Values of a lattice by a hash, in [-1, 1], cubic between."""
    def corner(i, j):
        h = (i * 374761393 + j * 668265263) & 0xFFFFFFFF
        h = (h ^ h >> 13) * 1274126177 & 0xFFFFFFFF
        return (h ^ h >> 16) / 0x7FFFFFFF - 1
    i, j = math.floor(x), math.floor(y)
    u, v = (t * t * (3 - 2 * t) for t in (x - i, y - j))
    return sum(corner(i + a, j + b) * (u if a else 1 - u) * (v if b else 1 - v) for a in (0, 1) for b in (0, 1))


def height(x, y):
    """Ridges that rise towards the back, and a lake before them."""
    ridge = sum(2 ** -k * (1 - abs(noise(0.33 * 2 ** k * x + 7.3 * k, 0.33 * 2 ** k * y - 3.1 * k))) for k in range(5)) - 1.05
    lake = math.exp(-((x - 0.6) ** 2 + (y + 2.6) ** 2) / 5)
    return ridge * (0.6 + 2.2 / (1 + math.exp(-1.2 * (y - 1.8)))) + 0.16 - 1.1 * lake


def landscape(steps, size):
    points = [(size * (i / (steps - 1) - 0.5), size * (k / (steps - 1) - 0.5)) for k in range(steps) for i in range(steps)]
    vertices = [(x, y, height(x, y)) for x, y in points]
    faces = list(grid(steps, steps, False))
    write("landscape.obj", vertices, faces)
    # where trees grow: above the water, below the rocks, and not too steep
    def grows(face):
        z = [vertices[i][2] for i in face]
        return min(z) > 0.05 and max(z) < 0.95 and max(z) - min(z) < 0.75 * size / (steps - 1)
    chosen = [face for face in faces if grows(face)]
    used = sorted({i for face in chosen for i in face})
    place = {i: n for n, i in enumerate(used)}
    write("meadow.obj", [vertices[i] for i in used], [[place[i] for i in face] for face in chosen])


lathe("goblet.obj",
      [(0.001, 0), (0.4, 0), (0.4, 0.02), (0.12, 0.06)]
      + spline([(0.05, 0.14), (0.04, 0.5), (0.06, 0.72), (0.32, 0.9), (0.44, 1.2), (0.38, 1.7)], 4)
      + spline([(0.365, 1.7), (0.42, 1.2), (0.3, 0.93), (0.001, 0.83)], 4))
lathe("tumbler.obj", [(0.001, 0), (0.36, 0), (0.38, 0.02), (0.44, 1.05), (0.42, 1.06), (0.35, 0.1), (0.33, 0.08), (0.001, 0.07)])
lathe("bottle.obj",
      [(0.001, 0), (0.44, 0)]
      + spline([(0.47, 0.04), (0.48, 0.6), (0.48, 1.35), (0.34, 1.75), (0.14, 2.05), (0.13, 2.55)], 4)
      + [(0.16, 2.57), (0.16, 2.66), (0.1, 2.66)]
      + spline([(0.1, 2.1), (0.3, 1.72), (0.44, 1.33), (0.44, 0.1)], 4) + [(0.001, 0.08)])
loft("shell.obj", spline([(-2.2, 0.01, 0.55, 0.6), (-2.18, 0.6, 0.42, 0.78), (-2.05, 0.82, 0.32, 0.9), (-1.4, 0.92, 0.24, 0.95),
                          (-0.4, 0.94, 0.2, 0.93), (0.7, 0.93, 0.2, 0.88), (1.5, 0.88, 0.24, 0.78), (2.05, 0.74, 0.3, 0.66), (2.2, 0.5, 0.36, 0.58),
                          (2.23, 0.01, 0.45, 0.48)], 4))
loft("cabin.obj", spline([(-1.75, 0.01, 0.8, 0.84), (-1.7, 0.5, 0.75, 0.9), (-1.2, 0.7, 0.75, 1.18), (-0.4, 0.72, 0.75, 1.34), (0.2, 0.68, 0.75, 1.28),
                          (0.8, 0.6, 0.75, 0.98), (1.1, 0.4, 0.75, 0.84), (1.15, 0.01, 0.78, 0.8)], 4))
landscape(72, 12)
