#!/usr/bin/env python3
"""Prints lights.yaml: 64 arms of 16 lamps each, turned around an axis. A lamp is a light and a small sphere; the spheres of an arm are one definition."""
import colorsys
import math

ARMS, LAMPS = 64, 16

HEAD = """\
# 1,024 coloured lamps without shadows, in 64 arms around marble and gold. Written by lights.py.
image: { width: 960, height: 600 }
camera: { camera: Perspective, position: [0, -7.6, 3.3], target: [0, -0.35, 0.3], angle: 33 }
toneMapping: { toneMapping: Filmic, exposure: -2.2 }

materials:
  floor: { material: Phong, diffuse: { map: Checker, color1: 0.4, color2: 0.16, input: { map: UVTransform, scaleU: 48, scaleV: 48 } }, specular: 0.12, shininess: 0.7 }
  gold: { material: Phong, diffuse: [0.32, 0.19, 0.03], specular: [1, 0.72, 0.3], shininess: 0.8 }
  lamp: { material: Phong, diffuse: 0, emissive: [3.4, 3.1, 2.7] }"""

OBJECTS = """
objects:
  - { object: Parallelogram, u: [24, 0, 0], v: [0, 24, 0], transform: { translation: [-12, -12, 0] }, material: floor }
  - { object: Sphere, radius: 0.62, material: { file: ../materials/marble.yaml }, transform: { translation: [0, 0, 0.62] } }
  - { object: Sphere, radius: 0.2, material: gold, transform: { translation: [0, 0, 1.44] } }"""


def place(lamp, arm):
    """Of a lamp in the arm 0, turned to its own: x, y, z."""
    radius = 0.95 + 0.012 * lamp * (lamp + 6)
    turn = 0.07 * lamp + 2 * math.pi * arm / ARMS
    return radius * math.cos(turn), radius * math.sin(turn), 0.08 + 0.6 * math.exp(-0.5 * lamp)


def numbers(values, digits):
    return "[" + ", ".join(f"{v:.{digits}f}" for v in values) + "]"


def color(arm):
    return colorsys.hsv_to_rgb(arm / ARMS, 0.88, 1)


print(HEAD)
print("\ndefs:\n  arm:\n    object: Group\n    objects:")
for lamp in range(LAMPS):
    print(f"      - {{ object: Sphere, radius: 0.028, transform: {{ translation: {numbers(place(lamp, 0), 3)} }} }}")
print(OBJECTS)
for arm in range(ARMS):
    print(f"  - {{ object: Instance, of: arm, material: lamp, transform: {{ rotation: [0, 0, {2 * math.pi * arm / ARMS:.6f}] }} }}")
print("\nlights:")
for arm in range(ARMS):
    for lamp in range(LAMPS):
        print(f"  - {{ light: Point, position: {numbers(place(lamp, arm), 3)}, color: {numbers(color(arm), 2)}, "
              f"intensity: {0.012 + 0.0022 * lamp:.4f}, shadows: false }}")
