/* A scene on the GPU: each mesh once, each program once with the constants of all its materials,
 * and objects in groups that one call draws. If the driver supports instancing, matrices and
 * constants are in buffers; otherwise each object is a group of its own. */
#ifndef MATC_GPU_SCENE_GPU_SCENE_H
#define MATC_GPU_SCENE_GPU_SCENE_H
#include "runtime/gpu_scene/cull.h"
#include "runtime/gpu_scene/triangle_id_text.h"
#include "runtime/gpu_scene/transparency.h"
#include "runtime/gpu_scene/view_space.h"
#include "runtime/displace/displaced.h"
#include "runtime/gl/mesh.h"

/* Target of a material's program: shadow maps, voxels (alpha-tested surfaces), or the picture. */
typedef enum {
    GPU_SCENE_USE_cast,
    GPU_SCENE_USE_cut,
    GPU_SCENE_USES,
    GPU_SCENE_USE_seen = GPU_SCENE_USES
} GpuSceneUse;

/* Materials that differ only in constants: one program with the same textures and uniforms. */
typedef struct {
    /* material of the program; without instancing its uniforms hold one object's matrices */
    Material material;
    bool transparent; /* at least some fragments are transparent */
    /* Buffer with the constants of all materials of the program; 0: no constants. */
    GLuint numbers;
} GpuSceneKind;

/* A draw call: objects with the same kind, mesh and winding of triangles. */
typedef struct {
    int kind, mesh;       /* indices in GpuScene.kinds and GpuScene.meshes */
    bool mirrored;        /* negative determinant: the winding is flipped */
    int first, count;     /* range in GpuScene.places, and in the first part of GpuScene.list */
    int first_seen, seen; /* range of the objects in view, in the second part of GpuScene.list */
    bool solid;           /* all meshes are closed and viewed from outside: back faces are culled */
} Drawable;

/* An object that is drawn, with its kind and mesh. */
typedef struct {
    int object;          /* index in Scene.objects */
    int kind, mesh, row; /* `row`: index of the object's constants in the kind's buffer */
    /* Index in GpuScene.casters of the program for shadow maps; -1: drawn by depth alone, or casts
     * no shadow. */
    int caster;
    /* Index in GpuScene.casters of the program that draws an alpha-tested surface into voxels; -1:
     * not alpha-tested. */
    int cut;
    GLuint program;
    bool transparent, mirrored;
    const float *even; /* transmittance with three components if constant; else NULL */
} GpuScenePlace;

typedef struct {
    Material material;
    int object;
    bool transparent;
    const PassProgram *program;
} GpuScenePlane;

/* A place and its depth for sorting. */
typedef struct {
    double nearness;
    uint32_t place;
} GpuSceneOrder;

enum { GPU_SCENE_LISTS = 3 /* number of lists of places in one buffer; see GpuScene.list */ };

typedef struct {
    bool instances; /* the driver supports instancing */
    GpuSceneKind *kinds;
    int kind_count;
    /* Programs that draw transparent or alpha-tested surfaces into shadow maps and voxels; their
     * constants have the same order as those of `kinds`. */
    GpuSceneKind *casters;
    int caster_count;
    /* per program of the material set: uniform buffer of its constants; 0: no constants */
    GLuint *numbers;
    int number_count;
    Mesh *meshes;
    CullBox *boxes; /* bounding boxes of the meshes */
    Key *mesh_keys; /* hashes of the meshes' contents */
    /* indexed by mesh: how the GPU displaces the mesh; empty for other meshes */
    Displaced *displaced;
    /* Indexed by kind: program that shades ray-marched surfaces (gpu_scene_trace.h); empty if
     * the kind has none. */
    Material *traced;
    bool tracing; /* some kind has a program in `traced` */
    /* A displaced mesh has been tessellated again; readers reset the flag. */
    bool displaced_rebuilt;
    int mesh_count;
    /* Objects except infinite planes, opaque ones first, sorted by program, kind, mesh. */
    GpuScenePlace *places;
    int place_count;
    int *place_of; /* indexed by object: index of the object in `places`; -1: none */
    Drawable *surfaces;
    int surface_count;
    int opaque_count; /* opaque ones come first; the others have transparent fragments */
    GpuScenePlane *planes;
    int plane_count, opaque_plane_count;
    Material sky;
    bool has_sky;
    long triangles; /* number of triangles of all surfaces */
    /* Indices of places, in three parts: all, those in the camera's view, those in a light's
     * view. The buffer `words` has the same contents. */
    uint32_t *list;
    uint32_t *seen_list; /* the second part of `list`, as last written to the buffer */
    int seen;
    GpuSceneOrder *order; /* scratch memory for sorting places */
    uint32_t *cast_order; /* places of shadow casters, sorted by caster and mesh */
    int cast_count;
    /* Buffers: matrices of the places, draw list, uniform block View for [camera, light]. */
    GLuint matrices, words, views[2];
} GpuScene;

