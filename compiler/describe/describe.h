/* The tables as text for people: what --list, --explain and the reference pages share. */
#ifndef MATC_DESCRIBE_H
#define MATC_DESCRIBE_H
#include "compiler/base/diag.h"
#include "grammar/layout_tables.h"
#include "compiler/layout/layout.h"
#include "compiler/base/text.h"
#include "grammar/key_table.h"
#include "grammar/scene_tables.h"

#define CHAIN_DOC "second(factor * first(v) + shift): two waves, one after the other."

/* JSON Schema of a file of files.def, "manifest", ...; from malloc, NULL if there is none of that
 * name. describe_files.c */
char *describe_file(const char *name);
/* JSON Schema of documents; from malloc. `ref`: the schema of a use of a definition, `document`: of
 * one that is the outermost level; NULL: of any. describe_schema.c */
char *describe_document_schema(const char *ref, const char *document);
/* Members of "properties": what may stand beside a material at the outermost level. */
void describe_beside(Text *out);
/* The page of a name that describe knows by its tables: --explain; from malloc, NULL: it knows
 * none. describe_explain.c */
char *describe_explain(const char *name);
/* Does what describe_type does for a parameter of a scene. describe_scene.c */
const char *describe_scene_type(const SceneParamRow *row);
/* Pages of parameters of that name, of materials, maps and scenes, and of words that they may be.
 * `same` compares names. Nothing is added if there are none. describe_param.c */
typedef int DescribeCompare(const char *, const char *);
void describe_params(Text *out, const char *name, DescribeCompare *same);
void describe_words(Text *out, const char *name, DescribeCompare *same);
/* Explains what a name of other tools is called here. describe_foreign.c */
void describe_foreign(Text *out, const char *name);
/* Lists: all names of other tools; all definitions of the library. describe_foreign.c */
void describe_foreign_list(Text *out);
void describe_library_list(Text *out);
/* The kind of value that a document writes for a parameter: "map", "number", ... */
const char *describe_type(const ParamRow *param);
/* "0.5", "[1, 0, 0]", "true", "none". With a preset, its default. */
void describe_default(Text *out, const ParamRow *param, const char *preset);
/* "0 to 16"; nothing for every number. */
void describe_range(Text *out, const ParamRow *param);
/* A smallest document: the kind (by that name of it) with its defaults written out. */
void describe_example(Text *out, Kind kind, const char *name);
/* Pieces of a layout: "normal", "emissive.r, emissive.g"; "0.xy" or "0.r 8-15"; "0.00196". */
void describe_piece(Text *out, const Piece *piece);
void describe_allocation(Text *out, const LayoutRow *layout, const Piece *piece);
void describe_error(Text *out, const FieldRow *field);
/* Functions of formulas, one a line; the page of one function, a Term; the schema of a formula and
 * of its `with:`. describe_expression.c */
void describe_functions(Text *out);
void describe_function(Text *out, int term);
void describe_formula_schema(Text *out);
/* The parameters of Principled that translations.def computes for a material, one a line, then what
 * is lost. describe_translation.c */
void describe_translations(Text *out, Kind kind, const char *indent);
/* The page of a layout. describe_layout.c */
void describe_layout(Text *out, const LayoutRow *layout);
/* The schema of a parameter's value, as members of a JSON object; its definition of a list of
 * words.def. describe_value.c */
void describe_value(Text *out, const ParamRow *param);
/* "name": { "description": what keys.def says, and the definition goes on. describe_value.c */
void describe_open_key(Text *out, const char *name, DocumentKey key);
const char *describe_word_list(ParamKind list);
/* The page of a scene's kind, and of a sort. describe_scene.c */
void describe_scene_kind(Text *out, SceneKind kind);
void describe_scene_sort(Text *out, SceneSort sort);
/* Definitions of all of them in the schema of documents, and the keys of a document that are
 * theirs, as further properties. */
void describe_scene_definitions(Text *out);
void describe_scene_keys(Text *out);
/* A diagnostic's format with "..." where it has arguments. */
void describe_message(Text *out, const DiagRow *diag);

/* The i-th kind that matc_list_of knows, NULL behind the last. describe_list.c */
const char *describe_list_kind(const void *user, int i);

extern const char *const severity_names[];
/* Is the row the first of its preset? A preset has one row a parameter. */
bool describe_is_preset_head(int row);
/* The text in memory from malloc; the arena is freed. */
char *describe_finish(Text *text);
#endif
