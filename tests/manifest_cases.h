/* Documents of test_manifest.c, and the expected manifests of batches of them. */
#ifndef TESTS_MANIFEST_CASES_H
#define TESTS_MANIFEST_CASES_H
#include "compiler/matc.h"

enum { MAX_OPTIONS = 4, MAX_DOCUMENTS = 3 };

/* -- documents */

/* A quote, a backslash and a byte that is not UTF-8. */
#define ODD "say \"one\" a\\b \xff.yaml"

typedef struct {
    const char *name, *text;
} Document;

static const Document documents[] = {
    {ODD, "materials:\n"
          "  red:\n"
          "    material: Phong\n"
          "    diffuse: { map: Checker, color1: [0.125, 0.25, 0.375], color2: [0.5, 0.625, 0.75], "
          "input:\n"
          "      { map: UVTransform, offsetU: 0.25, scaleU: 0.5 } }\n"
          "    ambient: { map: Checker, color1: 0.5, color2: 0.75 }\n"
          "    specular: { param: gloss, default: 0.25 }\n"
          "    emissive: { map: ImageMap, image: 'ti\"le\\s.png' }\n"
          "  blue:\n"
          "    material: Phong\n"
          "    diffuse: { map: Checker, color1: [0.125, 0.875, 0.375], color2: [1, 0.625, 0.75], "
          "input:\n"
          "      { map: UVTransform, offsetU: 0.75, scaleU: 0.5 } }\n"
          "    ambient: { map: Checker, color1: 0.625, color2: 0.375 }\n"
          "    specular: { param: gloss, default: 0.25 }\n"
          "    emissive: { map: ImageMap, image: tiles.png }\n"},
    {"glass.yaml", "material: Phong\ndiffuse: 0.5\ntransparency: 0.75\n"},
    {"plain.yaml", "material: Phong\ndiffuse: [0.1, 0.2, 0.3]\n"},
    {"holes.yaml", "material: Phong\ntransparency: { map: Checker, color1: 0, color2: 1 }\n"},
    {"carpenter.yaml", "material: Phong\ndiffuse: { map: Carpenter }\n"},
    {"noise.yaml",
     "material: Phong\n"
     "diffuse: { map: Checker, input: { map: Turbulence }, color1: 0.5, color2: 1 }\n"},
    {"moved.yaml", "material: Phong\n"
                   "displacement: { map: Checker, color1: 0.125, color2: 0.25 }\n"},
    {"bad.yaml", "material: Phong\ndiffuse: { map: Checkers }\n"},
};

/* -- manifests without keys and hashes; ' stands for a JSON quote, @ for the documents' folder */

typedef struct {
    const char *options[MAX_OPTIONS], *documents[MAX_DOCUMENTS], *manifest;
} Case;

#define HEAD(target) "{'matc': '" MATC_VERSION "', 'target': '" target "', "
/* std140: a vec3 begins at a multiple of 16, a float fills its fourth place, a vec2 begins at a
 * multiple of 8, and the size is a multiple of 16. */
#define BLOCK                                                                                      \
    "'constants': {'block': 'Constants', 'size': 48, 'members': ["                                 \
    "{'name': 'diffuse_checker_constant', 'type': 'vec3', 'offset': 0},"                           \
    "{'name': 'ambient_checker_constant', 'type': 'float', 'offset': 12},"                         \
    "{'name': 'diffuse_checker_constant2', 'type': 'vec3', 'offset': 16},"                         \
    "{'name': 'ambient_checker_constant2', 'type': 'float', 'offset': 28},"                        \
    "{'name': 'diffuse_uvTransform_constant', 'type': 'vec2', 'offset': 32}]}"

