"""Renders a world with Cycles: Lambertian surfaces, one picture per light, because Cycles picks a random light for
each sample. For lights without extent only a sample's place in its pixel is random, within 0.005 pixels of the center."""
import ast
import math
import os
import tempfile

import bpy
import mathutils
import numpy

import world

SAMPLES, AREA_SAMPLES, HALF_SHADOW_SAMPLES, BOUNCED_SAMPLES, PRINCIPLED_SAMPLES = 64, 4096, 1024, 1024, 8192


def begin(scenery, samples):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = samples, False, False
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", .01  # at the middle of the pixel; a box is 1 wide, whatever is said
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.max_bounces = cycles.diffuse_bounces = 0
    cycles.transparent_max_bounces = cycles.min_transparent_bounces = cycles.min_light_bounces = 64
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = scenery.width, scenery.height, 100
    render.threads_mode, render.threads = "FIXED", 1
    render.dither_intensity = 0
    settings = render.image_settings
    settings.file_format, settings.color_depth, settings.color_mode = "OPEN_EXR", "32", "RGB"
    scene.view_settings.view_transform = "Raw"
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
    add_camera(scene, scenery)
    return scene


def matrix_of(axes, position):
    matrix = numpy.eye(4)
    matrix[:3, :3], matrix[:3, 3] = axes, position
    return mathutils.Matrix(matrix.tolist())


def add_camera(scene, scenery):
    seen = bpy.data.cameras.new("camera")
    seen.sensor_fit = "HORIZONTAL" if scenery.width < scenery.height else "VERTICAL"
    seen.clip_start, seen.clip_end = .001, 1e5
    if scenery.camera.flat:
        seen.type, seen.ortho_scale = "ORTHO", 2 * scenery.camera.half
    else:
        seen.angle = 2 * math.atan(scenery.camera.half)
        seen.sensor_width = seen.sensor_height = 32
        seen.lens = 16 / scenery.camera.half
    eye = bpy.data.objects.new("camera", seen)
    eye.matrix_world = matrix_of(scenery.camera.axes, scenery.camera.position)
    scene.collection.objects.link(eye)
    scene.camera = eye


class Shader:
    """Nodes of a material; `tree.add` adds closures up."""

    def __init__(self, name):
        self.made = bpy.data.materials.new(name)
        self.made.use_nodes = True
        self.tree = self.made.node_tree
        self.tree.nodes.clear()
        self.sum = None

    def node(self, kind, **inputs):
        made = self.tree.nodes.new(kind)
        for name, value in inputs.items():
            if hasattr(value, "node"):
                self.tree.links.new(value, made.inputs[name])
            else:
                made.inputs[name].default_value = value
        return made

    def add(self, closure):
        if self.sum:
            both = self.node("ShaderNodeAddShader")
            self.tree.links.new(self.sum, both.inputs[0])
            self.tree.links.new(closure.outputs[0], both.inputs[1])
            closure = both
        self.sum = closure.outputs[0]

    def done(self, material=()):
        self.tree.links.new(self.sum, self.node("ShaderNodeOutputMaterial").inputs["Surface"])
        if "displacement" in material:
            displace(self, material)
        return self.made


def rgba(lanes):
    return (*map(float, lanes), 1.)


def painted(shader, scenery, written):
    """The output of a map's nodes: Checker or ImageMap on u and v."""
    place = shader.node("ShaderNodeTexCoord").outputs["UV"]
    if written["map"] == "Checker":
        squares = shader.node("ShaderNodeTexChecker", Color1=rgba(world.colour(written.get("color1", 1))),
                              Color2=rgba(world.colour(written.get("color2", 0))), Scale=2.)
        shader.tree.links.new(place, squares.inputs["Vector"])
        return squares.outputs["Color"]
    sampled = shader.node("ShaderNodeTexImage")
    sampled.image = bpy.data.images.load(os.path.join(scenery.folder, written["image"]))
    sampled.image.colorspace_settings.name = "sRGB" if written.get("colorspace") == "srgb" else "Non-Color"
    sampled.interpolation = "Linear" if written.get("bilinearFiltering", True) else "Closest"
    if sampled.interpolation == "Linear":  # its texels have their colour in their middle, ours at their corner
        moved = shader.node("ShaderNodeVectorMath")
        moved.inputs[1].default_value = (.5 / sampled.image.size[0], .5 / sampled.image.size[1], 0)
        shader.tree.links.new(place, moved.inputs[0])
        place = moved.outputs[0]
    shader.tree.links.new(place, sampled.inputs["Vector"])
    return sampled.outputs["Color"]


