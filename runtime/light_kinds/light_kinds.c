/* The table of light kinds. */
#include "runtime/light_kinds/light_kind.h"

typedef enum {
#define LIGHT_KIND(kind, row) LIGHT_KIND_##kind,
#include "runtime/light_kinds/light_kinds.def"
    LIGHT_KIND_COUNT
} LightKindNumber;
_Static_assert((int)LIGHT_KIND_COUNT <= (int)LIGHT_KINDS_MAX, "room for all kinds");

#define LIGHT_KIND(kind, row) extern const LightKind row;
#include "runtime/light_kinds/light_kinds.def"

const LightKind *const light_kind_table[LIGHT_KINDS_MAX + 1] = {
#define LIGHT_KIND(kind, row) [LIGHT_KIND_##kind] = &row,
#include "runtime/light_kinds/light_kinds.def"
};
static const int numbers[SCENE_KIND_COUNT] = {
#define LIGHT_KIND(kind, row) [SCENE_##kind] = LIGHT_KIND_##kind,
#include "runtime/light_kinds/light_kinds.def"
};

int light_kind_number(SceneKind kind) { return numbers[kind]; }

const LightKind *light_kind_of(const SceneLight *light)
{
    return light_kind_table[numbers[light->kind]];
}

const char *light_kind_name(const LightKind *row) { return scene_kind_table[row->kind].name; }

bool light_kind_is_wide(const SceneLight *light)
{
    const LightKind *row = light_kind_of(light);
    return row->from == LIGHT_FROM_point &&
           (!row->cone || light->outer_cosine <= LIGHT_KIND_WIDEST);
}
