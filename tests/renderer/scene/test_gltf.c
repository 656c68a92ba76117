/* glTF files with materials: their documents, unsupported content and its place; their meshes in
 * parts; objects of a scene. */
#include "grammar/lobe_table.h"
#include "tests/gltf_folder.h"
#include "compiler/document.h"
#include "runtime/mesh_import/model.h"

#define MESH                                                                                       \
    "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"              \
    "\"primitives\":["                                                                             \
    "{\"attributes\":{\"POSITION\":0},\"material\":1},{\"attributes\":{\"POSITION\":1},"           \
    "\"material\":0},"                                                                             \
    "{\"attributes\":{\"POSITION\":2}}]}],\"buffers\":[{\"uri\":\"corners.bin\",\"byteLength\":"   \
    "108}],"                                                                                       \
    "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":36},{\"buffer\":0,"            \
    "\"byteOffset\":36,"                                                                           \
    "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":72,\"byteLength\":36}],\"accessors\":["       \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,-1],"     \
    "\"max\":[1,0,0]},"                                                                            \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[2,0,-1],"     \
    "\"max\":[3,0,0]},"                                                                            \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[4,0,-1],"     \
    "\"max\":[5,0,0]}]"
#define PICTURES                                                                                   \
    "\"textures\":[{\"source\":0,\"sampler\":0},{\"source\":1}],\"samplers\":[{\"wrapS\":33071,"   \
    "\"wrapT\":33071,"                                                                             \
    "\"magFilter\":9728}],\"images\":[{\"uri\":\"tiles%20a.png\"},{\"bufferView\":0,\"mimeType\":" \
    "\"image/png\"}]"
#define HEAD               "{\"asset\":{\"version\":\"2.0\"}," MESH "," PICTURES ",\n\"materials\":"
#define FILE_OF(materials) HEAD materials "}"
static const char head[] = HEAD;

static const char bark[] =
    FILE_OF("[{\"name\":\"Old "
            "bark!\",\"alphaMode\":\"MASK\",\"doubleSided\":true,\"emissiveFactor\":[1,0.5,0],"
            "\"normalTexture\":{\"index\":0,\"scale\":0.5},\"pbrMetallicRoughness\":{"
            "\"roughnessFactor\":0.75,"
            "\"metallicRoughnessTexture\":{\"index\":0},\"baseColorTexture\":{\"index\":0,"
            "\"extensions\":{\"KHR_"
            "texture_transform\":"
            "{\"offset\":[0.25,0.5],\"scale\":[2,4]}}}},\"extensions\":{\"KHR_materials_emissive_"
            "strength\":{"
            "\"emissiveStrength\":3}}},"
            "{\"name\":\"Old bark?\"}]");

static void materials_are_a_document(void **state)
{
    (void)state;
    static const char wanted[] =
        "materials: \n  Old_bark_: \n    material: glTF\n    roughnessFactor: 0.75\n"
        "    metallicRoughnessTexture: \n      map: ImageMap\n      image: tiles a.png\n      "
        "colorspace: linear\n"
        "      address: clamp\n      bilinearFiltering: false\n    baseColorTexture: \n      map: "
        "ImageMap\n"
        "      image: tiles a.png\n      colorspace: srgb\n      address: clamp\n      "
        "bilinearFiltering: false\n"
        "      input: \n        map: UVTransform\n        scaleU: 2\n        scaleV: 4\n        "
        "offsetU: -0.125\n"
        "        offsetV: 0.875\n    alphaMode: \"MASK\"\n    emissiveFactor: \n      - 1\n      - "
        "0.5\n      - 0\n"
        "    normalTexture: \n      map: ImageMap\n      image: tiles a.png\n      colorspace: "
        "linear\n"
        "      address: clamp\n      bilinearFiltering: false\n    normalScale: 0.5\n    "
        "emissiveStrength: 3\n"
        "  Old_bark__2: \n    material: glTF\n  default: \n    material: glTF\n";
    MatcOptions options;
    char path[128];
    matc_options_init(&options);
    MatcDocument *document = matc_read(path_of("bark.gltf", path), bark, sizeof bark - 1, &options);
    assert_string_equal(matc_diagnostics(document, MATC_TEXT), "");
    assert_int_equal(matc_material_count(document), 3);
    assert_string_equal(matc_tree_text(document), wanted);
    matc_document_free(document);
}

