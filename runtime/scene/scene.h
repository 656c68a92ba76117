/* A scene as plain data: objects, lights, camera, and picture settings. Makes no GL calls. All
 * numbers are in double, with world axes; positions are relative to Scene.origin
 * (scene_origin.h), which is 0 unless the scene lies far from the world's origin. */
#ifndef MATC_SCENE_H
#define MATC_SCENE_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"
#include "grammar/scene_tables.h"
#include "runtime/gl/shape.h"
#include "runtime/light_kinds/light_kind.h"

enum {
    SCENE_OBJECTS = 1 << 20, /* max objects and groups of a scene, each use of an alias counted */
    /* max triangles of all different meshes: some 40 bytes each, and as much again on the GPU */
    SCENE_TRIANGLES = 1 << 26,
    SCENE_PLANES = 256, /* max infinite planes: each is evaluated at every pixel */
    SCENE_NUMBERS = 6,
    SCENE_PLACE = 1024 /* bytes of a place as text; longer file names are cut */
};

/* Affine transform. Stored by columns, as in GL: m[4 column + row]; the last row is 0, 0, 0, 1. */
typedef struct {
    double m[16];
} SceneMatrix;

/* A material of a document. */
typedef struct {
    MatcDocument *document;
    int index;
} SceneMaterial;

/* A mesh of a file; objects of one file share it. */
typedef struct {
    const char *path;
    Shape shape;
    /* The file's material that these triangles use; -1: all triangles of the file. */
    int part;
    /* Patches that the GPU displaces: scene_patches.h. NULL: the shape is final. */
    struct ScenePatches *patches;
    double steps[2]; /* cell sizes of a volume (scene_volume.h), in world units; 0: no volume */
} SceneMesh;

typedef struct {
    SceneKind kind; /* an object: a solid, a Plane or a Mesh */
    double numbers
        /* Sphere: radius, detail; Box: size; Cylinder, Cone: radius, height, detail;
         * Parallelogram: u, v. */
        [SCENE_NUMBERS];
    int mesh;     /* index in Scene.meshes if the object is a Mesh */
    int material; /* index in Scene.materials */
    /* The document gives no detail, so a large scene chooses it by the size in the picture:
     * scene_detail.h. */
    bool adapts;
    /* name, preceded by those of its groups, such as "lamps/bulb"; NULL: no name */
    const char *name;
    bool removed; /* removed by the host: hidden for good; the slot may be reused */
    /* Neither drawn nor casting shadows; after a change call renderer_changed_meshes(). */
    bool hidden;
    SceneMatrix world_from_local;
} SceneObject;

typedef struct {
    SceneKind kind; /* Perspective or Orthographic */
    double position[3];
    /* point that the camera looks at; direction closest to up in the picture */
    double target[3], upright[3];
    /* Derived from these: orthonormal axes; the camera looks along -back. */
    double right[3], up[3], back[3];
    /* Half the picture's shorter side: a tangent, or, orthographic, a length. */
    double half;
    double near;  /* Perspective: distance of the near plane */
    double depth; /* Orthographic: distance of the far plane */
} SceneCamera;

typedef struct {
    double time, position[3], target[3];
} SceneKey;

typedef struct {
    SceneKind kind; /* Turntable or Path */
    int frames;     /* number of frames; 0: no motion */
    double axis[3]; /* Turntable: a unit vector */
    double angle;   /* Turntable: over all frames, in radians */
    SceneKey *keys; /* Path: at least two, with ascending times */
    int key_count;
} SceneMotion;

typedef struct {
    bool grid, axes, lights;
    int grid_cells; /* number of grid cells from the origin to each side */
    double grid_step, axes_length, light_size;
} SceneTools;

/* Settings of some displacement methods. */
typedef struct {
    Keyword skirts; /* a KEYWORD_Skirts_... value, such as KEYWORD_Skirts_auto */
    /* symbol of method points: a KEYWORD_Symbol_... value, such as KEYWORD_Symbol_square */
    Keyword symbol;
    /* method points: share of the distance from a triangle's corners to its center */
    double spread;
    /* Method feedback: a triangle is divided while distance - near < detail * area. */
    double near, detail;
    double push, bulge; /* rounding of hard-edged meshes: displace_point.glsl */
    int steps;          /* method feedback: number of passes; 0: by the number of triangles */
} SceneDividing;

/* Settings of `indirect:`, documented in scene.def. */
typedef struct {
    /* KEYWORD_Indirect_none: `indirect:` is missing, or selects none. */
    Keyword method;
    /* numbers of rays, samples and steps; rays 0: the scene has no document and no indirect light
     */
    int rays, samples, steps;
    int history; /* number of frames that accumulate */
    /* Error of ambient occlusion at which sampling stops; 0: all samples are taken. */
    double error;
    double radius, offset, thickness; /* lengths in world units; 0: chosen automatically */
    double contrast;
    Keyword weight, distribution, sequence, rotation, march, filter;
    /* Denoise radius in pixels; resolution divisor of the ray pass. */
    int filter_size, coarse;
    int moving; /* resolution divisor while something moves */
    bool jitter, checked, directional, dims_direct;
    int bounces;
    double gain;
} SceneIndirect;

/* An object or a group at the top level of the document. */
typedef struct {
    double at[3]; /* translation of the object or group */
    int number;   /* index of the object or group in its list */
    bool plane;   /* the object is an infinite plane */
} SceneRoot;

