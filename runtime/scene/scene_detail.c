#include "runtime/scene/scene_detail.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Min samples of a path: --frames may select other frames than the scene. */
enum { MIN_SAMPLES = 512 };

static double distance(const double a[3], const double b[3])
{
    const double way[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(vec3_dot(way, way));
}

/* Returns a sphere around positions and the path between them. */
static SceneDetailEye ball_of(const double (*at)[3], int count)
{
    SceneDetailEye ball = {{0}, 0};
    double step = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            ball.center[k] += at[i][k] / count;
    for (int i = 0; i < count; i++) {
        ball.radius = fmax(ball.radius, distance(at[i], ball.center));
        step = i ? fmax(step, distance(at[i], at[i - 1])) : 0;
    }
    ball.radius += step / 2;
    return ball;
}

/* Each sphere covers a run of frames; consecutive runs share a frame. */
static void find_eyes(const Scene *scene, SceneDetail *detail)
{
    const int wanted = scene->motion.frames > MIN_SAMPLES ? scene->motion.frames : MIN_SAMPLES,
              run = (wanted + SCENE_DETAIL_EYES - 1) / SCENE_DETAIL_EYES;
    enum { PART = 64 }; /* max samples in a run of the path */
    for (int eye = 0; eye < SCENE_DETAIL_EYES; eye++) {
        SceneDetailEye *made = &detail->eyes[detail->eye_count++];
        const int stride = (run + PART - 1) / PART;
        double at[PART + 2][3];
        int count = 0;
        for (int frame = eye * run; frame <= (eye + 1) * run; frame += stride) {
            SceneCamera camera;
            scene_motion_camera(scene, frame < wanted ? frame : wanted - 1, wanted, &camera);
            memcpy(at[count++], camera.position, sizeof at[0]);
        }
        *made = ball_of((const double(*)[3])at, count);
    }
}

void scene_detail_find(const Scene *scene, const int size[2], SceneDetail *detail)
{
    const SceneCamera *camera = &scene->camera;
    const double sides[2] = {size[0], size[1]}, shorter = fmin(sides[0], sides[1]);
    const double across = camera->half * sides[0] / shorter,
                 along = camera->half * sides[1] / shorter;
    const bool parallel = camera->kind == SCENE_Orthographic;
    *detail = (SceneDetail){.scene = scene, .pixels = shorter / 2 / camera->half};
    /* the maximum occurs at a corner of the picture, where a sphere becomes an ellipse */
    if (!parallel)
        detail->pixels *= 1 + across * across + along * along;
    if (scene->motion.frames) {
        find_eyes(scene, detail);
        return;
    }
    detail->eye_count = 1;
    memcpy(detail->eyes[0].center, camera->position, sizeof camera->position);
}

/* Returns the distance of a point from the segment a + t b, t from 0 to `most`. */
static double from_line(const double at[3], const double a[3], const double b[3], double most)
{
    double way[3], near[3];
    for (int i = 0; i < 3; i++)
        way[i] = at[i] - a[i];
    const double size = vec3_dot(b, b), t = size > 0 ? vec3_dot(way, b) / size : 0;
    for (int i = 0; i < 3; i++)
        near[i] = a[i] + fmin(fmax(t, 0), most) * b[i];
    return distance(at, near);
}

/* Returns the distance at which a solid counts because of its shadow. A lamp magnifies a shadow
 * as much as it moves it away: a length e at C, visible by its shadow at S behind it, has e |S -
 * L| / |C - L| / |S - E| pixels for a camera at E and a lamp at L, at most e over the distance
 * from C to the line from E to L. For a directional light the line is infinite. */
static double shadow_distance(const SceneDetailEye *eye, const SceneLight *light,
                              const double center[3])
{
    double way[3], edges = 0;
    const LightFrom from = light_from(light);
    if (!scene_light_casts(light))
        return INFINITY;
    for (int i = 0; i < 3; i++)
        way[i] =
            from == LIGHT_FROM_afar ? -light->direction[i] : light->position[i] - eye->center[i];
    for (int i = 0; i < 2 && from == LIGHT_FROM_extent; i++)
        edges += sqrt(vec3_dot(light->edges[i], light->edges[i]));
    return from_line(center, eye->center, way, from == LIGHT_FROM_afar ? INFINITY : 1) - edges;
}

static bool is_magnified(const Scene *scene)
{
    bool is = false;
    for (int i = 0; i < scene->light_count; i++)
        is |= scene_light_casts(&scene->lights[i]) &&
              light_from(&scene->lights[i]) != LIGHT_FROM_afar;
    return is;
}

/* Returns the max pixels of a unit of length of a solid within a bounding sphere: directly, in
 * plane mirrors, and in its shadows, across the light's rays. INFINITY if the camera may be
 * inside. */
static double scene_detail_pixels(const SceneDetail *detail, const double center[3], double radius)
{
    const Scene *scene = detail->scene;
    double nearest = INFINITY;
    if (!scene || !isfinite(radius))
        return INFINITY;
    /* a lamp's shadow of a small object may fill the picture */
    if (scene->camera.kind == SCENE_Orthographic)
        return is_magnified(scene) ? INFINITY : detail->pixels;
    for (int i = 0; i < detail->eye_count; i++) {
        const SceneDetailEye *eye = &detail->eyes[i];
        double near = distance(center, eye->center);
        for (int k = 0; k < scene->light_count; k++)
            near = fmin(near, shadow_distance(eye, &scene->lights[k], center));
        nearest = fmin(nearest, near - eye->radius);
    }
    return nearest > radius ? detail->pixels / (nearest - radius) : INFINITY;
}

/* Returns the number of steps of a circle. With n steps a chord has an error of r (1 - cos(pi /
 * n)). A sphere's cells are at most squares of the same angle, so their centers have the error
 * of half a diagonal. */
int scene_detail_steps(SceneKind kind, double pixels)
{
    const double part = kind == SCENE_Sphere ? sqrt(2) : 1;
    int steps = SCENE_DETAIL_STEPS;
    for (int level = 1; level < SCENE_DETAIL_LEVELS; level++) {
        const int coarser = SCENE_DETAIL_STEPS >> level;
        if (!(pixels * (1 - cos(part * PI / coarser)) <= SCENE_DETAIL_ERROR))
            break;
        steps = coarser;
    }
    return steps;
}

static SceneBall ball_of_shape(const Shape *shape)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < 3 * shape->vertex_count; i++) {
        low[i % 3] = fmin(low[i % 3], (double)shape->vertices[i / 3].position[i % 3]);
        high[i % 3] = fmax(high[i % 3], (double)shape->vertices[i / 3].position[i % 3]);
    }
    SceneBall ball = {.radius = distance(low, high) / 2};
    for (int i = 0; i < 3; i++)
        ball.center[i] = (low[i] + high[i]) / 2;
    return ball;
}

