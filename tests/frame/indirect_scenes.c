/* The documents of indirect_scenes.h. */
#include "tests/frame/indirect_scenes.h"
#include <stdio.h>

const char indirect_scenes_box[] =
    "camera: { camera: Perspective, position: [0, -4.25, 1], target: [0, 0, 1], angle: 39 }\n"
    "lights: [{ light: Point, position: [.1, -.4, 1.5], intensity: 1, shadows: none "
    "}]\nmaterials:\n"
    "  white: { material: Phong, diffuse: .75, specular: 0 }\n  red: { material: Phong, diffuse: "
    "[.63, .06, .05], "
    "specular: 0 }\n"
    "  green: { material: Phong, diffuse: [.15, .48, .09], specular: 0 }\nobjects:\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, "
    "-.05] } }\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, "
    "2.05] } }\n"
    "- { object: Box, size: [2.2, .1, 2.2], material: white, transform: { translation: [0, 1.05, "
    "1] } }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: red, transform: { translation: [-1.05, 0, 1] "
    "} }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: green, transform: { translation: [1.05, 0, "
    "1] } }\n"
    "- { object: Box, size: [.6, .6, 1.2], material: white, transform: { translation: [-.35, .3, "
    ".6], rotation: [0, 0, "
    ".3] } }\n"
    "- { object: Box, size: [.6, .6, .6], material: white, transform: { translation: [.37, -.35, "
    ".3], rotation: [0, 0, "
    "-.3] } }\n";

void indirect_scenes_bunny(const char *mesh, const char *lift, char text[INDIRECT_SCENES_TEXT])
{
    snprintf(text, INDIRECT_SCENES_TEXT,
             "camera: { camera: Perspective, position: [.6, -4.6, 2.6], target: [0, 0, .7], angle: "
             "40 }\n"
             "materials: { m: { material: Phong, diffuse: .6 } }\nobjects:\n"
             "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, "
             "-.1] } }\n"
             "- { object: Mesh, file: %s, material: m, transform: { rotation: [1.5707963, 0, 0], "
             "translation: [0, 0, "
             "%s] } }\n",
             mesh, lift);
}