typedef struct SceneDisplacer SceneDisplacer;

typedef struct Scene {
    int width, height; /* size of the picture in pixels */
    double origin[3];  /* origin in world space of all positions below */
    SceneRoot *roots;
    int root_count;
    SceneCamera camera;
    SceneMotion motion;
    double time; /* time in seconds, read by materials; MatcOptions.time */
    SceneObject *objects;
    int object_count;
    SceneLight *lights;
    int light_count;
    SceneMaterial *materials; /* all used materials, without duplicates */
    int material_count;
    SceneMesh *meshes;
    int mesh_count;
    int sky; /* index of the sky material in `materials`; -1: none */
    /* Factor of the sky's radiance that lights the scene; the sun of a SunSkyLight is one of the
     * lights. */
    double sky_light[3];
    SceneKind tone;  /* kind of tone mapping, from the sort toneMapping */
    double exposure; /* exposure factor; 1 if the kind has none */
    /* numbers of the tone mapping: ReinhardDevlin, its parameters; Drago, bias; Shoulder, knee */
    double tone_numbers[4];
    /* Backdrop of pixels without a surface; with both, tiles appear only behind transparent
     * surfaces. */
    bool tiles, glow;
    int shadow_size;       /* edge of a shadow map in texels */
    int shadow_filter;     /* width of a shadow's edge in texels; 0: no filter */
    int shadow_cascades;   /* number of shadow maps of a directional light */
    int shadow_points;     /* sample points of an Area along each edge, a shadow map each */
    Keyword shadow_volume; /* variant of shadow volumes: a KEYWORD_Volume_... value */
    Keyword shadow_path;   /* source of the volumes' vertex depths: a KEYWORD_Path_... value */
    double shadow_offset;  /* depth offset of a blurred shadow volume, in texels */
    /* the centers of the outermost texels are taken to lie at the map's edge */
    bool shadow_stretched;
    bool shadow_colored; /* transparent surfaces color the light that they transmit */
    int displaced;       /* number of objects with displaced meshes: scene_displace.c */
    SceneDisplacer *displacer;
    Keyword displaced_by; /* method of displacement: a KEYWORD_Displacing_... value */
    /* Max error in the picture by bisection, or max edge by other GPU methods, in pixels; 0: the
     * picture does not matter. */
    double displaced_pixels;
    int displaced_level;     /* parts of a patch's edge; 0: chosen by displaced_triangles */
    int displaced_triangles; /* approximate min number of triangles of a displaced mesh */
    SceneDividing dividing;
    int voxel_size; /* voxels along an edge of the grid: a power of two */
    SceneIndirect indirect;
    SceneTools tools;
    MatcDocument **documents; /* other documents from which materials were read */
    int document_count;
} Scene;

/* Returns the name of a keyword of the list Displacing; NULL for any other keyword. */
const char *scene_displace_name(Keyword word);
/* Finds a method of the list Shadows by name. False if unknown. */
bool scene_shadows_find(const char *name, Keyword *method);
/* Returns the name of a keyword of the list Shadows; NULL for any other keyword. */
const char *scene_shadows_name(Keyword word);
/* Returns the name of a keyword of the list Volume; NULL for any other keyword. */
const char *scene_volume_name(Keyword word);
/* Sets the shadow method of all lights that cast shadows; area lights support only shadow maps,
 * so other methods leave them unchanged. */
void scene_lights_shadow(Scene *scene, Keyword method);
/* Functions for the list Indirect, like those for the list Shadows. */
bool scene_indirect_is(const Scene *scene); /* Reports whether the scene has indirect light. */
bool scene_indirect_find(const char *name, Keyword *method);
const char *scene_indirect_name(Keyword word);
/* Plain shadow maps, the default of `shadows:`. */
#define SCENE_SHADOWS_PLAIN KEYWORD_Shadows_map
static inline bool scene_light_casts(const SceneLight *light)
{
    return light->shadows != KEYWORD_Shadows_none;
}
/* Reports whether some light casts shadows. */
bool scene_casts(const Scene *scene);
/* Reports whether a light supports a method of the list Shadows. */
bool scene_light_takes(const SceneLight *light, Keyword method);
/* Returns the set of surface models that materials of the scene's objects use, as bits 1 <<
 * Model. */
unsigned scene_models(const Scene *scene);
/* Writes FILE:LINE:COLUMN of a material; scans the file's text up to there. */
void scene_material_place(const SceneMaterial *material, char place[SCENE_PLACE]);

/* Computes a camera's axes from position, target and upright. Returns the vector that has no
 * direction, if any. */
typedef enum { SCENE_AIM_fine, SCENE_AIM_view, SCENE_AIM_up } SceneAim;
SceneAim scene_camera_aim(SceneCamera *camera);
/* Reports whether an orthographic camera has the plane in front in all corners of the picture.
 * An edge-on plane does not count. */
bool scene_camera_sees_plane(const Scene *scene, const SceneCamera *camera,
                             const SceneMatrix *plane);
/* Computes the camera of a frame, 0 to frames - 1, of a scene with a motion. Returns false if it
 * has no direction. */
bool scene_motion_camera(const Scene *scene, int frame, int frames, SceneCamera *camera);
#endif
