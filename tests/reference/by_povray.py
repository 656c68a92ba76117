"""Renders a world with POV-Ray: true spheres, cylinders, cones and planes, smooth meshes; one ray through each pixel's
center. Its Phong lobe, max(R.l, 0)^n, is not multiplied by the cosine as ours is, so that cosine and lobe are drawn as
separate pictures for each light."""
import math
import os
import subprocess
import tempfile

import numpy

import world

LEVELS = 65535
SCALES = [1 - .5 * (k * .618033988749895 % 1) for k in range(16)]  # of light, evenly from 1/2 to 1
DEEP = 16  # a step behind five panes is one, too
NEAR = 1e-4  # of a fading light: beyond it falls as 2 NEAR^2 / distance^2, within 1e-8 of it


def vector(v):
    return "<" + ", ".join("%.17g" % lane for lane in v) + ">"


def smooth_mesh(thing, folder):
    points, normals, _, faces = world.read_obj(os.path.join(folder, thing["file"]))
    corners = [corner for face in faces for corner in face]
    lists = [("vertex_vectors", [points[c[0]] for c in corners]), ("normal_vectors", [normals[c[2]] for c in corners]),
             ("face_indices", [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])]
    return "mesh2 { " + " ".join("%s { %d, %s }" % (name, len(rows), ", ".join(map(vector, rows))) for name, rows in lists)


def shape(thing, folder):
    """Without its closing brace. Parallelograms are two triangles."""
    kind = thing["object"]
    if kind == "Sphere":
        return "sphere { 0, %.17g" % thing.get("radius", 1)
    if kind == "Box":
        size = world.colour(thing.get("size", 1)) / 2
        return "box { %s, %s" % (vector(-size), vector(size))
    if kind == "Cylinder":
        return "cylinder { 0, <0, 0, %.17g>, %.17g" % (thing.get("height", 1), thing.get("radius", .5))
    if kind == "Cone":
        return "cone { 0, %.17g, <0, 0, %.17g>, 0" % (thing.get("radius", .5), thing.get("height", 1))
    if kind == "Plane":
        return "plane { z, 0"
    if kind == "Mesh":
        return smooth_mesh(thing, folder)
    points, _, _ = world.flat_mesh(thing, folder)
    return "mesh2 { vertex_vectors { 4, %s } face_indices { 2, <0, 1, 2>, <0, 2, 3> }" % ", ".join(map(vector, points))


def objects(scenery, finish, shadow=False):
    """`finish(number, material)`: a pigment and a finish. That objects cast no shadow is theirs to say: shadowless lights have no lobe."""
    text, rest = "", "" if shadow else "no_shadow "
    for number, thing in enumerate(scenery.objects):
        columns = ", ".join("%.17g" % value for value in thing["matrix"][:3].T.ravel())
        text += "%s texture { %s } %smatrix <%s> }\n" % (shape(thing, scenery.folder), finish(number, thing["material"]), rest, columns)
    return text


def light(source):
    kind = source["kind"]
    strength = source["light"] * (1 if kind == "Directional" else 1 / (2 * NEAR ** 2))
    if kind == "Directional":
        away = world.unit(source.get("direction", (0, 0, -1)))
        return "light_source { %s, rgb %s parallel point_at 0 }\n" % (vector(-1e3 * away), vector(strength))
    place = numpy.array(source.get("position", (0, 0, 0)), float)
    rest = " fade_power 2 fade_distance %.17g" % NEAR
    if kind == "Spot":  # without tightness: the same cubic in the cosine
        at = place + source.get("direction", (0, 0, -1))
        rest += " spotlight radius %.17g falloff %.17g tightness 0 point_at %s" % (source.get("innerAngle", 20), source.get("outerAngle", 30), vector(at))
    return "light_source { %s, rgb %s%s }\n" % (vector(place), vector(strength), rest)


def camera(seen, width, height):
    shorter = min(width, height)
    right, up = (2 * seen.half * side / shorter * seen.axes[:, lane] for lane, side in enumerate((width, height)))
    return "camera { %s location %s right %s up %s direction %s }\n" % (
        "orthographic" if seen.flat else "perspective", vector(seen.position), vector(right), vector(up), vector(-seen.axes[:, 2]))


def levels(scenery, text):
    """Height x width x 3, from the top; whole numbers, LEVELS of which are 1."""
    with tempfile.TemporaryDirectory() as folder:
        source, made = os.path.join(folder, "scene.pov"), os.path.join(folder, "scene.ppm")
        with open(source, "w") as file:
            file.write("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 64 }\n" +
                       camera(scenery.camera, scenery.width, scenery.height) + text)
        command = ["povray", "+I" + source, "+O" + made, "+W%d" % scenery.width, "+H%d" % scenery.height, "+FP16", "File_Gamma=1.0",
                   "Dither=off", "-A", "-J", "-D", "-GA", "+WT1"]
        ran = subprocess.run(command, capture_output=True, text=True)
        if ran.returncode:
            raise RuntimeError(ran.stderr[-2000:])
        with open(made, "rb") as file:
            data = file.read()
    texels = numpy.frombuffer(data[-6 * scenery.width * scenery.height:], ">u2")
    return texels.reshape(scenery.height, scenery.width, 3)


