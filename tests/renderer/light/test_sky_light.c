/* The sky as a light: irradiance and lobes on a sphere against integrals in double of the
 * oracle's sky; closed forms under skies of one color; the sky's sun, in scenes and in the
 * reflection. */
/* ctest: seconds=20 */
#include "tests/test.h"
#include "compiler/evaluate.h"
#include "runtime/renderer/renderer.h"
#include "tests/frame/frame_draw.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 96, PIXELS = SIDE * SIDE };
/* The camera's axes are the world's: right x, up z, and it looks along y. */
#define VIEW                                                                                       \
    "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [0, -40, 0], "     \
    "target: [0, 0, 0], "                                                                          \
    "angle: 3 }\n"
#define HALF_ANGLE (1.5 * PI / 180)

typedef struct {
    MatcDocument *document;
    Scene *scene;
    MatcOptions options;
} Read;

static Read read_scene(const char *text)
{
    Read r = {0};
    matc_options_init(&r.options);
    r.options.layout = "integer";
    r.options.aa = "none";
    r.options.pixels = true;
    r.document = scene_read("scene.yaml", text, strlen(text), &r.options, &r.scene);
    if (!r.scene)
        fail_msg("%s", matc_diagnostics(r.document, MATC_TEXT));
    return r;
}

static void forget(Read *r)
{
    scene_free(r->scene);
    matc_document_free(r->document);
}

static float *draw(GlContext *gl, const Read *r, const char *view, bool fragment)
{
    Renderer *renderer = renderer_open(
        gl, &(RendererOptions){.compile = &r->options, .view = view, .fragment = fragment});
    float *rgba = calloc(PIXELS, 4 * sizeof *rgba);
    if (!renderer || !rgba || !renderer_set_scene(renderer, r->scene) ||
        !renderer_frame(renderer) || !renderer_read(renderer, rgba))
        fail_msg("%s", gl->error);
    renderer_close(renderer);
    return rgba;
}

/* -- the sky in double */

enum { HEIGHTS = 128, TURNS = 96 }; /* steps in z, and around */
typedef struct {
    double way[3], light[3];
} Ray;
static Ray rays[HEIGHTS * TURNS];

/* Rays of equal solid angles, and the oracle's sky along them. */
static void trace(const Read *r)
{
    const SceneMaterial *sky = &r->scene->materials[r->scene->sky];
    for (int i = 0; i < HEIGHTS * TURNS; i++) {
        SlotValues slots;
        Surface surface;
        const double z = 2 * (i / TURNS + .5) / HEIGHTS - 1,
                     turn = 2 * PI * (i % TURNS + .5) / TURNS;
        double *way = rays[i].way;
        way[0] = sqrt(1 - z * z) * cos(turn);
        way[1] = sqrt(1 - z * z) * sin(turn);
        way[2] = z;
        oracle_surface_default(&surface);
        for (int k = 0; k < 3; k++)
            surface.root[channel_id(GROUP_P, k)] = surface.root[channel_id(GROUP_X, k)] = way[k];
        /* semantics.md 5.3 */
        surface.root[channel_id(GROUP_U, 0)] = atan2(way[1], -way[0]) / (2 * PI) + .5;
        surface.root[channel_id(GROUP_U, 1)] = acos(-z) / PI;
        evaluate_material(sky->document, sky->index, &r->options, (SurfacePoints){&surface, 1},
                          &slots);
        for (int k = 0; k < 3; k++)
            rays[i].light[k] = slots.component[SLOT_diffuse][k] + slots.component[SLOT_emissive][k];
    }
}

