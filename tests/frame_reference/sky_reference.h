/* Reference of a sky's light reflected by a Principled surface without layers, as integrals in
 * double: multiple importance sampling of the sky's radiance and of GGX's visible normals,
 * combined by the balance heuristic (Veach and Guibas 1995). Implements the lobe by its
 * definition and takes the sky as a function; independent of matc. */
#ifndef MATC_SKY_REFERENCE_H
#define MATC_SKY_REFERENCE_H

typedef void (*SkyReferenceLight)(const void *sky, const double way[3], double rgb[3]);

/* Cells of equal solid angle, by height and azimuth, and the cumulative light of the cells
 * before each. */
enum {
    SKY_REFERENCE_HEIGHTS = 96,
    SKY_REFERENCE_TURNS = 192,
    SKY_REFERENCE_CELLS = SKY_REFERENCE_HEIGHTS * SKY_REFERENCE_TURNS
};
typedef struct {
    SkyReferenceLight light;
    const void *sky;
    double before[SKY_REFERENCE_CELLS + 1];
} SkyReference;

/* `albedos` by the cosine in 64 steps, and `mean`, are set by sky_reference_surface(). */
typedef struct {
    double base[3], metalness, roughness, reflectance;
    double albedos[65][2], mean[2];
} SkyReferenceSurface;

void sky_reference_open(SkyReference *reference, SkyReferenceLight light, const void *sky);
void sky_reference_surface(SkyReferenceSurface *surface);
/* pi times the BRDF and the light's cosine, for unit directions, with the normal along z. */
void sky_reference_lobe(const SkyReferenceSurface *surface, const double eye[3],
                        const double way[3], double lobe[3]);
/* Light sent to the eye, for a normal and a direction to the eye in the world; with `count`
 * samples of either kind. */
void sky_reference_sent(const SkyReference *reference, const SkyReferenceSurface *surface,
                        double ways[2][3], int samples, double rgb[3]);
#endif
