/* Textures of a program: images, baked reliefs, GroIMP's noise tables. */
#include "compiler/emit/texture.h"
#include "compiler/library/carpenter.h"
#include "compiler/library/srgb.h"
#include <math.h>
#include <string.h>

static const double GREATEST_HALF = 65504;
enum { TABLE_PERMUTATION = -1, TABLE_RANDOM = -2, TABLE_XOR = -3, SIDE = 256, RANDOM_COUNT = 512 };
/* The anisotropy that OpenGL 4.6 guarantees; drivers take no more samples than a footprint
 * needs. */
enum { SAMPLER_ANISOTROPY = 16 };

typedef struct {
    const char *name;
    int number, width, height, components;
    Texels texels;
} Table;

static const Table tables[] = {
    {"matc_permutation", TABLE_PERMUTATION, SIDE, SIDE, 1, TEXELS_R32F},
    {"matc_random", TABLE_RANDOM, RANDOM_COUNT, 1, 4, TEXELS_RGBA32F},
    {"matc_xor", TABLE_XOR, SIDE, SIDE, 1, TEXELS_R8},
};

/* Returns the textures that are filtered over the pixel, which needs mipmaps (except in GLSL
 * 1.10, which takes samples). */
static bool *averaged_textures(Session *session, const Ir *ir, const Interface *interface)
{
    bool from_mipmaps = false, *averaged = ARENA_ARRAY(session->arena, bool, ir->texture_count + 1);
    for (size_t i = 0; interface && i < interface->chunks.count; i++)
        from_mipmaps |= !strcmp(interface->chunks.at[i]->name, "imageFiltered");
    for (Ref ref = 1; from_mipmaps && ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_call) && ir_at(ir, ref)->payload == FN_imageFiltered)
            averaged[ir_at(ir, ir_arg(ir, ref, 0))->payload] = true;
    return averaged;
}

/* Returns the name of an Address, in the order of words.def. */
static const char *wrap_name(Keyword wrap)
{
    static const char *const names[] = {"repeat", "mirrored_repeat", "clamp_to_edge",
                                        "clamp_to_border"};
    return names[wrap - KEYWORD_Address_repeat];
}

static MatcTexture of_document(Session *session, const Ir *ir, int i, bool averaged)
{
    const IrTexture *t = &ir->textures[i];
    MatcTexture texture = {.name = emit_texture_name(session, ir, i),
                           .width = t->width,
                           .height = t->height,
                           .components = 1,
                           .anisotropy = 1};
    texture.format = texels_table[t->texels].name;
    texture.wrap = wrap_name(t->wrap);
    if (t->kind == TEXTURE_image) {
        texture.path = t->image->path;
        texture.components = 4;
        texture.bytes = texels_table[t->texels].bits == 8 ? image_bytes(t->image) : NULL;
        texture.mipmaps = averaged || t->sampled;
        texture.anisotropy = t->sampled ? SAMPLER_ANISOTROPY : 1;
    }
    return texture;
}

int texture_list(Session *session, const Ir *ir, const Interface *interface, MatcTexture **list,
                 int **made_by)
{
    enum { TABLE_COUNT = sizeof tables / sizeof *tables };
    int count = 0;
    const bool *averaged = averaged_textures(session, ir, interface);
    *list = ARENA_ARRAY(session->arena, MatcTexture, ir->texture_count + TABLE_COUNT);
    *made_by = ARENA_ARRAY(session->arena, int, ir->texture_count + TABLE_COUNT);
    for (size_t i = 0; i < ir->texture_count; i++)
        if (!interface || interface->textures[i]) {
            (*made_by)[count] = (int)i;
            (*list)[count++] = of_document(session, ir, (int)i, averaged[i]);
        }
    for (int i = 0; interface && i < TABLE_COUNT; i++)
        if (chunks_declare(&interface->chunks, tables[i].name)) {
            (*made_by)[count] = tables[i].number;
            (*list)[count++] = (MatcTexture){.name = tables[i].name,
                                             .width = tables[i].width,
                                             .height = tables[i].height,
                                             .components = tables[i].components,
                                             .format = texels_table[tables[i].texels].name,
                                             .anisotropy = 1,
                                             .wrap = wrap_name(KEYWORD_Address_repeat)};
        }
    return count;
}

