/* The shading slots of every material (semantics.md, section 4). */
#include "compiler/oracle/oracle.h"
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/stack.h"
#include "runtime/library/sky.h"
#include <math.h>
#include <string.h>

static void answer(Environment *environment, const Node *material, SlotValues *result);

typedef void OracleShader(Environment *environment, const Node *material, SlotValues *result);
typedef const Node *OracleSwitch(const Node *material, bool front);

#define SHADER_OF_SHADER(name) oracle_##name
#define SWITCH_OF_SHADER(name) NULL
#define FOREIGN_OF_SHADER(name) NULL
static OracleShader *const shaders[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SHADER(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

#define SHADER_OF_SWITCH(name) NULL
#define SWITCH_OF_SWITCH(name) oracle_choose_##name
#define FOREIGN_OF_SWITCH(name) NULL
static OracleSwitch *const switches[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SWITCH(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

static const double DEFAULT_EXPONENT = 4;
static const double GREATEST_EXPONENT = 65504;
static const double MISSING_GRAY = 128. / 255; /* java.awt.Color.GRAY */

static void set_colour(SlotValues *result, Slot slot, const double rgb[3])
{
    memcpy(result->lane[slot], rgb, 3 * sizeof *rgb);
}

/* R, G and B of a parameter's map. */
static void ask_colour(Environment *environment, const Node *node, int param, double rgb[3])
{
    for (int lane = 0; lane < 3; lane++)
        rgb[lane] = oracle_ask_param(environment, node, param, channel_id(GROUP_R, lane));
}

static void slot_colour(Environment *environment, const Node *node, int param, Slot slot, SlotValues *result)
{
    ask_colour(environment, node, param, result->lane[slot]);
}

/* Unit length, on the side that is seen. */
static void set_normal(const Environment *environment, const double normal[3], SlotValues *result)
{
    double *lane = result->lane[SLOT_normal];
    oracle_call(environment, FN_safeNormalize, normal, lane);
    if (environment->surface->front)
        return;
    for (int i = 0; i < 3; i++)
        lane[i] = -lane[i];
}

/* A Phong without maps, and black: what the other materials are variations of. */
static void set_neutral(const Environment *environment, SlotValues *result)
{
    memset(result, 0, sizeof *result);
    set_normal(environment, &environment->surface->root[channel_id(GROUP_N, 0)], result);
    result->lane[SLOT_alpha][0] = 1;
    result->lane[SLOT_shininess][0] = DEFAULT_EXPONENT;
    result->lane[SLOT_transparencyShininess][0] = GREATEST_EXPONENT;
    result->lane[SLOT_interpolatedTransparency][0] = 1;
    result->lane[SLOT_ior][0] = environment->surface->root[channel_id(GROUP_IOR, 0)];
}

/* As a Phong: diffuse rgb of alpha 1, and transparency 1 - a. */
static void set_rgba(const double rgb[3], double a, SlotValues *result)
{
    set_colour(result, SLOT_diffuse, rgb);
    set_colour(result, SLOT_transparency, (double[3]){1 - a, 1 - a, 1 - a});
}

void oracle_RGBA(Environment *environment, const Node *material, SlotValues *result)
{
    (void)environment;
    double rgb[3] = {oracle_number(material, P_RGBA_r), oracle_number(material, P_RGBA_g),
                     oracle_number(material, P_RGBA_b)};
    set_rgba(rgb, oracle_number(material, P_RGBA_a), result);
}

static void missing(SlotValues *result) { set_rgba((double[3]){MISSING_GRAY, MISSING_GRAY, MISSING_GRAY}, 1, result); }

/* The exponent that a shininess map means; a parameter without map leaves the neutral one. */
static void exponent(Environment *environment, const Node *material, int param, Slot slot, SlotValues *result)
{
    if (node_param(material, param)->kind == VALUE_none)
        return;
    double red = oracle_ask_param(environment, material, param, channel_id(GROUP_R, 0));
    oracle_call(environment, FN_phongExponent, &red, result->lane[slot]);
}

/* Alpha of the diffuse map makes the surface transparent: at 0 it is wholly so, at 1 the transparency map decides. */
static void transparency(Environment *environment, const Node *material, SlotValues *result)
{
    double alpha = oracle_ask_param(environment, material, P_Phong_diffuse, channel_id(GROUP_R, 3));
    double colour[3];
    ask_colour(environment, material, P_Phong_transparency, colour);
    result->lane[SLOT_alpha][0] = alpha;
    for (int i = 0; i < 3; i++)
        result->lane[SLOT_transparency][i] = 1 + alpha * (colour[i] - 1);
}

/* Only the normal and the index of refraction come from `input`; the other maps read the surface. */
void oracle_Phong(Environment *environment, const Node *material, SlotValues *result)
{
    double normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = oracle_ask_param(environment, material, P_Phong_input, channel_id(GROUP_N, i));
    set_normal(environment, normal, result);
    result->lane[SLOT_ior][0] = oracle_ask_param(environment, material, P_Phong_input, channel_id(GROUP_IOR, 0));
    slot_colour(environment, material, P_Phong_diffuse, SLOT_diffuse, result);
    slot_colour(environment, material, P_Phong_specular, SLOT_specular, result);
    slot_colour(environment, material, P_Phong_diffuseTransparency, SLOT_diffuseTransparency, result);
    slot_colour(environment, material, P_Phong_ambient, SLOT_ambient, result);
    slot_colour(environment, material, P_Phong_emissive, SLOT_emissive, result);
    transparency(environment, material, result);
    exponent(environment, material, P_Phong_shininess, SLOT_shininess, result);
    exponent(environment, material, P_Phong_transparencyShininess, SLOT_transparencyShininess, result);
    result->lane[SLOT_interpolatedTransparency][0] = oracle_number(material, P_Phong_interpolatedTransparency) != 0;
}

static double ask_red(Environment *environment, const Node *material, int param)
{
    return oracle_ask_param(environment, material, param, channel_id(GROUP_R, 0));
}

/* Fresnel's formulas along the normal say what the index of refraction reflects; metal takes the weight of that as a factor on its colour. */
void oracle_Principled(Environment *environment, const Node *material, SlotValues *result)
{
    double normal[3], colour[3];
    for (int i = 0; i < 3; i++)
        normal[i] = oracle_ask_param(environment, material, P_Principled_input, channel_id(GROUP_N, i));
    set_normal(environment, normal, result);
    const double metal = ask_red(environment, material, P_Principled_metalness);
    const double weight = ask_red(environment, material, P_Principled_specular);
    const double opacity = ask_red(environment, material, P_Principled_opacity);
    const double ior = fmax(ask_red(environment, material, P_Principled_ior), 0), root = (ior - 1) / (ior + 1);
    ask_colour(environment, material, P_Principled_baseColor, colour);
    for (int i = 0; i < 3; i++)
        result->lane[SLOT_diffuse][i] = colour[i] * ask_red(environment, material, P_Principled_baseWeight) * (1 - metal + metal * weight);
    ask_colour(environment, material, P_Principled_emissionColor, colour);
    for (int i = 0; i < 3; i++)
        result->lane[SLOT_emissive][i] = opacity * colour[i] * ask_red(environment, material, P_Principled_emission);
    slot_colour(environment, material, P_Principled_specularColor, SLOT_specular, result);
    set_colour(result, SLOT_transparency, (double[3]){1 - opacity, 1 - opacity, 1 - opacity});
    result->lane[SLOT_alpha][0] = opacity;
    result->lane[SLOT_metalness][0] = metal;
    result->lane[SLOT_roughness][0] = ask_red(environment, material, P_Principled_roughness);
    result->lane[SLOT_reflectance][0] = weight * root * root;
    result->lane[SLOT_model][0] = MODEL_Principled;
}

/* Arguments of skyRadiance: the view direction (of any length), the sun's, zenith over F(0, theta of the sun), and A to E. */
enum { SKY_VIEW, SKY_SUN, SKY_ZENITH, SKY_A, SKY_ARGUMENTS = SKY_A + 5 };
/* The rows of sky_coefficients: the scaled zenith, A to E, the unit vector to the sun. */
enum { ROW_ZENITH, ROW_A, ROW_SUN = ROW_A + 5, ROW_COUNT };

void oracle_SunSkyLight(Environment *environment, const Node *material, SlotValues *result)
{
    double sun[3], row[ROW_COUNT][3], args[SKY_ARGUMENTS][3];
    oracle_number3(material, P_SunSkyLight_sun, sun);
    sky_coefficients(sun, oracle_number(material, P_SunSkyLight_turbidity),
                     oracle_number(material, P_SunSkyLight_radianceFactor), row);
    memcpy(args[SKY_VIEW], &environment->surface->root[channel_id(GROUP_X, 0)], sizeof args[SKY_VIEW]);
    memcpy(args[SKY_SUN], row[ROW_SUN], sizeof row[ROW_SUN]);
    memcpy(args[SKY_ZENITH], row[ROW_ZENITH], sizeof row[ROW_ZENITH]);
    memcpy(args[SKY_A], row[ROW_A], 5 * sizeof row[ROW_A]);
    oracle_call(environment, FN_skyRadiance, &args[0][0], result->lane[SLOT_emissive]);
}

/* The material that a parameter holds; NULL when there is none. */
static const Node *material_of(const Node *material, int param)
{
    const Value *value = node_param(material, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

/* A missing back is the front; a missing front stays missing, whatever the back is. */
const Node *oracle_choose_SideSwitch(const Node *material, bool front)
{
    const Node *back = front ? NULL : material_of(material, P_SideSwitch_backShader);
    return back ? back : material_of(material, P_SideSwitch_frontShader);
}

const Node *oracle_choose_AlgorithmSwitch(const Node *material, bool front)
{
    (void)front;
    const int order[] = {P_AlgorithmSwitch_guiShader, P_AlgorithmSwitch_raytracerShader,
                         P_AlgorithmSwitch_radiationShader};
    for (int i = 0; i < 3; i++) {
        const Node *choice = material_of(material, order[i]);
        if (choice)
            return choice;
    }
    return NULL;
}

/* The material that a switch stands for, through any number of switches; NULL when it is missing. */
static const Node *chosen(const Node *material, bool front)
{
    while (material && switches[material->kind])
        material = switches[material->kind](material, front);
    return material;
}

const Node *oracle_displaced(const Node *material)
{
    while (material && !graph_displaces(material))
        material = switches[material->kind] ? switches[material->kind](material, true) : NULL;
    return material;
}

static double roughness_of(double exponent) { return sqrt(sqrt(2 / (exponent + 2))); }

/* From a slot of a's to that of b's. */
static void mix_slot(const Environment *environment, Slot slot, const SlotValues sides[2], double t, SlotValues *result)
{
    const double *a = sides[0].lane[slot], *b = sides[1].lane[slot];
    double *mean = result->lane[slot];
    if (!memcmp(a, b, sizeof sides[0].lane[slot])) {
        memcpy(mean, a, sizeof sides[0].lane[slot]);
        return;
    }
    for (int i = 0; i < 3; i++)
        mean[i] = a[i] * (1 - t) + b[i] * t;
    if (slot_mixing(slot) == MIXING_DIRECTION) {
        const double side = environment->surface->front ? 1 : -1;
        const double turned[3] = {side * mean[0], side * mean[1], side * mean[2]};
        set_normal(environment, turned, result);
    } else if (slot_mixing(slot) == MIXING_EXPONENT) {
        const double r = roughness_of(a[0]) * (1 - t) + roughness_of(b[0]) * t;
        mean[0] = fmin(fmax(2 / (r * r * r * r) - 2, 0), GREATEST_EXPONENT);
    }
}

static bool is_principled(const Environment *environment, const Node *material)
{
    const unsigned *models = environment->oracle->graph->models;
    return material && models && models[material->index] >> MODEL_Principled & 1;
}

/* A Phong's slots become those of the Principled that stands for it: it reflects as much along the normal, and as wide. */
static void as_principled(SlotValues *side)
{
    static const double LEAST_TINT = 1e-6;
    const double *specular = side->lane[SLOT_specular], share = 2 / (side->lane[SLOT_shininess][0] + 2);
    const double most = fmax(fmax(specular[0], fmax(specular[1], specular[2])), 0);
    static const Slot lost[] = {SLOT_shininess, SLOT_transparencyShininess, SLOT_interpolatedTransparency, SLOT_diffuseTransparency,
                                SLOT_ambient};
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++)
        for (int lane = 0; lane < type_table[slot_table[lost[i]].type].lanes; lane++)
            side->lane[lost[i]][lane] = slot_table[lost[i]].absent;
    for (int lane = 0; lane < 3; lane++)
        side->lane[SLOT_specular][lane] = (side->lane[SLOT_specular][lane] + LEAST_TINT) / (most + LEAST_TINT);
    side->lane[SLOT_roughness][0] = sqrt(sqrt(share));
    side->lane[SLOT_reflectance][0] = most * share;
    side->lane[SLOT_model][0] = MODEL_Principled;
}

/* A side by the model that the whole has. */
static void answer_as(Environment *environment, const Node *whole, const Node *side, SlotValues *result)
{
    answer(environment, side, result);
    if (is_principled(environment, whole) && result->lane[SLOT_model][0] != MODEL_Principled)
        as_principled(result);
}

/* A material that stands in a Mix twice, and so on, is asked as often: what that takes is bounded as all work is. */
void oracle_MixMaterial(Environment *environment, const Node *material, SlotValues *result)
{
    SlotValues sides[2];
    oracle_spend(environment, ANSWER_WORK);
    if (oracle_spent(environment->oracle))
        return;
    const double red = oracle_ask_param(environment, material, P_MixMaterial_mask, channel_id(GROUP_R, 0));
    answer_as(environment, material, material_of(material, P_MixMaterial_a), &sides[0]);
    answer_as(environment, material, material_of(material, P_MixMaterial_b), &sides[1]);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        mix_slot(environment, (Slot)slot, sides, fmin(fmax(red, 0), 1), result);
}

static void answer(Environment *environment, const Node *material, SlotValues *result)
{
    set_neutral(environment, result);
    const Node *shader = chosen(material, environment->surface->front);
    if (shader)
        shaders[shader->kind](environment, shader, result);
    else
        missing(result);
    if (is_principled(environment, material) && result->lane[SLOT_model][0] != MODEL_Principled)
        as_principled(result);
}

/* A shape is the same for all who look at it: where it is asked for, the direction to the viewer is the normal. */
static Surface unseen(const Surface *surface)
{
    Surface made = *surface;
    memcpy(&made.root[channel_id(GROUP_E, 0)], &surface->root[channel_id(GROUP_N, 0)], 3 * sizeof *made.root);
    made.root[channel_id(GROUP_E, 3)] = 0;
    return made;
}

/* Maps read the mesh; the normal alone, and what `input` makes of it, is that of the surface after it was displaced. */
static void answer_displaced(Environment *environment, const Node *material, SlotValues *result)
{
    const Node *displaced = oracle_displaced(material);
    answer(environment, material, result);
    if (!displaced)
        return;
    SlotValues moved;
    Surface surface = *environment->surface;
    const Surface shape = unseen(environment->surface);
    Environment shaped = environment_open(environment->oracle, &shape, environment->depth);
    oracle_displace(&shaped, displaced, &surface);
    Environment there = environment_open(environment->oracle, &surface, environment->depth + 1);
    there.mesh = environment->surface;
    answer(&there, material, &moved);
    memcpy(result->lane[SLOT_normal], moved.lane[SLOT_normal], sizeof result->lane[SLOT_normal]);
}

typedef struct {
    Environment environment;
    const Node *material;
    SlotValues *result;
} Question;

static void answer_on_stack(void *user)
{
    Question *question = user;
    answer_displaced(&question->environment, question->material, question->result);
}

bool oracle_material(Oracle *oracle, const Node *material, const Surface *surface, SlotValues *result)
{
    Question question = {environment_open(oracle, surface, 0), material, result};
    oracle->work = 0;
    stack_run(material ? material->depth : 0, answer_on_stack, &question);
    return !oracle_spent(oracle);
}

typedef struct {
    Environment environment;
    const Node *displaced;
    bool slopes; /* are asked for, too */
    OracleDisplacement *result;
} MoveQuestion;

static void move_on_stack(void *user)
{
    MoveQuestion *question = user;
    if (question->slopes)
        oracle_move(&question->environment, question->displaced, question->result);
    else
        oracle_move_by(&question->environment, question->displaced, question->result->by);
}

static bool move(Oracle *oracle, const Node *material, const Surface *surface, bool slopes, OracleDisplacement *result)
{
    const Node *displaced = oracle_displaced(material);
    *result = (OracleDisplacement){.by = {0}};
    oracle->work = 0;
    const Surface shape = unseen(surface);
    MoveQuestion question = {environment_open(oracle, &shape, 0), displaced, slopes, result};
    if (displaced)
        stack_run(displaced->depth, move_on_stack, &question);
    return !oracle_spent(oracle);
}

bool oracle_displacement(Oracle *oracle, const Node *material, const Surface *surface, OracleDisplacement *result)
{
    return move(oracle, material, surface, true, result);
}

bool oracle_displacement_at(Oracle *oracle, const Node *material, const Surface *surface, double by[3])
{
    OracleDisplacement found;
    const bool fine = move(oracle, material, surface, false, &found);
    memcpy(by, found.by, sizeof found.by);
    return fine;
}
