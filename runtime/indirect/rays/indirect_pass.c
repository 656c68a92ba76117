/* Inputs of every pass with indirect_place.glsl: definitions, the uniform block Indirect,
 * textures. */
#include "gen/indirect_layout.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/rays/blue_noise.h"
#include "runtime/indirect/rays/indirect_sequence.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Length in voxels over which hybrid rays read the depth buffer: one voxel per step, half the
 * assumed thickness of visible surfaces. */
enum { NEAR = 4 };

/* PACKED: 16-bit ranks of blue noise in a vector of the block. */
enum { RAYS_OF_SLICE = 8, PACKED = 8, SHIFTS_MAX = BLUE_NOISE_EDGE * BLUE_NOISE_EDGE / PACKED };

/* Returns the sequence of a pixel's samples. The slices of a bit mask share one shift, of up to
 * the angle between two slices. */
static IndirectSequence sequence_of(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    return (IndirectSequence){in->sequence, in->rotation,
                              indirect_method(renderer)->one_shift ? 1 : in->rays};
}

static bool turns_bits(const IndirectSequence *of)
{
    return of->rotation == KEYWORD_Rotation_tile && of->sequence == KEYWORD_Sequence_sobol;
}

/* Returns the number of vectors of the block that hold shifts. */
static int shifts_of(const IndirectSequence *of)
{
    const int edge = indirect_sequence_edge(of);
    return of->rotation == KEYWORD_Rotation_blue ? SHIFTS_MAX : edge * edge;
}

void indirect_define(const Renderer *renderer, int coarse, char text[INDIRECT_DEFINITIONS])
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const bool uniform = in->distribution == KEYWORD_Distribution_uniform,
               bent = indirect_shows(renderer, "bent");
    const IndirectSequence sequence = sequence_of(renderer);
    const IndirectMethod *method = indirect_method(renderer);
    char voxels[32] = "", turns[64] = "";
    if (turns_bits(&sequence))
        snprintf(turns, sizeof turns, "#define INDIRECT_TURNS_BITS\n#define INDIRECT_BLOCK %d\n",
                 indirect_sequence_block(&sequence));
    if (indirect_reads_voxels(renderer))
        snprintf(voxels, sizeof voxels, "#define VOXEL_SIZE %d\n", renderer->scene->voxel_size);
    snprintf(
        text, INDIRECT_DEFINITIONS,
        "#define INDIRECT_RAYS %d\n#define INDIRECT_SLICES %d\n#define INDIRECT_STEPS %d\n"
        "#define INDIRECT_SAMPLES %d\n#define INDIRECT_TILE %d\n#define INDIRECT_SHIFTS %d\n"
        "#define INDIRECT_WEIGHT_%s\n#define INDIRECT_ROTATION_%s\n#define INDIRECT_JITTER %s\n"
        "#define INDIRECT_COARSE %d\n#define INDIRECT_FILTER %d\n%s%s%s%s%s%s%s%s%s",
        in->rays, (in->rays + RAYS_OF_SLICE - 1) / RAYS_OF_SLICE,
        in->steps ? in->steps : method->steps, indirect_keeps(renderer) ? 1 : in->samples,
        indirect_sequence_edge(&sequence), shifts_of(&sequence), keyword_table[in->weight].name,
        keyword_table[in->rotation].name, in->jitter ? "1.0" : "0.0", coarse,
        indirect_filter_size(renderer, coarse), turns,
        indirect_keeps(renderer) ? "#define INDIRECT_SETS\n" : "",
        uniform ? "#define INDIRECT_UNIFORM\n#define INDIRECT_SHARE(cosine) (2.0 * (cosine))\n"
                : "#define INDIRECT_SHARE(cosine) 1.0\n",
        in->march == KEYWORD_March_picture ? "#define INDIRECT_PICTURE\n" : "",
        in->checked ? "#define INDIRECT_CHECKED\n" : "",
        method->reads & INDIRECT_READS_near ? "#define INDIRECT_NEAR\n" : "",
        in->bounces > 0 && !bent && !indirect_shows(renderer, "visibility")
            ? "#define INDIRECT_LIGHT\n"
            : "",
        bent ? "#define INDIRECT_BENT\n" : "", voxels);
}

int indirect_filter_size(const Renderer *renderer, int coarse)
{
    const int widest = 8; /* max filter size in pixels of the picture */
    const SceneIndirect *in = &renderer->scene->indirect;
    const IndirectSequence sequence = sequence_of(renderer);
    const int edge = indirect_sequence_edge(&sequence);
    if (in->filter == KEYWORD_Filter_none || in->filter_size)
        return in->filter == KEYWORD_Filter_none ? 0 : in->filter_size;
    const int tile = edge && edge < INDIRECT_SEQUENCE_TILE ? edge / 2 : INDIRECT_SEQUENCE_TILE / 2;
    return tile * coarse > widest ? widest / coarse : tile;
}

const char *indirect_surface_text(const Renderer *renderer)
{
    return renderer->set.unpack ? renderer->set.unpack : "struct Surface { float nothing; };\n";
}

double indirect_near(const Renderer *renderer)
{
    return NEAR * voxel_grid(renderer->scene, &renderer->gpu_scene).edge;
}