def picture(scenery, text):
    """Rounded once: of numbers, of which nothing is compared but where they step."""
    return levels(scenery, text) / LEVELS


def light_picture(scenery, text):
    """Light to some 20 bits. text(s) has all light s times as bright, so light v is rounded to n with |n - LEVELS s v| <= 1/2: each s tells an interval
    of v, and all of them together a short one. In levels: v = 16383.75 is within 16383.5 and 16384.5 by s = 1, within 16382.6 and 16383.8 by
    s = 0.809, and so within 16383.5 and 16383.8."""
    least, most = -numpy.inf, numpy.inf
    for scale in SCALES:
        level = levels(scenery, text(scale))
        least, most = numpy.maximum(least, (level - .5) / scale), numpy.minimum(most, (level + .5) / scale)
    if (least - most).max() > .02:
        raise RuntimeError("light is not proportional to the lights: off by %g steps" % (least - most).max())
    return (least + most) / 2 / LEVELS


def matt(lanes, more=""):
    return "pigment { rgb %s } finish { ambient 0 diffuse 1 %s }" % (vector(lanes), more)


def pane(material):
    """Behind it t of the light comes through, and (1 - t) diffuse is its own: a coat that hides 1 - T of a filter of colour t / T."""
    share = world.slot(material, "transparency")
    most = share.max()
    if not most:
        return matt(world.slot(material, "diffuse"))
    own = world.slot(material, "diffuse") * (1 - share) / (1 - most)
    return "pigment { rgb %s filter 1 } finish { ambient 0 diffuse 0 } } texture { pigment { rgb %s transmit %.17g } finish { ambient 0 diffuse 1 }" % (
        vector(share / most), vector(own), most)


def half(material):
    """Of a pigment: what is transparent shows half of what is behind it."""
    return " transmit .5" if "transparency" in material else ""


def shining(lanes, more=""):
    return "pigment { rgb %s%s } finish { ambient 0 emission 1 diffuse 0 }" % (vector(lanes), more)


def numbered(scenery):
    return picture(scenery, objects(scenery, lambda number, material: shining(numpy.full(3, (number + 1) / 16), half(material)))) * 16


def facing(scenery):
    """The normal that faces the eye, its positive lanes and then its negative ones: what lights along the axes make of white."""
    axes = [dict(kind="Directional", direction=-sign * axis, light=axis) for sign in (1, -1) for axis in numpy.eye(3)]
    text = objects(scenery, lambda number, material: matt((1, 1, 1)).replace(" }", half(material) + " }", 1))
    return [picture(scenery, text + "".join(light(axis) for axis in axes[half:half + 3])) for half in (0, 3)]


def shaded(scenery, source, shadow):
    """diffuse cosine + specular cosine lobe, by three pictures; the lobe's light doesn't fade and has no colour. Panes have no lobe."""
    def lit(source, scale):
        return light(dict(source, light=scale * numpy.asarray(source["light"])))
    if scenery.clear:
        return light_picture(scenery, lambda scale: objects(scenery, lambda number, material: pane(material)) + lit(source, scale))

    def answer(slot):
        text = objects(scenery, lambda number, material: matt(world.slot(material, slot)), shadow)
        return light_picture(scenery, lambda scale: text + lit(source, scale))

    def lobe(number, material):
        return "pigment { rgb 0 } finish { ambient 0 diffuse 0 phong 1 phong_size %.17g }" % world.exponent(material)

    def bulb(scale):
        if source["kind"] == "Directional":
            return light(dict(source, light=numpy.full(3, scale)))
        return "light_source { %s, rgb %.17g }\n" % (vector(source.get("position", (0, 0, 0))), scale)
    return answer("diffuse") + answer("specular") * light_picture(scenery, lambda scale: objects(scenery, lobe) + bulb(scale))


def render(scenery, shadows):
    """Light, and pictures whose steps are edges."""
    numbers = numbered(scenery)
    ambient = sum((source["light"] for source in scenery.lights if source["kind"] == "Ambient"), numpy.zeros(3))
    lights, steps = 0. if scenery.clear else light_picture(scenery, lambda scale: objects(scenery, lambda number, material: shining(
        scale * (world.slot(material, "emissive") + world.slot(material, "ambient") * ambient)))), [numbers] + facing(scenery)
    if scenery.clear:
        steps = [DEEP * step for step in steps]
    for source in scenery.lights:
        if source["kind"] == "Ambient":
            continue
        free = shaded(scenery, source, False)
        cast = shaded(scenery, source, True) if shadows else free
        steps.append((cast.max(axis=2, keepdims=True) >= .5 * free.max(axis=2, keepdims=True)).astype(float))
        lights = lights + cast
    return lights, steps, numbers[..., 0] > .25
