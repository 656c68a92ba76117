#include "tests/frame_reference/glass_ray.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <string.h>

/* Offsets a point slightly from the surface, to the light's side. */
static double leave(const SceneLight *light, const double point[3], const double microfacet[3],
                    Ray *ray)
{
    const double distance = shadow_way_to(light, point, ray->way);
    const double off = (reference_dot(microfacet, ray->way) < 0 ? -1 : 1) * 3e-5;
    for (int i = 0; i < 3; i++)
        ray->at[i] = point[i] + off * microfacet[i];
    return distance;
}

/* Materials as text, and their transmittances: a constant; by the cells of a checker, odd ones
 * first; by the side, front first. */
typedef struct {
    const char *text;
    enum { CONSTANT, CELLS, CUBES, SIDES } by;
    double scale[3], through[2][3];
} Glass;
static const Glass glasses[] = {
    {"m: { material: Phong, diffuse: .5 }", CONSTANT, {0}, {{0}}},
    {"round: { material: Phong, diffuse: [.2, .5, .3], transparency: { map: Checker, color1: 1, "
     "color2: 0, input: { "
     "map: "
     "UVTransform, scaleU: 8, scaleV: 4 } } }",
     CELLS,
     {16, 8, 0},
     {{1, 1, 1}, {0}}},
    {"coarse: { material: Phong, diffuse: [.5, .5, .3], transparency: { map: Checker, color1: [0, "
     "0, .1], color2: 1, "
     "input: { map: UVTransform, scaleU: 1, scaleV: 2 } } }",
     CELLS,
     {2, 4, 0},
     {{0, 0, .1}, {1, 1, 1}}},
    {"solid: { material: Phong, diffuse: [.2, .3, .5], transparency: { map: VolumeChecker, color1: "
     "[0, 0, 0], color2: "
     "[1, 1, 1], input: { map: XYZTransform, transform: { scale: [1.9, 1.9, 1.9] } } } }",
     CUBES,
     {1.9, 1.9, 1.9},
     {{0}, {1, 1, 1}}},
    {"clear: { material: Phong, diffuse: .3, transparency: [.6, .9, .3] }",
     CONSTANT,
     {0},
     {{.6, .9, .3}}},
    {"dim: { material: Phong, diffuse: .3, transparency: [.4, .2, .5] }",
     CONSTANT,
     {0},
     {{.4, .2, .5}}},
    {"red: { material: Phong, diffuse: [.2, .1, .1], specular: .3, transparency: [.9, .2, .1], "
     "diffuseTransparency: .2 "
     "}",
     CONSTANT,
     {0},
     {{.9, .2, .1}}},
    {"sided: { material: SideSwitch, frontShader: { material: Phong, diffuse: .5 }, backShader: { "
     "material: Phong, "
     "diffuse: .5, transparency: 1 } }",
     SIDES,
     {0},
     {{0}, {1, 1, 1}}},
};
_Static_assert(sizeof glasses / sizeof *glasses == GLASS_COUNT, "glass_ray.h says how many");

const char *glass_text(int number) { return glasses[number].text; }

static const Glass *glass_of(const Tracer *tracer, const Hit *hit)
{
    const SceneMaterial *material =
        &tracer->scene->materials[tracer->scene->objects[hit->object].material];
    const char *name = matc_material_name(material->document, material->index);
    int i = 0;
    while (strncmp(glasses[i].text, name, strlen(name)) != 0)
        i++;
    return &glasses[i];
}

/* Transmittance of a surface. Its front is the light's side, because rays go toward the light. */
static const double *through(const Tracer *tracer, const Hit *hit)
{
    const Glass *glass = glass_of(tracer, hit);
    const double *at = glass->by == CELLS ? hit->uv : hit->local;
    long cells = 0;
    for (int i = 0; i < 3; i++)
        cells += glass->scale[i] != 0 ? (long)floor(glass->scale[i] * at[i]) : 0;
    return glass->through[glass->by == CONSTANT ? 0
                          : glass->by == SIDES  ? hit->front
                                                : cells % 2 == 0];
}

/* Multiplies by a transmittance; a cut-out transmits nothing or everything. */
static void multiply(const Tracer *tracer, const Hit *hit, double shares[3])
{
    const double *t = through(tracer, hit);
    const bool passes = (t[0] + t[1] + t[2]) / 3 > .5;
    for (int i = 0; i < 3; i++)
        shares[i] *= tracer->scene->shadow_colored ? t[i] : passes;
}

void glass_shares(const Tracer *tracer, const SceneLight *light, const double point[3],
                  const double microfacet[3], double shares[3])
{
    Ray ray;
    const double distance = leave(light, point, microfacet, &ray);
    double behind = 0;
    shares[0] = shares[1] = shares[2] = 1;
    while (shares[0] + shares[1] + shares[2] > 0) {
        Hit hit = reference_hit(tracer, &ray, behind);
        if (hit.object < 0 || hit.distance >= distance)
            return;
        multiply(tracer, &hit, shares);
        behind = fmax(behind, hit.distance) * (1 + 1e-5) + 1e-6;
    }
}
