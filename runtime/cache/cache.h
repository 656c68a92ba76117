/* A scene on the driver's side: each mesh once, each program once with the numbers of all its
 * materials, and objects in groups that one call draws. Where the driver can: instances, whose
 * matrices and numbers lie in buffers; else each object is a group of its own. */
#ifndef MATC_CACHE_CACHE_H
#define MATC_CACHE_CACHE_H
#include "runtime/cache/cull.h"
#include "runtime/cache/seen_text.h"
#include "runtime/cache/transparency.h"
#include "runtime/cache/view_space.h"
#include "runtime/displace/displaced.h"
#include "runtime/gl/mesh.h"

/* Into what a surface is drawn by programs of its material: into shadow maps, into voxels; into the
 * picture. */
typedef enum { CACHE_USE_cast, CACHE_USE_cut, CACHE_USES, CACHE_USE_seen = CACHE_USES } CacheUse;

/* Materials that are drawn alike but for their numbers: one program, the same textures and
 * uniforms. */
typedef struct {
    Material material; /* without instances: with an object's matrices */
    bool transparent;  /* at least in places */
    /* buffer of the numbers of all materials of the program; 0: there are none */
    GLuint numbers;
} CacheKind;

/* One draw call: objects of one kind, one mesh, and one winding of its triangles. */
typedef struct {
    int kind, mesh;       /* in Cache.kinds, Cache.meshes */
    bool mirrored;        /* its triangles turn the other way round */
    int first, count;     /* in Cache.places, and in the first half of Cache.list */
    int first_seen, seen; /* of these, those in view: in the second half */
    bool solid;           /* none of those shows its inside: back faces are not drawn */
} Drawable;

/* Where an object is among those that are drawn. */
typedef struct {
    int object;          /* in Scene.objects */
    int kind, mesh, row; /* `row`: of the kind's numbers */
    /* in Cache.casters: with what it is drawn into shadow maps; -1: by depth alone, or it casts
     * none */
    int caster;
    /* in Cache.casters: with what it is drawn into voxels, of which it fills some, as it is cut
     * out; -1: it is not */
    int cut;
    GLuint program;
    bool transparent, mirrored;
    const float *even; /* what it lets through, if that is the same everywhere; else NULL */
} CachePlace;

typedef struct {
    Material material;
    int object;
    bool transparent;
    const SetProgram *program;
} CachePlane;

/* A place, and how near it is. */
typedef struct {
    double nearness;
    uint32_t place;
} CacheOrder;

enum { CACHE_LISTS = 3 /* of places, in one buffer */ };

typedef struct {
    bool instances; /* objects are drawn as instances */
    CacheKind *kinds;
    int kind_count;
    CacheKind *
        /* programs that draw into shadow maps and voxels, of what is transparent; the numbers by
         * the rows of its kind */
        casters;
    int caster_count;
    GLuint *numbers; /* by program of the set: a buffer, or 0 */
    int number_count;
    Mesh *meshes;
    CullBox *boxes;       /* of the meshes */
    Key *mesh_keys;       /* of what they are made of */
    Displaced *displaced; /* by mesh: how the driver makes it; empty where it is there as it is */
    /* by kind: draws surfaces that rays have found (cache_trace.h); empty where none is */
    Material *traced;
    bool tracing; /* there is one */
    /* such a mesh has other triangles, since whoever reads this took it back */
    bool displaced_anew;
    int mesh_count;
    /* of the objects but planes, opaque ones first, sorted by program, kind, mesh */
    CachePlace *places;
    int place_count;
    int *place_of; /* by object; -1: it has none */
    Drawable *surfaces;
    int surface_count;
    int opaque_count; /* of these; the others are transparent, at least in places */
    CachePlane *planes;
    int plane_count, opaque_plane_count;
    Material sky;
    bool has_sky;
    long triangles; /* of all surfaces */
    /* places: all of them, then those in view, then those that a light sees; a buffer has the
     * same */
    uint32_t *list;
    uint32_t *seen_list; /* the second of these, as the buffer has it */
    int seen;
    CacheOrder *order;    /* room to sort places in */
    uint32_t *cast_order; /* places of what casts shadows, sorted by caster and mesh */
    int cast_count;
    GLuint matrices, words,
        /* buffers: of places, of the list, of the block View for the camera and for a light */
        views[2];
} Cache;

