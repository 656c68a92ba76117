/* glTF files with embedded pictures and triangles: .glb, data: URIs, buffers; wrong lengths;
 * their meshes in parts. */
#include "tests/gltf_folder.h"
#include "runtime/mesh_import/model.h"
#include "runtime/mesh_import/model_number.h"

#define MESH                                                                                       \
    "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"              \
    "\"primitives\":["                                                                             \
    "{\"attributes\":{\"POSITION\":0},\"material\":1},{\"attributes\":{\"POSITION\":1},"           \
    "\"material\":0},"                                                                             \
    "{\"attributes\":{\"POSITION\":2}}]}],\"buffers\":[{\"byteLength\":108}],"                     \
    "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":36},{\"buffer\":0,"            \
    "\"byteOffset\":36,"                                                                           \
    "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":72,\"byteLength\":36}],\"accessors\":["       \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,-1],"     \
    "\"max\":[1,0,0]},"                                                                            \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[2,0,-1],"     \
    "\"max\":[3,0,0]},"                                                                            \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[4,0,-1],"     \
    "\"max\":[5,0,0]}]"

/* A .glb of these chunks, with correct lengths unless others are given. */
typedef struct {
    const char *json;
    const void *binary; /* NULL: none */
    size_t binary_size;
    uint32_t version, length, json_length; /* 0: as it is */
    bool late;                             /* its JSON comes second */
} Binary;

static size_t make_binary(const Binary *b, unsigned char *to)
{
    const uint32_t json = (uint32_t)strlen(b->json), binary = (uint32_t)b->binary_size;
    const uint32_t size = 20 + json + (b->binary ? 8 + binary : 0);
    const uint32_t head[] = {0x46546C67, b->version ? b->version : 2, b->length ? b->length : size},
                   first[] = {b->json_length ? b->json_length : json, 0x4E4F534A},
                   second[] = {binary, 0x004E4942};
    unsigned char *at = to + 12, *last = to + 12 + 8 + (b->late ? binary : json);
    memcpy(to, head, sizeof head);
    memcpy(b->late ? last : at, first, 8);
    memcpy((b->late ? last : at) + 8, b->json, json);
    if (b->binary) {
        memcpy(b->late ? at : last, second, 8);
        memcpy((b->late ? at : last) + 8, b->binary, binary);
    }
    return size;
}

static void put_base64(char *to, const unsigned char *from, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3, to += 4) {
        const unsigned bits = from[i] << 16 | (i + 1 < size ? from[i + 1] : 0) << 8 |
                              (i + 2 < size ? from[i + 2] : 0);
        for (int k = 0; k < 4; k++)
            to[k] = i + (size_t)k > size ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    *to = 0;
}

#define PAINTED(rest)                                                                              \
    "{\"asset\":{\"version\":\"2.0\"},\"materials\":[{\"pbrMetallicRoughness\":{"                  \
    "\"baseColorTexture\":{\"index\":0}}}]"                                                        \
    ","                                                                                            \
    "\"textures\":[{\"source\":0}]," rest "}"

static unsigned char bytes[1 << 16], tiles[1 << 13];
static size_t tiles_size;

/* Value of a document's picture at a point, or the first fault, as text. */
static const char *shown_by(const char *name, const void *text, size_t size, char shown[512])
{
    char path[128];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    write_file(name, text, size);
    MatcDocument *document = matc_read(path_of(name, path), text, size, &options);
    const char *fault = strstr(matc_diagnostics(document, MATC_TEXT), "error: ");
    const MatcNumbers seen =
        fault ? (MatcNumbers){0} : matc_eval_slot(document, 0, "u=.3 v=.8", &options);
    snprintf(shown, 512, "%s", fault ? fault + 7 : "");
    shown[strcspn(shown, "\n")] = 0;
    if (!fault)
        snprintf(shown, 512, "%.9f %.9f %.9f", seen.component[0], seen.component[1],
                 seen.component[2]);
    matc_document_free(document);
    unlink(path);
    return shown;
}

