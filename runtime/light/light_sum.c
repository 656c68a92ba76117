/* Composes the GLSL that sums over kinds of lights, from the texts of the scene's kinds.
 *
 *     Area lights and a Hemisphere give
 *     layout(std140) uniform LightKinds { int light_Area; };
 *     vec3 lightAround(Seen seen)
 *     {
 *         vec3 sum = vec3(0.0);
 *         sum += lightFromHemisphere(seen);
 *         return sum;
 *     }
 *     vec3 lightFromKinds(vec3 sum, Seen seen)
 *     {
 *         int light = light_plain + light_points;
 *         for (int i = 0; i < light_Area; i++, light++)
 *             sum += lightFromArea(light, seen);
 *         return sum;
 *     } */
#include "runtime/light/lighting.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>

enum { LIGHT_SUM_NAME = 64 };

static bool is_around(const LightKind *row) { return row->from >= LIGHT_FROM_around; }

/* Reports whether a kind is summed: the scene has such lights, the kind has GLSL, and it is
 * ambient or `places` is set. Ambient light that does not vary by direction is always summed: it
 * costs almost nothing, and scenes with and without it share a program. */
static bool is_summed(const Renderer *renderer, const LightKind *row, bool places)
{
    const Scene *scene = renderer->scene;
    bool summed = row->from == LIGHT_FROM_sky ? light_sky_shines(scene)
                                              : row->from == LIGHT_FROM_around && !row->varies;
    for (int i = 0; i < scene->light_count; i++)
        summed |= scene->lights[i].kind == row->kind;
    return summed && row->glsl && (places || is_around(row));
}

void light_sum_texts(const Renderer *renderer, bool places, ScreenPassText *text)
{
    for (int k = 0; light_kind_table[k]; k++)
        if (is_summed(renderer, light_kind_table[k], places))
            screen_pass_add(text, light_kind_table[k]->glsl);
}

static void put(char composed[LIGHT_SUM_TEXT], const char *before, const char *name,
                const char *after)
{
    const size_t size = strlen(composed);
    const int more =
        snprintf(composed + size, LIGHT_SUM_TEXT - size, "%s%s%s", before, name, after);
    assert(more < LIGHT_SUM_TEXT - (int)size);
    (void)more;
}

/* Declares a uniform for each kind with a position: the number of its lights. */
static void put_numbers(const Renderer *renderer, char composed[LIGHT_SUM_TEXT])
{
    const char *head = "layout(std140) uniform LightKinds {\n    int light_",
               *next = "    int light_";
    bool some = false;
    for (int k = 0; light_kind_table[k]; k++) {
        const LightKind *row = light_kind_table[k];
        if (is_around(row) || !is_summed(renderer, row, true))
            continue;
        put(composed, some ? next : head, light_kind_name(row), ";\n");
        some = true;
    }
    put(composed, some ? "};\n\n" : "", "", "");
}

static void put_sums(const Renderer *renderer, bool around, bool places,
                     char composed[LIGHT_SUM_TEXT])
{
    for (int k = 0; light_kind_table[k]; k++) {
        const LightKind *row = light_kind_table[k];
        const char *name = light_kind_name(row);
        if (is_around(row) != around || !is_summed(renderer, row, places))
            continue;
        if (!around)
            put(composed, "    for (int i = 0; i < light_", name, "; i++, light++)\n    ");
        put(composed, "    sum += lightFrom", name, around ? "(seen);\n" : "(light, seen);\n");
    }
}

void light_sum_compose(const Renderer *renderer, bool places, char composed[LIGHT_SUM_TEXT])
{
    static const char end[] = "    return sum;\n}\n\n";
    *composed = 0;
    if (places)
        put_numbers(renderer, composed);
    put(composed, "vec3 lightAround(Seen seen)\n{\n    vec3 sum = vec3(0.0);\n", "", "");
    put_sums(renderer, true, places, composed);
    put(composed, end, "vec3 lightFromKinds(vec3 sum, Seen seen)\n{\n",
        "    int light = light_plain + light_points;\n");
    put_sums(renderer, false, places, composed);
    put(composed, end, "", "");
}

void light_sum_set(const Renderer *renderer, ScreenPass *pass)
{
    for (int k = 0; light_kind_table[k]; k++) {
        const LightKind *row = light_kind_table[k];
        char count[LIGHT_SUM_NAME];
        float numbers[VIEW_SPACE_AROUND][4];
        snprintf(count, sizeof count, "light_%s", light_kind_name(row));
        view_space_around(&renderer->space, renderer->scene, row, numbers);
        /* the program has the block, or does not sum lights of this kind */
        if (row->from == LIGHT_FROM_around)
            material_write(&pass->material, light_kind_name(row), numbers, sizeof numbers);
        else if (row->glsl && !is_around(row))
            material_set_number(&pass->material, count,
                                (float)renderer->light->counts[VIEW_SPACE_KINDS + k]);
    }
}
