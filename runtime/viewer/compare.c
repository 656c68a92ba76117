/* Draws the scene once per method of the compared list. */
#include "runtime/tessellate/scene_displace.h"
#include "runtime/viewer/compare.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Method of a cell: a word of the list, and a variant for some shadow techniques. */
typedef struct {
    Keyword method, variant; /* KEYWORD of the variant; WORD_COUNT: the method has no variant */
} Way;

typedef struct {
    GlContext *gl;
    ScenePictures *pictures;
    Scene scene; /* copy of the scene with its own lights, which the methods change */
    Scene *given;
    unsigned char *rgb;
    ContactSheet *sheet;
    Way ways[WORD_COUNT];
    int count;
} Comparison;

typedef struct {
    const char *list;
    const char *(*name)(Keyword); /* returns NULL for words outside the list */
    bool (*use)(Comparison *, Way);
} Listing;

/* -- methods and their variants */

static bool use_shadows(Comparison *c, Way way)
{
    memcpy(c->scene.lights, c->given->lights,
           (size_t)c->given->light_count * sizeof *c->scene.lights);
    scene_lights_shadow(&c->scene, way.method);
    if (way.variant != WORD_COUNT)
        renderer_shadows_vary(&c->scene, way.method, way.variant);
    return true;
}

static bool use_indirect(Comparison *c, Way way)
{
    memcpy(c->scene.lights, c->given->lights,
           (size_t)c->given->light_count * sizeof *c->scene.lights);
    c->scene.indirect.method = way.method;
    return true;
}

static bool use_displacement(Comparison *c, Way way)
{
    if (scene_displace_by(c->given, way.method) == SCENE_DISPLACED_failed)
        return gl_fail(c->gl, "displacement by %s needs too many triangles, operations or memory",
                       scene_displace_name(way.method));
    c->scene = *c->given;
    return true;
}

static const Listing listings[] = {{"shadows", scene_shadows_name, use_shadows},
                                   {"indirect", scene_indirect_name, use_indirect},
                                   {"displacement", scene_displace_name, use_displacement}};

static void add_way(Comparison *c, Keyword method)
{
    Scene varied = c->scene;
    const int before = c->count;
    for (int i = 0; i < WORD_COUNT; i++)
        if (renderer_shadows_vary(&varied, method, (Keyword)i))
            c->ways[c->count++] = (Way){method, (Keyword)i};
    if (c->count == before)
        c->ways[c->count++] = (Way){method, WORD_COUNT};
}

static void find_ways(Comparison *c, const Listing *listing)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (listing->name((Keyword)i) && i != KEYWORD_Indirect_auto && i != KEYWORD_Displacing_auto)
            add_way(c, (Keyword)i);
}

/* -- displacement, limited to the cells' resolution */

/* Returns the size of a shadow map: at least one texel per pixel of a cell. Tracing 4096 x 4096
 * takes minutes under llvmpipe. */
static int cell_texels(const ContactSheet *sheet)
{
    enum { LEAST = 256 };
    int texels = LEAST;
    while (texels < sheet->width || texels < sheet->height)
        texels *= 2;
    return texels;
}

/* Returns the triangle limit of a mesh: one per PIXELS pixels of a cell, the coarsest resolution
 * whose triangles are not visible. */
static int cell_triangles(const ContactSheet *sheet)
{
    enum { PIXELS = 8, LEAST = 4096 };
    const int triangles = sheet->width * sheet->height / PIXELS;
    return triangles > LEAST ? triangles : LEAST;
}

static int least(int a, int b) { return a < b ? a : b; }

static void fit_displacement(const ContactSheet *sheet, Scene *scene)
{
    scene->shadow_size = least(scene->shadow_size, cell_texels(sheet));
    scene->displaced_triangles = least(scene->displaced_triangles, cell_triangles(sheet));
}

/* -- the comparison */

static bool draw_way(Comparison *c, const Listing *listing, Way way)
{
    char name[SHEET_NAME];
    const bool varied = way.variant != WORD_COUNT;
    snprintf(name, sizeof name, "%s%s%s", listing->name(way.method), varied ? ", " : "",
             varied ? renderer_shadows_vary(&c->scene, way.method, way.variant) : "");
    if (!contact_sheet_has_capacity(c->sheet))
        return gl_fail(c->gl, "%s", contact_sheet_too_large);
    if (!listing->use(c, way) || !scene_pictures_show(c->pictures, &c->scene) ||
        !scene_pictures_pixels(c->pictures, c->rgb))
        return false;
    contact_sheet_add(c->sheet, name, c->rgb);
    return true;
}

static bool draw_ways(Comparison *c, const Listing *listing, const ScenePictureOptions *options)
{
    bool fine = true;
    find_ways(c, listing);
    for (int i = 0; fine && i < c->count; i++) {
        if (options->progress)
            options->progress(options->user, i, c->count);
        fine = draw_way(c, listing, c->ways[i]);
    }
    return fine;
}

static bool draw_displacement(Comparison *c, const Listing *listing,
                              const ScenePictureOptions *options)
{
    const Keyword method = c->given->displaced_by;
    const int texels = c->given->shadow_size, triangles = c->given->displaced_triangles;
    if (!c->given->displaced)
        return gl_fail(c->gl, "no material of the scene displaces an object");
    fit_displacement(c->sheet, c->given);
    bool fine = draw_ways(c, listing, options);
    c->given->shadow_size = texels;
    c->given->displaced_triangles = triangles;
    return scene_displace_by(c->given, method) != SCENE_DISPLACED_failed && fine;
}

static const Listing *listing_of(const char *list)
{
    const Listing *listing = listings;
    while (strcmp(listing->list, list) != 0)
        listing++;
    return listing;
}

bool compare_methods(GlContext *gl, Scene *scene, const char *list,
                     const ScenePictureOptions *options, ContactSheet *sheet)
{
    Comparison *c = calloc(1, sizeof *c);
    ScenePictureOptions of_one = *options;
    const Listing *listing = listing_of(list);
    if (!c)
        return gl_fail(gl, "out of memory");
    of_one.progress = NULL; /* The picture's rows are not the sheet's progress. */
    sheet->width = options->renderer.width;
    sheet->height = options->renderer.height;
    *c = (Comparison){.gl = gl, .scene = *scene, .given = scene, .sheet = sheet};
    SceneLight *lights = c->scene.lights =
        malloc(((size_t)scene->light_count + 1) * sizeof *lights);
    c->rgb = malloc(3 * (size_t)sheet->width * (size_t)sheet->height);
    bool done = (lights && c->rgb) || gl_fail(gl, "out of memory");
    c->pictures = done ? scene_pictures_open(gl, &of_one) : NULL;
    done = c->pictures &&
           (listing->use == use_displacement ? draw_displacement : draw_ways)(c, listing, options);
    scene_pictures_close(c->pictures);
    free(lights);
    free(c->rgb);
    free(c);
    return done;
}
