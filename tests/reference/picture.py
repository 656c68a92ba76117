"""Writes a renderer's result to a file: linear light in R, G and B as floats, and in A a mask of the pixels to compare.
Rows from the top."""
import struct
import zlib

import numpy

STEP = 2. ** -22  # light is rounded to multiples of it, which makes the file half as large, and is 1.2e-7 at most


def edges(*pictures):
    """Where one of the pictures differs within a pixel: another object, another face, another shadow."""
    found = False
    for picture in pictures:
        height, width = picture.shape[:2]
        padded = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
        for y in range(3):
            for x in range(3):
                found = found | (numpy.abs(padded[y:y + height, x:x + width] - picture).max(axis=2) > .3)
    return found


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def write_png(path, light):
    """Linear light as sRGB, cut at 1."""
    cut = numpy.clip(light, 0, 1)
    curved = numpy.where(cut <= .0031308, 12.92 * cut, 1.055 * cut ** (1 / 2.4) - .055)
    rows = numpy.pad(numpy.round(255 * curved).astype(numpy.uint8).reshape(len(light), -1), ((0, 0), (1, 0)))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in ((b"IHDR", struct.pack(">2I5B", light.shape[1], len(light), 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


def write_exr(path, light, compared, step=STEP):
    """Floats, compressed by ZIP: 16 rows a block, bytes of one weight together, each less the one before."""
    height, width = compared.shape
    planes = [compared.astype("<f4")] + [numpy.round(light[..., lane] / step).astype("f8") * step for lane in (2, 1, 0)]
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in (b"A", b"B", b"G", b"R")) + b"\0"
    header = struct.pack("<ii", 20000630, 2) + attribute("channels", "chlist", channels) + attribute("compression", "compression", b"\3")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    blocks = []
    for y in range(0, height, 16):
        raw = b"".join(plane[row].astype("<f4").tobytes() for row in range(y, min(y + 16, height)) for plane in planes)
        parted = numpy.frombuffer(raw[0::2] + raw[1::2], numpy.uint8).astype(int)
        parted[1:] = (parted[1:] - parted[:-1] + 128) & 255
        packed = zlib.compress(parted.astype(numpy.uint8).tobytes(), 9)
        packed = packed if len(packed) < len(raw) else raw
        blocks.append(struct.pack("<ii", y, len(packed)) + packed)
    at = len(header) + 8 * len(blocks)
    with open(path, "wb") as file:
        file.write(header)
        for block in blocks:
            file.write(struct.pack("<Q", at))
            at += len(block)
        file.write(b"".join(blocks))
