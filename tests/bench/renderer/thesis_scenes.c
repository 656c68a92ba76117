/* Generated documents in place of the thesis' scenes. Scatter places their copies, so they are
 * equal on every machine. */
#include <stdio.h>
#include "thesis.h"
#include <math.h>

static const char picture[] =
    "image: { width: 512, height: 512 }\ntoneMapping: { toneMapping: ReinhardDevlin }\n";
static const char day[] = "sky: { material: SunSkyLight, sun: [-0.6, -0.5, 0.6], turbidity: 3 }\n";

/* Houses on a plane, a tenth of them with panes of glass around them, in sun and sky. */
static void put_city(Text *out, int objects)
{
    const int panes = objects / 10, houses = objects - 1 - panes;
    text_put(out, "camera: { camera: Perspective, position: [0, -46, 22], target: [0, 0, 1], "
                  "angle: 40 }\nmaterials:\n"
                  "  street: { material: Phong, diffuse: 0.12, ambient: 0.2 }\n"
                  "  plaster: { material: Phong, diffuse: { map: Checker, color1: [.6, .55, .45], "
                  "color2: [.2, .25, .3], "
                  "input: { map: UVTransform, scaleU: 4, scaleV: 6 } }, ambient: .4 }\n"
                  "  glass: { material: Phong, diffuse: .05, specular: .5, shininess: .9, "
                  "transparency: [.5, .6, .7] }\n"
                  "lights:\n- { light: Directional, direction: [.6, .5, -.6], intensity: .8 }\n"
                  "- { light: Ambient, intensity: .4 }\n");
    text_put(out, day);
    text_format(
        out,
        "objects:\n- { object: Plane, material: street }\n"
        "- { object: Scatter, count: %d, seed: 1, size: [70, 60, 0], least: .6, most: 1.6, "
        "objects: [{ object: "
        "Box, size: [1, 1, 3], material: plaster, transform: { translation: [0, 0, 1.5] } }] }\n"
        "- { object: Scatter, count: %d, seed: 2, size: [60, 50, 0], least: .6, most: 1.6, "
        "objects: [{ object: "
        "Box, size: [1.2, 1.2, 4], material: glass, transform: { translation: [0, 0, 2] } }] }\n",
        houses, panes);
}

/* Leaves over ground whose color is two noises of eight octaves. */
static void put_plants(Text *out, int objects)
{
    text_put(out, "camera: { camera: Perspective, position: [0, -9, 5], target: [0, 0, 0], angle: "
                  "45 }\nmaterials:\n"
                  "  ground: { material: Phong, diffuse: { map: Blend, input: { map: "
                  "VolumeTurbulence, size: 2, octaves: 8, "
                  "noiseRatio: .5 }, blend: [{ value: -.5, input: [.2, .12, .06] }, { value: .5, "
                  "input: [.4, .3, .15] }] "
                  "}, input: { map: BumpMap, strength: .5, displacement: { map: VolumeTurbulence, "
                  "size: 4, octaves: 8, "
                  "noiseRatio: .5 } } }\n"
                  "  leaf: { material: Phong, diffuse: { map: Checker, color1: [.1, .4, .05], "
                  "color2: [.2, .5, .1] }, "
                  "specular: .2, shininess: .5 }\n"
                  "lights:\n- { light: Directional, direction: [.6, .5, -.6], intensity: .8 }\n"
                  "- { light: Ambient, intensity: .2 }\n");
    text_put(out, day);
    text_format(out,
                "objects:\n- { object: Plane, material: ground }\n"
                "- { object: Scatter, count: %d, seed: 3, size: [7, 7, 1], rotation: [1, 1, 3.2], "
                "least: .5, most: 1.5, "
                "objects: [{ object: Parallelogram, u: [.5, 0, 0], v: [0, .2, 0], material: leaf, "
                "transform: { "
                "translation: [0, 0, .6] } }] }\n",
                objects - 1);
}

/* A swarm of cones before the sky. */
static void put_boids(Text *out, int objects)
{
    text_put(out,
             "camera: { camera: Perspective, position: [0, -20, 0], target: [0, 0, 0], angle: 40 "
             "}\nmaterials:\n"
             "  boid: { material: Phong, diffuse: [.8, .3, .1], specular: .3, shininess: .6 }\n"
             "lights:\n- { light: Directional, direction: [.6, .5, -.6], intensity: .9, shadows: "
             "false }\n"
             "- { light: Ambient, intensity: .2 }\n");
    text_put(out, day);
    text_format(out,
                "objects:\n- { object: Scatter, count: %d, seed: 4, size: [12, 12, 12], rotation: "
                "[3.2, 3.2, 3.2], "
                "objects: [{ object: Cone, radius: .15, height: .6, material: boid }] }\n",
                objects);
}

