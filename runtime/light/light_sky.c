/* The sky as a light: its program is drawn into the faces of a cube map around the world's
 * origin, which is read back and integrated. The GLSL is light_sky.glsl.
 *
 * Irradiance / pi is the sum over bands l of (2l+1)/(4 pi) A_l/pi times the integral of P_l(n.u)
 * times the radiance from u; A_l = pi, 2 pi/3, pi/4, -pi/24, pi/64 for l = 0, 1, 2, 4, 6, and 0
 * for other odd l (Ramamoorthi and Hanrahan 2001). In the even bands each power (n.u)^2m becomes
 * (n.u)^2m |n|^(6-2m), since |n| is 1, so that together they are one polynomial in n, all of
 * whose 28 terms have degree 6. */
#include "runtime/light/lighting.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FACE = SKY_FACE, FACES = 6, DEGREE = 6, POWERS = DEGREE + 1 };
#define PI 3.14159265358979323846

/* Factors of bands 0, 1, 2, 4, 6: (2l+1)/(4 pi) A_l/pi. */
static const double bands[] = {1 / (4 * PI), 1 / (2 * PI), 5 / (16 * PI), -3 / (32 * PI),
                               13 / (256 * PI)};

/* A homogeneous polynomial in x, y, z: [i][j] belongs to x^i y^j z^(degree-i-j); the last index
 * is the color component. */
typedef double Polynomial[POWERS][POWERS][3];

/* Integrals of radiance times powers of the direction: of each even degree, and of degree 1. */
typedef struct {
    Polynomial even[DEGREE / 2 + 1];
    double odd[3][3]; /* integrals of degree 1, indexed by axis and color component */
} Moments;

bool light_sky_shines(const Scene *scene)
{
    const double *of = scene->sky_light;
    return scene->sky >= 0 && of[0] + of[1] + of[2] > 0;
}

/* OpenGL's table of cube faces: direction to the center, and along s and t. */
static const double faces[FACES][3][3] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
};

/* Adds all products of powers of u with the degree, times `light`. */
static void add_powers(const double u[3], int degree, const double light[3], Polynomial sum)
{
    double powers[3][POWERS];
    for (int axis = 0; axis < 3; axis++) {
        powers[axis][0] = 1;
        for (int k = 1; k <= degree; k++)
            powers[axis][k] = powers[axis][k - 1] * u[axis];
    }
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++) {
            const double power = powers[0][i] * powers[1][j] * powers[2][degree - i - j];
            for (int component = 0; component < 3; component++)
                sum[i][j][component] += power * light[component];
        }
}

/* Integrates a face: degree 6 and degree 1. Lower even degrees follow from 6, since |u| is 1. */
static void add_face(const double face[3][3], const float *rgba, Moments *moments)
{
    for (int i = 0; i < FACE * FACE; i++) {
        const double a = (2 * (i % FACE) + 1.) / FACE - 1, b = (2 * (i / FACE) + 1.) / FACE - 1;
        const double square = 1 + a * a + b * b, length = sqrt(square);
        const double angle = 4. / (FACE * FACE) / (square * length);
        double u[3], light[3];
        for (int k = 0; k < 3; k++) {
            u[k] = (face[0][k] + a * face[1][k] + b * face[2][k]) / length;
            light[k] = angle * rgba[4 * i + k];
        }
        add_powers(u, DEGREE, light, moments->even[DEGREE / 2]);
        for (int k = 0; k < 9; k++)
            moments->odd[k / 3][k % 3] += u[k / 3] * light[k % 3];
    }
}

/* Computes moments of degree d from those of d + 2: the sum over axes of the moments with that
 * axis squared. */
static void lower_degree(Polynomial from, int degree, Polynomial to)
{
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++)
            for (int component = 0; component < 3; component++)
                to[i][j][component] =
                    from[i + 2][j][component] + from[i][j + 2][component] + from[i][j][component];
}

/* Multiplies by x^2 + y^2 + z^2: degree d becomes d + 2. */
static void multiply_by_square(Polynomial p, int degree)
{
    Polynomial product = {{{0}}};
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++)
            for (int component = 0; component < 3; component++) {
                product[i + 2][j][component] += p[i][j][component];
                product[i][j + 2][component] += p[i][j][component];
                product[i][j][component] += p[i][j][component];
            }
    memcpy(p, product, sizeof product);
}

static double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/* Adds the integral of radiance times (n.u)^degree, as a polynomial in n, times a factor. */
static void add_power(Polynomial moments, int degree, double factor, Polynomial sum)
{
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++) {
            const double count =
                factorial(degree) / (factorial(i) * factorial(j) * factorial(degree - i - j));
            for (int component = 0; component < 3; component++)
                sum[i][j][component] += factor * count * moments[i][j][component];
        }
}

/* Writes the coefficients in the order of the GLSL. */
static void put_numbers(Polynomial even, double odd[3][3], float out[SKY_WORLD][4])
{
    int at = 0;
    memset(out, 0, SKY_WORLD * sizeof *out);
    for (int i = DEGREE; i >= 0; i--)
        for (int j = DEGREE - i; j >= 0; j--, at++)
            for (int component = 0; component < 3; component++)
                out[at][component] = (float)even[i][j][component];
    for (int axis = 0; axis < 3; axis++, at++)
        for (int component = 0; component < 3; component++)
            out[at][component] = (float)(bands[1] * odd[axis][component]);
}

