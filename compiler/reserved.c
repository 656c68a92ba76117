/* Names that a param cannot have, since its uniform would clash with GLSL's words or with what matc declares. Temporaries are
 * not among them: emit.c names those around the uniforms. */
#include "link.h"
#include "resolve.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Sorted: keywords of every target, the built-in functions that matc's code calls, and matc's own names. */
static const char *const words[] = {
    "Draw", "Material", "Surface", "abs", "acos", "acosh", "active", "all", "any", "asin", "asinh", "asm", "atan",
    "atanh", "atomic_uint", "attribute", "bool", "break", "buffer", "bvec2", "bvec3", "bvec4", "carpenter", "case",
    "cast", "ceil", "centroid", "clamp", "class", "coherent", "common", "const", "continue", "cos", "cosh", "cross",
    "dFdx", "dFdy", "default", "degrees", "determinant", "discard", "distance", "dmat2", "dmat3", "dmat4", "do",
    "dot", "double", "dvec2", "dvec3", "dvec4", "else", "enum", "equal", "exp", "exp2", "extern", "external",
    "faceforward", "false", "filter", "fixed", "flat", "float", "floatBitsToInt", "floatBitsToUint", "floor", "for",
    "fract", "fragment0", "fragment1", "fragment2", "fragment3", "fvec2", "fvec3", "fvec4", "fwidth", "goto",
    "greaterThan", "greaterThanEqual", "half", "highp", "hvec2", "hvec3", "hvec4", "if", "iimage2D", "iimage3D",
    "image1D", "image2D", "image3D", "in", "inline", "inout", "input", "int", "intBitsToFloat", "interface",
    "invariant", "inverse", "inversesqrt", "isampler2D", "isampler3D", "isinf", "isnan", "ivec2", "ivec3", "ivec4",
    "layout", "length", "lessThan", "lessThanEqual", "log", "log2", "long", "lowp", "main", "mat2", "mat2x2",
    "mat2x3", "mat2x4", "mat3", "mat3x2", "mat3x3", "mat3x4", "mat4", "mat4x2", "mat4x3", "mat4x4", "matc",
    "matrixCompMult", "max", "mediump", "min", "mix", "mod", "modf", "namespace", "noinline", "noperspective",
    "normal", "normalize", "not", "notEqual", "out", "outerProduct", "output", "p", "packHalf2x16", "packSnorm2x16",
    "packUnorm2x16", "packed", "partition", "patch", "position", "pow", "precise", "precision", "public", "radians",
    "readonly", "reflect", "refract", "resource", "restrict", "return", "round", "roundEven", "row_major", "sample",
    "sampler1D", "sampler2D", "sampler2DRect", "sampler2DShadow", "sampler3D", "sampler3DRect", "samplerBuffer",
    "samplerCube", "shared", "short", "sign", "sin", "sinh", "sizeof", "smooth", "smoothstep", "sqrt", "st", "static",
    "step", "struct", "subroutine", "superp", "switch", "tan", "tangentU", "tangentV", "tanh", "template", "texcoord",
    "texelFetch", "texelFetchOffset", "texture", "texture2D", "textureGrad", "textureGradOffset", "textureLod",
    "textureLodOffset", "textureOffset", "textureProj", "textureProjGrad", "textureProjGradOffset", "textureProjLod",
    "textureProjLodOffset", "textureProjOffset", "textureSize", "this", "transpose", "true", "trunc", "typedef",
    "uimage2D", "uint", "uintBitsToFloat", "uniform", "union", "unpackHalf2x16", "unpackSnorm2x16", "unpackUnorm2x16",
    "unsigned", "usampler2D", "usampler3D", "using", "uvec2", "uvec3", "uvec4", "varying", "vec2", "vec3", "vec4",
    "void", "volatile", "while", "writeonly",
};

static int by_word(const void *name, const void *word) { return strcmp(name, *(const char *const *)word); }

static bool is_letter(char c) { return isalnum((unsigned char)c) || c == '_'; }

/* Whether a text calls or defines a function of that name. */
static bool calls(const char *text, const char *name)
{
    size_t size = strlen(name);
    for (const char *at = text; (at = strstr(at, name)); at += size)
        if (at[size] == '(' && (at == text || !is_letter(at[-1])))
            return true;
    return false;
}

/* The functions of the library, helpers too, in whichever variant. */
static bool is_function(const char *name)
{
    for (int i = 0; i < chunk_count; i++)
        if (calls(chunk_table[i].body, name))
            return true;
    return false;
}

static bool has_prefix(const char *name, const char *prefix) { return !strncmp(name, prefix, strlen(prefix)); }

bool name_is_reserved(const char *name)
{
    if (bsearch(name, words, sizeof words / sizeof *words, sizeof *words, by_word) || is_function(name))
        return true;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (!strcmp(input_table[i].glsl, name))
            return true;
    return has_prefix(name, "gl_") || has_prefix(name, "matc_") || has_prefix(name, "imageTexture") ||
           has_prefix(name, "carpenterTexture") || has_prefix(name, "smooth3DInput") || has_prefix(name, "laplace3DInput") ||
           strstr(name, "__") || strlen(name) > LIMIT_NAME;
}
