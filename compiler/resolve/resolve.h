/* Tree -> Graph: names, aliases, types, defaults, ranges, references, cycles. */
#ifndef MATC_RESOLVE_H
#define MATC_RESOLVE_H
#include "compiler/graph/resolver.h"
#include <string.h>

/* NULL: see the diagnostics. */
Graph *resolve(Session *session, Tree *document);

/* Keys of the outermost level that stand beside a material's own. */
static inline bool resolve_is_document_key(const char *key)
{
    return !strcmp(key, "defs") || !strcmp(key, "include") || !strcmp(key, "colors");
}
/* It has keys that make it a scene: its `materials:` are compiled, the rest is runtime/scene's. */
bool resolve_is_scene(const Tree *document);
/* A map or a material, made once however often it is met; `outermost`: the document itself.
 * resolve.c */
const Node *resolve_any(Resolver *r, Tree *tree, bool material, bool outermost, bool *fault);
/* A map: number, list, colour, param, reference or object. NULL for none and for a fault; *fault
 * tells. */
const Node *resolve_map(Resolver *r, Tree *tree, bool *fault);
const Node *resolve_material(Resolver *r, Tree *tree, bool *fault);
/* A node that is whole but for its number, its lanes, whose part it is, and what is measured below
 * it; NULL and a diagnostic: that is too much. Of a number, which is no part of `nodes`.
 * resolve_node.c */
const Node *resolve_make_node(Resolver *r, Node of);
const Node *resolve_make_constant(Resolver *r, Node of, Value number);
/* A parameter that is not given. A map's default is one node for all of the document. */
Value resolve_default(Resolver *r, const ParamRow *row);
/* translations.def makes a Principled of such a material, whose parameters are resolved; NULL and a
 * diagnostic. resolve_translation.c */
bool resolve_is_foreign(Kind kind);
const Node *resolve_translate(Resolver *r, Node of);
/* A list of items, and one of maps. resolve_items.c */
bool resolve_items(Resolver *r, Tree *tree, Value *value);
bool resolve_map_list(Resolver *r, const char *name, Tree *tree, Value *value);
/* The value of one parameter. */
bool resolve_param(Resolver *r, const ParamRow *row, Tree *tree, Value *value);
/* False, and a diagnostic: a lane of the number, or of a param's default, is beyond what the row
 * allows. resolve_leaf.c */
bool resolve_in_range(Resolver *r, const ParamRow *row, const Tree *tree, const Value *value);
/* Resolves a value that holds neither maps nor materials; the value of null. resolve_leaf.c */
bool resolve_leaf(Resolver *r, const ParamRow *row, Tree *tree, Value *value);
Value resolve_null(Resolver *r, const ParamRow *row, const Tree *tree);

/* False, and a diagnostic: a float of GLSL does not hold the number of that tree. */
bool resolve_fits_float(Resolver *r, const char *what, const Tree *tree, double number);
/* A number, a list of numbers, a colour or a param; `what` is for messages. */
bool resolve_number(Resolver *r, const char *what, Tree *tree, LaneCount lanes, Value *value);
/* "#rgb", a name, or one of them in srgb() or linear(); linear light. resolve_color.c */
bool resolve_color(Resolver *r, const Tree *tree, Value *value);
/* Reads a document's `colors:`, which holds for all of its file. */
bool resolve_color_space(Resolver *r, const Tree *document);
/* Colors of that source are sRGB unless stated otherwise. */
bool resolve_is_srgb(const Resolver *r, uint32_t file);
/* Advises about a hex color such as "#ff8800", whose components are `lanes`, if its file has no
 * `colors:` line; once for each file. */
void resolve_advise_colors(Resolver *r, Span span, const char *hex, const double *lanes);
/* NULL for null. resolve_wave.c */
bool resolve_wave(Resolver *r, Tree *tree, const Wave **wave);
/* resolve_transform.c */
bool resolve_transform(Resolver *r, Tree *tree, Transform *transform);

/* An Expression's formula and the maps that it reads, into its parameters. resolve_expression.c */
bool resolve_expression(Resolver *r, const Tree *tree, Value *params);
/* Resolves a text whose names are those of `with`, NULL for none, and of the document's
 * definitions. */
bool resolve_formula(Resolver *r, const Tree *text, const Tree *with, Value *params);
/* Reads a formula that stands where numbers are wanted. Its value must be known here; it has one
 * lane, or as many as the numbers may have. */
bool resolve_known_formula(Resolver *r, const char *what, const Tree *text, LaneCount lanes,
                           Value *value);
/* A text that begins with '='. */
static inline bool resolve_is_formula(const Tree *tree)
{
    return tree->kind == TREE_scalar && tree->count > 0 && tree->text[0] == '=';
}

/* Letters, digits and _-. behind a letter: what a file can be called. resolve_document.c */
bool resolve_is_name(const char *name);

/* An ImageMap's colour space, where it has none of its own: linear, until resolve_picture_spaces
 * finds that it feeds a colour, or that it is of a glTF material, which has its texels in the
 * middle of their squares, too. resolve_picture.c */
void resolve_picture(Resolver *r, const Node *node, Value *params);
void resolve_picture_spaces(Resolver *r, const NamedMaterial *materials, int count);

#endif