def diffuse(shader, scenery, material):
    if world.is_painted(material):
        return painted(shader, scenery, material["diffuse"])
    return rgba(world.slot(material, "diffuse"))


def lambert(scenery, material):
    """What answers light: diffuse on its side, diffuseTransparency on the other."""
    shader = Shader("lambert")
    shader.add(shader.node("ShaderNodeBsdfDiffuse", Color=diffuse(shader, scenery, material)))
    if "diffuseTransparency" in material:
        shader.add(shader.node("ShaderNodeBsdfTranslucent", Color=rgba(world.slot(material, "diffuseTransparency"))))
    return shader.done(material)


def shining(scenery, material):
    """What needs no light from anywhere: emissive, and the answer to ambient light."""
    ambient = sum((light["light"] for light in scenery.lights if light["kind"] == "Ambient"), numpy.zeros(3))
    shader = Shader("shining")
    shader.add(shader.node("ShaderNodeEmission", Color=rgba(world.slot(material, "emissive") + world.slot(material, "ambient") * ambient)))
    return shader.done(material)


def paint(scenery, material):
    shader = Shader("paint")
    shader.add(shader.node("ShaderNodeEmission", Color=diffuse(shader, scenery, material)))
    return shader.done(material)


def geometry(output, scale, offset, material):
    """A vector of the surface's geometry as a colour: times the scale, and the offset."""
    shader = Shader(output)
    colour = shader.node("ShaderNodeVectorMath")
    colour.operation = "MULTIPLY_ADD"
    shader.tree.links.new(shader.node("ShaderNodeNewGeometry").outputs[output], colour.inputs[0])
    colour.inputs[1].default_value, colour.inputs[2].default_value = (scale,) * 3, (offset,) * 3
    shader.add(shader.node("ShaderNodeEmission", Color=colour.outputs[0]))
    return shader.done(material)


def facing(scenery, material):
    """The normal, from -1 to 1, as a colour from 0 to 1."""
    return geometry("Normal", .5, .5, material)


def placed(scenery, material):
    """Where the surface is, as a colour: from -2 to 2 in 0 to 1."""
    return geometry("Position", .25, .5, material)


def principled(scenery, material):
    """Of a ball, by the normals of its closed form: a mesh has its faces'."""
    shader = Shader("principled")
    centre = next(thing["matrix"][:3, 3] for thing in scenery.objects if thing["material"] is material)
    outward = shader.node("ShaderNodeVectorMath")
    outward.operation = "SUBTRACT"
    shader.tree.links.new(shader.node("ShaderNodeNewGeometry").outputs["Position"], outward.inputs[0])
    outward.inputs[1].default_value = centre
    unit = shader.node("ShaderNodeVectorMath")
    unit.operation = "NORMALIZE"
    shader.tree.links.new(outward.outputs[0], unit.inputs[0])
    made = shader.node("ShaderNodeBsdfPrincipled", Metallic=float(material["metalness"]), Roughness=float(material["roughness"]), Specular=.5)
    made.inputs["Base Color"].default_value = rgba(world.colour(material["baseColor"]))
    made.distribution = "MULTI_GGX"  # height-correlated, and light that facets reflect more than once
    shader.tree.links.new(unit.outputs[0], made.inputs["Normal"])
    shader.add(made)
    return shader.done()


MATHS = {ast.Add: "ADD", ast.Sub: "SUBTRACT", ast.Mult: "MULTIPLY", "sin": "SINE"}


def formula(shader, term):
    """The output of a formula's nodes, or its number: sums, products and sines over u, v and x, y, z, where the object's space is the world."""
    if isinstance(term, ast.Constant):
        return float(term.value)
    if isinstance(term, ast.Name):
        on_face = term.id in "uv"
        place = shader.node("ShaderNodeTexCoord").outputs["UV"] if on_face else shader.node("ShaderNodeNewGeometry").outputs["Position"]
        return shader.node("ShaderNodeSeparateXYZ", Vector=place).outputs["uv".index(term.id) if on_face else "xyz".index(term.id)]
    made = shader.node("ShaderNodeMath")
    made.operation = MATHS[term.func.id] if isinstance(term, ast.Call) else MATHS[type(term.op)]
    for at, part in enumerate(term.args if isinstance(term, ast.Call) else (term.left, term.right)):
        value = formula(shader, part)
        if hasattr(value, "node"):
            shader.tree.links.new(value, made.inputs[at])
        else:
            made.inputs[at].default_value = value
    return made.outputs[0]