/* Integral of light times (w.u)^exponent (n.u), over pi; exponent 0: the cosine alone. */
static void integrate(const double n[3], const double w[3], double exponent, double sum[3])
{
    memset(sum, 0, 3 * sizeof *sum);
    for (int i = 0; i < HEIGHTS * TURNS; i++) {
        const double cosine = dot(n, rays[i].way), along = dot(w, rays[i].way);
        if (cosine <= 0 || (exponent > 0 && along <= 0))
            continue;
        const double weight =
            cosine * (exponent > 0 ? pow(along, exponent) : 1) * 4 * PI / (HEIGHTS * TURNS) / PI;
        for (int k = 0; k < 3; k++)
            sum[k] += weight * rays[i].light[k];
    }
}

/* The integral as prefiltered levels approximate it: the mean of the light by the power alone,
 * which is one look-up, times the cosine's factor for uniform light. */
static void blur(const double n[3], const double w[3], double exponent, double sum[3])
{
    double all = 0, left = 0;
    memset(sum, 0, 3 * sizeof *sum);
    for (int i = 0; i < HEIGHTS * TURNS; i++) {
        const double weight = pow(fmax(dot(w, rays[i].way), 0), exponent);
        all += weight;
        left += weight * fmax(dot(n, rays[i].way), 0) * 4 / (HEIGHTS * TURNS);
        for (int k = 0; k < 3; k++)
            sum[k] += weight * rays[i].light[k];
    }
    for (int k = 0; k < 3; k++)
        sum[k] *= left / all;
}

/* -- a sphere in it */

typedef struct {
    double n[3], w[3]; /* the normal, and the mirrored view, in the world */
} Spot;

/* False: the pixel is not on the sphere. The normal is the one that the surface's slots have. */
static bool spot_of(const float *normals, int pixel, Spot *spot)
{
    const float *e = normals + 4 * pixel;
    const double eye[3] = {e[0], e[1], e[2]}, length = sqrt(dot(eye, eye)), half = tan(HALF_ANGLE);
    double view[3] = {(2 * (pixel % SIDE) + 1. - SIDE) / SIDE * half, 1,
                      (2 * (pixel / SIDE) + 1. - SIDE) / SIDE * half};
    const double far = sqrt(dot(view, view));
    if (40 * sqrt(1 - 1 / (far * far)) > .97)
        return false;
    spot->n[0] = eye[0] / length;
    spot->n[1] = -eye[2] / length;
    spot->n[2] = eye[1] / length;
    for (int i = 0; i < 3; i++)
        view[i] /= far;
    for (int i = 0; i < 3; i++)
        spot->w[i] = view[i] - 2 * dot(view, spot->n) * spot->n[i];
    return true;
}

/* The greatest difference on the sphere, relative to the greatest value; *blurred: that of
 * prefiltered levels. */
static double off_by(const float *light, const float *normals, const double specular[3],
                     double exponent, double *blurred)
{
    enum { STEP = 163 };
    double off = 0, other = 0, greatest = 0;
    int count = 0;
    for (int pixel = STEP / 2; pixel < PIXELS; pixel += STEP) {
        Spot spot;
        double sum[3], levels[3];
        if (!spot_of(normals, pixel, &spot))
            continue;
        integrate(spot.n, spot.w, exponent, sum);
        blur(spot.n, spot.w, exponent, levels);
        for (int k = 0; k < 3; k++) {
            off = fmax(off, fabs(light[4 * pixel + k] - specular[k] * sum[k]));
            other = fmax(other, fabs(specular[k] * (levels[k] - sum[k])));
            greatest = fmax(greatest, specular[k] * sum[k]);
        }
        count++;
    }
    assert_true(count > 30 && greatest > 0);
    *blurred = other / greatest;
    return off / greatest;
}

static void put_scene(char *text, size_t capacity, const char *material, const char *sky)
{
    snprintf(text, capacity,
             VIEW
             "lights: [{ light: Sky }]\nobjects: [{ object: Sphere, material: %s }]\nsky: %s\n",
             material, sky);
}

/* An exponent of a shininess, semantics.md 4.1. */
static double exponent_of(double shininess) { return -2 / log(shininess * (2 - shininess)); }

