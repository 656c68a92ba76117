#include "tests/value/ways.h"
#include "tests/value/share.h"
#include <math.h>
#include <stdio.h>

/* Without a footprint, filtered maps have the values of unfiltered ones. */
const Way way_table[] = {
    {TARGET_glsl330, 0, CHOICE_noise_lattice, false},
    {TARGET_glsl330, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl110, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl450, 2, CHOICE_noise_lattice, false},
    {TARGET_essl300, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl330, 2, CHOICE_noise_groimp, false},
    {TARGET_glsl110, 2, CHOICE_noise_groimp, false},
    {TARGET_glsl330, 2, CHOICE_noise_simplex, false},
    {TARGET_glsl110, 2, CHOICE_noise_simplex, false},
    {TARGET_glsl330, 2, CHOICE_derivatives_finite, false},
    {TARGET_glsl110, 2, CHOICE_derivatives_finite, false},
    {TARGET_glsl330, 2, CHOICE_derivatives_analytic, false},
    {TARGET_glsl110, 2, CHOICE_derivatives_analytic, false},
    {TARGET_glsl330, 2, CHOICE_aa_box, false},
    {TARGET_glsl330, 2, CHOICE_coordinates_long, false},
    {TARGET_glsl330, 2, CHOICE_trigonometry_bounded, false},
    {TARGET_glsl330, 2, CHOICE_powers_compensated, false},
    {TARGET_glsl330, 2, CHOICE_noise_lattice, true},
    {TARGET_glsl110, 2, CHOICE_noise_lattice, true},
    {TARGET_glsl450, 0, CHOICE_noise_lattice, true},
    {TARGET_glsl330, 0, CHOICE_aa_auto, false},
    {TARGET_glsl330, 2, CHOICE_aa_auto, false},
    {TARGET_glsl110, 2, CHOICE_aa_auto, false},
    {TARGET_essl300, 2, CHOICE_aa_auto, false},
};
const int way_count = sizeof way_table / sizeof *way_table;

const char *way_name(const Way *way, bool front, char text[64])
{
    snprintf(text, 64, "%s -O%d %s%s%s", target_table[way->target].name, way->optimize,
             choice_table[way->choice].name, way->buffered ? " buffered" : "",
             front ? "" : " back");
    return text;
}

void way_options(const Way *way, Slot slot, MatcOptions *options)
{
    const ChoiceRow *choice = &choice_table[way->choice];
    options->pass = "value";
    options->slot = slot_table[slot].name;
    options->target = target_table[way->target].name;
    options->aa = "none";
    matc_options_set(options, axis_table[choice->axis].name, choice->name);
    options->optimize = way->optimize;
    options->constants = way->buffered ? "uniform" : "baked";
    options->validate = false;
}

bool way_matters(const Way *way, const Subjects *subjects)
{
    const Choice choice = way->choice;
    if (choice == CHOICE_aa_auto) /* its means are those of aa=box */
        return subjects->has[KIND_ImageMap] || subjects->has[KIND_Checker] ||
               subjects->has[KIND_Gradient];
    if (axis_table[choice_table[choice].axis].first == (int)choice)
        return true;
    if (choice_table[choice].axis == AXIS_noise)
        return subjects_noise(subjects);
    return choice_table[choice].axis != AXIS_derivatives || subjects->has[KIND_BumpMap] ||
           subjects->displaced;
}

ReferenceNoise way_noise(const Way *way)
{
    return job_noise(choice_table[way->choice].axis == AXIS_noise ? way->choice
                                                                  : CHOICE_noise_lattice,
                     way->target);
}

Choice way_derivatives(const Way *way)
{
    return choice_table[way->choice].axis == AXIS_derivatives ? way->choice
                                                              : CHOICE_derivatives_auto;
}

/* The oracle computes all slots at once, which takes most of the time. Modes that need another
 * noise or derivative of the oracle are therefore in a single share of a material, with all
 * slots; modes of the plain oracle, which every share needs, are spread over the shares. */
bool way_taken(const Way *way, Slot slot, int number)
{
    enum { SHARES = 6 };
    const int noise = (int)way_noise(way),
              derivatives = (int)way_derivatives(way) - CHOICE_derivatives_auto;
    const bool plain = noise == REFERENCE_LATTICE && !derivatives;
    return share_takes(
        plain ? (int)slot + (int)(way - way_table) : number + noise + 3 * derivatives, SHARES);
}

bool way_samples(const Way *way, const Subjects *subjects)
{
    return way->choice == CHOICE_aa_auto && subjects->has[KIND_ImageMap];
}

/* Bound for pictures of 16 bits or floats: a target without float textures keeps 11 bits, which
 * drivers may truncate: 2^-11 of the value. */
static double half_bound(const Document *document, Target target)
{
    for (int i = 0; i < document->graph->image_count; i++) {
        const Image *image = document->graph->images[i];
        if ((image->bits == 16 && !target_table[target].word_textures) ||
            (image->bits == 32 && !image->halves && !target_table[target].float_filters))
            return 0x1p-11;
    }
    return 0;
}

double way_bound(const Way *way, const Document *document, int governing)
{
    return fmax(bound_table[governing].bound, half_bound(document, way->target));
}

/* Distances beyond which differences of the oracle's doubles are no measure of a derivative, and
 * beyond which the bounded sine's error bound does not hold. */
static const float far_for_slopes = 1000, far_for_sines = 1e5f;
/* Distance beyond which half a texel is lost to the rounding of a coordinate: the sampler's
 * coordinates are floats, too. test_filtered_picture covers slopes of sampled pictures for
 * BumpMap on targets without texel fetches. */
static const float far_for_samplers = 100;
/* Distance beyond which the points of a filter, each rounded separately, have wrong spacings: a
 * hull moves all of them alike. */
static const float far_for_filters = 1000;
/* Distance beyond which the point of a cell, a float, is off by more than its map's value may
 * vary: a hull moves the position, but not the cell's point. */
static const float far_for_centres = 3;

/* True if simplex noise is exactly 0 at a lattice point on a checker's edge, where it moves
 * values by no more than rounding. */
static bool point_on_edges(const Point *point)
{
    const float near = 1e-5f, *u = point->input[INPUT_U];
    return fabsf(4 * u[0] - rintf(4 * u[0])) < near && fabsf(4 * u[1] - rintf(4 * u[1])) < near;
}

/* True if the values depend on slopes that the oracle approximates by finite differences. */
static bool has_slopes(const Way *way, const Subjects *subjects)
{
    return subjects_slopes(subjects, way->choice) &&
           subjects->has[SUBJECT_SLOTS + (int)SLOT_normal];
}

bool way_judges(const Way *way, const Subjects *subjects, const Point *point)
{
    const bool sampled = way_samples(way, subjects);
    const bool by_slopes_of_samplers =
        (subjects->has[KIND_BumpMap] || subjects->displaced) && !target_table[way->target].words;
    const bool filters = subjects->has[KIND_Laplace3D] || subjects->has[KIND_Smooth3D];
    return !point_is_extreme(point) &&
           !(has_slopes(way, subjects) && point_is_far(point, far_for_slopes)) &&
           !(way->choice == CHOICE_trigonometry_bounded && point_is_far(point, far_for_sines)) &&
           !(sampled && (by_slopes_of_samplers || point_is_far(point, far_for_samplers))) &&
           !(filters && point_is_far(point, far_for_filters)) &&
           !(subjects->has[KIND_CellCentre] && point_is_far(point, far_for_centres)) &&
           !(way->choice == CHOICE_noise_simplex && point_on_edges(point));
}
