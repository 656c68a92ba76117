"""Writes studio.exr, an environment map by formulas: `blender -b --factory-startup -P tests/reference/studio.py`.
Gray walls, lighter above; a window 60 times as bright, and a warm one 12 times."""
import os
import sys

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import picture  # noqa: E402

WIDTH, HEIGHT = 64, 32


def window(u, v, middle, size):
    """1 within, 0 outside, a texel or two between."""
    apart = numpy.abs((u - middle[0] + .5) % 1 - .5) / size[0], numpy.abs(v - middle[1]) / size[1]
    return numpy.clip(4 - 3 * numpy.maximum(*apart), 0, 1)


v, u = numpy.meshgrid(1 - (numpy.arange(HEIGHT) + .5) / HEIGHT, (numpy.arange(WIDTH) + .5) / WIDTH, indexing="ij")
light = (.15 + .1 * v)[..., None] * numpy.array((.9, .95, 1))
light = light + window(u, v, (.2, .68), (.03, .05))[..., None] * 12 * numpy.array((1, .95, .9))
light = light + window(u, v, (.44, .55), (.06, .04))[..., None] * 2.4 * numpy.array((1, .7, .4))
picture.write_exr(os.path.join(HERE, "studio.exr"), light, numpy.ones((HEIGHT, WIDTH), bool), 2. ** -14)
