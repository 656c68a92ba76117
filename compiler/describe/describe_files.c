/* matc --schema=manifest and similar: JSON Schemas (2020-12) of the file types of files.def. */
#include "compiler/base/session.h"
#include "compiler/describe/describe.h"
#include "compiler/base/json_write.h"
#include "compiler/matc.h"
#include <string.h>

/* Appends a name to a JSON list. */
static void put_name(Text *out, const char *name, size_t size, bool first)
{
    text_put(out, first ? "" : ", ");
    json_bytes(out, name, size);
}

static const char *target_name(int i) { return target_table[i].name; }
static const char *pass_name(int i) { return pass_table[i].name; }
static const char *slot_name(int i) { return slot_table[i].name; }
static const char *normals_name(int i) { return normals_table[i].name; }
static const char *format_name(int i) { return format_table[i + 1].name; } /* skips FORMAT_none */
static const char *encoding_name(int i) { return encoding_table[i].name; }

/* Tables whose names are choices. */
static const struct {
    const char *of;
    const char *(*name)(int i);
    int count;
} tables[] = {
    {"target", target_name, TARGET_COUNT},     {"pass", pass_name, PASS_COUNT},
    {"slot", slot_name, SLOT_COUNT},           {"normals", normals_name, NORMALS_COUNT},
    {"format", format_name, FORMAT_COUNT - 1}, {"encoding", encoding_name, ENCODING_COUNT},
};
enum { TABLE_COUNT = sizeof tables / sizeof *tables };

/* Writes "enum": [...] with a table's names, or with the names in `of` itself. */
static void put_choice(Text *out, const char *of)
{
    int table = 0;
    while (table < TABLE_COUNT && strcmp(tables[table].of, of) != 0)
        table++;
    text_put(out, "\"enum\": [");
    if (table < TABLE_COUNT)
        for (int i = 0; i < tables[table].count; i++)
            put_name(out, tables[table].name(i), strlen(tables[table].name(i)), i == 0);
    else
        for (const char *at = of; *at; at += strspn(at, "|")) {
            size_t size = strcspn(at, "|");
            put_name(out, at, size, at == of);
            at += size;
        }
    text_put(out, "]");
}

/* Writes an object with a choice for every axis of variants.def. */
static void put_choices(Text *out)
{
    text_put(out, "\"type\": \"object\", \"additionalProperties\": false, \"properties\": {");
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        text_format(out, "%s\n          \"%s\": {\"description\": ", axis ? "," : "",
                    axis_table[axis].name);
        json_string(out, axis_table[axis].doc);
        text_put(out, ", \"enum\": [");
        for (int i = 0; i < axis_choices((Axis)axis); i++) {
            const char *name = choice_table[axis_table[axis].first + i].name;
            put_name(out, name, strlen(name), i == 0);
        }
        text_put(out, "]}");
    }
    text_put(out, "\n        }");
}

/* Writes the schema of "diffuse", "diffuse.rg", and lists of them: one alternative per slot. */
static void put_slots_definition(Text *out)
{
    text_put(out, "    \"slot\": {\n      \"type\": \"string\",\n      \"pattern\": \"^(");
    for (int i = 0; i < SLOT_COUNT; i++) {
        int components = type_table[slot_table[i].type].components;
        text_format(out, "%s%s([.][%.*s%.*s]+)?", i ? "|" : "", slot_table[i].name, components,
                    "rgba", components, "xyzw");
    }
    text_put(
        out,
        ")$\"\n    },\n"
        "    \"slots\": {\"anyOf\": [{\"$ref\": \"#/$defs/slot\"}, "
        "{\"type\": \"array\", \"items\": {\"$ref\": \"#/$defs/slot\"}, \"minItems\": 1}]},\n");
}

static void put_slot_constants(Text *out)
{
    text_put(out, "\"type\": \"object\", \"additionalProperties\": false, \"properties\": {");
    for (int i = 0; i < SLOT_COUNT; i++) {
        int components = type_table[slot_table[i].type].components;
        text_format(out, "%s\n          \"%s\": {\"description\": ", i ? "," : "",
                    slot_table[i].name);
        json_string(out, slot_table[i].doc);
        text_put(out, ", \"anyOf\": [{\"type\": \"number\"}, ");
        text_format(out,
                    "{\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": %d, "
                    "\"maxItems\": %d}]}",
                    components, components);
    }
    text_put(out, "\n        }");
}

