/* Reserved names of GLSL, as listed by the specifications of all targets. A param with a
 * reserved name is refused for every target, so that a document works for all of them; materials
 * and definitions may have any name. */
/* ctest: seconds=15 */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "compiler/matc.h"
#include "tests/value/documents.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_WORD = 64, LONGEST_DOCUMENT = 512 };

/* Chapters 3.6 of the GLSL 1.10, 3.30 and 4.50 specifications, 3.7 of GLSL ES 3.00, and what
 * GL_KHR_vulkan_glsl adds: keywords, and words reserved for future use. */
static const struct {
    const char *specification, *words;
} lists[] = {
    {"GLSL 1.10", "attribute const uniform varying break continue do for while if else in out "
                  "inout float int void "
                  "bool true false discard return "
                  "mat2 mat3 mat4 vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 sampler1D "
                  "sampler2D sampler3D "
                  "samplerCube sampler1DShadow "
                  "sampler2DShadow struct "
                  "asm class union enum typedef template this packed goto switch default inline "
                  "noinline volatile "
                  "public static extern external "
                  "interface long short double half fixed unsigned input output hvec2 hvec3 hvec4 "
                  "dvec2 dvec3 dvec4 "
                  "fvec2 fvec3 fvec4 "
                  "sampler2DRect sampler3DRect sampler2DRectShadow sizeof cast namespace using"},
    {"GLSL 3.30", "attribute const uniform varying layout centroid flat smooth noperspective break "
                  "continue do for while switch "
                  "case default if "
                  "else in out inout float int void bool true false invariant discard return mat2 "
                  "mat3 mat4 mat2x2 mat2x3 mat2x4 "
                  "mat3x2 mat3x3 "
                  "mat3x4 mat4x2 mat4x3 mat4x4 vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 "
                  "uint uvec2 uvec3 uvec4 lowp "
                  "mediump highp "
                  "precision sampler1D sampler2D sampler3D samplerCube sampler1DShadow "
                  "sampler2DShadow samplerCubeShadow "
                  "sampler1DArray "
                  "sampler2DArray sampler1DArrayShadow sampler2DArrayShadow isampler1D isampler2D "
                  "isampler3D isamplerCube "
                  "isampler1DArray "
                  "isampler2DArray usampler1D usampler2D usampler3D usamplerCube usampler1DArray "
                  "usampler2DArray sampler2DRect "
                  "sampler2DRectShadow isampler2DRect usampler2DRect samplerBuffer isamplerBuffer "
                  "usamplerBuffer sampler2DMS "
                  "isampler2DMS "
                  "usampler2DMS sampler2DMSArray isampler2DMSArray usampler2DMSArray struct "
                  "common partition active asm class union enum typedef template this packed goto "
                  "inline noinline volatile public "
                  "static extern "
                  "external interface long short double half fixed unsigned superp input output "
                  "hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 "
                  "fvec2 fvec3 "
                  "fvec4 sampler3DRect filter image1D image2D image3D imageCube iimage1D iimage2D "
                  "iimage3D iimageCube uimage1D "
                  "uimage2D uimage3D "
                  "uimageCube image1DArray image2DArray iimage1DArray iimage2DArray uimage1DArray "
                  "uimage2DArray image1DShadow "
                  "image2DShadow "
                  "image1DArrayShadow image2DArrayShadow imageBuffer iimageBuffer uimageBuffer "
                  "sizeof cast namespace using "
                  "row_major"},
    {"GLSL 4.50", "attribute const uniform varying buffer shared coherent volatile restrict "
                  "readonly writeonly atomic_uint layout "
                  "centroid flat "
                  "smooth noperspective patch sample break continue do for while switch case "
                  "default if else subroutine in out "
                  "inout float double "
                  "int void bool true false invariant precise discard return dmat2 dmat3 dmat4 "
                  "dmat2x2 dmat2x3 dmat2x4 dmat3x2 "
                  "dmat3x3 dmat3x4 "
                  "dmat4x2 dmat4x3 dmat4x4 dvec2 dvec3 dvec4 uint uvec2 uvec3 uvec4 lowp mediump "
                  "highp precision samplerCubeArray "
                  "samplerCubeArrayShadow isamplerCubeArray usamplerCubeArray image1D iimage1D "
                  "uimage1D image2D iimage2D uimage2D "
                  "image3D iimage3D "
                  "uimage3D image2DRect iimage2DRect uimage2DRect imageCube iimageCube uimageCube "
                  "imageBuffer iimageBuffer "
                  "uimageBuffer "
                  "image1DArray iimage1DArray uimage1DArray image2DArray iimage2DArray "
                  "uimage2DArray imageCubeArray iimageCubeArray "
                  "uimageCubeArray image2DMS iimage2DMS uimage2DMS image2DMSArray iimage2DMSArray "
                  "uimage2DMSArray struct "
                  "common partition active asm class union enum typedef template this resource "
                  "goto inline noinline public static "
                  "extern external "
                  "interface long short half fixed unsigned superp input output hvec2 hvec3 hvec4 "
                  "fvec2 fvec3 fvec4 sampler3DRect "
                  "filter sizeof "
                  "cast namespace using"},
    {"GLSL ES 3.00",
     "const uniform layout centroid flat smooth break continue do for while switch case default if "
     "else in out inout float int void "
     "bool true false invariant discard return lowp mediump highp precision sampler2D sampler3D "
     "samplerCube sampler2DShadow "
     "samplerCubeShadow sampler2DArray sampler2DArrayShadow isampler2D isampler3D isamplerCube "
     "isampler2DArray usampler2D usampler3D "
     "usamplerCube usampler2DArray struct "
     "attribute varying coherent volatile restrict readonly writeonly resource atomic_uint "
     "noperspective patch sample subroutine "
     "common partition active asm class union enum typedef template this goto inline noinline "
     "public "
     "static extern external "
     "interface long short double half fixed unsigned superp input output filter image1D image2D "
     "image3D imageCube iimage1D iimage2D "
     "iimage3D iimageCube uimage1D uimage2D uimage3D uimageCube image1DArray image2DArray "
     "iimage1DArray iimage2DArray uimage1DArray "
     "uimage2DArray imageBuffer iimageBuffer uimageBuffer sampler1D sampler1DShadow sampler1DArray "
     "sampler1DArrayShadow isampler1D "
     "isampler1DArray usampler1D usampler1DArray sampler2DRect sampler2DRectShadow isampler2DRect "
     "usampler2DRect samplerBuffer "
     "isamplerBuffer usamplerBuffer sampler2DMS isampler2DMS usampler2DMS sampler2DMSArray "
     "isampler2DMSArray usampler2DMSArray sizeof "
     "cast namespace using"},
    {"GL_KHR_vulkan_glsl",
     "sampler samplerShadow texture1D texture2D texture3D textureCube texture1DArray "
     "texture2DArray textureCubeArray texture2DRect "
     "textureBuffer texture2DMS texture2DMSArray itexture1D itexture2D itexture3D itextureCube "
     "itexture1DArray itexture2DArray "
     "itextureCubeArray itexture2DRect itextureBuffer itexture2DMS itexture2DMSArray utexture1D "
     "utexture2D utexture3D utextureCube "
     "utexture1DArray utexture2DArray utextureCubeArray utexture2DRect utextureBuffer "
     "utexture2DMS utexture2DMSArray subpassInput "
     "isubpassInput usubpassInput subpassInputMS isubpassInputMS usubpassInputMS"},
};
enum { LISTS = sizeof lists / sizeof *lists };