/* Fills the element `models`. x: length along which voxels miss hits, since rays start off the
 * surface and ignore the voxels in which they start. y: thickness of visible surfaces; a voxel
 * may be off by its diagonal. zw: the picture's pixel at the tile's origin. */
static void set_models(const Renderer *renderer, float models[4])
{
    const double thick = 2,
                 part = .5; /* thickness of surfaces: in voxels; as a share of the ray length */
    const SceneIndirect *in = &renderer->scene->indirect;
    const bool voxels = indirect_reads_voxels(renderer);
    const double edge = voxels ? voxel_grid(renderer->scene, &renderer->gpu_scene).edge : 0;
    const double radius = voxel_grid_radius(renderer->scene, &renderer->gpu_scene);
    models[0] = voxels ? (float)indirect_near(renderer) : 0;
    models[1] = (float)(in->thickness > 0 ? in->thickness : voxels ? thick * edge : part * radius);
}

/* Fills the shifts. For blue noise the pass computes shifts from ranks, 16 bits each; other
 * shifts are stored as vectors. */
static void put_shifts(const IndirectSequence *of, float (*block)[4])
{
    const int edge = indirect_sequence_edge(of);
    for (int i = 0; i < edge * edge; i++) {
        double shift[3];
        if (of->rotation == KEYWORD_Rotation_blue) {
            const uint16_t rank = (uint16_t)blue_noise_rank(i % edge, i / edge);
            memcpy((char *)block + sizeof rank * (size_t)i, &rank, sizeof rank);
            continue;
        }
        indirect_sequence_shift(of, i % edge, i / edge, shift);
        for (int k = 0; k < 3; k++)
            block[i][k] = (float)shift[k];
    }
}

/* Without the key `offset` rays start so far off the surface that they do not hit it: a point
 * may be up to sqrt(1/2) of a pixel off the pixel's center, and depth is off by the same. */
static void set_block(const Renderer *renderer, ScreenPass *pass)
{
    /* `part`: share of the ray length over which ambient occlusion is assumed to be constant */
    const double lift = .75, part = .05;
    const SceneIndirect *in = &renderer->scene->indirect;
    const IndirectSequence sequence = sequence_of(renderer);
    float block[INDIRECT_BLOCK_HEAD + INDIRECT_RAYS_MAX + SHIFTS_MAX][4] = {{0}};
    double samples[INDIRECT_RAYS_MAX][2];
    memcpy(block[INDIRECT_BLOCK_RAY], renderer->space.ray, sizeof block[INDIRECT_BLOCK_RAY]);
    memcpy(block[INDIRECT_BLOCK_VIEW], renderer->space.depth, sizeof block[INDIRECT_BLOCK_VIEW]);
    block[INDIRECT_BLOCK_REACH][0] =
        (float)voxel_grid_radius(renderer->scene, &renderer->gpu_scene);
    block[INDIRECT_BLOCK_REACH][1] = (float)in->offset;
    block[INDIRECT_BLOCK_REACH][2] = in->offset > 0 ? 0 : (float)lift;
    block[INDIRECT_BLOCK_REACH][3] = (float)in->contrast;
    set_models(renderer, block[INDIRECT_BLOCK_MODELS]);
    for (int i = 0; i < 2; i++) {
        const int beyond = renderer->whole[i] - renderer->at[i];
        block[INDIRECT_BLOCK_MODELS][2 + i] = (float)renderer->at[i];
        block[INDIRECT_BLOCK_PICTURE][i] =
            (float)(beyond < renderer->size[i] ? beyond : renderer->size[i]);
    }
    block[INDIRECT_BLOCK_PICTURE][3] =
        in->filter_size ? INFINITY
                        : (float)(part * voxel_grid_radius(renderer->scene, &renderer->gpu_scene));
    indirect_sequence_samples(in->sequence, in->rays, samples);
    for (int i = 0; i < in->rays; i++) {
        for (int k = 0; k < 2; k++)
            block[INDIRECT_BLOCK_HEAD + i][k] = (float)samples[i][k];
        block[INDIRECT_BLOCK_HEAD + i][2] = (float)indirect_sequence_third(in->sequence, i);
    }
    put_shifts(&sequence, block + INDIRECT_BLOCK_HEAD + in->rays);
    material_write(&pass->material, "Indirect", block,
                   sizeof *block * (size_t)(INDIRECT_BLOCK_HEAD + in->rays + shifts_of(&sequence)));
}

void indirect_set(const Renderer *renderer, ScreenPass *pass)
{
    char name[] = "matc_gbuffer0";
    if (!pass->material.store)
        return;
    for (int i = 0; material_set_format(&renderer->set, i); i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(pass, name, i);
    }
    screen_pass_sampler(pass, "indirect_depth", INDIRECT_DEPTH_UNIT);
    set_block(renderer, pass);
}

void indirect_bind(const Renderer *renderer)
{
    for (int i = 0; frame_format(renderer, FRAME_TARGET_gbuffer, i); i++)
        texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_gbuffer, i), i);
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_depth, 0), INDIRECT_DEPTH_UNIT);
}