/* Clear skies by the height of their sun; disableSun leaves only the sky. Bounds: 0.3 % for
 * diffuse, 4 % for lobes, of the greatest value. */
static void clear_skies(void **state)
{
    (void)state;
    static const int heights[] = {5, 30};
    static const double shininesses[] = {.3, .9};
    GlContext *gl = frame_context();
    int faults = 0;
    for (int i = 0; i < 2; i++) {
        char sky[256], text[1024];
        snprintf(sky, sizeof sky,
                 "{ material: SunSkyLight, sun: [%.9f, 0, %.9f], turbidity: 3, disableSun: true }",
                 cos(heights[i] * PI / 180), sin(heights[i] * PI / 180));
        for (int k = -1; k < 2; k++) {
            char material[128] = "{ material: Phong, diffuse: 1 }";
            if (k >= 0)
                snprintf(material, sizeof material,
                         "{ material: Phong, diffuse: 0, specular: 1, shininess: %g }",
                         shininesses[k]);
            put_scene(text, sizeof text, material, sky);
            Read r = read_scene(text);
            if (k < 0)
                trace(&r);
            float *light = draw(gl, &r, "light", k == 1), *normals = draw(gl, &r, "normal", false);
            const double exponent = k < 0 ? 0 : exponent_of(shininesses[k]);
            double blurred;
            const double off =
                off_by(light, normals, (const double[]){1, 1, 1}, exponent, &blurred);
            print_message("sun at %2d degrees, exponent %5.1f: %.3f %%", heights[i], exponent,
                          100 * off);
            print_message(k < 0 ? "\n" : "; prefiltered levels would be off by %.1f %%\n",
                          100 * blurred);
            faults += !(off <= (k < 0 ? .003 : .04));
            free(light);
            free(normals);
            forget(&r);
        }
    }
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* A picture all around, which has light below the horizon, too. */
static void pictures(void **state)
{
    (void)state;
    char text[1024];
    GlContext *gl = frame_context();
    put_scene(
        text, sizeof text, "{ material: Phong, diffuse: [1, .5, .25] }",
        "{ material: Phong, diffuse: 0, emissive: { map: ImageMap, image: examples/tiles.png } }");
    Read r = read_scene(text);
    trace(&r);
    float *light = draw(gl, &r, "light", false), *normals = draw(gl, &r, "normal", false);
    double blurred;
    const double off = off_by(light, normals, (const double[]){1, .5, .25}, 0, &blurred);
    print_message("a picture: %.3f %%\n", 100 * off);
    assert_true(off <= .01);
    free(light);
    free(normals);
    forget(&r);
    gl_close(gl);
}

/* A uniform sky whose light is twice its visible brightness: a diffuse 1 reflects exactly its
 * light, a mirror 2 (n.w) / (exponent + 2), less at the sky's horizon. */
static void one_color(void **state)
{
    (void)state;
    char text[1024];
    GlContext *gl = frame_context();
    for (int mirror = 0; mirror < 2; mirror++) {
        snprintf(text, sizeof text,
                 VIEW "lights: [{ light: Sky, intensity: .5 }, { light: Sky, color: [1.5, 0, 1.5] "
                      "}]\nobjects: [{ object: "
                      "Sphere, "
                      "material: { material: Phong, diffuse: %d, specular: %d, shininess: .99 } "
                      "}]\nsky: { material: RGBA, "
                      "r: .25, g: .5, b: 0 }\n",
                 !mirror, mirror);
        Read r = read_scene(text);
        float *light = draw(gl, &r, "light", false), *normals = draw(gl, &r, "normal", false);
        for (int i = 0; i < PIXELS; i++) {
            Spot spot;
            if (!spot_of(normals, i, &spot) || (mirror && dot(spot.n, spot.w) < .1))
                continue;
            const double whole = mirror ? 2 * dot(spot.n, spot.w) / (exponent_of(.99) + 2) : 1;
            const double expected[3] = {.5 * whole, .25 * whole, 0};
            for (int k = 0; k < 3; k++)
                if (!(fabs(light[4 * i + k] - expected[k]) <= 1e-3 * whole))
                    fail_msg("%g, not %g", light[4 * i + k], expected[k]);
        }
        free(light);
        free(normals);
        forget(&r);
    }
    gl_close(gl);
}

/* Reflection of SunSkyLight by a horizontal white plane, summed over red, green and blue, times pi
 * / 3: the sky's scale is such that sky and sun give 10. */
static double flat(GlContext *gl, const char *more)
{
    char text[1024];
    snprintf(text, sizeof text,
             "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [0, 0, "
             "5], up: [0, 1, 0] }\n"
             "lights: [{ light: Sky }]\nobjects: [{ object: Plane, material: { material: Phong, "
             "diffuse: 1 } }]\n"
             "sky: { material: SunSkyLight, sun: [3, 4, 5], turbidity: 4%s }\n",
             more);
    Read r = read_scene(text);
    float *light = draw(gl, &r, "light", false);
    const double sum = (light[4 * 5000] + light[4 * 5000 + 1] + light[4 * 5000 + 2]) * PI / 3;
    free(light);
    forget(&r);
    return sum;
}

static void suns(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    const double both = flat(gl, ""), sky = flat(gl, ", disableSun: true");
    print_message("sky and sun %.4f, the sky %.4f\n", both, sky);
    assert_true(fabs(both - 10) <= .03);
    assert_true(sky > .5 && sky < 9.5);
    assert_true(fabs(flat(gl, ", radianceFactor: .5") - 5) <= .015);
    assert_true(flat(gl, ", disableLight: true") == 0);
    gl_close(gl);
}

/* -- the reflection */

static double number_after(const char *json, const char *key, int index)
{
    const char *at = strstr(json, key);
    assert_non_null(at);
    at = strchr(at, '[');
    for (int i = 0; i < index; i++)
        at = strchr(at + 1, ',');
    return strtod(at + 1, NULL);
}

/* The sun's direction, of length 1, and what it gives: with the sky, 10 on the horizontal plane. No
 * other material has one, nor another pass. */
static void reflected(void **state)
{
    (void)state;
    static const char text[] =
        "materials: { sky: { material: AlgorithmSwitch, radiationShader: { material: SunSkyLight, "
        "sun: [3, 4, "
        "5], turbidity: 4, disableSun: true } }, other: { material: RGBA } }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("sky.yaml", text, sizeof text - 1, &options);
    for (int i = 0; i < 4; i++) {
        options.pass = i % 2 ? "gbuffer" : "sky";
        MatcProgram *program = matc_compile(document, i / 2, MATC_REFLECT, &options);
        assert_true(matc_ok(program));
        const char *json = matc_output(program, MATC_REFLECT, NULL);
        assert_int_equal(strstr(json, "\"sunIrradiance\"") != NULL, i == 0);
        if (i == 0) {
            const double unit = sqrt(50);
            assert_non_null(
                strstr(json, "\"sky\": {\"disableLight\": false, \"disableSun\": true"));
            for (int k = 0; k < 3; k++)
                assert_true(fabs(number_after(json, "\"sun\":", k) - (3 + k) / unit) <= 1e-12);
            GlContext *gl = frame_context();
            double sum = 0;
            for (int k = 0; k < 3; k++)
                sum += number_after(json, "\"sunIrradiance\":", k) / 3;
            assert_true(fabs(sum * 5 / unit + flat(gl, ", disableSun: true") - 10) <= .03);
            gl_close(gl);
        }
        matc_program_free(program);
    }
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clear_skies), cmocka_unit_test(pictures),  cmocka_unit_test(one_color),
        cmocka_unit_test(suns),        cmocka_unit_test(reflected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