def displace(shader, material):
    """What moves the surface, beside its shader."""
    height = formula(shader, ast.parse(material["displacement"].lstrip("= "), mode="eval").body)
    moved = shader.node("ShaderNodeDisplacement", Height=height, Midlevel=0., Scale=float(material.get("displacementScale", 1)))
    out = next(node for node in shader.tree.nodes if node.type == "OUTPUT_MATERIAL")
    shader.tree.links.new(moved.outputs[0], out.inputs["Displacement"])
    shader.made.cycles.displacement_method = "DISPLACEMENT"


def fine_ball(radius, around=768, up=384):
    """Its faces leave it by 1e-5 of the radius."""
    rows = [(math.sin(math.pi * j / up), -math.cos(math.pi * j / up)) for j in range(up + 1)]
    points = [(radius * wide * math.cos(2 * math.pi * i / around), radius * wide * math.sin(2 * math.pi * i / around), radius * high)
              for wide, high in rows for i in range(around)]
    faces = [(j * around + i, j * around + (i + 1) % around, (j + 1) * around + (i + 1) % around, (j + 1) * around + i) for j in range(up) for i in range(around)]
    return points, faces, None


def divide(scene, thing):
    """Cycles' own subdivision, of flat faces, into parts of half a pixel."""
    scene.cycles.feature_set, scene.cycles.dicing_rate = "EXPERIMENTAL", .5
    scene.cycles.max_subdivisions = 12
    thing.modifiers.new("parts", "SUBSURF").subdivision_type = "SIMPLE"
    thing.cycles.use_adaptive_subdivision = True


def add_objects(scene, scenery, shading):
    for number, thing in enumerate(scenery.objects):
        points, faces, uv = fine_ball(thing["radius"]) if thing["object"] == "Sphere" else world.flat_mesh(thing, scenery.folder)
        mesh = bpy.data.meshes.new("mesh")
        placed = numpy.column_stack((points, numpy.ones(len(points)))) @ thing["matrix"].T  # an object's own matrix would lose its shear
        mesh.from_pydata(placed[:, :3].tolist(), [], faces)
        if uv:
            mesh.uv_layers.new().data.foreach_set("uv", numpy.ravel([corner for face in uv for corner in face]))
        mesh.materials.append(shading(scenery, thing["material"]))
        made = bpy.data.objects.new("object", mesh)
        scene.collection.objects.link(made)
        if "displacement" in thing["material"]:
            divide(scene, made)


def add_light(scene, light, shadow):
    """Cycles' power of a point is 4 pi times its radiant intensity, a sun's its irradiance; white Lambert surfaces send back 1 / pi of it."""
    kind = light["kind"]
    made = bpy.data.lights.new("light", {"Point": "POINT", "Spot": "SPOT", "Directional": "SUN"}[kind])
    made.color = tuple(light["light"] / light["light"].max())
    made.energy = float(light["light"].max()) * math.pi * (1 if kind == "Directional" else 4 * math.pi)
    made.use_shadow = made.cycles.cast_shadow = shadow
    if kind == "Directional":
        made.angle = 0
    else:
        made.shadow_soft_size = 0
    placed = bpy.data.objects.new("light", made)
    back = -world.unit(light.get("direction", (0, 0, -1)))
    right = world.unit(numpy.cross((0, 1, 0) if abs(back[1]) < .9 else (1, 0, 0), back))
    placed.matrix_world = matrix_of(numpy.column_stack((right, numpy.cross(back, right), back)), light.get("position", (0, 0, 0)))
    scene.collection.objects.link(placed)


