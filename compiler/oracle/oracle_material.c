/* Evaluates the shading slots of every material (semantics.md, section 4). */
#include "compiler/oracle/oracle.h"
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/stack.h"
#include "compiler/library/sky.h"
#include <math.h>
#include <string.h>

static void answer(Environment *environment, const Node *material, SlotValues *result);

typedef void OracleShader(Environment *environment, const Node *material, SlotValues *result);
typedef const Node *OracleSwitch(const Node *material, bool front);

#define SHADER_OF_SHADER(name)  oracle_##name
#define SWITCH_OF_SHADER(name)  NULL
#define FOREIGN_OF_SHADER(name) NULL
static OracleShader *const shaders[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SHADER(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

#define SHADER_OF_SWITCH(name)  NULL
#define SWITCH_OF_SWITCH(name)  oracle_choose_##name
#define FOREIGN_OF_SWITCH(name) NULL
static OracleSwitch *const switches[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SWITCH(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

static const double DEFAULT_EXPONENT = 4;
static const double GREATEST_EXPONENT = 65504;
static const double MISSING_GRAY = 128. / 255; /* the color java.awt.Color.GRAY */

static void set_colour(SlotValues *result, Slot slot, const double rgb[3])
{
    memcpy(result->component[slot], rgb, 3 * sizeof *rgb);
}

void oracle_query_colour(Environment *environment, const Node *node, int param, double rgb[3])
{
    for (int component = 0; component < 3; component++)
        rgb[component] =
            oracle_query_param(environment, node, param, channel_id(GROUP_R, component));
}

static void slot_colour(Environment *environment, const Node *node, int param, Slot slot,
                        SlotValues *result)
{
    oracle_query_colour(environment, node, param, result->component[slot]);
}

void oracle_set_normal(const Environment *environment, const double normal[3], SlotValues *result)
{
    double *component = result->component[SLOT_normal];
    oracle_call(environment, FN_safeNormalize, normal, component);
    if (environment->surface->front)
        return;
    for (int i = 0; i < 3; i++)
        component[i] = -component[i];
}

/* Sets a black Phong without maps: the base of the other materials. */
static void set_neutral(const Environment *environment, SlotValues *result)
{
    memset(result, 0, sizeof *result);
    oracle_set_normal(environment, &environment->surface->root[channel_id(GROUP_N, 0)], result);
    result->component[SLOT_alpha][0] = result->component[SLOT_filmIor][0] = 1;
    for (int component = 0; component < 3; component++)
        result->component[SLOT_coatTint][component] = 1;
    result->component[SLOT_shininess][0] = DEFAULT_EXPONENT;
    result->component[SLOT_transparencyShininess][0] = GREATEST_EXPONENT;
    result->component[SLOT_interpolatedTransparency][0] = 1;
    result->component[SLOT_ior][0] = environment->surface->root[channel_id(GROUP_IOR, 0)];
}

/* Sets a Phong from an RGBA: diffuse rgb of alpha 1, and transparency 1 - a. */
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

static void missing(SlotValues *result)
{
    set_rgba((double[3]){MISSING_GRAY, MISSING_GRAY, MISSING_GRAY}, 1, result);
}

/* Sets the Phong exponent that a shininess map encodes; a parameter without a map keeps the
 * neutral exponent. */
static void exponent(Environment *environment, const Node *material, int param, Slot slot,
                     SlotValues *result)
{
    if (node_param(material, param)->kind == VALUE_none)
        return;
    double red = oracle_query_param(environment, material, param, channel_id(GROUP_R, 0));
    oracle_call(environment, FN_phongExponent, &red, result->component[slot]);
}

/* Sets the transparency. The diffuse map's alpha makes the surface transparent: at 0 completely,
 * at 1 the transparency map decides. */
static void transparency(Environment *environment, const Node *material, SlotValues *result)
{
    double alpha =
        oracle_query_param(environment, material, P_Phong_diffuse, channel_id(GROUP_R, 3));
    double colour[3];
    oracle_query_colour(environment, material, P_Phong_transparency, colour);
    result->component[SLOT_alpha][0] = alpha;
    for (int i = 0; i < 3; i++)
        result->component[SLOT_transparency][i] = 1 + alpha * (colour[i] - 1);
}

/* Evaluates a Phong. Only the normal and the index of refraction come from `input`; the other
 * maps read the surface. */
void oracle_Phong(Environment *environment, const Node *material, SlotValues *result)
{
    double normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] =
            oracle_query_param(environment, material, P_Phong_input, channel_id(GROUP_N, i));
    oracle_set_normal(environment, normal, result);
    result->component[SLOT_ior][0] =
        oracle_query_param(environment, material, P_Phong_input, channel_id(GROUP_IOR, 0));
    slot_colour(environment, material, P_Phong_diffuse, SLOT_diffuse, result);
    slot_colour(environment, material, P_Phong_specular, SLOT_specular, result);
    slot_colour(environment, material, P_Phong_diffuseTransparency, SLOT_diffuseTransparency,
                result);
    slot_colour(environment, material, P_Phong_ambient, SLOT_ambient, result);
    slot_colour(environment, material, P_Phong_emissive, SLOT_emissive, result);
    transparency(environment, material, result);
    exponent(environment, material, P_Phong_shininess, SLOT_shininess, result);
    exponent(environment, material, P_Phong_transparencyShininess, SLOT_transparencyShininess,
             result);
    result->component[SLOT_interpolatedTransparency][0] =
        oracle_number(material, P_Phong_interpolatedTransparency) != 0;
}

/* Arguments of skyRadiance: the view direction (of any length), the sun's direction, zenith over
 * F(0, theta of the sun), and A to E. */
enum { SKY_VIEW, SKY_SUN, SKY_ZENITH, SKY_A, SKY_ARGUMENTS = SKY_A + 5 };

/* Returns the coefficients of the sky with these numbers, usually those of the previous point. */
static const OracleSky *sky_of(Oracle *oracle, const double numbers[5])
{
    OracleSky *sky = &oracle->sky;
    if (!sky->known || memcmp(sky->numbers, numbers, sizeof sky->numbers) != 0) {
        memcpy(sky->numbers, numbers, sizeof sky->numbers);
        sky_coefficients(numbers, numbers[3], numbers[4], sky->rows);
        sky->known = true;
    }
    return sky;
}

void oracle_SunSkyLight(Environment *environment, const Node *material, SlotValues *result)
{
    double numbers[5], args[SKY_ARGUMENTS][3];
    oracle_number3(material, P_SunSkyLight_sun, numbers);
    numbers[3] = oracle_number(material, P_SunSkyLight_turbidity);
    numbers[4] = oracle_number(material, P_SunSkyLight_radianceFactor);
    const OracleSky *sky = sky_of(environment->oracle, numbers);
    memcpy(args[SKY_VIEW], &environment->surface->root[channel_id(GROUP_X, 0)],
           sizeof args[SKY_VIEW]);
    memcpy(args[SKY_SUN], sky->rows[SKY_ROW_SUN], sizeof sky->rows[SKY_ROW_SUN]);
    memcpy(args[SKY_ZENITH], sky->rows[SKY_ROW_ZENITH], sizeof sky->rows[SKY_ROW_ZENITH]);
    memcpy(args[SKY_A], sky->rows[SKY_ROW_A], 5 * sizeof sky->rows[SKY_ROW_A]);
    oracle_call(environment, FN_skyRadiance, &args[0][0], result->component[SLOT_emissive]);
}

const Node *oracle_material_of(const Node *material, int param)
{
    const Value *value = node_param(material, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

/* Returns the material of a side. A missing back is replaced by the front; a missing front stays
 * missing, whatever the back is. */
const Node *oracle_choose_SideSwitch(const Node *material, bool front)
{
    const Node *back = front ? NULL : oracle_material_of(material, P_SideSwitch_backShader);
    return back ? back : oracle_material_of(material, P_SideSwitch_frontShader);
}

const Node *oracle_choose_AlgorithmSwitch(const Node *material, bool front)
{
    (void)front;
    const int order[] = {P_AlgorithmSwitch_guiShader, P_AlgorithmSwitch_raytracerShader,
                         P_AlgorithmSwitch_radiationShader};
    for (int i = 0; i < 3; i++) {
        const Node *choice = oracle_material_of(material, order[i]);
        if (choice)
            return choice;
    }
    return NULL;
}

/* Returns the material that a switch chooses, through any number of nested switches; NULL if
 * missing. */
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

static void answer(Environment *environment, const Node *material, SlotValues *result)
{
    set_neutral(environment, result);
    const Node *shader = chosen(material, environment->surface->front);
    if (shader)
        shaders[shader->kind](environment, shader, result);
    else
        missing(result);
    if (oracle_is_principled(environment, material) &&
        result->component[SLOT_model][0] != MODEL_Principled)
        oracle_as_principled(result);
}

void oracle_map_value_as(Environment *environment, const Node *whole, const Node *side,
                         SlotValues *result)
{
    answer(environment, side, result);
    if (oracle_is_principled(environment, whole) &&
        result->component[SLOT_model][0] != MODEL_Principled)
        oracle_as_principled(result);
}

/* Returns the surface for evaluating a shape, which depends on neither viewer nor object: the
 * direction to the viewer is the normal, mesh attributes have their defaults, and the object's
 * random number is 0. */
static Surface unseen(const Surface *surface)
{
    Surface made = *surface;
    memcpy(&made.root[channel_id(GROUP_E, 0)], &surface->root[channel_id(GROUP_N, 0)],
           3 * sizeof *made.root);
    made.root[channel_id(GROUP_E, 3)] = 0;
    made.root[channel_id(GROUP_O, 0)] = 0;
    made.has = 0;
    return made;
}

/* Evaluates a material with displacement. Maps read the undisplaced mesh; only the normals, and
 * the maps in `input`, use the displaced surface. */
static void map_value_displaced(Environment *environment, const Node *material, SlotValues *result)
{
    const Node *displaced = oracle_displaced(material);
    answer(environment, material, result);
    if (!displaced || graph_displaces_volume(displaced))
        return;
    SlotValues moved;
    Surface surface = *environment->surface;
    const Surface shape = unseen(environment->surface);
    Environment shaped = environment_open(environment->oracle, &shape, environment->depth);
    oracle_displace(&shaped, displaced, &surface);
    Environment there = environment_open(environment->oracle, &surface, environment->depth + 1);
    there.mesh = environment->surface;
    answer(&there, material, &moved);
    memcpy(result->component[SLOT_normal], moved.component[SLOT_normal],
           sizeof result->component[SLOT_normal]);
    memcpy(result->component[SLOT_coatNormal], moved.component[SLOT_coatNormal],
           sizeof result->component[SLOT_coatNormal]);
}

typedef struct {
    Environment environment;
    const Node *material;
    SlotValues *result;
} Question;

static void map_value_on_stack(void *user)
{
    Question *question = user;
    map_value_displaced(&question->environment, question->material, question->result);
}

bool oracle_material(Oracle *oracle, const Node *material, const Surface *surface,
                     SlotValues *result)
{
    Question question = {environment_open(oracle, surface, 0), material, result};
    oracle->work = 0;
    stack_run(material ? material->depth : 0, map_value_on_stack, &question);
    return !oracle_spent(oracle);
}

typedef struct {
    Environment environment;
    const Node *displaced;
    bool slopes; /* slopes are evaluated, too */
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

static bool move(Oracle *oracle, const Node *material, const Surface *surface, bool slopes,
                 OracleDisplacement *result)
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

bool oracle_displacement(Oracle *oracle, const Node *material, const Surface *surface,
                         OracleDisplacement *result)
{
    return move(oracle, material, surface, true, result);
}

bool oracle_displacement_at(Oracle *oracle, const Node *material, const Surface *surface,
                            double by[ORACLE_HEIGHTS])
{
    OracleDisplacement found;
    const bool fine = move(oracle, material, surface, false, &found);
    memcpy(by, found.by, sizeof found.by);
    return fine;
}
