/* Names that a param cannot have, since its uniform would clash with GLSL's words or with what matc declares. Temporaries are
 * not among them: emit.c names those around the uniforms. */
#include "link.h"
#include "resolve.h"
#include <stdlib.h>
#include <string.h>

/* Sorted: keywords of every target, the built-in functions that matc's code calls, and matc's own names. */
static const char *const words[] = {
    "Draw", "Material", "Surface", "abs", "acos", "active", "all", "any", "asin", "asm", "atan", "atomic_uint",
    "attribute", "bool", "break", "buffer", "bvec2", "bvec3", "bvec4", "carpenter", "case", "cast", "ceil",
    "centroid", "clamp", "class", "coherent", "common", "const", "continue", "cos", "cross", "default", "degrees",
    "discard", "dmat2", "dmat3", "dmat4", "do", "dot", "double", "dvec2", "dvec3", "dvec4", "else", "enum", "exp",
    "exp2", "extern", "external", "false", "filter", "fixed", "flat", "float", "floor", "for", "fract", "fragment0",
    "fragment1", "fragment2", "fragment3", "fvec2", "fvec3", "fvec4", "goto", "half", "highp", "hvec2", "hvec3",
    "hvec4", "if", "iimage2D", "iimage3D", "image1D", "image2D", "image3D", "in", "inline", "inout", "input", "int",
    "interface", "invariant", "inversesqrt", "isampler2D", "isampler3D", "ivec2", "ivec3", "ivec4", "layout",
    "length", "log", "log2", "long", "lowp", "main", "mat2", "mat2x2", "mat2x3", "mat2x4", "mat3", "mat3x2", "mat3x3",
    "mat3x4", "mat4", "mat4x2", "mat4x3", "mat4x4", "max", "mediump", "min", "mix", "mod", "namespace", "noinline",
    "noperspective", "normal", "normalize", "not", "out", "output", "p", "packed", "partition", "patch", "position",
    "pow", "precise", "precision", "public", "radians", "readonly", "resource", "restrict", "return", "row_major",
    "sample", "sampler1D", "sampler2D", "sampler2DRect", "sampler2DShadow", "sampler3D", "sampler3DRect",
    "samplerBuffer", "samplerCube", "shared", "short", "sign", "sin", "sizeof", "smooth", "smoothstep", "sqrt", "st",
    "static", "step", "struct", "subroutine", "superp", "switch", "tan", "tangentU", "tangentV", "template",
    "texcoord", "texelFetch", "texture", "texture2D", "this", "true", "typedef", "uimage2D", "uint", "uniform",
    "union", "unsigned", "usampler2D", "usampler3D", "using", "uvec2", "uvec3", "uvec4", "varying", "vec2", "vec3",
    "vec4", "void", "volatile", "while", "writeonly",
};

static int by_word(const void *name, const void *word) { return strcmp(name, *(const char *const *)word); }

/* "lattice.groimp.110" is of the function lattice. */
static bool is_chunk(const char *name)
{
    for (int i = 0; i < chunk_count; i++) {
        size_t size = strcspn(chunk_table[i].name, ".");
        if (strlen(name) == size && !strncmp(name, chunk_table[i].name, size))
            return true;
    }
    return false;
}

static bool has_prefix(const char *name, const char *prefix) { return !strncmp(name, prefix, strlen(prefix)); }

bool name_is_reserved(const char *name)
{
    if (bsearch(name, words, sizeof words / sizeof *words, sizeof *words, by_word) || is_chunk(name))
        return true;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (!strcmp(input_table[i].glsl, name))
            return true;
    return has_prefix(name, "gl_") || has_prefix(name, "matc_") || has_prefix(name, "imageTexture") ||
           has_prefix(name, "carpenterTexture") || has_prefix(name, "smooth3DInput") || has_prefix(name, "laplace3DInput") ||
           strstr(name, "__") || strlen(name) > LIMIT_NAME;
}