/* Chapter 8 of GLSL 1.10 and of GLSL 4.50. */
static const char functions[] =
    "radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp "
    "log exp2 log2 sqrt inversesqrt abs sign floor "
    "trunc round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan "
    "isinf floatBitsToInt floatBitsToUint "
    "intBitsToFloat uintBitsToFloat fma frexp ldexp packUnorm2x16 packSnorm2x16 "
    "packUnorm4x8 packSnorm4x8 unpackUnorm2x16 "
    "unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 packDouble2x32 unpackDouble2x32 "
    "packHalf2x16 unpackHalf2x16 length distance dot "
    "cross normalize ftransform faceforward reflect refract matrixCompMult outerProduct "
    "transpose determinant inverse lessThan "
    "lessThanEqual greaterThan greaterThanEqual equal notEqual any all not uaddCarry "
    "usubBorrow umulExtended imulExtended "
    "bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB textureSize "
    "textureQueryLod textureQueryLevels "
    "textureSamples texture textureProj textureLod textureOffset texelFetch "
    "texelFetchOffset textureProjOffset textureLodOffset "
    "textureProjLod textureProjLodOffset textureGrad textureGradOffset textureProjGrad "
    "textureProjGradOffset textureGather "
    "textureGatherOffset textureGatherOffsets texture1D texture1DProj texture1DLod "
    "texture1DProjLod texture2D texture2DProj texture2DLod "
    "texture2DProjLod texture3D texture3DProj texture3DLod texture3DProjLod textureCube "
    "textureCubeLod shadow1D shadow2D shadow1DProj "
    "shadow2DProj shadow1DLod shadow2DLod shadow1DProjLod shadow2DProjLod atomicCounter "
    "imageLoad imageStore dFdx dFdy dFdxFine dFdyFine "
    "dFdxCoarse dFdyCoarse fwidth fwidthFine fwidthCoarse interpolateAtCentroid "
    "interpolateAtSample interpolateAtOffset noise1 noise2 "
    "noise3 noise4 EmitVertex EndPrimitive barrier memoryBarrier";