/* Parts of a machine above the ground, in sunlight with shadows and a lamp. The last part, the
 * rotor, moves. */
static void put_helicopter(Text *out, int objects)
{
    text_put(out,
             "camera: { camera: Perspective, position: [5, -12, 6], target: [0, 0, 2], angle: 40 "
             "}\nmaterials:\n"
             "  ground: { material: Phong, diffuse: .4 }\n"
             "  paint: { material: Phong, diffuse: [.2, .3, .5], specular: .5, shininess: .8 }\n"
             "lights:\n- { light: Directional, direction: [.6, .5, -.8], intensity: .8 }\n"
             "- { light: Spot, position: [-4, -4, 7], direction: [4, 4, -5], intensity: 30 }\n");
    text_put(out, day);
    text_format(out,
                "objects:\n- { object: Plane, material: ground }\n"
                "- { object: Scatter, count: %d, seed: 5, size: [5, 2, 2], rotation: [3.2, 3.2, "
                "3.2], least: .4, most: 1, "
                "transform: { translation: [0, 0, 2] }, objects: [{ object: Box, size: [.5, .4, "
                ".3], material: paint }] }\n"
                "- { object: Box, size: [6, .2, .05], material: paint, transform: { translation: "
                "[0, 0, 3.4] } }\n",
                objects - 2);
}

void thesis_scene(Text *out, ThesisScene scene, int object_count)
{
    static void (*const writers[THESIS_SCENES])(Text *, int) = {
        [THESIS_city] = put_city,
        [THESIS_plants] = put_plants,
        [THESIS_boids] = put_boids,
        [THESIS_helicopter] = put_helicopter,
    };
    text_put(out, picture);
    writers[scene](out, object_count);
}

void thesis_spheres(Text *out)
{
    enum { SPHERES = 4000, MATERIALS = 80 };
    text_put(out, picture);
    text_put(
        out,
        "camera: { camera: Perspective, position: [0, -24, 8], target: [0, 0, 0], angle: 40 }\n"
        "lights:\n- { light: Directional, direction: [.6, .5, -.6], intensity: .9, shadows: false "
        "}\n"
        "- { light: Ambient, intensity: .2 }\nmaterials:\n");
    for (int i = 0; i < MATERIALS; i++)
        text_format(
            out,
            "  m%d: { material: Phong, diffuse: [.%d, .%d, .%d], specular: .3, shininess: .6 }\n",
            i, 1 + i % 9, 1 + i / 9, 1 + i % 7);
    text_put(out, "objects:\n");
    for (int i = 0; i < MATERIALS; i++)
        text_format(out,
                    "- { object: Scatter, count: %d, seed: %d, size: [16, 16, 6], objects: [{ "
                    "object: Sphere, radius: .2, detail: 24, "
                    "material: m%d }] }\n",
                    SPHERES / MATERIALS, i, i);
}

void thesis_lights(Text *out, int count)
{
    const double all = 60, edge = 1.25;
    const int across = (int)ceil(sqrt(count));
    text_put(out, picture);
    text_put(out,
             "camera: { camera: Perspective, position: [0, -24, 14], target: [0, -3, 0], angle: 45 "
             "}\nmaterials:\n"
             "  black: { material: Phong, diffuse: 0, specular: .3, shininess: .6 }\n"
             "  ball: { material: Phong, diffuse: [.8, .3, .2], specular: .5, shininess: .7 }\n"
             "objects:\n- { object: Plane, material: black }\n");
    for (int i = 0; i < count; i++)
        text_format(out,
                    "- { object: Sphere, radius: .3, material: ball, transform: { translation: "
                    "[%.3f, %.3f, .3] } }\n",
                    edge * (i % across - .5 * (across - 1)),
                    edge * (i / across - .5 * (across - 1)));
    text_put(out, "lights:\n");
    for (int i = 0; i < count; i++)
        text_format(
            out,
            "- { light: Point, shadows: false, intensity: %.6f, position: [%.3f, %.3f, 1.5] }\n",
            all / count, edge * (i % across - .5 * (across - 1)),
            edge * (i / across - .5 * (across - 1)));
}
