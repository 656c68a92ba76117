/* A Rig as a test's state, and scenes drawn by it; a failure ends the test. */
#ifndef TESTS_RIG_STATE_H
#define TESTS_RIG_STATE_H
#include "tests/draw/rig.h"
#include "tests/draw/scene.h"

enum { SIDE = RIG_SIDE, PIXELS = RIG_PIXELS };
#define RIG ((Rig *)*state)

static inline int set_up(void **state)
{
    Rig *rig = *state = rig_new(true);
    if (*rig->error)
        print_error("%s\n", rig->error);
    return *rig->error != 0;
}

static inline int tear_down(void **state)
{
    rig_free(*state);
    return 0;
}

static inline Scene open_scene(Rig *rig, const char *text, const SceneOptions *options)
{
    Scene scene;
    if (!scene_open(&scene, rig->store, text, options))
        fail_msg("%s", scene.error);
    return scene;
}

static inline void draw_scene(Rig *rig, Scene *scene, const Space *space, const Mesh *mesh,
                              const Framebuffer *target)
{
    if (!rig_draw(rig, scene, space, mesh, target))
        fail_msg("%s", rig->gl->error);
}

static inline SlotValues values_at(const Scene *scene, const Surface *surface)
{
    SlotValues values;
    if (!scene_values(scene, surface, &values))
        fail_msg("no values");
    return values;
}

/* Feeds the material's first own attribute with the x component of the vertices' positions. */
static inline void feed_attribute(const GlContext *gl, const Mesh *mesh)
{
    enum { FIRST_OWN = 11 }; /* first location of own attributes: language.md */
    gl->BindVertexArray(mesh->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
    gl->EnableVertexAttribArray(FIRST_OWN);
    gl->VertexAttribPointer(FIRST_OWN, 1, GL_FLOAT, GL_FALSE, sizeof(ShapeVertex),
                            (const void *)offsetof(ShapeVertex, position));
}

/* Center of a pixel, in clip space. */
static inline double middle(int index) { return 2 * (index + 0.5) / SIDE - 1; }
#endif
