/* Tree -> Graph: names, aliases, types, defaults, ranges, references, cycles. */
#ifndef MATC_RESOLVE_H
#define MATC_RESOLVE_H
#include "compiler/graph/resolver.h"
#include <string.h>

/* Returns NULL after reporting faults. */
Graph *resolve(Session *session, Tree *document);

/* Top-level keys that are not parameters of a material. */
static inline bool resolve_is_document_key(const char *key)
{
    return !strcmp(key, "defs") || !strcmp(key, "include") || !strcmp(key, "colors");
}
/* Returns true if the document has scene keys: matc compiles its `materials:`, and runtime/scene
 * reads the rest. */
bool resolve_is_scene(const Tree *document);
/* Resolves a map or a material, at most once per tree; `outermost`: the document itself.
 * resolve.c */
const Node *resolve_any(Resolver *r, Tree *tree, bool material, bool outermost, bool *fault);
/* Resolves a map: number, list, color, param, reference or object. Returns NULL for null or a
 * fault; *fault distinguishes them. */
const Node *resolve_map(Resolver *r, Tree *tree, bool *fault);
const Node *resolve_material(Resolver *r, Tree *tree, bool *fault);
/* Completes a node: number, width, owner, and depth and filters of the graph below it. Returns
 * NULL after reporting an exceeded limit. resolve_make_constant() makes a Constant of a number,
 * which is not listed in `nodes`. resolve_node.c */
const Node *resolve_make_node(Resolver *r, Node of);
const Node *resolve_make_constant(Resolver *r, Node of, Value number);
/* Returns the value of a parameter that is not given. A map's default is one node in the whole
 * document. */
Value resolve_default(Resolver *r, const ParamRow *row);
/* Translates a material of another model, with resolved parameters, to a Principled by
 * translations.def. Returns NULL after reporting a fault. resolve_translation.c */
bool resolve_is_foreign(Kind kind);
const Node *resolve_translate(Resolver *r, Node of);
/* Resolves a list of items, or a list of maps. resolve_items.c */
bool resolve_items(Resolver *r, Tree *tree, Value *value);
bool resolve_map_list(Resolver *r, const char *name, Tree *tree, Value *value);
/* Resolves the value of one parameter. */
bool resolve_param(Resolver *r, const ParamRow *row, Tree *tree, Value *value);
/* Checks the components of a number, or of a param's default, against the row's range. Returns
 * false after reporting a violation. resolve_leaf.c */
bool resolve_in_range(Resolver *r, const ParamRow *row, const Tree *tree, const Value *value);
/* Resolves a value that contains neither maps nor materials; resolve_null() returns the value of
 * null. resolve_leaf.c */
bool resolve_leaf(Resolver *r, const ParamRow *row, Tree *tree, Value *value);
Value resolve_null(Resolver *r, const ParamRow *row, const Tree *tree);

/* Returns false, after reporting it, if the number exceeds the range of a GLSL float. */
bool resolve_fits_float(Resolver *r, const char *what, const Tree *tree, double number);
/* Resolves a number, a list of numbers, a color or a param; `what` names it in messages. */
bool resolve_number(Resolver *r, const char *what, Tree *tree, ComponentCount components,
                    Value *value);
/* Resolves "#rgb", a color name, or either in srgb() or linear(), to linear light.
 * resolve_color.c */
bool resolve_color(Resolver *r, const Tree *tree, Value *value);
/* Reads a document's `colors:`, which applies to its whole file. */
bool resolve_color_space(Resolver *r, const Tree *document);
/* Returns true if colors of that source are sRGB unless stated otherwise. */
bool resolve_is_srgb(const Resolver *r, uint32_t file);
/* Advises about a hex color such as "#ff8800" with the components `components`, if its file has no
 * `colors:` line; once per file. */
void resolve_advise_colors(Resolver *r, Span span, const char *hex, const double *components);
/* Resolves a wave; *wave is NULL for null. resolve_wave.c */
bool resolve_wave(Resolver *r, Tree *tree, const Wave **wave);
/* Resolves a transform. resolve_transform.c */
bool resolve_transform(Resolver *r, Tree *tree, Transform *transform);

/* Resolves an Expression's formula and the maps that the formula reads, into its parameters.
 * resolve_expression.c */
bool resolve_expression(Resolver *r, const Tree *tree, Value *params);
/* Resolves a formula's text. Its names come from `with` (may be NULL) and from the document's
 * definitions. */
bool resolve_formula(Resolver *r, const Tree *text, const Tree *with, Value *params);
/* Evaluates a formula in the place of numbers. Its value must be known at compile time, with one
 * component or a number of components that `components` allows. */
bool resolve_known_formula(Resolver *r, const char *what, const Tree *text,
                           ComponentCount components, Value *value);
/* Returns true for a text that begins with '='. */
static inline bool resolve_is_formula(const Tree *tree)
{
    return tree->kind == TREE_scalar && tree->count > 0 && tree->text[0] == '=';
}

/* Returns true for a valid material name, usable as a file name: letters, digits, '_', '-' and '.',
 * starting with a letter. resolve_document.c */
bool resolve_is_name(const char *name);

/* Sets an ImageMap's color space if the document does not: linear for now.
 * resolve_picture_spaces() later selects sRGB for images that feed colors or belong to a glTF
 * material; the latter also get texel centers inside the texels. resolve_picture.c */
void resolve_picture(Resolver *r, const Node *node, Value *params);
void resolve_picture_spaces(Resolver *r, const NamedMaterial *materials, int count);

#endif