static const float *relief(Session *session, const Node *node)
{
    double n[6][4];
    for (int i = 0; i < 6; i++)
        value_number(&node->params[i + 1], TYPE_float, n[i]);
    const CarpenterRelief carpenter = {n[0][0],          n[1][0],      n[2][0],
                                       (int64_t)n[3][0], (int)n[4][0], (int)n[5][0]};
    float *texels = ARENA_ARRAY(session->arena, float, carpenter.width *carpenter.height);
    carpenter_bake(&carpenter, texels);
    return texels;
}

static const float *permutation_table(Session *session)
{
    float *texels = arena_alloc(session->arena, sizeof(float) * SIDE * SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        texels[i] = reference_permutation()[i];
    return texels;
}

static const float *random_table(Session *session)
{
    float *texels = arena_alloc(session->arena, sizeof(float) * 4 * RANDOM_COUNT);
    for (int i = 0; i < 4 * RANDOM_COUNT; i++)
        texels[i] = reference_random_table()[(i / 4 + i % 4) % RANDOM_COUNT];
    return texels;
}

static const unsigned char *xor_table(Session *session)
{
    unsigned char *texels = arena_alloc(session->arena, SIDE * SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        texels[i] = (unsigned char)((i % SIDE) ^ (i / SIDE));
    return texels;
}

/* Returns a component as the texture stores it; sRGB is decoded unless the sampler decodes it. */
static double texel_component(const IrTexture *texture, size_t number)
{
    const Image *image = texture->image;
    const double value = image->bits == 8    ? image_bytes(image)[number] / 255.
                         : image->bits == 16 ? image_words(image)[number] / 65535.
                                             : (double)image_floats(image)[number];
    return texture->srgb && number % 4 < 3 ? srgb_decode(value) : value;
}

static const unsigned short *decoded_words(Session *session, const IrTexture *texture)
{
    const size_t count = (size_t)texture->width * (size_t)texture->height * 4;
    unsigned short *words = arena_alloc(session->arena, count * sizeof *words);
    for (size_t i = 0; i < count; i++)
        words[i] = (unsigned short)(texel_component(texture, i) * 65535 + .5);
    return words;
}

/* Clamps texels to the range of half floats. */
static const float *decoded_floats(Session *session, const IrTexture *texture)
{
    const double most = texture->texels == TEXELS_RGBA16F ? GREATEST_HALF : INFINITY;
    const size_t count = (size_t)texture->width * (size_t)texture->height * 4;
    float *floats = arena_alloc(session->arena, count * sizeof *floats);
    for (size_t i = 0; i < count; i++)
        floats[i] = (float)fmin(fmax(texel_component(texture, i), -most), most);
    return floats;
}

/* Fills in the texels if the image was read. */
static void fill_picture(Session *session, const IrTexture *picture, MatcTexture *texture)
{
    if (picture->image->texels && texels_table[picture->texels].bits == 16)
        texture->words = decoded_words(session, picture);
    else if (picture->image->texels)
        texture->floats = decoded_floats(session, picture);
}

void texture_fill(Session *session, const Ir *ir, MatcTexture *texture, int made_by)
{
    if (texture->bytes || texture->floats || texture->words)
        return;
    if (made_by == TABLE_PERMUTATION)
        texture->floats = permutation_table(session);
    else if (made_by == TABLE_RANDOM)
        texture->floats = random_table(session);
    else if (made_by == TABLE_XOR)
        texture->bytes = xor_table(session);
    else if (ir->textures[made_by].kind == TEXTURE_carpenter)
        texture->floats = relief(session, ir->textures[made_by].node);
    else
        fill_picture(session, &ir->textures[made_by], texture);
}
