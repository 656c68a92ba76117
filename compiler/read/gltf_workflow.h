/* Builds the objects of a document made from a glTF file, and converts materials that do not
 * follow the metallic-roughness workflow. */
#ifndef MATC_GLTF_WORKFLOW_H
#define MATC_GLTF_WORKFLOW_H
#include "compiler/base/session.h"
#include "compiler/read/tree.h"

#ifdef MATC_WEBP
#define GLTF_WEBP true /* images in WebP are readable */
#else
#define GLTF_WEBP false
#endif

/* An object under construction. */
typedef struct {
    Member *members;
    size_t count, capacity;
} GltfKeys;
void gltf_workflow_put(Session *session, GltfKeys *made, const char *key, Tree *value);
Tree *gltf_workflow_word(Session *session, const char *text, Span span);
Tree *gltf_workflow_number(Session *session, double value, Span span);
Tree *gltf_workflow_object(Session *session, const GltfKeys *made, Span span);

/* Content of KHR_materials_pbrSpecularGlossiness with its textures as maps; NULL: no texture. */
typedef struct {
    const Tree *from;
    Tree *diffuse, *glossy;
} GltfGlossiness;
/* Adds the parameters of a dielectric whose reflectance at normal incidence is the specular color,
 * and whose roughness is 1 - glossiness. */
void gltf_workflow_glossiness(Session *session, GltfKeys *made, const GltfGlossiness *parts);
/* Converts KHR_materials_unlit: the base color is emitted, and nothing is reflected. */
GltfKeys gltf_workflow_unlit(Session *session, const GltfKeys *lit, Span span);
#endif