def add_area(scene, light, shadow):
    """A rectangle. Its power is 4 times area and radiance; nothing but its own samples may meet it, since there are no bounces."""
    u, v = (numpy.array(light.get(name, init), float) for name, init in (("u", (0, 1, 0)), ("v", (1, 0, 0))))
    made = bpy.data.lights.new("light", "AREA")
    made.shape, made.size, made.size_y = "RECTANGLE", numpy.linalg.norm(u), numpy.linalg.norm(v)
    made.color = tuple(light["light"] / light["light"].max())
    made.energy = float(light["light"].max()) * 4 * made.size * made.size_y
    made.use_shadow = made.cycles.cast_shadow = shadow
    made.cycles.use_multiple_importance_sampling = False
    placed = bpy.data.objects.new("light", made)
    back = -world.unit(numpy.cross(u, v))
    axes = numpy.column_stack((world.unit(u), numpy.cross(back, world.unit(u)), back))
    placed.matrix_world = matrix_of(axes, numpy.array(light.get("position", (0, 0, 1))) + (u + v) / 2)
    placed.visible_camera = False
    scene.collection.objects.link(placed)


def sky(scenery):
    """Preetham's, up to a factor; of what the camera sees there is nothing else."""
    scene = begin(scenery, 1)
    tree = scene.world.node_tree
    made = tree.nodes.new("ShaderNodeTexSky")
    made.sky_type, made.turbidity = "PREETHAM", scenery.sky["turbidity"]
    made.sun_direction = world.unit(scenery.sky["sun"])
    tree.links.new(made.outputs["Color"], tree.nodes["Background"].inputs["Color"])
    tree.nodes["Background"].inputs["Strength"].default_value = .3
    return picture(scene)


def picture(scene):
    """Height x width x 3, from the top."""
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "picture.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.name = "Raw"
        texels = numpy.empty(len(image.pixels), numpy.float32)
        image.pixels.foreach_get(texels)
        width, height = image.size
        bpy.data.images.remove(image)
    return texels.reshape(height, width, -1)[::-1, :, :3].astype(float)


def shaded(scenery, shading, light=None, shadow=False):
    area = light and light["kind"] == "Area"
    scene = begin(scenery, PRINCIPLED_SAMPLES if shading is principled else (HALF_SHADOW_SAMPLES if shadow else AREA_SAMPLES) if area else SAMPLES if light else 1)
    add_objects(scene, scenery, shading)
    if area:
        add_area(scene, light, shadow)
    elif light:
        add_light(scene, light, shadow)
    return picture(scene)


def numbered(scenery):
    """Each object's number, in a colour of its own; 0 where nothing is."""
    numbers = {id(thing): number for number, thing in enumerate(scenery.objects)}
    scene = begin(scenery, 1)
    order = iter(range(1, 1 + len(scenery.objects)))

    def shading(scenery, material):
        shader = Shader("number")
        shader.add(shader.node("ShaderNodeEmission", Color=rgba((next(order),) * 3)))
        return shader.done(material)
    add_objects(scene, scenery, shading)
    return picture(scene)


def bounced(scenery, bounces):
    """Light that came by way of so many surfaces, at most, and by one at least: of lights with shadows; and all light."""
    indirect, whole = 0, 0
    for source in scenery.lights:
        direct = shaded(scenery, lambert, source, True)
        scene = begin(scenery, BOUNCED_SAMPLES)
        scene.cycles.max_bounces = scene.cycles.diffuse_bounces = bounces
        add_objects(scene, scenery, lambert)
        add_light(scene, source, True)
        all_light = picture(scene)
        indirect, whole = indirect + numpy.maximum(all_light - direct, 0), whole + all_light
    return indirect, whole


def render(scenery, shadows):
    """Light, and pictures whose steps are edges."""
    if scenery.sky:
        return sky(scenery), [], numpy.ones((scenery.height, scenery.width), bool)
    numbers = numbered(scenery)
    steps = [numbers, 2 * shaded(scenery, facing), 4 * shaded(scenery, paint)]
    light = shaded(scenery, shining)
    for source in scenery.lights:
        if source["kind"] == "Ambient":
            continue
        free = shaded(scenery, lambert, source)
        cast = shaded(scenery, lambert, source, True) if shadows else free
        if source["kind"] != "Area":  # whose shadows have no edge
            steps.append((cast.max(axis=2, keepdims=True) >= .5 * free.max(axis=2, keepdims=True)).astype(float))
        light += cast
    return light, steps, numbers[..., 0] > 0
