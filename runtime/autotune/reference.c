/* Evaluates reference values and measures errors against them. */
#include "compiler/evaluate.h"
#include "runtime/autotune/autotune.h"
#include <math.h>
#include <stdlib.h>

bool autotune_reference(const AutotuneRequest *request, const Variant *variant,
                        const FieldVertex *points, SlotValues *values)
{
    MatcOptions options = variant_options(variant, request->options);
    options.target = NULL; /* the drawn programs are GLSL 3.30 */
    Surface *surfaces = calloc(POINTS, sizeof *surfaces);
    if (!surfaces)
        abort();
    for (int i = 0; i < POINTS; i++)
        sample_surface(&points[i], &surfaces[i]);
    bool known = evaluate_material(request->document, request->material, &options,
                                   (SurfacePoints){surfaces, POINTS}, values);
    free(surfaces);
    return known;
}

static double distance(const SlotRow *row, double found, double wanted)
{
    if (!isfinite(found))
        return INFINITY;
    double right = clamp(wanted, row->low, row->high);
    return fabs(clamp(found, row->low, row->high) - right) / fmax(1, fabs(right));
}

Distance autotune_distance(Slot slot, const SlotValues *found, const SlotValues *wanted, int count)
{
    const SlotRow *row = &slot_table[slot];
    int components = type_table[row->type].components;
    double most = 0, squares = 0;
    for (int i = 0; i < count; i++)
        for (int component = 0; component < components; component++) {
            double d = distance(row, found[i].component[slot][component],
                                wanted[i].component[slot][component]);
            most = fmax(most, d);
            squares += d * d;
        }
    return (Distance){most, sqrt(squares / fmax(1, (double)count * components))};
}
