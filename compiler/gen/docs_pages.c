/* Reference of scenes, diagnostics and layouts from the tables. Paragraphs are wrapped at 100
 * columns, as in pages that are written by hand:
 *
 *     - `radius` (number, default 1, 0.000001 to 1e+09): From its centre.
 */
#include "docs_pages.h"
#include "compiler/describe/describe.h"
#include <string.h>

enum { COLUMNS = 100 };

#define MADE "<!-- Made from the tables by compiler/gen/docs_pages.c -->\n\n"

/* Writes text as a paragraph, whose first line already has `start` spaces; lines after it begin
 * with `indent` spaces. */
static void put_wrapped_at(Text *out, const char *text, int start, int indent)
{
    int column = start;
    while (*text) {
        const int length = (int)strcspn(text, " ");
        if (column > start && column + 1 + length > COLUMNS) {
            text_format(out, "\n%*s", indent, "");
            column = indent;
        } else if (column > start) {
            text_char(out, ' ');
            column++;
        }
        for (int i = 0; i < length; i++)
            if (text[i] == '<')
                text_put(out, "&lt;");
            else
                text_char(out, text[i]);
        column += length;
        text += length;
        text += strspn(text, " ");
    }
    text_char(out, '\n');
}

static void put_wrapped(Text *out, const char *text, int indent)
{
    put_wrapped_at(out, text, 0, indent);
}

/* Writes an item of a list that is `indent` spaces in. */
static void put_item(Text *out, int indent, const char *name, const char *doc)
{
    Text line = text_new(out->arena);
    text_format(&line, "- `%s`: %s", name, doc);
    text_format(out, "%*s", indent, "");
    put_wrapped_at(out, line.at, indent, indent + 2);
}

/* Writes the anchor of a heading: a sort's name in lower case. */
static void put_anchor(Text *out, const char *name)
{
    text_char(out, '#');
    for (; *name; name++)
        text_char(out, text_lower(*name));
}

static void put_scene_param(Text *out, const SceneParamRow *row)
{
    Text line = text_new(out->arena), initial = text_new(out->arena), range = text_new(out->arena);
    text_put(&range, "");
    describe_default(&initial, &row->param, NULL);
    if (row->value == SCENE_VALUE_plain)
        describe_range(&range, &row->param);
    text_format(&line, "- `%s` (", row->param.name);
    if (row->value == SCENE_VALUE_one || row->value == SCENE_VALUE_list) {
        text_format(&line, "%s[%s](", row->value == SCENE_VALUE_list ? "list of " : "",
                    scene_sort_table[row->of].name);
        put_anchor(&line, scene_sort_table[row->of].name);
        text_char(&line, ')');
    } else
        text_put(&line, describe_scene_type(row));
    if (strcmp(initial.at, "none"))
        text_format(&line, ", default %s", initial.at);
    if (*range.at)
        text_format(&line, ", %s", range.at);
    if (*row->unit)
        text_format(&line, "%s%s", *range.at ? " " : ", in ", row->unit);
    text_format(&line, "): %s", row->param.doc);
    put_wrapped(out, line.at, 2);
    for (int i = 0; i < WORD_COUNT && param_is_word(&row->param); i++)
        if (keyword_table[i].list == row->param.type)
            put_item(out, 4, keyword_table[i].name, keyword_table[i].doc);
}

/* Writes the part of a kind's page on keywords that set other parameters. */
static void put_scene_presets(Text *out, SceneKind kind)
{
    Text page = text_new(out->arena);
    describe_scene_kind(&page, kind);
    const char *presets = strstr(page.at, "\nValues of parameters");
    if (presets) {
        const char *rows = strchr(presets + 1, '\n') + 1;
        text_format(out, "\n%.*s:\n\n```text\n%s```\n", (int)(rows - presets - 2), presets + 1,
                    rows);
    }
}

static void put_scene_kind(Text *out, SceneKind kind)
{
    const SceneKindRow *row = &scene_kind_table[kind];
    if (scene_kind_only(row->sort) < 0)
        text_format(out, "\n### %s\n", row->name);
    text_char(out, '\n');
    put_wrapped(out, row->doc, 0);
    text_put(out, row->count ? "\n" : "");
    for (int i = row->first; i < row->first + row->count; i++)
        put_scene_param(out, &scene_param_table[i]);
    put_scene_presets(out, kind);
}