/* Unsupported content is reported with its place in the file. */
static void what_is_not_read_is_reported(void **state)
{
    (void)state;
    static const struct {
        const char *materials, *reported;
        size_t lines; /* number of diagnostics, if it is not 0 */
    } cases[] = {
        {"[{\"extensions\":{\"EXT_gloss\":{\"gloss\":1}}}, {\"extensions\":{\"EXT_gloss\":{}}}]",
         "2:29: warning: EXT_gloss is ignored", 1},
        {"[{\"emissiveStrength\":1,\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.4,\"sheen\":2}}"
         "}]",
         "2:15: warning: emissiveStrength is ignored", 2},
        {"[{}],\"extensionsRequired\":[\"KHR_materials_unlit\",\"EXT_gloss\"]",
         "2:62: error: the file requires the extension EXT_gloss, which is not supported", 1},
        {"[{}],\"animations\":[{}]", "2:18: warning: animations is ignored", 1},
        {"[{}],\"skins\":[{\"joints\":[0],\"byteOffset\":-4}]",
         "2:54: error: byteOffset expects a number of bytes, not the number -4", 1},
        {"[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1}}}]",
         "1:861: error: cannot read the image 'case.gltf#/images/1': the format is not PNG, JPEG, "
         "OpenEXR or BMP",
         0},
        {"[{\"normalTexture\":{\"index\":0,\"texCoord\":1}}]",
         "2:53: warning: the direction of a further set of texture coordinates, of normals, is "
         "ignored",
         0},
        {"[{\"normalTexture\":{\"index\":2}}]",
         "2:40: error: the list textures of the glTF file has no item 2", 0},
        {"[{\"normalTexture\":{\"index\":-1}}]",
         "2:40: error: the list textures of the glTF file has no item -1", 0},
        {"[{\"normalTexture\":7}]", "2:31: warning: a texture without an image is ignored", 0},
        {"[{\"thicknessTexture\":{\"index\":0}}]", "2:15: warning: thicknessTexture is ignored", 0},
        {"[{\"alphaMode\":\"GLASS\"}]",
         "2:27: error: alphaMode expects OPAQUE, MASK or BLEND, not 'GLASS'", 0},
        {"[{\"occlusionTexture\":{\"index\":0}}]",
         "2:34: warning: occlusionTexture of a glTF is only approximated", 0},
        {"[7, null, \"a\"]", "", 0},
        {"7", "", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcOptions options;
        char path[128], text[4096];
        matc_options_init(&options);
        snprintf(text, sizeof text, "%s%s}", head, cases[i].materials);
        MatcDocument *document =
            matc_read(path_of("case.gltf", path), text, strlen(text), &options);
        const char *reported = matc_diagnostics(document, MATC_TEXT),
                   *behind = reported + (*reported ? strlen(path) + 1 : 0);
        if (strncmp(behind, cases[i].reported, strlen(cases[i].reported)) != 0 ||
            !*cases[i].reported != !*reported)
            fail_msg("%s: %s", cases[i].materials, reported);
        size_t lines = 0;
        for (const char *at = reported; (at = strstr(at, "case.gltf:")); at++)
            lines++;
        if (cases[i].lines)
            assert_int_equal(lines, cases[i].lines);
        matc_document_free(document);
    }
}

static void meshes_are_in_parts(void **state)
{
    (void)state;
    char path[128], error[1024] = "";
    ModelPart *parts;
    Shape whole;
    int count;
    if (!model_read_parts(path_of("bark.gltf", path), &parts, &count, error, sizeof error))
        fail_msg("%s", error);
    assert_int_equal(count, 3);
    assert_true(model_read_in_place(path, &whole, error, sizeof error));
    assert_int_equal(whole.index_count, 9);
    for (int i = 0; i < 3; i++) {
        const float first[] = {2, 0, 4};
        const Shape *shape = &parts[i].shape;
        assert_int_equal(parts[i].material, i < 2 ? i : MODEL_NO_MATERIAL);
        assert_int_equal(shape->index_count, 3);
        assert_int_equal(shape->vertex_count, 3);
        float least = 9;
        for (int k = 0; k < 3; k++) {
            assert_true(shape->indices[k] < 3);
            least = fminf(least, shape->vertices[shape->indices[k]].position[0]);
        }
        if (!(fabsf(least - first[i]) < 1e-6f))
            fail_msg("part %d begins at %g", i, (double)least);
        shape_free(&parts[i].shape);
    }
    shape_free(&whole);
    free(parts);
}

static void a_mesh_has_the_files_materials(void **state)
{
    (void)state;
    char text[1024];
    MatcDocument *document;
    snprintf(text, sizeof text,
             RED "objects:\n- { object: Mesh, file: %s/bark.gltf }\n- { object: Mesh, file: "
                 "%s/bark.gltf, material: red }\n"
                 "- { object: Mesh, file: %s/bark.gltf, transform: { scale: 2 } }\n"
                 "- { object: Box, material: { file: %s/bark.gltf, material: Old_bark_ } }\n",
             folder, folder, folder, folder);
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, 8);
    assert_int_equal(scene->mesh_count, 4); /* each part once, and the whole */
    assert_int_equal(scene->material_count, 4);
    for (int i = 0; i < 3; i++) {
        const SceneObject *object = &scene->objects[i];
        assert_int_equal(scene->materials[object->material].index, i);
        assert_int_equal(scene->objects[4 + i].material, object->material);
        assert_int_equal(scene->objects[4 + i].mesh, object->mesh);
        assert_int_equal(scene->meshes[object->mesh].part, i < 2 ? i : MODEL_NO_MATERIAL);
    }
    assert_int_equal(scene->meshes[scene->objects[3].mesh].shape.index_count, 9);
    assert_int_equal(scene->objects[7].material, scene->objects[0].material);
    assert_int_equal(scene_models(scene) & ~(MODEL_EMITS | MODEL_RELIEF),
                     (1u << MODEL_Phong) | 1u << MODEL_Principled);
    forget(scene, document);
    assert_fault("objects:\n- { object: Mesh, file: nothing.gltf }\n", NULL);
    snprintf(text, sizeof text, "objects:\n- { object: Mesh, file: %s/broken.gltf }\n", folder);
    assert_fault(text, NULL);
}