SceneBall scene_detail_ball(const SceneObject *object, const Shape *shape)
{
    const double *n = object->numbers;
    switch (object->kind) {
    case SCENE_Sphere:
        return (SceneBall){{0}, n[0]};
    case SCENE_Box:
        return (SceneBall){{0}, sqrt(vec3_dot(n, n)) / 2};
    case SCENE_Cylinder:
    case SCENE_Cone:
        return (SceneBall){{0, 0, n[1] / 2}, hypot(n[0], n[1] / 2)};
    case SCENE_Parallelogram:
        return (SceneBall){{(n[0] + n[3]) / 2, (n[1] + n[4]) / 2, (n[2] + n[5]) / 2},
                           (sqrt(vec3_dot(n, n)) + sqrt(vec3_dot(n + 3, n + 3))) / 2};
    case SCENE_Mesh:
        return ball_of_shape(shape);
    default:
        return (SceneBall){{0}, INFINITY};
    }
}

double scene_detail_stretch(const SceneMatrix *matrix)
{
    const double *m = matrix->m;
    double most = 0;
    /* row sums of the Gram matrix bound its eigenvalues */
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += fabs(vec3_dot(&m[4 * i], &m[4 * k]));
        most = fmax(most, sum);
    }
    return sqrt(most);
}

double scene_detail_unit(const SceneDetail *detail, const SceneMatrix *world_from_local,
                         const SceneBall *ball, double reach)
{
    const double *m = world_from_local->m, *own = ball->center;
    double center[3];
    for (int i = 0; i < 3; i++)
        center[i] = m[i] * own[0] + m[4 + i] * own[1] + m[8 + i] * own[2] + m[12 + i];
    return scene_detail_pixels(detail, center,
                               ball->radius * scene_detail_stretch(world_from_local) + reach);
}