/* Macros that preprocessors define, and constants. */
static const char macros[] = "GL_ES GL_core_profile GL_compatibility_profile GL_es_profile "
                             "GL_FRAGMENT_PRECISION_HIGH VULKAN GL_SPIRV "
                             "gl_FragCoord gl_FrontFacing gl_MaxDrawBuffers defined main";

/* The next word; false: none is left. */
static bool next_word(const char **at, char word[LONGEST_WORD])
{
    *at += strspn(*at, " ");
    size_t size = strcspn(*at, " ");
    snprintf(word, LONGEST_WORD, "%.*s", (int)size, *at);
    *at += size;
    return size > 0;
}

static MatcDocument *read_text(const char *text, const MatcOptions *options)
{
    return matc_read("reserved.yaml", text, strlen(text), options);
}

/* A document with a param of that name, beside maps that call many functions. */
static MatcDocument *read_param(const char *name, const MatcOptions *options)
{
    char text[LONGEST_DOCUMENT];
    snprintf(text, sizeof text,
             "material: Phong\nspecular: { map: Granite }\ndiffuse: { map: Checker, color1: { "
             "param: %s, default: 0.5 } }\n",
             name);
    return read_text(text, options);
}

static bool is_refused(const char *name)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = read_param(name, &options);
    bool refused = !matc_material_count(document);
    if (refused && !strstr(matc_diagnostics(document, MATC_JSON), "\"param_reserved\""))
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    matc_document_free(document);
    return refused;
}