/* Vertex colors multiply the base color, and pictures may use the second set of coordinates: as
 * attributes of the mesh. */
static void meshes_have_colors(void **state)
{
    (void)state;
    static const char painted[] =
        "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{\"attributes\":{"
        "\"POSITION\":0,\"COLOR_0\":1},\"material\":0}]}],"
        "\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"tiles%20a.png\"}],"
        "\"materials\":[{\"name\":\"a\",\"pbrMetallicRoughness\":{"
        "\"baseColorTexture\":{\"index\":0,\"texCoord\":1}}},{\"name\":\"b\","
        "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}]}";
    char path[128];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document =
        matc_read(path_of("painted.gltf", path), painted, sizeof painted - 1, &options);
    assert_string_equal(matc_diagnostics(document, MATC_TEXT), "");
    const MatcNumbers seen =
        matc_eval_slot(document, 0, "u=.9 v=.9 @uv1.x=.1 @uv1.y=.3 @color.r=.5", &options);
    const MatcNumbers plain = matc_eval_slot(document, 1, "u=.1 v=.3", &options);
    assert_null(seen.fault);
    assert_true(plain.component[0] > 0 &&
                fabs(seen.component[0] - plain.component[0] / 2) < 1e-12 &&
                fabs(seen.component[1] - plain.component[1]) < 1e-12);
    matc_document_free(document);
}

/* Values at u = .1, v = .3 of materials, by hand from the specifications:
 * - KHR_texture_transform: offset (0, 1), rotation pi / 2 and scale .5 show the lower left quarter
 *   of the image, turned clockwise by 90 degrees. With v down, (u', v') = (.5 v, 1 - .5 u), so
 *   that (.1, .7) becomes (.35, .95): u = .35, v = .05 from below.
 * - KHR_materials_unlit: the base color is emitted; the slot has the factor alpha.
 * - KHR_materials_pbrSpecularGlossiness: roughness is 1 - glossiness, F0 the specular color. */