/* A picture in the binary chunk, in a buffer that is a file or a data: URI, or in a data: URI
 * itself, equals that of a separate file. */
static void pictures_are_within(void **state)
{
    (void)state;
    static char data[4 * sizeof tiles / 3 + 64], text[sizeof data + 1024];
    char file[512], shown[512], view[256];
    const char of_file[] = PAINTED("\"images\":[{\"uri\":\"tiles%20a.png\"}]");
    shown_by("file.gltf", of_file, sizeof of_file - 1, file);
    assert_true(file[0] == '0');
    snprintf(view, sizeof view,
             "\"images\":[{\"bufferView\":1}],\"bufferViews\":[{},{\"buffer\":0,\"byteOffset\":%d,"
             "\"byteLength\":%zu}],"
             "\"buffers\":[{",
             0, tiles_size);
    snprintf(text, sizeof text, PAINTED("%s\"byteLength\":%zu}]"), view, tiles_size);
    Binary binary = {.json = text, .binary = tiles, .binary_size = tiles_size};
    assert_string_equal(shown_by("a.glb", bytes, make_binary(&binary, bytes), shown), file);
    snprintf(text, sizeof text, PAINTED("%s\"uri\":\"tiles%%20a.png\"}]"), view);
    assert_string_equal(shown_by("a.gltf", text, strlen(text), shown), file);
    put_base64(data, tiles, tiles_size);
    snprintf(text, sizeof text, PAINTED("%s\"uri\":\"data:;base64,%s\"}]"), view, data);
    assert_string_equal(shown_by("a.gltf", text, strlen(text), shown), file);
    snprintf(text, sizeof text, PAINTED("\"images\":[{\"uri\":\"data:image/png;base64,%s\"}]"),
             data);
    assert_string_equal(shown_by("a.gltf", text, strlen(text), shown), file);
    write_file("b.gltf", text, strlen(text)); /* and by a document of one's own */
    static const char own[] = "material: glTF\nbaseColorTexture: { map: ImageMap, image: "
                              "\"b.gltf#/images/0\", colorspace: srgb, texels: "
                              "centre }\n";
    assert_string_equal(shown_by("a.yaml", own, sizeof own - 1, shown), file);
    unlink(path_of("b.gltf", text));
}

