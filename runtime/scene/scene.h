/* A scene as plain data: what is seen, what lights it, from where, in which picture. No GL; all
 * numbers in double, in the world's axes, and positions relative to Scene.origin (scene_origin.h),
 * which is 0 unless the scene lies far from there. */
#ifndef MATC_SCENE_H
#define MATC_SCENE_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"
#include "grammar/scene_tables.h"
#include "runtime/gl/shape.h"
#include "runtime/light_kinds/light_kind.h"

enum {
    SCENE_OBJECTS =
        /* objects and groups that a scene may have, those that an alias repeats counted each
         * time */
    1 << 20,
    /* of meshes that differ: some 40 bytes each, and as much again for the driver */
    SCENE_TRIANGLES = 1 << 26,
    SCENE_PLANES = 256, /* infinite planes: each is asked at every pixel */
    SCENE_NUMBERS = 6,
    SCENE_PLACE = 1024 /* bytes of a place as text, longer names of files being cut */
};

/* By columns, as GL has them: m[4 * column + row]; the last row is 0, 0, 0, 1. */
typedef struct {
    double m[16];
} SceneMatrix;

/* One of a document's materials. */
typedef struct {
    MatcDocument *document;
    int index;
} SceneMaterial;

/* A mesh out of a file; objects of one file share it. */
typedef struct {
    const char *path;
    Shape shape;
    /* the file's material whose triangles these are; -1: all triangles of the file */
    int part;
    /* whoever draws it displaces it: scene_patches.h. NULL: it is as it stands here */
    struct ScenePatches *patches;
    double steps[2]; /* of a volume (scene_volume.h), in the world; 0: it is none */
} SceneMesh;

typedef struct {
    SceneKind kind; /* of the sort object: a solid, a Plane or a Mesh */
    double numbers
        /* Sphere: radius, detail; Box: size; Cylinder, Cone: radius, height, detail; Parallelogram:
         * u, v */
        [SCENE_NUMBERS];
    int mesh;     /* of a Mesh: in Scene.meshes */
    int material; /* in Scene.materials */
    /* its detail is not given, and goes by the picture where a scene is large: scene_detail.h */
    bool adapts;
    const char *name; /* with those of its groups, "lamps/bulb"; NULL: it has none */
    bool removed;     /* by a host: hidden for good, and its place is free for another */
    /* it is neither drawn nor casts shadows; the renderer is to be told by
     * render_changed_meshes() */
    bool hidden;
    SceneMatrix world_from_local;
} SceneObject;

typedef struct {
    SceneKind kind; /* Perspective or Orthographic */
    double position[3];
    double target[3], upright[3]; /* a point that it looks at; what is up as far as it can be */
    /* of these; unit vectors at right angles: it looks along -back */
    double right[3], up[3], back[3];
    /* of the shorter side of the picture: as a tangent, or, orthographic, as a length */
    double half;
    double near;  /* Perspective: the nearest that is seen */
    double depth; /* Orthographic: the farthest */
} SceneCamera;

typedef struct {
    double time, position[3], target[3];
} SceneKey;

typedef struct {
    SceneKind kind; /* Turntable or Path */
    int frames;     /* 0: nothing moves */
    double axis[3]; /* Turntable: a unit vector */
    double angle;   /* Turntable: of all frames, in radians */
    SceneKey *keys; /* Path: two or more, their times rise */
    int key_count;
} SceneMotion;

typedef struct {
    bool grid, axes, lights;
    int grid_cells; /* from the origin to each side */
    double grid_step, axes_length, light_size;
} SceneTools;

/* Settings of some displacement methods. */
typedef struct {
    Word skirts;   /* WORD_Skirts_auto, ... */
    Word symbol;   /* of points: WORD_Symbol_square, ... */
    double spread; /* of points: how far those of a triangle go to its middle */
    /* of feedback: triangles are divided while distance - near < detail * area */
    double near, detail;
    double push, bulge; /* hard bodies become rounder: displace_point.glsl */
    int steps;          /* of feedback: passes; 0: by the number of triangles */
} SceneDividing;

/* Settings of `indirect:`, as scene.def describes them. */
typedef struct {
    /* WORD_Indirect_none: there is no `indirect:`, or that is what it says */
    Word method;
    /* no rays: the scene was not read, and has no indirect light */
    int rays, samples, steps;
    int history; /* frames that count */
    /* of openness, at which samples are enough; 0: all are taken */
    double error;
    double radius, offset, thickness; /* 0: to be found */
    double contrast;
    Word weight, distribution, sequence, rotation, march, filter;
    /* pixels; of the picture, along an edge of one for which rays go out */
    int filter_size, coarse;
    int moving; /* the same while something moves */
    bool jitter, checked, directional, dims_direct;
    int bounces;
    double gain;
} SceneIndirect;