#define SET    "\"index\":0,\"texCoord\":1"
#define TURNED "\"rotation\":1.5707963267948966,\"offset\":[0,1],\"scale\":[0.5,0.5]"
#define BASE   "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{"
#define MOVED  "\"extensions\":{\"KHR_texture_transform\":{"
static void values_are_those_of_the_specification(void **state)
{
    (void)state;
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"textures\":[{\"source\":0}],\"images\":[{\"uri\":"
        "\"tiles%20a."
        "png\"}],\"materials\":[" BASE "\"index\":0}}}," BASE "\"index\":0," MOVED TURNED
        "}}}}}," BASE SET "," MOVED "\"texCoord\":0," TURNED "}}}}}," BASE SET "," MOVED
        "\"texCoord\":3}}}}},"
        "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,0.125,0.75]},\"alphaMode\":"
        "\"BLEND\",\"emissiveFactor\":[1,1,1],\"extensions\":{\"KHR_materials_unlit\":{}}},"
        "{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[0.8,0.4,0.2,"
        "1],"
        "\"specularFactor\":[0.9,0.45,0.45],\"glossinessFactor\":0.75}}},"
        "{\"emissiveFactor\":[0.5,0.25,0.125],\"extensions\":{\"KHR_materials_emissive_strength\":{"
        "\"emissiveStrength\":8}}}]}";
    static const struct {
        int material;
        const char *point;
        int same; /* material whose value at `same_point` is the same; -1: `wanted` */
        const char *same_point;
        const char *slot;
        double wanted[3];
    } rows[] = {
        {1, "u=.1 v=.3", 0, "u=.35 v=.05", "diffuse", {0}},
        {2, "u=.1 v=.3 @uv1.x=.9", 0, "u=.35 v=.05", "diffuse", {0}},
        {3, "u=.9 v=.9 @uv3.x=.1 @uv3.y=.3", 0, "u=.1 v=.3", "diffuse", {0}},
        {4, "u=.1 v=.3", -1, NULL, "emissive", {.375, .1875, .09375}},
        {4, "u=.1 v=.3", -1, NULL, "diffuse", {0, 0, 0}},
        {4, "u=.1 v=.3", -1, NULL, "reflectance", {0}},
        {4, "u=.1 v=.3", -1, NULL, "alpha", {.75}},
        {5, "u=.1 v=.3", -1, NULL, "diffuse", {.8, .4, .2}},
        {5, "u=.1 v=.3", -1, NULL, "roughness", {.25}},
        {5, "u=.1 v=.3", -1, NULL, "reflectance", {.9}},
        {5, "u=.1 v=.3", -1, NULL, "specular", {1, .5, .5}},
        {6, "u=.1 v=.3", -1, NULL, "emissive", {4, 2, 1}},
    };
    char path[128];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document =
        matc_read(path_of("values.gltf", path), text, sizeof text - 1, &options);
    assert_int_equal(matc_error_count(document), 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        options.slot = rows[i].slot;
        const MatcNumbers value =
            matc_eval_slot(document, rows[i].material, rows[i].point, &options);
        const MatcNumbers other =
            matc_eval_slot(document, rows[i].same < 0 ? 0 : rows[i].same,
                           rows[i].same < 0 ? "" : rows[i].same_point, &options);
        const double *wanted = rows[i].same < 0 ? rows[i].wanted : other.component;
        for (int k = 0; k < value.components && k < 3; k++)
            if (value.fault || !(fabs(value.component[k] - wanted[k]) < 1e-9))
                fail_msg("row %zu: %g, not %g", i, value.component[k], wanted[k]);
    }
    matc_document_free(document);
}

static int prepare(void **state)
{
    (void)state;
    char path[128];
    if (!mkdtemp(folder))
        return -1;
    write_file("corners.bin", &corners, sizeof corners);
    write_file("bark.gltf", bark, sizeof bark - 1);
    write_file("broken.gltf", bark, sizeof bark / 2);
    return symlink(SOURCE_FOLDER "/examples/tiles.png", path_of("tiles a.png", path));
}

static int clean(void **state)
{
    (void)state;
    static const char *const names[] = {"corners.bin", "bark.gltf", "broken.gltf", "tiles a.png"};
    char path[128];
    for (int i = 0; i < 4; i++)
        unlink(path_of(names[i], path));
    return rmdir(folder);
}

/* Ways to pictures below a node. */
typedef struct {
    int linear, srgb, centred;
} Pictures;

static void count_pictures(const Node *node, Pictures *found)
{
    if (node && node->kind == KIND_ImageMap) {
        const bool srgb =
            node_param(node, P_ImageMap_colorspace)->number[0] == KEYWORD_ColorSpace_srgb;
        found->srgb += srgb, found->linear += !srgb;
        found->centred += node_param(node, P_ImageMap_texels)->number[0] == KEYWORD_Texels_centre;
    }
    for (int i = 0; node && i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_node)
            count_pictures(value->node, found);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            count_pictures(value->items->item[k].input, found);
    }
}

