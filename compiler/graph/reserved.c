/* Reserved names: a param cannot have them, since its uniform would clash with GLSL's words or
 * with declarations of matc. Temporaries avoid the words too; emit_name.c names temporaries so
 * that they differ from the uniforms. */
#include "compiler/graph/reserved.h"
#include "compiler/base/session.h"
#include "grammar/tables.h"
#include "compiler/library/chunk.h"
#include "compiler/base/text.h"
#include <string.h>

/* Keywords of every target, including words reserved for future use. Types are listed by
 * is_type(). */
static const char keywords[] = "active asm atomic_uint attribute bool break buffer case cast "
                               "centroid class coherent common const continue "
                               "default discard do double else enum extern external false filter "
                               "fixed flat float for goto half highp if in "
                               "inline inout input int interface invariant isubpassInput layout "
                               "long lowp mediump namespace noinline "
                               "noperspective out output packed partition patch precise precision "
                               "public readonly resource restrict return "
                               "row_major sample sampler shared short sizeof smooth static struct "
                               "subpassInput subroutine superp switch template "
                               "this true typedef uint uniform union unsigned using usubpassInput "
                               "varying void volatile while writeonly";

/* Built-in functions: GLSL ES forbids redeclaring their names, even if they are not called. */
static const char functions[] = "EmitVertex EndPrimitive abs acos acosh all any asin asinh atan "
                                "atanh atomicCounter barrier bitCount "
                                "bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp cos "
                                "cosh cross dFdx dFdxCoarse dFdxFine dFdy "
                                "dFdyCoarse dFdyFine degrees determinant distance dot equal exp "
                                "exp2 faceforward findLSB findMSB floatBitsToInt "
                                "floatBitsToUint floor fma fract frexp ftransform fwidth "
                                "fwidthCoarse fwidthFine greaterThan greaterThanEqual "
                                "imageLoad imageStore imulExtended intBitsToFloat "
                                "interpolateAtCentroid interpolateAtOffset interpolateAtSample "
                                "inverse inversesqrt isinf isnan ldexp length lessThan "
                                "lessThanEqual log log2 matrixCompMult max memoryBarrier "
                                "min mix mod modf noise1 noise2 noise3 noise4 normalize not "
                                "notEqual outerProduct packDouble2x32 packHalf2x16 "
                                "packSnorm2x16 packSnorm4x8 packUnorm2x16 packUnorm4x8 pow radians "
                                "reflect refract round roundEven shadow1D "
                                "shadow1DLod shadow1DProj shadow1DProjLod shadow2D shadow2DLod "
                                "shadow2DProj shadow2DProjLod sign sin sinh "
                                "smoothstep sqrt step tan tanh texelFetch texelFetchOffset texture "
                                "textureGather textureGatherOffset "
                                "textureGatherOffsets textureGrad textureGradOffset textureLod "
                                "textureLodOffset textureOffset textureProj "
                                "textureProjGrad textureProjGradOffset textureProjLod "
                                "textureProjLodOffset textureProjOffset textureQueryLevels "
                                "textureQueryLod textureSamples textureSize transpose trunc "
                                "uaddCarry uintBitsToFloat umulExtended "
                                "unpackDouble2x32 unpackHalf2x16 unpackSnorm2x16 unpackSnorm4x8 "
                                "unpackUnorm2x16 unpackUnorm4x8 usubBorrow";

/* Names that matc declares, or that glslang defines for Vulkan. */
static const char own[] = "Constants Draw Levels Material Surface VULKAN carpenter fragment0 "
                          "fragment1 fragment2 fragment3 "
                          "fragment4 fragment5 fragment6 fragment7 main matc normal p position st "
                          "tangentU tangentV texcoord";

/* Returns true if a list of words separated by spaces contains a word. */
static bool has_word(const char *list, const char *word)
{
    const size_t size = strlen(word);
    for (const char *at = list; (at = strstr(at, word)); at += size)
        if ((at == list || at[-1] == ' ') && (!at[size] || at[size] == ' '))
            return true;
    return false;
}

/* Returns the rest of the name after `start`; NULL if the name has another prefix. */
static const char *behind(const char *name, const char *start)
{
    while (*start && *start == *name)
        start++, name++;
    return *start ? NULL : name;
}

/* sampler2D, iimageCubeArray, utextureBuffer: an optional letter for integers, the kind, and the
 * dimensions. */
static bool is_opaque_type(const char *name)
{
    static const char *const kinds[] = {"sampler", "image", "texture", "subpassInput"};
    static const char *const forms[] = {"1D", "2D", "3D", "Cube", "Buffer", "Shadow", "MS"};
    for (int kind = 0; kind < 4; kind++) {
        const char *rest = behind(name, kinds[kind]);
        if (!rest && (name[0] == 'i' || name[0] == 'u'))
            rest = behind(name + 1, kinds[kind]);
        for (int form = 0; rest && form < 7; form++)
            if (behind(rest, forms[form]))
                return true;
    }
    return false;
}

static bool is_size(char c) { return c >= '2' && c <= '4'; }

/* Returns true for vector and matrix types: vec2, dvec3, mat4, dmat2x3. */
static bool is_number_type(const char *name)
{
    const char *start = *name && strchr("bdfhiu", *name) ? name + 1 : name,
               *rest = behind(start, "vec");
    if (rest)
        return is_size(rest[0]) && !rest[1];
    rest = behind(*name == 'd' ? name + 1 : name, "mat");
    return rest && is_size(rest[0]) &&
           (!rest[1] || (rest[1] == 'x' && is_size(rest[2]) && !rest[3]));
}

static bool is_type(const char *name) { return is_opaque_type(name) || is_number_type(name); }

static bool is_letter(char c) { return text_is_alphanumeric(c) || c == '_'; }

/* Returns true if a text calls or defines a function of that name. */
static bool calls(const char *text, const char *name)
{
    size_t size = strlen(name);
    for (const char *at = text; (at = strstr(at, name)); at += size)
        if (at[size] == '(' && (at == text || !is_letter(at[-1])))
            return true;
    return false;
}

/* Returns true if the name is a function of the library or a helper, in any variant. */
static bool is_function(const char *name)
{
    for (int i = 0; i < chunk_count; i++)
        if (calls(chunk_table[i].body, name))
            return true;
    return false;
}

bool reserved_is_word(const char *name)
{
    /* `GL_` belongs to the preprocessor; matc appends numbers to the others */
    static const char *const prefixes[] = {
        "gl_",           "GL_",           "matc_", "imageTexture", "carpenterTexture",
        "smooth3DInput", "laplace3DInput"};
    if (has_word(keywords, name) || has_word(functions, name) || has_word(own, name) ||
        is_type(name))
        return true;
    for (int i = 0; i < INPUT_COUNT; i++)
        /* fast path: most names differ in the first letter */
        if (*input_table[i].glsl == *name && !strcmp(input_table[i].glsl, name))
            return true;
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++)
        if (behind(name, prefixes[i]))
            return true;
    return strstr(name, "__") || strlen(name) > LIMIT_NAME;
}

bool reserved_has(const char *name) { return reserved_is_word(name) || is_function(name); }
