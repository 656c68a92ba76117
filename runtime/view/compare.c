/* The scene, again and again, with other words. */
#include "runtime/view/compare.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    GlContext *gl;
    ScenePictures *pictures;
    Scene scene; /* whose lights are a copy, where they change */
    Scene *given;
    unsigned char *rgb;
    Sheet *sheet;
} Comparison;

static void use_method(Comparison *c, Word shadows)
{
    memcpy(c->scene.lights, c->given->lights, (size_t)c->given->light_count * sizeof *c->scene.lights);
    scene_lights_shadow(&c->scene, shadows);
}

static bool add(Comparison *c, const char *name)
{
    if (!sheet_has_room(c->sheet))
        return gl_fail(c->gl, "%s", sheet_too_large);
    if (!scene_pictures_show(c->pictures, &c->scene) || !scene_pictures_pixels(c->pictures, c->rgb))
        return false;
    sheet_add(c->sheet, name, c->rgb);
    return true;
}

static bool add_volumes(Comparison *c, const char *method)
{
    char name[SHEET_NAME];
    for (int i = 0; i < WORD_COUNT; i++) {
        const char *volume = scene_volume_name((Word)i);
        if (!volume)
            continue;
        c->scene.shadow_volume = (Word)i;
        snprintf(name, sizeof name, "%s, %s", method, volume);
        if (!add(c, name))
            return false;
    }
    return true;
}

static bool add_indirect(Comparison *c)
{
    memcpy(c->scene.lights, c->given->lights, (size_t)c->given->light_count * sizeof *c->scene.lights);
    for (int i = 0; i < WORD_COUNT; i++) {
        const char *name = scene_indirect_name((Word)i);
        c->scene.indirect.method = (Word)i;
        if (name && i != WORD_Indirect_auto && !add(c, name))
            return false;
    }
    return true;
}

static bool add_shadows(Comparison *c)
{
    for (int i = 0; i < WORD_COUNT; i++) {
        const char *name = scene_shadows_name((Word)i);
        if (!name)
            continue;
        use_method(c, (Word)i);
        if (!(i == WORD_Shadows_hybrid ? add_volumes(c, name) : add(c, name)))
            return false;
    }
    return true;
}

/* With how many triangles that is. */
static bool add_displacement(Comparison *c)
{
    const Word given = c->given->displaced_by;
    bool fine = c->given->displaced || gl_fail(c->gl, "no material of the scene displaces an object");
    for (int i = 0; fine && i < WORD_COUNT; i++) {
        const char *name = scene_displace_name((Word)i);
        if (!name || i == WORD_Displacing_auto)
            continue;
        fine = scene_displace_by(c->given, (Word)i) != SCENE_DISPLACED_failed ||
               gl_fail(c->gl, "displacement by %s takes too many triangles, operations, or more memory than there is",
                       name);
        c->scene = *c->given;
        fine = fine && add(c, name);
    }
    return fine && scene_displace_by(c->given, given) != SCENE_DISPLACED_failed;
}

bool compare_methods(GlContext *gl, Scene *scene, const char *list, const ScenePictureOptions *options, Sheet *sheet)
{
    Comparison c = {.gl = gl, .scene = *scene, .given = scene, .sheet = sheet};
    sheet->width = options->render.width;
    sheet->height = options->render.height;
    c.scene.lights = malloc(((size_t)scene->light_count + 1) * sizeof *c.scene.lights);
    c.rgb = malloc(3 * (size_t)sheet->width * (size_t)sheet->height);
    c.pictures = scene_pictures_open(gl, options);
    const bool room = c.scene.lights && c.rgb;
    SceneLight *lights = c.scene.lights;
    bool (*const add_all)(Comparison *) = !strcmp(list, "shadows")    ? add_shadows
                                          : !strcmp(list, "indirect") ? add_indirect
                                                                      : add_displacement;
    const bool done = room ? c.pictures && add_all(&c) : gl_fail(gl, "out of memory");
    scene_pictures_close(c.pictures);
    free(lights);
    free(c.rgb);
    return done;
}
