"""Renders the references: `blender -b --factory-startup -P tests/reference/render.py -- [NAME ...]`; all without a name.
See README.md."""
import glob
import os
import sys

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import picture  # noqa: E402
import world  # noqa: E402


BOUNCED_STEP = 2. ** -13
DISPLACED_STEP = 2. ** -18
PRINCIPLED_STEP = 2. ** -14
DISPLACED_JUMP = 8  # 0.15 of a length from pixel to pixel is an edge


def render_bounced(path, by, scenery):
    """NAME_1.exr and NAME_n.exr: the noise of paths is a thousand times what light is rounded to else. And a picture for docs."""
    there = by.numbered(scenery)
    compared = (there[..., 0] > 0) & ~numpy.asarray(picture.edges(there, 2 * by.shaded(scenery, by.facing)))
    for bounces in (1, scenery.bounces):
        light, whole = by.bounced(scenery, bounces)
        file = path[:-len(".yaml")] + "_%d.exr" % bounces
        picture.write_exr(file, light, compared, BOUNCED_STEP)
        print("%-60s %6d bytes, light of %d bounces %.4g in the mean" % (os.path.relpath(file, HERE), os.path.getsize(file), bounces, light[compared].mean()), file=sys.stderr)
    picture.write_png(os.path.join(HERE, "..", "..", "docs", "cycles.png"), whole)


def render_displaced(path, by, scenery):
    """NAME_points.exr and NAME_normals.exr; and a picture for docs, with shadows."""
    numbers, normals, points = by.numbered(scenery), by.shaded(scenery, by.facing), by.shaded(scenery, by.placed)
    compared = (numbers[..., 0] > 0) & ~numpy.asarray(picture.edges(numbers, 2 * normals, DISPLACED_JUMP * points))
    for name, lanes in (("points", 4 * points - 2), ("normals", 2 * normals - 1)):
        file = path[:-len(".yaml")] + "_%s.exr" % name
        picture.write_exr(file, lanes, compared, DISPLACED_STEP)
        print("%-60s %6d bytes, %.0f %% of pixels compared" % (os.path.relpath(file, HERE), os.path.getsize(file), 100 * compared.mean()), file=sys.stderr)
    light = sum(by.shaded(scenery, by.lambert, source, True) for source in scenery.lights)
    picture.write_png(os.path.join(HERE, "..", "..", "docs", "displaced-cycles.png"), light)


def render_principled(path, by, scenery):
    """Light of physically based balls, without shadows; paths between facets are noise, so that bits of a small share of light are none."""
    numbers = by.numbered(scenery)
    light = sum(by.shaded(scenery, by.principled, source) for source in scenery.lights)
    compared = (numbers[..., 0] > 0) & ~numpy.asarray(picture.edges(numbers))
    picture.write_exr(path[:-len(".yaml")] + ".exr", light, compared, PRINCIPLED_STEP)
    picture.write_png(os.path.join(HERE, "..", "..", "docs", "principled-cycles.png"), light)


def render(path):
    by = __import__("by_" + os.path.basename(os.path.dirname(path)))
    scenery = world.World(path)
    if scenery.bounces:
        return render_bounced(path, by, scenery)
    if any(thing["material"]["material"] == "Principled" for thing in scenery.objects):
        return render_principled(path, by, scenery)
    if "displacement" in scenery.document:
        return render_displaced(path, by, scenery)
    for suffix, shadows in (("", False), ("_shadows", True))[:2 if scenery.casts else 1]:
        light, steps, there = by.render(scenery, shadows)
        if shadows and numpy.array_equal(light, free):
            break
        free = light
        compared = there & ~numpy.asarray(picture.edges(*steps))
        file = path[:-len(".yaml")] + suffix + ".exr"
        picture.write_exr(file, light, compared)
        print("%-60s %6d bytes, %.0f %% of pixels compared, light up to %.3g" %
              (os.path.relpath(file, HERE), os.path.getsize(file), 100 * compared.mean(), light[compared].max()), file=sys.stderr)


names = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
for path in sorted(glob.glob(os.path.join(HERE, "*", "*.yaml"))):
    if not names or os.path.basename(path)[:-len(".yaml")] in names:
        render(path)
