/* Warnings about constants that look as if they were meant in another unit, and about colours where
 * a normal is wanted. */
#include "compiler/base/text.h"
#include "compiler/hints/doubt.h"
#include <math.h>
#include <string.h>

/* The first lane of a constant map, the greatest of a list of numbers, the default of a param;
 * false: it is none of these. */
static bool lane_of(const Value *value, double *lane)
{
    const bool map = value->kind == VALUE_node && value->node->kind == KIND_Constant;
    const Value *number = map ? &value->node->params[0] : value;
    if (!value->given || (number->kind != VALUE_number && number->kind != VALUE_uniform))
        return false;
    const double *lanes = number->kind == VALUE_uniform ? number->uniform->initial : number->number;
    *lane = lanes[0];
    for (int i = 1; !map && i < type_table[number->type].lanes; i++)
        *lane = fabs(lanes[i]) > fabs(*lane) ? lanes[i] : *lane;
    return true;
}

/* "; 45 degrees are 0.7854" */
static void put_meant(Text *out, const UnitRow *unit, double number)
{
    const double meant = number * unit->factor;
    text_put(out, "");
    if (!*unit->other || meant < unit->low || meant > unit->high || fabs(number) < 2 * unit->high)
        return;
    text_put(out, "; ");
    text_plain(out, number);
    text_format(out, " %s are ", unit->other);
    text_plain(out, round(meant * 1e4) / 1e4);
}

void doubt_unit(Session *session, const char *name, const UnitRow *unit, const Value *value)
{
    double number;
    if (!unit || unit == &unit_table[UNIT_gloss] || !lane_of(value, &number) ||
        (number >= unit->low && number <= unit->high))
        return;
    Text is = text_new(session->arena), low = text_new(session->arena),
         high = text_new(session->arena);
    Text meant = text_new(session->arena);
    text_plain(&is, number);
    text_plain(&low, round(unit->low * 1e3) / 1e3);
    text_plain(&high, round(unit->high * 1e3) / 1e3);
    if (*unit->name)
        text_format(&is, " %s", unit->name);
    put_meant(&meant, unit, number);
    diag_add(session, value->span, DIAG_unusual_number, name, is.at, low.at, high.at, meant.at);
}

void doubt_units(Session *session, const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    /* of another model's numbers, which were looked at as such */
    const bool made = node->written && node->written != node->kind;
    for (int i = 0; i < row->count && !made; i++) {
        const UnitRow *unit = unit_of(row->first + i);
        if (unit && node->params[i].given)
            doubt_unit(session, node_written_param(node, i), unit, &node->params[i]);
    }
}

/* It makes colours of a place, or is one number, and no direction. */
static bool is_plain(const Node *map)
{
    const Section section = section_of(map->kind);
    const bool number = map->kind == KIND_Constant && type_table[map->params[0].type].lanes == 1;
    return number || section == SECTION_surface || section == SECTION_volume ||
           section == SECTION_dimensions;
}

void doubt_normals(Session *session, const Node *material)
{
    static const char *const names[] = {"input", "coatNormal", "tangent", "coatTangent"};
    const KindRow *row = &kind_table[material->kind];
    for (int i = 0; i < row->count; i++) {
        const Value *value = &material->params[i];
        size_t name = 0;
        if (value->kind != VALUE_node || !is_plain(value->node))
            continue;
        while (name < sizeof names / sizeof *names &&
               strcmp(names[name], param_table[row->first + i].name) != 0)
            name++;
        if (name == sizeof names / sizeof *names)
            continue;
        const bool direction = name >= 2;
        diag_add(session, value->span, direction ? DIAG_plain_direction : DIAG_plain_normal,
                 node_written_param(material, i),
                 value->node->kind == KIND_Constant ? "a number"
                                                    : kind_table[value->node->kind].name);
    }
}