typedef struct {
    const Scene *scene;
    const MaterialSet *set;
    const ViewSpace *space;
    const CullVolume *volume;   /* frustum for culling; NULL disables culling */
    const CullVolume *view;     /* the camera's frustum, even if culling is disabled */
    const int *size;            /* size of the picture, in pixels */
    const int *at;              /* first pixel of the tile */
    const MatcOptions *compile; /* compile options for programs that displace */
    /* The scene's meshes also need the triangles that the GPU displaces. */
    bool triangles;
    /* Only the camera and shadow maps read the scene: no rays, no other shadows. */
    bool alone;
    bool casts; /* the scene has shadow maps */
    Transparency transparency;
    const TriangleIdText *written; /* outputs of opaque surfaces in addition to the G-buffer */
    bool lines;                    /* surfaces are drawn as lines */
} GpuSceneSource;

/* Makes a GPU scene, and moves meshes that `before` (or NULL) already has. Returns false on
 * failure, with *made empty; see the context's error. */
bool gpu_scene_make(Store *store, const GpuSceneSource *source, GpuScene *before, GpuScene *made);
/* Frees the GPU scene and leaves it empty; safe on an empty one. */
void gpu_scene_delete(GlContext *gl, GpuScene *gpu_scene);

/* Adds the mesh of an object. This function and the next ones: gpu_scene_mesh.c. */
bool gpu_scene_mesh_make(Store *store, const GpuSceneSource *source, GpuScene *gpu_scene,
                         const SceneObject *object);
/* Displaces meshes on the GPU again whose tessellation depends on the view. */
bool gpu_scene_mesh_view(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene);
/* Reports whether the tessellation of some mesh depends on lights. */
bool gpu_scene_mesh_by_lights(const GpuScene *gpu_scene);
/* Applies a new view without making resources. This function and the next ones: gpu_scene_view.c.
 */
bool gpu_scene_view(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene);
/* Applies new matrices of `count` objects from `first` on. */
bool gpu_scene_move(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene, int first,
                    int count);
/* Sets a uniform of a material. Returns false if none of its programs has a uniform with the
 * given name and number of components. */
bool gpu_scene_set(const GpuSceneSource *source, GpuScene *gpu_scene, int material,
                   const MaterialValue *value);
/* Sorts the places into drawables, and writes all buffers. */
bool gpu_scene_arrange(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene);
/* Sorts places of a drawable from far to near. gpu_scene_order.c */
void gpu_scene_order(const GpuSceneSource *source, GpuScene *gpu_scene, const Drawable *drawable,
                     uint32_t *list, int count);
/* Draws the surfaces in view with their programs: the opaque ones that are not ray-marched, or
 * the transparent ones. */
void gpu_scene_draw(GlContext *gl, GpuScene *gpu_scene, bool transparent);

/* Parameters for ray marching surfaces into a shadow map. */
typedef struct {
    float offset[2]; /* factor and units of glPolygonOffset */
    float pixel[2];  /* size of a texel of the map, in clip space */
    float corner[2]; /* corner of texel (0, 0) in clip space */
} GpuSceneLightTrace;

/* A light's view of the scene, for shadow maps and similar targets. */
typedef struct {
    const double *clip_from_world; /* matrix of 16 numbers, by columns */
    const CullVolume *volume;
    bool mirrored;   /* the projection flips the winding */
    Material *solid; /* program that draws depth alone (shadow_depth.glsl) */
    /* Indexed by kind: replacement program for opaque surfaces (radiance.h); NULL: no
     * replacement. */
    Material *kept;
    /* Number of the map: the uniform glass_map of programs that color shadows. */
    int number;
    /* Indexed by place: only places whose entry equals `wave` are drawn; NULL: all are drawn. */
    const unsigned char *waves;
    int wave;
    /* Draws alpha-tested surfaces, by their own programs or by `kept`. */
    bool cut;
    /* Omits surfaces of constant transmittance: exact shadows handle them by triangles. */
    bool varying;
    /* Settings for ray marching the surfaces that the picture ray-marches; NULL: their grids are
     * drawn. */
    const GpuSceneLightTrace *traced;
} GpuSceneLight;

/* Sorts the shadow casters. This function and the next one: gpu_scene_cast.c. */
bool gpu_scene_arrange_casters(GlContext *gl, GpuScene *gpu_scene);
/* Draws shadow casters: opaque ones by depth alone, transparent ones by their caster programs,
 * or alpha-tested ones. */
void gpu_scene_cast(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene,
                    const GpuSceneLight *light, bool transparent);
#endif