static void compile_everywhere(const char *name)
{
    for (int target = 0; target < TARGET_COUNT; target++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = target_table[target].name;
        MatcDocument *document = read_param(name, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        if (!matc_ok(program))
            fail_msg("a param called %s for %s: %s", name, target_table[target].name,
                     matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        matc_document_free(document);
    }
}

static void test_words(void **state)
{
    (void)state;
    char word[LONGEST_WORD];
    int missing = 0;
    for (int list = 0; list < LISTS; list++)
        for (const char *at = lists[list].words; next_word(&at, word);)
            if (!is_refused(word)) {
                printf("%s: %s can name a param\n", lists[list].specification, word);
                missing++;
            }
    assert_int_equal(missing, 0);
}

/* The name and a parenthesis, after no letter. */
static bool calls(const char *text, const char *name)
{
    size_t size = strlen(name);
    for (const char *at = text; (at = strstr(at, name)); at += size)
        if (at[size] == '(' && (at == text || !(isalnum((unsigned char)at[-1]) || at[-1] == '_')))
            return true;
    return false;
}

/* The functions that a document's programs call are no names for uniforms. */
static void check_calls(const char *path, int target)
{
    char word[LONGEST_WORD];
    size_t size;
    const char *why;
    char *text = file_read(path, &size, &why);
    MatcOptions options;
    matc_options_init(&options);
    options.target = target_table[target].name;
    options.validate = false;
    options.precision = target % 2 ? "exact" : NULL;
    options.aa = target % 2 ? NULL : "aniso";
    MatcDocument *document = matc_read(path, text, size, &options);
    for (int material = 0; material < matc_material_count(document); material++) {
        MatcProgram *program = matc_compile(document, material, MATC_FRAGMENT, &options);
        for (const char *at = functions; matc_ok(program) && next_word(&at, word);)
            if (calls(matc_output(program, MATC_FRAGMENT, NULL), word) && !is_refused(word))
                fail_msg("%s is called by %s, and can name a param", word, path);
        matc_program_free(program);
    }
    matc_document_free(document);
    free(text);
}

static void test_functions_called(void **state)
{
    (void)state;
    DocumentList documents = documents_list(SOURCE_FOLDER);
    assert_true(documents.count > 100);
    for (int i = 0; i < documents.count; i++)
        for (int target = 0; target < TARGET_COUNT; target++)
            check_calls(documents.paths[i], target);
    documents_free(&documents);
}

static void check_all(const char *words)
{
    char word[LONGEST_WORD];
    while (next_word(&words, word))
        if (!is_refused(word))
            compile_everywhere(word);
}

static void test_functions(void **state)
{
    (void)state;
    check_all(functions);
}

static void test_macros(void **state)
{
    (void)state;
    check_all(macros);
}

/* The outputs of a program into as many targets as a layout can have. */
static void test_outputs(void **state)
{
    (void)state;
    static const char layout[] =
        "layout: wide\ntargets: [R32UI, R32UI, R32UI, R32UI, R32UI, R32UI, R32UI, R32UI]\n"
        "fields:\n  - { slot: normal, encoding: octahedral, bits: 16 }\n"
        "  - { slot: diffuse, encoding: full }\n  - { slot: emissive, encoding: full }\n"
        "  - { slot: shininess, encoding: full }\n";
    MatcOptions options;
    matc_options_init(&options);
    options.custom = matc_layout_read("wide.yaml", layout, strlen(layout), &options);
    if (!matc_layout_ok(options.custom))
        fail_msg("%s", matc_layout_diagnostics((MatcLayout *)options.custom, MATC_TEXT));
    for (char name[] = "fragment0"; name[8] <= '7'; name[8]++) {
        MatcDocument *document = read_param(name, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        if (matc_material_count(document) && !matc_ok(program))
            fail_msg("a param called %s: %s", name, matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        matc_document_free(document);
    }
    MatcDocument *document = read_param("tint", &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(program));
    assert_non_null(strstr(matc_output(program, MATC_FRAGMENT, NULL), "fragment7 ="));
    matc_program_free(program);
    matc_document_free(document);
    matc_layout_free((MatcLayout *)options.custom);
}

/* Case counts, and a word within a name does not. */
static void test_free_names(void **state)
{
    (void)state;
    static const char names[] =
        "tint roughness Float VEC3 int1 floatValue samplers x A a_b uniform1 v4 dFdX";
    char word[LONGEST_WORD];
    for (const char *at = names; next_word(&at, word);) {
        assert_false(is_refused(word));
        compile_everywhere(word);
    }
}

/* The program of a material, with that name for it and for what it refers to. */
static char *program_of(const char *name)
{
    char text[LONGEST_DOCUMENT];
    MatcOptions options;
    matc_options_init(&options);
    options.validate = true;
    snprintf(text, sizeof text,
             "materials:\n  %s: { material: Phong, diffuse: { ref: \"%s\" } }\ndefs:\n  %s: { map: "
             "Checker }\n",
             name, name, name);
    MatcDocument *document = read_text(text, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program))
        fail_msg("%s: %s", name, matc_diagnostics(document, MATC_TEXT));
    char *copy = strdup(matc_output(program, MATC_FRAGMENT, NULL));
    matc_program_free(program);
    matc_document_free(document);
    return copy;
}

static void test_materials_and_definitions(void **state)
{
    (void)state;
    char word[LONGEST_WORD], *plain = program_of("plain"), declared[LONGEST_WORD + 8];
    assert_non_null(strstr(plain, " plain = "));
    for (int list = 0; list < LISTS; list++)
        for (const char *at = lists[list].words; next_word(&at, word);) {
            if (!strcmp(word, "true") || !strcmp(word, "false"))
                continue; /* no names in YAML */
            char *other = program_of(word);
            snprintf(declared, sizeof declared, " %s = ", word);
            if (strstr(strstr(other, "void main"), declared))
                fail_msg("a temporary is called %s:\n%s", word, other);
            free(other);
        }
    free(plain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_functions_called),
        cmocka_unit_test(test_functions),
        cmocka_unit_test(test_macros),
        cmocka_unit_test(test_outputs),
        cmocka_unit_test(test_free_names),
        cmocka_unit_test(test_materials_and_definitions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
