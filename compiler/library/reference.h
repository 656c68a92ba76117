/* C references of the library functions in double precision, written from the mathematics, not
 * from the GLSL. The tests, the constant folder and `matc --eval` use them as oracle. Example:
 *     REFERENCE(wood) { result[0] = hypot(args[0], args[1]); }
 * args: the function's arguments in order, a vector as its components, a sampler as an index
 * into context->textures. */
#ifndef MATC_REFERENCE_H
#define MATC_REFERENCE_H
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#ifndef M_PI
#define M_PI   3.14159265358979323846
#define M_E    2.71828182845904523536
#define M_LN10 2.30258509299404568402
#endif

/* Texels outside a texture: repeated; mirrored, then repeated; the edge texel; 0 in all
 * components. */
typedef enum {
    REFERENCE_REPEAT,
    REFERENCE_MIRROR,
    REFERENCE_CLAMP,
    REFERENCE_BORDER
} ReferenceWrap;

/* A texture that references sample. Row 0 is the bottom row, v = 0. */
typedef struct {
    int width, height;
    int components; /* number of components, 1 or 4 */
    /* `components` bytes per texel; value = byte / 255; NULL if floats are set */
    const uint8_t *bytes;
    const float *floats;
    /* a word per component; value = word / 65535; NULL if bytes or floats are set */
    const uint16_t *words;
    bool srgb;          /* the first three components are sRGB-encoded */
    ReferenceWrap wrap; /* treatment of texels outside the texture */
    bool
        /* The wrap is the sampler's, and texel fetches repeat; otherwise every function wraps. */
        sampler_wraps;
} ReferenceTexture;

/* The lattice noise on which every noise-like function is built. */
typedef enum {
    REFERENCE_LATTICE,       /* integer hash: glsl330 and up, essl300 */
    REFERENCE_LATTICE_FLOAT, /* float hash: glsl110 */
    REFERENCE_GROIMP,        /* uses the tables of GroIMP */
    REFERENCE_SIMPLEX,       /* simplex lattice, integer hash */
    REFERENCE_SIMPLEX_FLOAT, /* simplex lattice, float hash */
    /* GroIMP's tables for glsl110; functions without a table use the float hash */
    REFERENCE_GROIMP_FLOAT,
    REFERENCE_NOISE_COUNT
} ReferenceNoise;

typedef struct {
    ReferenceNoise noise;
    const ReferenceTexture *textures;
} ReferenceContext;

#define REFERENCE(name)                                                                            \
    void reference_##name(const void *context, const double *args, double *result)

static inline double clamp(double v, double low, double high)
{
    return v < low ? low : v > high ? high : v;
}
/* Truncates v toward 0 and clamps it to [low, high]; NaN gives low. IR text may have any number
 * as a count. */
static inline int whole_between(double v, int low, int high)
{
    return !(v >= low) ? low : v > high ? high : (int)v;
}
static inline double fraction(double v) { return v - floor(v); }

/* Argument limits of the waves: exp stays below the largest float, log above the smallest normal
 * float. Limits of counts exceed any document's. */
#define WAVE_EXP_LIMIT  88.0
#define WAVE_EXP2_LIMIT 127.0
/* no float has a larger tangent; a GPU's cosine of a float may be 0, though */
#define TAN_LIMIT         1e18
#define WAVE_LEAST        1.17549435e-38
#define REFERENCE_BITS    16 /* max bits of a code */
#define REFERENCE_OCTAVES 64
#define REFERENCE_STEPS   65536
#define WAVE_PHI          1.61803398874989484820

/* Returns the value-plus-gradient lattice noise: L_0 of semantics.md 3.1 with table offset 0 and
 * its gradient (slope may be NULL), and (L_0, L_8, L_16). */
double reference_lattice(ReferenceNoise noise, const double p[3], double slope[3]);
void reference_lattice3(ReferenceNoise noise, const double p[3], double result[3]);
/* Computes the three outputs and the gradient of each output. */
void reference_lattice_slope(ReferenceNoise noise, const double p[3], double result[3],
                             double slope[3][3]);
/* GroIMP's tables: a permutation of 0..65535 and 512 numbers in [-1, 1). Built on first use;
 * safe for threads. */
const uint16_t *reference_permutation(void);
const float *reference_random_table(void);
#endif
