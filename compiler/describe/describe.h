/* Formats the tables for readers: shared by --list, --explain and the reference pages. */
#ifndef MATC_DESCRIBE_H
#define MATC_DESCRIBE_H
#include "compiler/base/diag.h"
#include "grammar/layout_tables.h"
#include "compiler/layout/layout.h"
#include "compiler/base/text.h"
#include "grammar/key_table.h"
#include "grammar/scene_tables.h"

#define CHAIN_DOC "second(factor * first(v) + shift): two waveforms, applied one after the other."

/* Returns the JSON Schema of a file type of files.def, such as "manifest"; from malloc, NULL if
 * unknown. describe_files.c */
char *describe_file(const char *name);
/* Returns the JSON Schema of documents; from malloc. `ref`: schema of a use of a definition,
 * `document`: of a top-level use; NULL: of any definition. describe_schema.c */
char *describe_document_schema(const char *ref, const char *document);
/* Writes members of "properties": top-level keys allowed next to a material. */
void describe_beside(Text *out);
/* Returns the --explain page of a name from the tables; from malloc, NULL if unknown.
 * describe_explain.c */
char *describe_explain(const char *name);
/* Returns the type of a scene parameter, as describe_type() does. describe_scene.c */
const char *describe_scene_type(const SceneParamRow *row);
/* Writes pages of all parameters with that name, of materials, maps and scenes; describe_words()
 * of keywords. `same` compares names. Writes nothing for an unknown name. describe_param.c */
typedef int DescribeCompare(const char *, const char *);
void describe_params(Text *out, const char *name, DescribeCompare *same);
void describe_words(Text *out, const char *name, DescribeCompare *same);
/* Explains a name of another tool. describe_foreign.c */
void describe_foreign(Text *out, const char *name);
/* Lists all names of other tools; all definitions of the library. describe_foreign.c */
void describe_foreign_list(Text *out);
void describe_library_list(Text *out);
/* Returns the type of value that a document gives for a parameter: "map", "number", ... */
const char *describe_type(const ParamRow *param);
/* Writes a default: "0.5", "[1, 0, 0]", "true", "none". With a preset, the preset's default. */
void describe_default(Text *out, const ParamRow *param, const char *preset);
/* Writes a range: "0 to 16"; nothing if unbounded. */
void describe_range(Text *out, const ParamRow *param);
/* Writes a minimal document: the kind, under the given name, with its defaults. */
void describe_example(Text *out, Kind kind, const char *name);
/* Writes parts of a layout: a piece's slots "normal", "emissive.r, emissive.g"; its place "0.xy"
 * or "0.r 8-15"; its error "0.00196". */
void describe_piece(Text *out, const Piece *piece);
void describe_allocation(Text *out, const LayoutRow *layout, const Piece *piece);
void describe_error(Text *out, const FieldRow *field);
/* Writes the functions of formulas, one per line; the page of one function, a Term; the schema
 * of a formula and of its `with:`. describe_expression.c */
void describe_functions(Text *out);
void describe_function(Text *out, int term);
void describe_formula_schema(Text *out);
/* Writes the Principled parameters that translations.def computes for a material, one per line,
 * then the losses. describe_translation.c */
void describe_translations(Text *out, Kind kind, const char *indent);
/* Writes the page of a layout. describe_layout.c */
void describe_layout(Text *out, const LayoutRow *layout);
/* Writes the schema of a parameter's value as members of a JSON object. describe_value.c */
void describe_value(Text *out, const ParamRow *param);
/* Begins a schema definition: "name": { "description": the text of keys.def.
 * describe_word_list() returns the definition's name of a list of words.def. describe_value.c */
void describe_open_key(Text *out, const char *name, DocumentKey key);
const char *describe_word_list(ParamKind list);
/* Writes the page of a scene's kind, or of a sort. describe_scene.c */
void describe_scene_kind(Text *out, SceneKind kind);
void describe_scene_sort(Text *out, SceneSort sort);
/* Writes the schema definitions of all kinds of scenes, and the scene keys of a document as
 * properties. */
void describe_scene_definitions(Text *out);
void describe_scene_keys(Text *out);
/* Writes a diagnostic's format with "..." for its arguments. */
void describe_message(Text *out, const DiagRow *diag);

/* Returns the i-th kind that matc_list_of knows, NULL after the last. describe_list.c */
const char *describe_list_kind(const void *user, int i);

extern const char *const severity_names[];
/* Returns true for the first row of a preset; a preset has one row per parameter. */
bool describe_is_preset_head(int row);
/* Returns the text in memory from malloc and frees its arena. */
char *describe_finish(Text *text);
#endif
