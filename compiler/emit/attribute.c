/* Maps mesh attributes of a document to GLSL names and locations. */
#include "compiler/emit/attribute.h"
#include "compiler/base/json_write.h"
#include "compiler/emit/emit_declare.h"
#include <string.h>

int emit_input_location(Input input)
{
    int location = 0;
    for (int i = 0; i < (int)input; i++)
        location += input_table[i].source == SOURCE_varying;
    return location;
}

/* Returns the location of the object attributes: after all varyings and the material number of
 * an instance. */
int emit_object_location(void) { return emit_input_location(INPUT_COUNT) + 1; }

int attribute_location(int attribute) { return emit_object_location() + 1 + attribute; }

static const char *type_of(const MeshAttribute *attribute)
{
    return type_table[attribute->type].name;
}

const char *attribute_declaration(const Ir *ir, int attribute)
{
    Text text = text_new(ir->arena);
    text_format(&text, "%s attribute_%s", type_of(ir->graph->attributes[attribute]),
                ir->graph->attributes[attribute]->name);
    return text.at;
}

void attribute_put_name(Text *out, const MeshAttribute *attribute, AttributePart part)
{
    static const char *const ends[ATTRIBUTE_PARTS] = {"", "ByX", "ByY"};
    text_format(out, "matc_attribute_%s%s", attribute->name, ends[part]);
}

void attribute_put_varyings(Text *out, const Job *job, const Interface *interface, const char *word)
{
    for (int i = 0; i < LIMIT_ATTRIBUTES; i++) {
        if (!interface->attributes[i])
            continue;
        if (target_table[job->target].locations)
            text_format(out, "layout(location = %d) ", attribute_location(i));
        text_format(out, "%s %s ", target_table[job->target].in_out ? word : "varying",
                    type_of(interface->ir->graph->attributes[i]));
        attribute_put_name(out, interface->ir->graph->attributes[i], ATTRIBUTE_value);
        text_put(out, ";\n");
    }
}

void attribute_hand_on(Text *out, const Interface *interface)
{
    for (int i = 0; i < LIMIT_ATTRIBUTES; i++) {
        if (!interface->attributes[i])
            continue;
        text_put(out, "    ");
        attribute_put_name(out, interface->ir->graph->attributes[i], ATTRIBUTE_value);
        text_format(out, " = attribute_%s;\n", interface->ir->graph->attributes[i]->name);
    }
}

static void put_change(Text *out, const MeshAttribute *attribute, AttributePart part,
                       AttributeChanges form)
{
    text_put(out, form == ATTRIBUTE_CHANGES_declared ? "" : "    ");
    if (form != ATTRIBUTE_CHANGES_shared)
        text_format(out, "%s ", type_of(attribute));
    attribute_put_name(out, attribute, part);
    if (form != ATTRIBUTE_CHANGES_declared) {
        text_put(out, part == ATTRIBUTE_by_x ? " = dFdx(" : " = dFdy(");
        attribute_put_name(out, attribute, ATTRIBUTE_value);
        text_char(out, ')');
    }
    text_put(out, ";\n");
}

void attribute_put_changes(Text *out, const Interface *interface, AttributeChanges form)
{
    for (int i = 0; i < LIMIT_ATTRIBUTES; i++)
        for (int part = ATTRIBUTE_by_x; interface->attribute_changes[i] && part <= ATTRIBUTE_by_y;
             part++)
            put_change(out, interface->ir->graph->attributes[i], (AttributePart)part, form);
}

void attribute_describe(Text *out, const MeshAttribute *attribute)
{
    json_next(out, "attribute", attribute->name);
    text_put(out, ", \"default\": [");
    for (int component = 0; component < type_table[attribute->type].components; component++) {
        text_put(out, component ? ", " : "");
        text_double(out, attribute->initial[component]);
    }
    text_put(out, "]}");
}

int attribute_list(const Ir *ir, MatcAttribute list[LIMIT_ATTRIBUTES])
{
    bool used[LIMIT_ATTRIBUTES] = {false};
    int count = 0;
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_attribute))
            used[attribute_of(ir_at(ir, ref)->payload)] = true;
    for (int i = 0; i < ir->graph->attribute_count; i++) {
        const MeshAttribute *own = ir->graph->attributes[i];
        const char *declaration = attribute_declaration(ir, i);
        Text varying = text_new(ir->arena);
        attribute_put_name(&varying, own, ATTRIBUTE_value);
        MatcAttribute attribute = {own->name,
                                   strchr(declaration, ' ') + 1,
                                   varying.at,
                                   type_table[own->type].components,
                                   ATTRIBUTE_FIRST_LOCATION + i,
                                   {0}};
        memcpy(attribute.initial, own->initial, sizeof attribute.initial);
        if (used[i])
            list[count++] = attribute;
    }
    return count;
}