static void make_numbers(Moments *m, float out[SKY_WORLD][4])
{
    const double b0 = bands[0], b2 = bands[2], b4 = bands[3], b6 = bands[4];
    /* coefficients of (n.u)^0, 2, 4, 6 in the weighted sum of Legendre polynomials */
    const double powers[] = {b0 - b2 / 2 + 3 * b4 / 8 - 5 * b6 / 16,
                             3 * b2 / 2 - 30 * b4 / 8 + 105 * b6 / 16, 35 * b4 / 8 - 315 * b6 / 16,
                             231 * b6 / 16};
    Polynomial sum = {{{0}}};
    for (int half = DEGREE / 2 - 1; half >= 0; half--)
        lower_degree(m->even[half + 1], 2 * half, m->even[half]);
    for (int half = 0; half <= DEGREE / 2; half++) {
        if (half)
            multiply_by_square(sum, 2 * half - 2);
        add_power(m->even[half], 2 * half, powers[half], sum);
    }
    put_numbers(sum, m->odd, out);
}

/* Draws the sky into a face of the cube map, and reads it back. */
static bool draw_face(Renderer *renderer, int face, const Framebuffer *target, float *rgba)
{
    GlContext *gl = renderer->gl;
    SceneCamera camera = {.kind = SCENE_Perspective, .half = 1, .near = 1};
    ViewSpace space;
    for (int i = 0; i < 3; i++) {
        camera.right[i] = faces[face][1][i];
        camera.up[i] = faces[face][2][i];
        camera.back[i] = -faces[face][0][i];
    }
    view_space_make(&camera, (const int[]){FACE, FACE}, renderer->zero_to_one, &space);
    space.spaces.time = (float)renderer->scene->time;
    spaces_set(&space.spaces, &renderer->gpu_scene.sky);
    framebuffer_use(gl, target);
    material_use(&renderer->gpu_scene.sky);
    screen_draw(gl, &renderer->screen);
    if (!framebuffer_read(gl, target, 0, rgba))
        return false;
    /* clamps to the range of half floats; NaN becomes black */
    for (int i = 0; i < 4 * FACE * FACE; i++)
        rgba[i] = rgba[i] > 0 ? fminf(rgba[i], 65504) : 0;
    for (int i = 0; i < 4 * FACE * FACE; i += 4)
        renderer->light->sky.uneven |= memcmp(rgba + i, face ? renderer->light->sky.first : rgba,
                                              sizeof renderer->light->sky.first) != 0;
    if (!face)
        memcpy(renderer->light->sky.first, rgba, sizeof renderer->light->sky.first);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_CUBE_MAP, renderer->light->sky.map);
    gl->TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, 0, GL_RGBA16F, FACE, FACE, 0,
                   GL_RGBA, GL_FLOAT, rgba);
    return gl_check(gl, "drawing the sky");
}

static void make_map(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    gl->Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl->GenTextures(1, &renderer->light->sky.map);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_CUBE_MAP, renderer->light->sky.map);
    gl->TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl->TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

bool light_sky_make(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    const FramebufferSpec spec = {
        .width = FACE, .height = FACE, .color_count = 1, .color_format = GL_RGBA32F};
    float *rgba = malloc(4 * FACE * FACE * sizeof *rgba);
    Moments *moments = calloc(1, sizeof *moments);
    Framebuffer target = {0};
    bool fine = (rgba && moments) || gl_fail(gl, "out of memory");
    fine = fine && framebuffer_make(gl, &spec, &target);
    if (fine)
        make_map(renderer);
    for (int face = 0; fine && face < FACES; face++) {
        fine = draw_face(renderer, face, &target, rgba);
        if (fine)
            add_face(faces[face], rgba, moments);
    }
    if (fine) {
        gl->BindTexture(GL_TEXTURE_CUBE_MAP, renderer->light->sky.map);
        gl->GenerateMipmap(GL_TEXTURE_CUBE_MAP);
        make_numbers(moments, renderer->light->sky.irradiance);
    }
    const Spaces seen = view_space_of_sky(&renderer->space);
    spaces_set(&seen, &renderer->gpu_scene.sky);
    framebuffer_delete(gl, &target);
    free(moments);
    free(rgba);
    return fine && gl_check(gl, "making the sky's light");
}

void light_sky_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    float numbers[SKY_NUMBERS][4] = {{0}};
    memcpy(numbers, renderer->light->sky.irradiance, sizeof renderer->light->sky.irradiance);
    for (int row = 0; row < 3; row++) { /* the inverse of a rotation is its transpose */
        for (int i = 0; i < 3; i++)
            numbers[SKY_WORLD + row][i] = (float)renderer->space.eye_from_world[4 * row + i];
        numbers[SKY_LIGHT][row] = (float)renderer->scene->sky_light[row];
    }
    material_write(&pass->material, "Sky", numbers, sizeof numbers);
    screen_pass_sampler(pass, "sky_map", unit);
}

void light_sky_bind(const Renderer *renderer, int unit)
{
    renderer->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    renderer->gl->BindTexture(GL_TEXTURE_CUBE_MAP, renderer->light->sky.map);
}