static void broken_binaries_are_reported(void **state)
{
    (void)state;
    static const char fine[] =
        PAINTED("\"images\":[{\"bufferView\":0}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
                "4}],\"buffers\":[{\"byteLength\":4}]");
#define PICTURE(images, views, buffers)                                                            \
    {                                                                                              \
        .json = PAINTED("\"images\":[" images "],\"bufferViews\":[" views                          \
                        "],\"buffers\":[" buffers "]"),                                            \
        .binary = "abcd", .binary_size = 4                                                         \
    }
#define CANNOT "cannot read the image 'x.glb#/images/0': "
    static const struct {
        Binary binary;
        const char *reported;
    } cases[] = {
        {{.json = fine, .binary = "abcd", .binary_size = 4},
         CANNOT "the format is not PNG, JPEG, OpenEXR or BMP"},
        {{.json = fine, .version = 1},
         "invalid .glb file: it has version 1; only version 2 is supported"},
        {{.json = fine, .length = 1u << 31},
         "invalid .glb file: its header says 2147483648 bytes, and it has 2"},
        {{.json = fine, .json_length = 0xFFFFFFF8},
         "invalid .glb file: the chunk at byte 12 is longer than the file"},
        {{.json = fine, .binary = "abcd", .binary_size = 4, .late = true},
         "invalid .glb file: its first chunk, and no other, is JSON"},
        {{.json = fine}, CANNOT "its buffer has no uri, and the file no binary chunk"},
        {PICTURE("{\"bufferView\":1}", "", ""), CANNOT "its bufferView does not exist"},
        {PICTURE("{\"bufferView\":0}", "{\"buffer\":-1,\"byteLength\":4}", "{}"),
         CANNOT "its bufferView names no buffer"},
        {PICTURE("{\"bufferView\":0}", "{\"buffer\":0}", "{}"),
         CANNOT "its bufferView exceeds its buffer"},
        {PICTURE("{\"bufferView\":0}",
                 "{\"buffer\":0,\"byteOffset\":4294967295,\"byteLength\":4294967295}", "{}"),
         CANNOT "its bufferView exceeds"},
        {PICTURE("{\"bufferView\":0}", "{\"buffer\":0,\"byteOffset\":1.5,\"byteLength\":1}", "{}"),
         "byteOffset expects a number of bytes, not the number 1.5"},
        {PICTURE("{\"bufferView\":0}", "{\"buffer\":0,\"byteLength\":4}", "{\"uri\":[]}"),
         CANNOT "its buffer's uri is not a string"},
        {PICTURE("{\"bufferView\":0}", "{\"buffer\":0,\"byteLength\":4}", "{\"uri\":\"gone.bin\"}"),
         CANNOT "No such file"},
        {PICTURE("{\"uri\":\"data:image/png;base64,iV!O\"}", "", ""),
         CANNOT "its data: address is not base64"},
        {PICTURE("{\"uri\":\"data:image/png,iVO\"}", "", ""),
         CANNOT "its data: address has no ;base64,"},
        {PICTURE("{}", "", ""), CANNOT "the file has neither its uri nor its bufferView"},
        {PICTURE("7", "", ""), CANNOT "the file has neither its uri nor its bufferView"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char shown[512];
        const size_t size = make_binary(&cases[i].binary, bytes);
        if (strncmp(shown_by("x.glb", bytes, size, shown), cases[i].reported,
                    strlen(cases[i].reported)) != 0)
            fail_msg("%zu: %s, not %s", i, shown, cases[i].reported);
    }
    const Binary whole = {.json = fine, .binary = "abcd", .binary_size = 4};
    const size_t size = make_binary(&whole, bytes);
    for (size_t cut = 0; cut < size; cut++) { /* anywhere */
        char shown[512];
        if (strncmp(shown_by("x.glb", bytes, cut, shown), "invalid .glb file: ", 14) != 0)
            fail_msg("cut at %zu: %s", cut, shown);
    }
    static const char
        own[] = "material: Phong\ndiffuse: { map: ImageMap, image: \"none.gltf#/images/7\" }\n",
        none[] = "material: Phong\ndiffuse: { map: ImageMap, image: \"none.gltf#/images/\" }\n";
    char shown[512];
    assert_string_equal(shown_by("a.yaml", own, sizeof own - 1, shown),
                        "cannot read the image 'none.gltf#/images/7': the list images of the file "
                        "has no such item");
    assert_string_equal(
        shown_by("a.yaml", none, sizeof none - 1, shown),
        "cannot read the image 'none.gltf#/images/': the list images of the file has no such item");
}

/* Twelve pictures in twelve buffers that are one file, with a name that is escaped in one of
 * them. */
enum { TWELVE = 12 };

static char *count_reads(void *user, const char *path, size_t *size, const char **why)
{
    (void)path, (void)why;
    ++*(int *)user;
    char *copy = malloc(tiles_size + 1);
    assert_non_null(copy);
    memcpy(copy, tiles, tiles_size);
    copy[tiles_size] = 0;
    *size = tiles_size;
    return copy;
}

static void a_file_is_read_once(void **state)
{
    (void)state;
    char *text = NULL;
    size_t size;
    int reads = 0;
    FILE *out = open_memstream(&text, &size);
    const char *const lists[] = {"\"source\":%d", "\"bufferView\":%d",
                                 "\"buffer\":%d,\"byteLength\":%zu"};
    fputs("{\"asset\":{\"version\":\"2.0\"},\"materials\":[{}", out);
    for (int i = 0; i < TWELVE; i++)
        fprintf(out, ",{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":%d}}}", i);
    for (int k = 0; k < 3; k++) {
        fprintf(out, "],\"%s\":[", k == 0 ? "textures" : k == 1 ? "images" : "bufferViews");
        for (int i = 0; i < TWELVE; i++) {
            fputs(i ? ",{" : "{", out);
            fprintf(out, lists[k], i, tiles_size);
            fputc('}', out);
        }
    }
    fputs("],\"buffers\":[", out);
    for (int i = 0; i < TWELVE; i++)
        fprintf(out, "%s{\"uri\":\"%s.bin\",\"byteLength\":%zu}", i ? "," : "", i ? "a" : "%61",
                tiles_size);
    fputs("]}", out);
    fclose(out);
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    options.read_file = count_reads;
    options.user = &reads;
    MatcDocument *document = matc_read("x.gltf", text, size, &options);
    if (matc_error_count(document))
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    assert_int_equal(reads, 1);
    matc_document_free(document);
    free(text);
}

