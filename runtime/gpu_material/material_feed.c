/* Named attributes: from a program's list to locations, and to attributes of meshes. */
#include "runtime/gpu_material/material_feed.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Static_assert((int)MESH_ATTRIBUTE_end <= (int)MATERIAL_FEED_NAMES, "names of all attributes");

bool material_feed_make(Material *m, const MatcProgram *program, const char **names,
                        ProgramText *text)
{
    int count = MESH_ATTRIBUTE_end;
    memcpy(names, mesh_attribute_names, sizeof mesh_attribute_names);
    m->feeds = calloc((size_t)matc_attribute_count(program) + 1, sizeof *m->feeds);
    if (!m->feeds)
        return gl_fail(store_context(m->store), "out of memory");
    for (int i = 0; i < matc_attribute_count(program); i++) {
        const MatcAttribute *attribute = matc_attribute(program, i);
        MeshFeed *feed = &m->feeds[m->feed_count];
        *feed = (MeshFeed){.location = (GLuint)attribute->location};
        /* names in documents are shorter */
        snprintf(feed->name, sizeof feed->name, "%s", attribute->name);
        for (int component = 0; component < 4; component++)
            feed->initial[component] = (float)attribute->initial[component];
        if (attribute->location >= MATERIAL_FEED_NAMES)
            return gl_fail(store_context(m->store), "too many attributes");
        while (count <= attribute->location)
            names[count++] = NULL;
        names[attribute->location] = attribute->attribute;
        m->feed_count++;
    }
    if (m->feed_count && !text->attributes) {
        text->attributes = names;
        text->attribute_count = count;
    }
    return true;
}

void material_feed(const Material *m, const Mesh *mesh)
{
    mesh_feed(store_context(m->store), mesh, m->feeds, m->feed_count);
}