/* Writes the schema of a value as members of a JSON object. */
static void put_type(Text *out, const FileRow *row)
{
    static const char *const plain[] = {
        [MEMBER_text] = "\"type\": \"string\"",
        [MEMBER_name] = "\"type\": \"string\", \"pattern\": \"^[A-Za-z_][A-Za-z0-9_]*$\"",
        [MEMBER_key] = "\"type\": \"string\", \"pattern\": \"^[0-9a-f]{32}$\"",
        [MEMBER_whole] = "\"type\": \"integer\", \"minimum\": 0",
        [MEMBER_number] = "\"type\": \"number\"",
        [MEMBER_yes] = "\"const\": true",
        [MEMBER_flag] = "\"type\": \"boolean\"",
        [MEMBER_texts] = "\"type\": \"array\", \"items\": {\"type\": \"string\"}",
        [MEMBER_names] = "\"type\": \"array\", \"items\": {\"type\": \"string\"}",
        [MEMBER_numbers] =
            "\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 1",
        [MEMBER_rows] = "\"type\": \"array\", \"items\": {\"type\": \"array\", \"items\": "
                        "{\"type\": \"number\"}, "
                        "\"minItems\": 1, \"maxItems\": 4}",
        [MEMBER_textsByName] =
            "\"type\": \"object\", \"additionalProperties\": {\"type\": \"string\"}",
        [MEMBER_numbersByName] =
            "\"type\": \"object\", \"additionalProperties\": {\"type\": \"array\", \"items\": "
            "{\"type\": \"number\"}, \"minItems\": 1, \"maxItems\": 4}",
        [MEMBER_identifier] = "\"type\": \"string\", \"pattern\": \"^[A-Za-z][A-Za-z0-9_.-]*$\"",
        [MEMBER_label] = "\"type\": [\"string\", \"number\", \"boolean\"]",
        [MEMBER_pair] = "\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 2, "
                        "\"maxItems\": 2",
    };
    switch (row->type) {
    case MEMBER_choice:
    case MEMBER_encoding:
        put_choice(out, row->type == MEMBER_encoding ? "encoding" : row->of);
        break;
    case MEMBER_choiceList:
        text_put(out, "\"type\": \"array\", \"minItems\": 1, \"items\": {");
        put_choice(out, row->of);
        text_put(out, "}");
        break;
    case MEMBER_object:
        text_format(out, "\"$ref\": \"#/$defs/%s\"", row->of);
        break;
    case MEMBER_objects:
        text_format(out, "\"type\": \"array\", \"items\": {\"$ref\": \"#/$defs/%s\"}", row->of);
        break;
    case MEMBER_choices:
        put_choices(out);
        break;
    case MEMBER_slotComponents:
        text_put(out, "\"$ref\": \"#/$defs/slots\"");
        break;
    case MEMBER_slotConstants:
        put_slot_constants(out);
        break;
    default:
        text_put(out, plain[row->type]);
    }
}

/* Writes the range of bits of each encoding. */
static void put_encodings(Text *out)
{
    text_put(out, ",\n      \"allOf\": [");
    for (int i = 0; i < ENCODING_COUNT; i++) {
        const EncodingRow *row = &encoding_table[i];
        text_format(out,
                    "%s\n        {\"if\": {\"properties\": {\"encoding\": {\"const\": \"%s\"}}, "
                    "\"required\": "
                    "[\"encoding\"]}, \"then\": {\"properties\": {\"bits\": {\"minimum\": %d, "
                    "\"maximum\": %d}}",
                    i ? "," : "", row->name, row->least, row->most);
        text_put(out, row->least != row->most ? ", \"required\": [\"bits\"]}}" : "}}");
    }
    text_put(out, "\n      ]");
}

/* Writes a member. In layout files, which are hand-written, a null value equals an absent
 * member. */
static void put_member(Text *out, const FileRow *row, bool written_by_people)
{
    text_format(out, "\n        \"%s\": {\"description\": ", row->name);
    json_string(out, row->doc);
    text_put(out, ", ");
    if (written_by_people && !row->must) {
        text_put(out, "\"anyOf\": [{\"type\": \"null\"}, {");
        put_type(out, row);
        text_put(out, "}]}");
    } else {
        put_type(out, row);
        text_put(out, "}");
    }
}

/* Writes the object at a row with its members. Returns the row after them. */
static int put_object(Text *out, int at, bool written_by_people)
{
    int first = at + 1, end = first;
    bool encodings = false, any = false;
    text_format(out, "    \"%s\": {\n      \"description\": ", file_table[at].name);
    json_string(out, file_table[at].doc);
    text_put(
        out,
        ",\n      \"type\": \"object\", \"additionalProperties\": false,\n      \"required\": [");
    for (; end < file_row_count && file_table[end].kind == FILE_ROW_member; end++)
        if (file_table[end].must) {
            put_name(out, file_table[end].name, strlen(file_table[end].name), !any);
            any = true;
        }
    text_put(out, "],\n      \"properties\": {");
    for (int i = first; i < end; i++) {
        text_put(out, i > first ? "," : "");
        put_member(out, &file_table[i], written_by_people);
        encodings |= file_table[i].type == MEMBER_encoding;
    }
    text_put(out, "\n      }");
    if (encodings)
        put_encodings(out);
    text_put(out, "\n    }");
    return end;
}

char *describe_file(const char *name)
{
    int at = 0;
    while (at < file_row_count &&
           (file_table[at].kind != FILE_ROW_file || strcmp(file_table[at].name, name) != 0))
        at++;
    if (at == file_row_count)
        return NULL;
    Arena arena = {0};
    Text out = text_new(&arena);
    const bool layout = !strcmp(name, "layout");
    text_format(&out,
                "{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n  \"title\": "
                "\"matc %s %s\",\n",
                MATC_VERSION, name);
    text_put(&out, "  \"description\": ");
    json_string(&out, file_table[at].doc);
    text_format(&out, ",\n  \"$ref\": \"#/$defs/%s\",\n  \"$defs\": {\n", file_table[at + 1].name);
    if (layout)
        put_slots_definition(&out);
    for (int row = at + 1; row < file_row_count && file_table[row].kind == FILE_ROW_object;) {
        text_put(&out, row > at + 1 ? ",\n" : "");
        row = put_object(&out, row, layout);
    }
    text_put(&out, "\n  }\n}\n");
    return describe_finish(&out);
}