typedef struct {
    const Scene *scene;
    const Set *set;
    const ViewSpace *space;
    const CullVolume *volume;   /* what is seen; NULL: all */
    const CullVolume *view;     /* the camera's, also where all is drawn */
    const int *size;            /* of the picture, in pixels */
    const int *at;              /* its pixel that is drawn first: of a tile */
    const MatcOptions *compile; /* of programs that displace */
    /* of meshes that the driver displaces are wanted in the scene, too */
    bool triangles;
    /* the camera alone looks at the scene, and maps of shadows: no ray, no other shadows */
    bool alone;
    bool casts; /* there are such maps */
    Transparency transparency;
    const SeenText *written; /* by what is opaque, beside the G-buffer */
    bool lines;              /* surfaces are drawn as lines */
} CacheSource;

/* Meshes that `before` has are taken out of it; NULL: there was none. False: see the context's
 * error; *made is empty then. */
bool cache_make(Store *store, const CacheSource *source, Cache *before, Cache *made);
/* Safe on an empty one, which it leaves behind. */
void cache_delete(GlContext *gl, Cache *cache);

/* Adds the mesh of an object. cache_mesh.c, as is what follows. */
bool cache_mesh_make(Store *store, const CacheSource *source, Cache *cache,
                     const SceneObject *object);
/* Has the driver displace meshes again that go by the view. */
bool cache_mesh_view(GlContext *gl, const CacheSource *source, Cache *cache);
/* Some of these go by lights. */
bool cache_mesh_by_lights(const Cache *cache);
/* The view is another. Nothing is made. cache_view.c, as is what follows. */
bool cache_view(GlContext *gl, const CacheSource *source, Cache *cache);
/* So many objects from `first` on stand elsewhere. */
bool cache_move(GlContext *gl, const CacheSource *source, Cache *cache, int first, int count);
/* Sets a uniform of a material. False: no program of it has one of that name and so many lanes. */
bool cache_set(const CacheSource *source, Cache *cache, int material, const MaterialValue *value);
/* Sorts the places into drawables, and writes all buffers. */
bool cache_arrange(GlContext *gl, const CacheSource *source, Cache *cache);
/* Sorts places of a drawable, from the farthest on. cache_order.c. */
void cache_order(const CacheSource *source, Cache *cache, const Drawable *drawable, uint32_t *list,
                 int count);
/* Draws the surfaces in view, each with its program: those that are opaque but not traced, or the
 * others. */
void cache_draw(GlContext *gl, Cache *cache, bool transparent);

/* How what is traced goes to a shadow map. */
typedef struct {
    float offset[2]; /* of glPolygonOffset */
    float pixel[2];  /* a texel of the map, in clip space */
    float corner[2]; /* of the texel 0, 0 there */
} CacheLightTrace;

/* View of a light on the scene. */
typedef struct {
    const double *clip_from_world; /* 16, by columns */
    const CullVolume *volume;
    bool mirrored;   /* triangles turn the other way round there */
    Material *solid; /* draws depth alone (shadow_depth.glsl) */
    /* by kind, draws what is opaque in its place (radiance.h); or NULL */
    Material *kept;
    /* of its map: the uniform glass_map of programs that color shadows */
    int number;
    /* by place: those are drawn that have the number `wave`; NULL: all are */
    const unsigned char *waves;
    int wave;
    /* draws what is cut out, by programs of its own, or in place of these by `kept` */
    bool cut;
    /* what is transparent by the same everywhere is not drawn: it casts by exact triangles */
    bool varying;
    /* what is traced for pictures is traced; NULL: its grid is drawn */
    const CacheLightTrace *traced;
} CacheLight;

/* Sorts what casts shadows. cache_cast.c, as is what follows. */
bool cache_arrange_casters(GlContext *gl, Cache *cache);
/* Draws what casts shadows: what is opaque by depth alone, or all else by its caster; or what is
 * cut out. */
void cache_cast(GlContext *gl, const CacheSource *source, Cache *cache, const CacheLight *light,
                bool transparent);
#endif
