#!/usr/bin/env python3
"""Writes glow.exr, 16 x 16 half floats: a lamp in the middle, four times as bright as white, and a blue that is below 0 at the edge."""
import struct

SIDE = 16


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def number(channel, x, y):
    near = max(0.0, 1 - ((x - 7.5) ** 2 + (y - 7.5) ** 2) / 64)
    return {"R": 4 * near, "G": 3 * near * near, "B": near - 0.125}[channel]


channels = b"".join(name + b"\0" + struct.pack("<iiii", 1, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
window = struct.pack("<iiii", 0, 0, SIDE - 1, SIDE - 1)
head = struct.pack("<ii", 20000630, 2)
for row in (("channels", "chlist", channels), ("compression", "compression", b"\0"), ("dataWindow", "box2i", window),
            ("displayWindow", "box2i", window), ("lineOrder", "lineOrder", b"\0"),
            ("pixelAspectRatio", "float", struct.pack("<f", 1)), ("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
            ("screenWindowWidth", "float", struct.pack("<f", 1))):
    head += attribute(*row)
head += b"\0"
line = 8 + 2 * 3 * SIDE
places = b"".join(struct.pack("<q", len(head) + 8 * SIDE + line * y) for y in range(SIDE))
lines = b"".join(struct.pack("<ii", y, line - 8) +
                 b"".join(struct.pack("<e", number(channel, x, y)) for channel in "BGR" for x in range(SIDE))
                 for y in range(SIDE))
with open("glow.exr", "wb") as file:
    file.write(head + places + lines)
