/* The C references of the library functions: double precision, written from the mathematics, not
 * from the GLSL. They are the oracle of the tests, the constant folder and `matc --eval`. A
 * reference is
 *     REFERENCE(wood) { result[0] = hypot(args[0], args[1]); }
 * args: the function's arguments one after the other, a vector as its components, a sampler as an
 * index into context->textures. */
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

/* Texels beyond the edges of a texture: repeated; mirrored, then repeated; the texel at the edge; 0
 * in all components. */
typedef enum {
    REFERENCE_REPEAT,
    REFERENCE_MIRROR,
    REFERENCE_CLAMP,
    REFERENCE_BORDER
} ReferenceWrap;

/* A texture as the reference sees it. Row 0 is the bottom row, v = 0. */
typedef struct {
    int width, height;
    int components; /* 1 or 4 */
    /* components a texel, a byte over 255 is the value; NULL when floats are set */
    const uint8_t *bytes;
    const float *floats;
    const uint16_t *words; /* a word over 65535 is the value; NULL when bytes or floats are set */
    bool srgb;             /* the first three components are decoded */
    ReferenceWrap wrap;    /* what stands beyond the edges */
    bool
        /* of a program: the wrap is its sampler's, and what fetches texels repeats them; else it is
         * every function's */
        sampler_wraps;
} ReferenceTexture;

/* Which lattice noise stands below every noise-like function. */
typedef enum {
    REFERENCE_LATTICE,       /* integer hash: glsl330 and up, essl300 */
    REFERENCE_LATTICE_FLOAT, /* float hash: glsl110 */
    REFERENCE_GROIMP,        /* GroIMP's tables */
    REFERENCE_SIMPLEX,       /* simplex lattice, integer hash */
    REFERENCE_SIMPLEX_FLOAT, /* the same with the float hash */
    /* GroIMP's tables for glsl110, where what has no table has a float hash */
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
/* The whole number towards 0, taken to [low, high]; low for what is no number. Text of the IR may
 * have any number as a count. */
static inline int whole_between(double v, int low, int high)
{
    return !(v >= low) ? low : v > high ? high : (int)v;
}
static inline double fraction(double v) { return v - floor(v); }

/* Limits of the waves: exp stays below the greatest float, log above the least normal one. Limits
 * of counts: beyond what any document has. */
#define WAVE_EXP_LIMIT  88.0
#define WAVE_EXP2_LIMIT 127.0
/* no float has such a tangent; a cosine that a GPU makes of one may be 0, though */
#define TAN_LIMIT         1e18
#define WAVE_LEAST        1.17549435e-38
#define REFERENCE_BITS    16 /* of one code, at most */
#define REFERENCE_OCTAVES 64
#define REFERENCE_STEPS   65536
#define WAVE_PHI          1.61803398874989484820

/* L_0 of semantics.md 3.1 with table offset 0 and its gradient (or NULL), and (L_0, L_8, L_16):
 * value-plus-gradient lattice noise. */
double reference_lattice(ReferenceNoise noise, const double p[3], double slope[3]);
void reference_lattice3(ReferenceNoise noise, const double p[3], double result[3]);
/* The three outputs and the gradient of each. */
void reference_lattice_slope(ReferenceNoise noise, const double p[3], double result[3],
                             double slope[3][3]);
/* GroIMP's tables: permutation of 0..65535 and 512 numbers in [-1, 1). Built once, on first use, by
 * any thread. */
const uint16_t *reference_permutation(void);
const float *reference_random_table(void);
#endif