void docs_scenes(Text *out)
{
    text_put(out, "# Scenes: every key\n\n" MADE
                  "A scene is a document with `objects:`, `lights:`, `camera:` or another key of "
                  "the first section.\nThe kind of a part stands under the part's name, such as "
                  "`object: Sphere` or `light: Spot`. Where a\npart has a single kind, no name "
                  "is needed: `image: { width: 640 }`.\n[language.md](language.md#scenes) "
                  "introduces scenes, and `matc --explain Sphere` prints the entry\n"
                  "of one kind.\n");
    for (int sort = 0; sort < SCENE_SORT_COUNT; sort++) {
        text_format(out, "\n## %s\n\n", scene_sort_table[sort].name);
        put_wrapped(out, scene_sort_table[sort].doc, 0);
        for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
            if ((int)scene_kind_table[kind].sort == sort)
                put_scene_kind(out, (SceneKind)kind);
    }
}

static void put_severity(Text *out, Severity severity, const char *title, const char *what)
{
    text_format(out, "\n## %s\n\n%s\n", title, what);
    for (int i = 0; i < DIAG_COUNT; i++) {
        const DiagRow *diag = &diag_table[i];
        Text message = text_new(out->arena);
        if (diag->severity != severity)
            continue;
        describe_message(&message, diag);
        text_format(out, "\n### %s\n\n```text\n%s\n```\n\n", diag->name, message.at);
        put_wrapped(out, diag->doc, 0);
    }
}

void docs_diagnostics(Text *out)
{
    text_put(out, "# Diagnostics\n\n" MADE
                  "These are the messages of matc about documents, with \"...\" for what varies. "
                  "The names are those of\n`--diagnostics=json`, and `matc --explain NAME` prints "
                  "one entry.\n");
    put_severity(out, SEVERITY_error, "Errors",
                 "After an error nothing is written, and the exit status is 1.");
    put_severity(out, SEVERITY_warning, "Warnings",
                 "`-Wno-NAME` turns a warning off; `-Werror=NAME` makes it an error.");
    put_severity(out, SEVERITY_note, "Notes", "A note follows an error or a warning.");
    put_severity(out, SEVERITY_advice, "Advice",
                 "Advice is off with `-d` and in the library until `-WNAME` turns it on.");
}

static void put_case(Text *out, const LayoutRow *layout, int number)
{
    Placement placement;
    layout_allocate(layout, number, &placement);
    if (number) {
        Text line = text_new(out->arena);
        text_format(&line, "Case %d: %s", number, layout->cases[number].doc);
        text_char(out, '\n');
        put_wrapped(out, line.at, 0);
    }
    text_put(out, "\n| place | slot | encoding | stored | error at most |\n| --- | --- | --- | --- "
                  "| --- |\n");
    for (int i = 0; i < placement.count; i++) {
        const Piece *piece = &placement.pieces[i];
        text_put(out, "| ");
        describe_allocation(out, layout, piece);
        text_put(out, " | ");
        describe_piece(out, piece);
        text_put(out, " | ");
        layout_put_encoding(out, piece->field);
        text_put(out, " | ");
        layout_put_range(out, piece->field);
        text_put(out, " | ");
        describe_error(out, piece->field);
        text_put(out, " |\n");
    }
}

static void put_layout(Text *out, const LayoutRow *layout)
{
    Text line = text_new(out->arena);
    text_format(&line, "%s %d bytes per pixel:", layout->doc, layout_bytes(layout));
    for (int target = 0; target < layout_targets(layout); target++)
        text_format(&line, " `%s`", format_table[layout->formats[target]].name);
    text_format(out, "\n## %s\n\n", layout->name);
    put_wrapped(out, line.at, 0);
    for (int number = 0; number < layout->case_count; number++)
        put_case(out, layout, number);
}

void docs_layouts(Text *out)
{
    text_put(out, "# Built-in layouts\n\n" MADE
                  "A place is a render target with its components or bits. "
                  "[layouts.md](layouts.md) explains cases, and\nhow to write a layout.\n");
    for (int i = 0; i < LAYOUT_COUNT; i++)
        put_layout(out, &layout_table[i]);
    text_put(out, "\n## Encodings\n\n");
    for (int i = 0; i < ENCODING_COUNT; i++)
        put_item(out, 0, encoding_table[i].name, encoding_table[i].doc);
    text_put(out, "\n## Slots\n\n");
    for (int i = 0; i < SLOT_COUNT; i++)
        put_item(out, 0, slot_table[i].name, slot_table[i].doc);
}