/* glTF 2.0, section 3.9: the pictures of base color, emission, sheen color and specular color
 * are sRGB, all others linear; 3.8.4: a texel is a point in the middle of its square. In
 * UsdPreviewSurface and MaterialX (0, 0) and (1, 1) are corners of the picture, not of texels,
 * and a separate node sets color spaces. Documents do the same: a map's own setting comes first,
 * and pictures of other materials follow the document. */
static void documents_have_pictures_as_files_do(void **state)
{
    (void)state;
#define P "{ map: ImageMap, image: 'tiles a.png' }"
    enum { NONE, SOME, ALL };
    static const struct {
        const char *text;
        bool linear, srgb;
        int centred;
    } rows[] = {
        {"material: glTF\nbaseColorTexture: " P, false, true, ALL},
        {"material: glTF\nemissiveFactor: 1\nemissiveTexture: " P, false, true, ALL},
        {"material: glTF\nsheenColorFactor: 1\nsheenColorTexture: " P, false, true, ALL},
        {"material: glTF\nspecularColorTexture: " P, false, true, ALL},
        {"material: glTF\nmetallicRoughnessTexture: " P, true, false, ALL},
        {"material: glTF\nnormalTexture: " P, true, false, ALL},
        {"material: glTF\nclearcoatFactor: 1\nclearcoatRoughnessFactor: "
         "1\nclearcoatRoughnessTexture: " P,
         true, false, ALL},
        {"material: glTF\nemissiveFactor: { map: UVTransform, scaleU: 2, input: " P " }", false,
         true, ALL},
        {"material: glTF\nemissiveFactor: 1\nemissiveTexture: { map: Checker, input: " P " }", true,
         false, ALL},
        {"material: glTF\nnormalTexture: { map: ImageMap, image: 'tiles a.png', texels: corner }",
         true, false, NONE},
        {"material: glTF\nemissiveFactor: 1\nemissiveTexture: { map: ImageMap, image: 'tiles "
         "a.png', colorspace: linear }",
         true, false, ALL},
        {"colors: srgb\nmaterial: glTF\nmetallicRoughnessTexture: " P, true, false, ALL},
        {"material: Mix\na: { material: glTF, emissiveFactor: 1, emissiveTexture: " P
         " }\nb: { material: Principled, emission: 1, emissionColor: " P " }",
         true, true, SOME},
        {"material: StandardSurface\nemission: 1\nemission_color: " P, true, false, ALL},
        {"colors: srgb\nmaterial: StandardSurface\nemission: 1\nemission_color: " P, false, true,
         ALL},
        {"material: StandardSurface\nspecular_roughness: " P, true, false, ALL},
        {"material: StandardSurface\nspecular_roughness: { map: ImageMap, image: 'tiles a.png', "
         "texels: corner }",
         true, false, NONE},
        {"material: UsdPreview\ndiffuseColor: " P, true, false, ALL},
        {"material: UsdPreview\nnormal: { map: NormalMap, normal: " P " }", true, false, ALL},
        {"material: Principled\nbaseColor: " P, true, false, NONE},
        {"material: Phong\ndiffuse: " P, true, false, NONE},
        {"colors: srgb\nmaterial: Phong\ndiffuse: " P, false, true, NONE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Pictures found = {0};
        MatcOptions options;
        char path[128];
        matc_options_init(&options);
        MatcDocument *document =
            matc_read(path_of("rows.yaml", path), rows[i].text, strlen(rows[i].text), &options);
        if (!document->graph)
            fail_msg("%s: %s", rows[i].text, matc_diagnostics(document, MATC_TEXT));
        count_pictures(document->graph->materials[0].node, &found);
        const int all = found.linear + found.srgb, centred = found.centred == all ? ALL
                                                             : found.centred      ? SOME
                                                                                  : NONE;
        if (!all || (found.linear > 0) != rows[i].linear || (found.srgb > 0) != rows[i].srgb ||
            centred != rows[i].centred)
            fail_msg("%s: %d linear, %d sRGB, %d centred", rows[i].text, found.linear, found.srgb,
                     found.centred);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(materials_are_a_document),
                                       cmocka_unit_test(what_is_not_read_is_reported),
                                       cmocka_unit_test(values_are_those_of_the_specification),
                                       cmocka_unit_test(meshes_are_in_parts),
                                       cmocka_unit_test(meshes_have_colors),
                                       cmocka_unit_test(a_mesh_has_the_files_materials),
                                       cmocka_unit_test(documents_have_pictures_as_files_do)};
    return cmocka_run_group_tests(tests, prepare, clean);
}