/* Views of buffers of one file and one length are of the first of them, which assimp reads when it
 * meets them. */
static void meshes_read_a_buffer_once(void **state)
{
    (void)state;
    static const char json[] =
        "{\"buffers\":[{\"uri\":\"a.bin\",\"byteLength\":8},{\"uri\":\"b.bin\",\"byteLength\":8},"
        "{\"uri\":\"a.bin\",\"byteLength\":8},{\"uri\":\"a.bin\",\"byteLength\":4},{},{}],"
        "\"bufferViews\":[{\"buffer\":2},{\"buffer\":1},{\"buffer\":3},{\"buffer\":5},{\"buffer\":"
        "9}]}";
    char *made = model_number_text(json, sizeof json - 1);
    assert_non_null(made);
    assert_non_null(strstr(made, "\"bufferViews\":[{\"buffer\":0},{\"buffer\":1},{\"buffer\":3},{"
                                 "\"buffer\":5},{\"buffer\":9}]"));
    free(made);
}

/* A mesh of a .glb has its materials, too. */
static void binary_meshes_have_materials(void **state)
{
    (void)state;
    char text[256], path[128];
    MatcDocument *document;
    static const char json[] = "{\"asset\":{\"version\":\"2.0\"}," MESH
                               ",\"materials\":[{\"name\":\"a\"},{\"name\":\"a\"}]}";
    const Binary binary = {.json = json, .binary = &corners, .binary_size = sizeof corners};
    write_file("mesh.glb", bytes, make_binary(&binary, bytes));
    snprintf(text, sizeof text, "objects:\n- { object: Mesh, file: %s/mesh.glb }\n", folder);
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, 3);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(scene->materials[scene->objects[i].material].index, i);
        assert_int_equal(scene->meshes[scene->objects[i].mesh].part, i < 2 ? i : MODEL_NO_MATERIAL);
    }
    forget(scene, document);
    unlink(path_of("mesh.glb", path));
}

static int prepare(void **state)
{
    (void)state;
    char path[128];
    FILE *file = fopen(SOURCE_FOLDER "/examples/tiles.png", "rb");
    tiles_size = file ? fread(tiles, 1, sizeof tiles, file) : 0;
    if (!file || fclose(file) || !tiles_size || tiles_size == sizeof tiles || !mkdtemp(folder))
        return -1;
    write_file("none.gltf", PAINTED("\"images\":[]"), sizeof PAINTED("\"images\":[]") - 1);
    return symlink(SOURCE_FOLDER "/examples/tiles.png", path_of("tiles a.png", path));
}

static int clean(void **state)
{
    (void)state;
    char path[128];
    unlink(path_of("none.gltf", path));
    unlink(path_of("tiles a.png", path));
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_within), cmocka_unit_test(broken_binaries_are_reported),
        cmocka_unit_test(a_file_is_read_once), cmocka_unit_test(meshes_read_a_buffer_once),
        cmocka_unit_test(binary_meshes_have_materials)};
    return cmocka_run_group_tests(tests, prepare, clean);
}