static const Case cases[] = {
    /* Two materials share a program; the shadow pass of opaque materials is the depth program,
     * with five uses in all. */
    {{"--layout=integer", "--pass=gbuffer,shadow,depth",
      "--emit=glsl,vertex,reflect,unpack,layout"},
     {ODD, "glass.yaml"},
     HEAD("glsl330") "'layout': {'name': 'integer', 'normals': 'eye', 'bytes': 48, 'cases': [0],"
                     "'targets': ['RGBA32UI', 'RGBA32UI', 'RGBA32UI'],"
                     "'unpack': 'integer.unpack.glsl', 'file': 'integer.layout.yaml'},"
                     "'programs': ["
                     "{'pass': 'gbuffer', 'fragment': 'red.frag', 'vertex': 'red.vert', "
                     "'reflection': 'red.json',"
                     "'materials': 2, " BLOCK "},"
                     "{'pass': 'depth', 'fragment': 'red.depth.frag', 'vertex': 'red.depth.vert',"
                     "'reflection': 'red.depth.json', 'materials': 5},"
                     "{'pass': 'gbuffer', 'fragment': 'glass.frag', 'vertex': 'glass.vert',"
                     "'reflection': 'glass.json', 'materials': 1},"
                     "{'pass': 'shadow', 'fragment': 'glass.shadow.frag', 'vertex': "
                     "'glass.shadow.vert',"
                     "'reflection': 'glass.shadow.json', 'materials': 1}],"
                     "'materials': ["
                     "{'name': 'red', 'source': '@/say \\\"one\\\" a\\\\b \xEF\xBF\xBD.yaml', "
                     "'opacity': 'opaque',"
                     "'programs': [{'pass': 'gbuffer', 'program': 0,"
                     "'constants': [[0.5, 0.625, 0.75], [0.75], [0.125, 0.25, 0.375], [0.5], "
                     "[0.25, 0]],"
                     "'uniforms': {'gloss': [0.25]}, 'textures': {'imageTexture0': "
                     "'@/ti\\\"le\\\\s.png'}},"
                     "{'pass': 'shadow', 'program': 1}, {'pass': 'depth', 'program': 1}]},"
                     "{'name': 'blue', 'source': '@/say \\\"one\\\" a\\\\b \xEF\xBF\xBD.yaml', "
                     "'opacity': 'opaque',"
                     "'programs': [{'pass': 'gbuffer', 'program': 0,"
                     "'constants': [[1, 0.625, 0.75], [0.375], [0.125, 0.875, 0.375], [0.625], "
                     "[0.75, 0]],"
                     "'uniforms': {'gloss': [0.25]}, 'textures': {'imageTexture0': '@/tiles.png'}},"
                     "{'pass': 'shadow', 'program': 1}, {'pass': 'depth', 'program': 1}]},"
                     "{'name': 'glass', 'source': '@/glass.yaml', 'opacity': 'transparent',"
                     "'programs': [{'pass': 'gbuffer', 'program': 2},"
                     "{'pass': 'shadow', 'program': 3}, {'pass': 'depth', 'program': 1}]}]}"},
    /* Passes in the requested order; none writes a layout. A material with varying opacity has
     * its own shadow program. */
    {{"--pass=depth,shadow"},
     {"holes.yaml", "plain.yaml"},
     HEAD("glsl330") "'programs': [{'pass': 'depth', 'fragment': 'holes.depth.frag', 'materials': "
                     "3},"
                     "{'pass': 'shadow', 'fragment': 'holes.shadow.frag', 'materials': 1}],"
                     "'materials': [{'name': 'holes', 'source': '@/holes.yaml', 'opacity': "
                     "'varying',"
                     "'programs': [{'pass': 'depth', 'program': 0}, {'pass': 'shadow', 'program': "
                     "1}]},"
                     "{'name': 'plain', 'source': '@/plain.yaml', 'opacity': 'opaque',"
                     "'programs': [{'pass': 'depth', 'program': 0}, {'pass': 'shadow', 'program': "
                     "0}]}]}"},
    /* A file of every kind. */
    {{"--target=glsl450", "--normals=world",
      "--emit=glsl,vertex,tessvertex,tesscontrol,tesseval,geometryvertex,geometry,compute,displace,"
      "reflect,spirv,ir,dot"},
     {"moved.yaml"},
     HEAD(
         "glsl450") "'layout': {'name': 'compact', 'normals': 'world', 'bytes': 16, 'targets': "
                    "['RGBA32UI'],"
                    "'cases': [0]}, 'programs': [{'pass': 'gbuffer', 'fragment': 'moved.frag',"
                    "'vertex': 'moved.vert', 'reflection': 'moved.json', 'spirv': 'moved.spv', "
                    "'ir': 'moved.ir',"
                    "'dot': 'moved.dot', 'tessvertex': 'moved.tess.vert', 'tesscontrol': "
                    "'moved.tesc',"
                    "'tesseval': 'moved.tese', 'geometryvertex': 'moved.geom.vert', 'geometry': "
                    "'moved.geom',"
                    "'displace': 'moved.displace.glsl', 'compute': 'moved.comp', 'materials': 1}],"
                    "'materials': [{'name': 'moved', 'source': '@/moved.yaml', 'opacity': 'opaque',"
                    "'programs': [{'pass': 'gbuffer', 'program': 0}]}]}"},
    /* SPIR-V: the fragment program is under `spirv`. */
    {{"--target=spirv", "--emit=glsl,vertex", "--pass=shadow"},
     {"plain.yaml"},
     HEAD("spirv") "'programs': [{'pass': 'depth', 'spirv': 'plain.spv', 'vertex': "
                   "'plain.vert.spv', 'materials': 1}],"
                   "'materials': [{'name': 'plain', 'source': '@/plain.yaml', 'opacity': 'opaque',"
                   "'programs': [{'pass': 'shadow', 'program': 0}]}]}"},
    /* Noise tables belong to the program. */
    {{"--target=glsl110", "--noise=groimp", "--pass=value"},
     {"noise.yaml"},
     HEAD(
         "glsl110") "'programs': [{'pass': 'value', 'fragment': 'noise.frag', 'materials': 1,"
                    "'tables': ['matc_permutation', 'matc_random', 'matc_xor']}],"
                    "'materials': [{'name': 'noise', 'source': '@/noise.yaml', 'opacity': 'opaque',"
                    "'programs': [{'pass': 'value', 'program': 0}]}]}"},
    /* A plane has the layout; one of its cases is read. */
    {{"--pass=plane"},
     {"glass.yaml"},
     HEAD("glsl330") "'layout': {'name': 'compact', 'normals': 'eye', 'bytes': 16, 'targets': "
                     "['RGBA32UI'],"
                     "'cases': [1]}, 'programs': [{'pass': 'plane', 'fragment': 'glass.frag', "
                     "'materials': 1}],"
                     "'materials': [{'name': 'glass', 'source': '@/glass.yaml', 'opacity': "
                     "'transparent',"
                     "'programs': [{'pass': 'plane', 'program': 0}]}]}"},
    /* A texture that matc makes belongs to the material. */
    {{"--textures=@/ktx", "--pass=value"},
     {"carpenter.yaml"},
     HEAD(
         "glsl330") "'programs': [{'pass': 'value', 'fragment': 'carpenter.frag', 'materials': 1}],"
                    "'materials': [{'name': 'carpenter', 'source': '@/carpenter.yaml', 'opacity': "
                    "'opaque',"
                    "'programs': [{'pass': 'value', 'program': 0,"
                    "'textures': {'carpenterTexture0': "
                    "'@/ktx/carpenter.carpenterTexture0.ktx'}}]}]}"},
};

#undef HEAD
#undef BLOCK
#endif