/* An object or a group of the document's outermost list. */
typedef struct {
    double at[3]; /* its translation */
    int number;   /* in the list */
    bool plane;   /* it is an infinite plane */
} SceneRoot;

typedef struct SceneDisplacer SceneDisplacer;

typedef struct Scene {
    int width, height; /* pixels */
    double origin[3];  /* in the world, of all positions that follow */
    SceneRoot *roots;
    int root_count;
    SceneCamera camera;
    SceneMotion motion;
    double time; /* seconds, that materials go by; MatcOptions.time */
    SceneObject *objects;
    int object_count;
    SceneLight *lights;
    int light_count;
    SceneMaterial *materials; /* those in use, each once */
    int material_count;
    SceneMesh *meshes;
    int mesh_count;
    int sky; /* in materials, or -1 */
    /* what of the sky's radiance lights the scene; the sun of a SunSkyLight is among the lights */
    double sky_light[3];
    SceneKind tone;         /* of the sort toneMapping */
    double exposure;        /* a factor; 1 where the kind has none */
    double tone_numbers[4]; /* ReinhardDevlin: its params; Drago: bias; Shoulder: knee */
    /* where nothing is seen; with both, tiles are seen through glass alone */
    bool tiles, glow;
    int shadow_size;       /* texels of a shadow map's edge */
    int shadow_filter;     /* texels over which a shadow's edge is spread; 0: none */
    int shadow_cascades;   /* maps of a directional light */
    int shadow_points;     /* of an Area, along each edge: each has a map */
    Word shadow_volume;    /* of shadow volumes: WORD_Volume_plain, ... */
    Word shadow_path;      /* how its vertices come to their depths: WORD_Path_auto, ... */
    double shadow_offset;  /* texels, of a blurred volume */
    bool shadow_stretched; /* its outermost texels lie at the map's edge */
    bool shadow_colored;   /* what is transparent colours the light that goes through it */
    int displaced;         /* objects whose meshes were displaced: scene_displace.c */
    SceneDisplacer *displacer;
    Word displaced_by; /* how: WORD_Displacing_mesh, ... */
    /* by bisection: that an error may have in the picture; 0: it is not looked at */
    double displaced_pixels;
    int displaced_level;     /* parts of an edge; 0: by the next */
    int displaced_triangles; /* to about how many such a mesh is divided, at least */
    SceneDividing dividing;
    int voxel_size; /* voxels along an edge of the whole: a power of two */
    SceneIndirect indirect;
    SceneTools tools;
    MatcDocument **documents; /* further files of materials */
    int document_count;
} Scene;

/* The word, if it is the name of a method of the list Displacing; else NULL. */
const char *scene_displace_name(Word word);
/* A method of the list Shadows by its name. False: there is none of it. */
bool scene_shadows_find(const char *name, Word *method);
/* The word, if it is the name of such a method; else NULL. */
const char *scene_shadows_name(Word word);
/* Name of a word of the list Volume. */
const char *scene_volume_name(Word word);
/* All lights that cast shadows do so by this method; an Area by map, unless that is none. */
void scene_lights_shadow(Scene *scene, Word method);
/* Queries of the list Indirect, as those of Shadows. */
bool scene_indirect_is(const Scene *scene); /* it has indirect light */
bool scene_indirect_find(const char *name, Word *method);
const char *scene_indirect_name(Word word);
/* Plain maps: what `shadows:` is unless it says otherwise. */
#define SCENE_SHADOWS_PLAIN WORD_Shadows_map
static inline bool scene_light_casts(const SceneLight *light)
{
    return light->shadows != WORD_Shadows_none;
}
/* Some light does. */
bool scene_casts(const Scene *scene);
/* It can have shadows by a method of the list Shadows. */
bool scene_light_takes(const SceneLight *light, Word method);
/* 1 << Model of each surface model that materials of its objects show. */
unsigned scene_models(const Scene *scene);
/* FILE:LINE:COLUMN of a material that the scene has; reads its text up to there. */
void scene_material_place(const SceneMaterial *material, char place[SCENE_PLACE]);

/* Axes of an eye that stands, looks and is upright as the camera says. What has no direction: */
typedef enum { SCENE_AIM_fine, SCENE_AIM_view, SCENE_AIM_up } SceneAim;
SceneAim scene_camera_aim(SceneCamera *camera);
/* Orthographic: the plane is not behind it, in any corner of the picture. One that is seen edge-on
 * is not seen. */
bool scene_camera_sees_plane(const Scene *scene, const SceneCamera *camera,
                             const SceneMatrix *plane);
/* The camera of a frame, the first being 0, where the whole motion has so many frames. The scene
 * has a motion. False: it has no direction. */
bool scene_motion_camera(const Scene *scene, int frame, int frames, SceneCamera *camera);
#endif
