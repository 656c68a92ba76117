"""Reads a scene document into lists: objects with matrices and materials, lights, a camera. Written from `matc
--list=scenes` and docs/reference/semantics.md; shares no code with the C sources. Supports only the features of this
folder's scenes, and fails on any other."""
import math
import os

import numpy
import yaml


class World:
    """A document, read. `objects`: dictionaries with `matrix`, 4 x 4, and `material` as written; `lights` with `light`, color times intensity."""

    def __init__(self, path):
        self.folder = os.path.dirname(os.path.abspath(path))
        with open(path) as file:
            self.document = yaml.safe_load(file)
        image = self.document.get("image", {})
        self.width, self.height = image.get("width", 512), image.get("height", 512)
        self.camera = Camera(self.document.get("camera", {}))
        self.objects = []
        self.flatten(self.document.get("objects", []), numpy.eye(4), None)
        self.lights = [dict(light, light=colour(light.get("color", 1)) * light.get("intensity", 1), kind=light["light"])
                       for light in self.document.get("lights", [])]
        self.casts = any(light["kind"] in ("Point", "Spot", "Directional", "Area") for light in self.lights)
        self.clear = any("transparency" in thing["material"] for thing in self.objects)
        self.casts = self.casts and not self.clear  # coloured shadows are another matter
        self.bounces = self.document.get("indirect", {}).get("bounces", 0)
        self.sky = self.material(self.document.get("sky"))

    def flatten(self, objects, around, material):
        for thing in objects:
            matrix = around @ transform(thing.get("transform", {}))
            own = self.material(thing.get("material")) or material
            if thing["object"] == "Group":
                self.flatten(thing["objects"], matrix, own)
            else:
                self.objects.append(dict(thing, matrix=matrix, material=own))

    def material(self, written):
        return self.document["materials"][written] if isinstance(written, str) else written


class Camera:
    """`axes`: columns right, up, back; `half`: of the shorter side, as a tangent or as a length."""

    def __init__(self, written):
        self.flat = written.get("camera") == "Orthographic"
        self.position = numpy.array(written.get("position", (0, -5, 2)), float)
        back = unit(self.position - written.get("target", (0, 0, 0)))
        right = unit(numpy.cross(written.get("up", (0, 0, 1)), back))
        self.axes = numpy.column_stack((right, numpy.cross(back, right), back))
        self.half = written.get("size", 4) / 2 if self.flat else math.tan(math.radians(written.get("angle", 40) / 2))


def unit(v):
    return numpy.array(v, float) / numpy.linalg.norm(v)


def colour(written):
    return numpy.full(3, float(written)) if isinstance(written, (int, float)) else numpy.array(written, float)


def transform(written):
    """M = T Rz Ry Rx S H."""
    move, scale, shear = numpy.eye(4), numpy.eye(4), numpy.eye(4)
    move[:3, 3] = written.get("translation", (0, 0, 0))
    scale[:3, :3] = numpy.diag(colour(written.get("scale", 1)))
    shear[0, 1], shear[0, 2], shear[1, 2] = written.get("shear", (0, 0, 0))
    turn = numpy.eye(4)
    for axis, angle in enumerate(written.get("rotation", (0, 0, 0))):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        about = numpy.eye(4)
        about[i, i] = about[j, j] = math.cos(angle)
        about[j, i], about[i, j] = math.sin(angle), -math.sin(angle)
        turn = about @ turn
    return move @ turn @ scale @ shear


def exponent(material):
    """Of Phong's lobe: semantics 4.1."""
    if "shininess" not in material:
        return 4.
    y = material["shininess"] * (2 - material["shininess"])
    return 0. if y <= 0 else 65504. if y >= 1 else min(-2 / math.log(y), 65504.)


def slot(material, name):
    return colour(material.get(name, .5 if name == "diffuse" else 0))


def is_painted(material):
    """Whether its diffuse is a map."""
    return isinstance(material.get("diffuse"), dict)


def read_obj(path):
    """Points, normals, (u, v); faces of corners, each an index into the three, u and v alone where there is one. z is up, the file has y up."""
    points, normals, places, faces = [], [], [], []
    with open(path) as file:
        for words in map(str.split, file):
            if words[:1] == ["v"] or words[:1] == ["vn"]:
                x, y, z = map(float, words[1:4])
                (points if words[0] == "v" else normals).append((x, -z, y))
            elif words[:1] == ["vt"]:
                places.append(tuple(map(float, words[1:3])))
            elif words[:1] == ["f"]:
                faces.append([[int(part) - 1 if part else None for part in word.split("/")] for word in words[1:]])
    return points, normals, places, faces


def flat_mesh(thing, folder):
    """Points, faces, (u, v) of each face's corners, of what has flat faces alone."""
    kind = thing["object"]
    if kind == "Box":
        size = colour(thing.get("size", 1)) / 2
        points = [tuple(size * (i & 1 or -1, i >> 1 & 1 or -1, i >> 2 or -1)) for i in range(8)]
        return points, [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)], None
    if kind == "Parallelogram":
        u, v = numpy.array(thing.get("u", (1, 0, 0)), float), numpy.array(thing.get("v", (0, 1, 0)), float)
        return [(0, 0, 0), tuple(u), tuple(u + v), tuple(v)], [(0, 1, 2, 3)], [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    if kind == "Plane":
        s = 200.
        square = [(-s, -s), (s, -s), (s, s), (-s, s)]
        return [(x, y, 0) for x, y in square], [(0, 1, 2, 3)], [square]
    if kind == "Mesh":
        points, _, places, faces = read_obj(os.path.join(folder, thing["file"]))
        uv = [[places[corner[1]] for corner in face] for face in faces] if places else None
        return points, [[corner[0] for corner in face] for face in faces], uv
    raise ValueError(kind + " has no flat faces")
