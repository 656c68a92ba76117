/* matc: compiles material trees (YAML, JSON) to GLSL and SPIR-V. The library's only public header.
 *
 *     MatcOptions options;
 *     matc_options_init(&options);
 *     MatcDocument *document = matc_read("rock.yaml", text, size, &options);
 *     if (matc_material_count(document)) {
 *         MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_VERTEX, &options);
 *         puts(matc_output(program, MATC_FRAGMENT, NULL));
 *         matc_program_free(program);
 *     }
 *     fputs(matc_diagnostics(document, MATC_TEXT), stderr);
 *     matc_document_free(document);
 *
 * No global state, no printing, no exit: any number of threads may work at once, each with its own
 * documents; one document may be compiled by several threads. Only running out of memory ends the
 * process: "matc: out of memory" on standard error, then abort().
 *
 * Every function answers every call. For an index outside of what a count gives, for a document
 * with faults, for a program or a layout that is not ok, and for a handle that is NULL, pointers
 * are NULL, numbers 0 and answers false, where nothing else is said. Functions that make a handle
 * never return NULL: a text or a document that is NULL is an error in the diagnostics of what they
 * made. Diagnostics of NULL are "". Options may be NULL: the defaults. A name that is NULL names
 * nothing, and where a result is handed out by a pointer (`size`, `fault`, `before`), NULL means
 * that it is not wanted. What cannot be checked: that a pointer which is not NULL points to as much
 * as is said, and that a handle has not been freed.
 *
 * A program goes on working with a later libmatc.so of the same number: functions and enumerators
 * stay as they are, and structs grow at their end only. MatcOptions says how long it is; the other
 * structs are the library's, seen by pointer. */
#ifndef MATC_H
#define MATC_H
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__GNUC__)
#define MATC_API __attribute__((visibility("default")))
#else
#define MATC_API
#endif

#define MATC_VERSION "0.1.0"
/* The version of the library that runs, where it may be another than that of this header. */
MATC_API const char *matc_version(void);

typedef struct MatcDocument MatcDocument;
typedef struct MatcProgram MatcProgram;
/* Vertex programs that glslang has linked, for a host that compiles many materials: a vertex
 * program is parsed once for all fragment programs that declare the same inputs, instead of once
 * for each of them. Any number of threads may share it. */
typedef struct MatcLinked MatcLinked;
typedef struct MatcLayout MatcLayout;

/* Gives the bytes of a file in memory from malloc, or NULL and a reason. */
typedef char *(*MatcReadFile)(void *user, const char *path, size_t *size, const char **why);

/* Names are those of the command line; NULL is the default. Set by matc_options_init, then
 * changed. */
typedef struct {
    size_t size;        /* in bytes, of the struct that the caller was compiled with */
    const char *target; /* "glsl110", "glsl330" (default), "glsl450", "essl300", "spirv" */
    /* "gbuffer" (default), "plane", "sky", "shadow", "depth", "value", "displacement" */
    const char *pass;
    const char *slot; /* for the pass "value": "diffuse" (default), "normal", ... */
    /* "compact" (default; "thin" for glsl110), "thesis", "radix", "integer", ... */
    const char *layout;
    /* "fast" (default), "balanced", "exact": sets those below that are NULL */
    const char *precision;
    const char *noise;        /* "lattice" (default), "groimp", "simplex" */
    const char *aa;           /* "auto" (default), "none", "box", "aniso" */
    const char *derivatives;  /* "auto" (default), "finite", "analytic" */
    const char *coordinates;  /* "plain" (default), "long" */
    const char *powers;       /* "squaring" (default), "pow", "compensated" */
    const char *trigonometry; /* "native" (default), "bounded" */
    const char *
        /* "baked" (default; so is "auto", which is of sets), "uniform": the document's come from a
         * buffer */
        constants;
    /* by place (matc_place): the member of the buffer that it becomes, -1 for none; NULL */
    const int *members;
    int member_count;
    int optimize;  /* 0: as written; 1, 2 (default): all passes of the optimiser */
    bool validate; /* glslang parses and links what is written (default) */
    bool measure;  /* the document keeps times for MATC_STATS */
    unsigned
        /* for MATC_STATS: a bit for each of noise ... trigonometry, in that order, that measuring
         * chose */
        measured;
    /* the IR is checked after every pass of the optimiser (default in debug builds) */
    bool check;
    /* pictures are decoded whole, for matc_eval and matc_texture; else only their size is read */
    bool pixels;
    MatcReadFile read_file;   /* for pictures and includes; NULL reads the file system */
    void *user;               /* for read_file */
    const MatcLayout *custom; /* overrides `layout`; it lives as long as what is compiled with it */
    MatcLinked *linked;       /* or NULL */
    /* those that are not said, or are errors: "no-NAME,error=NAME,error", in any number; the last
     * one that speaks of a warning counts. NULL (default): all are said.
     * matc_explain("warnings") */
    const char *warnings;
    const char *normals; /* of a G-buffer: "eye" (default), "world" */
    /* "glsl450", passes that draw triangles: one call draws many objects, of any material that
     * shares the program. Matrices and numbers come from storage buffers, by the attribute
     * matc_instance (docs/reference/renderer.md); no MATC_REFLECT then */
    bool instances;
    /* meshes are displaced already, as matc_move does it: the vertex program moves nothing. Its
     * attribute `basePosition` (location 10) has where a point was, by which maps go */
    bool moved;
    double time; /* seconds: the time at which matc_move moves; programs have it by a uniform */
    /* folders of files that `include:` does not find beside a document; after them come those of
     * matc itself */
    const char *const *include;
    int include_count;
    /* of the layout, 1 << matc_case of each program: MATC_UNPACK reads back what those pack, and
     * its Surface has no slot that none of them gives. 0: all cases, so that it stays the same
     * whatever a set holds */
    unsigned cases;
    /* MATC_COMPUTE will be asked for, by matc_emit: the program is to have the normals that it
     * writes. matc_compile with MATC_COMPUTE knows by itself */
    bool compute;
    /* the folder below which all lies that documents name: includes, pictures, meshes and their
     * parts, after links are resolved. NULL: no limit. A read_file of the caller's is asked
     * instead, and decides by itself */
    const char *root;
    char warning_text[256]; /* where matc_options_set keeps `warnings`; counts where that is NULL */
    /* The matrices, eye and viewer that are set for a draw are relative to an origin near the
     * camera, since floats cannot hold positions far from the world's. What reads the position in
     * the world adds the uniform matc_origin */
    bool origin;
} MatcOptions;

MATC_API MatcLinked *matc_linked_new(void);
MATC_API void matc_linked_free(MatcLinked *linked);
/* Members beyond those that the caller knows of keep their defaults. */
#define matc_options_init(options) matc_options_init_sized(options, sizeof(MatcOptions))
MATC_API void matc_options_init_sized(MatcOptions *options, size_t size);
/* Sets a member by its name: "target", "noise", ...; false, and nothing is set, if it is none of
 * those above `optimize`, nor "warnings" or "normals", or has no such value. NULL is the default.
 * The value is copied: it may go afterwards, and the options may be assigned. A list of warnings
 * has at most 255 bytes. */
MATC_API bool matc_options_set(MatcOptions *options, const char *name, const char *value);
/* NULL, also of no options, or which option has a value that does not exist, "size" where
 * matc_options_init was not called; a program that is compiled with it says which values there
 * are. */
MATC_API const char *matc_options_fault(const MatcOptions *options);

/* Reads and resolves a document. Never NULL; faults are in its diagnostics, and it then has no
 * materials; nor has one of definitions alone.
 * `name` is for messages, for relative paths, and tells JSON (".json") from YAML. */
MATC_API MatcDocument *matc_read(const char *name, const char *text, size_t size,
                                 const MatcOptions *options);
MATC_API void matc_document_free(MatcDocument *document);
MATC_API int matc_material_count(const MatcDocument *document);
/* The name under `materials:`, or the file's stem; NULL: there is no such material. */
MATC_API const char *matc_material_name(const MatcDocument *document, int material);
/* Index of the material of that name, or -1. */
MATC_API int matc_material_find(const MatcDocument *document, const char *name);
/* Files that the document was made from, itself first, and those that it asked for in vain; NULL
 * beyond them. */
MATC_API int matc_depend_count(const MatcDocument *document);
MATC_API const char *matc_depend(const MatcDocument *document, int index);
/* The document as it was read, as text; owned by the document. */
MATC_API const char *matc_tree_text(MatcDocument *document);

/* The definitions that the document has or includes, with what they say of themselves, a line each;
 * the page of one. From malloc; NULL: there are none, there is none of that name, or the document
 * has faults. */
MATC_API char *matc_definitions(const MatcDocument *document);
MATC_API char *matc_explain_definition(MatcDocument *document, const char *name);

/* JSON Schema of documents, in which uses of definitions are those that this one has or includes,
 * by name, with their parameters and what they say of themselves: an editor completes and checks
 * them. From malloc; NULL: the document has faults. */
MATC_API char *matc_document_schema(MatcDocument *document);

typedef enum {
    MATC_FRAGMENT = 1, /* GLSL of the fragment program */
    MATC_VERTEX = 2,   /* GLSL of the matching vertex program */
    MATC_UNPACK = 4,   /* GLSL that reads the layout back */
    /* JSON: choices, inputs, uniforms, textures, outputs, opacity, sources, hash; of a sky its
     * sun */
    MATC_REFLECT = 8,
    /* SPIR-V words of the fragment program; and of all stages that are asked for beside it, by
     * matc_spirv */
    MATC_SPIRV = 16,
    MATC_IR = 32,  /* text of the optimised IR */
    MATC_DOT = 64, /* the same as a graph for Graphviz */
    /* alone: nothing is written yet, but keys, places and constants are there; matc_emit may
     * follow */
    MATC_KEY = 256,
    MATC_LAYOUT = 512, /* the layout as a file that matc_layout_read takes */
    /* GLSL of the programs that tessellate in the vertex program's stead: attributes handed on, */
    MATC_TESSVERTEX = 1024,
    MATC_TESSCONTROL = 2048, /* levels of a triangle's edges, each by its two ends alone, */
    /* and what the vertex program does at the points between. Targets of GLSL 4 alone */
    MATC_TESSEVAL = 4096,
    /* GLSL for any stage that is written around it: `vec3 matc_displaced(vec3 position, vec3
     * displacementNormal, vec2 displacementTexcoord, vec3 displacementTangentU, vec3
     * displacementTangentV)`, a point in the world */
    MATC_DISPLACE = 8192,
    /* GLSL of the vertex program that hands attributes on to a geometry program, */
    MATC_GEOMETRYVERTEX = 16384,
    /* and that: it divides triangles, and does what the vertex program does. Targets of desktop
     * GLSL from 3.30 on */
    MATC_GEOMETRY = 32768,
    /* GLSL of a compute program that reads vertices from a buffer, and writes where they are
     * displaced to, and the normals there. Targets of GLSL 4.5 alone
     * (docs/reference/displacement-programs.md) */
    MATC_COMPUTE = 65536,
    /* table of stages and optimiser passes; the choices, and what settled each */
    MATC_STATS = 128,
} MatcOutput;

/* Compiles one material into the outputs asked for (MatcOutput, or-ed). Never NULL. */
MATC_API MatcProgram *matc_compile(const MatcDocument *document, int material, unsigned outputs,
                                   const MatcOptions *options);
/* Writes what it was not asked for before; the document must still be there. False: see the
 * diagnostics. */
MATC_API bool matc_emit(MatcProgram *program, unsigned outputs);
MATC_API bool matc_ok(const MatcProgram *program);
/* An output, zero-terminated, owned by the program; NULL if it was not asked for or the program is
 * not ok. */
MATC_API const char *matc_output(const MatcProgram *program, MatcOutput output, size_t *size);
/* SPIR-V of a stage whose GLSL is an output (MATC_FRAGMENT, MATC_VERTEX, MATC_TESSEVAL,
 * MATC_COMPUTE, ...), where MATC_SPIRV was asked for with it: stages that are drawn together are
 * linked together. NULL otherwise. Size in bytes, words in the machine's order; owned by the
 * program. */
MATC_API const char *matc_spirv(const MatcProgram *program, MatcOutput stage, size_t *size);
MATC_API void matc_program_free(MatcProgram *program);
/* The pass whose program it is: "depth" for the shadow of an opaque material; of one that is not ok
 * that which was asked for, or "gbuffer". */
MATC_API const char *matc_pass(const MatcProgram *program);
/* "opaque" or "transparent" everywhere, or "varying"; NULL: the program is not ok. */
MATC_API const char *matc_opacity(MatcProgram *program);

/* The vertex program moves no point farther, in units of the world: `displacementBound`, or what
 * matc proves of the maps. 0: it moves none, INFINITY: neither is known. */
MATC_API double matc_displacement_bound(const MatcProgram *program);

/* Inputs that a displacement depends on: none, the material moves no point; attributes and matrices
 * up to a rigid motion of the whole; or also the position in the world. */
typedef enum { MATC_MOVES_none, MATC_MOVES_local, MATC_MOVES_world } MatcMoves;
MATC_API MatcMoves matc_moves(const MatcDocument *document, int material,
                              const MatcOptions *options);
/* A point of a mesh. The first four are in the world; tangents are derivatives of the position by u
 * and v, the normal has any length. */
typedef struct {
    double position[3], normal[3], tangent_u[3], tangent_v[3];
    double local[3], local_u[3], local_v[3]; /* position and tangents in the object's space */
    double uv[2];
} MatcPoint;
/* Moves positions as the vertex program does, by the C reference in double. The document has its
 * pictures whole (MatcOptions.pixels). False: it has faults, or a value takes too many
 * operations. */
MATC_API bool matc_move(const MatcDocument *document, int material, const MatcOptions *options,
                        MatcPoint *points, int count);

/* The material puts a volume in its surface's place (`displacementVolume`). */
MATC_API bool matc_has_volume(const MatcDocument *document, int material);
/* The solid intervals along the unit normal of a point, in units of the world: from heights[0] to
 * [1] and from [2] to [3]; an interval is empty if its second bound is not the larger one. */
typedef struct {
    MatcPoint at;
    double heights[4];
} MatcSolid;
/* Sets heights by the C reference in double, and answers as matc_move does. */
MATC_API bool matc_solid(const MatcDocument *document, int material, const MatcOptions *options,
                         MatcSolid *points, int count);

/* Gives a param of the document another default, of as many lanes as it has; `before`, of four
 * lanes, is told the one it had first, or is NULL. It holds for what is compiled, evaluated and
 * moved from now on, and no other thread uses the document meanwhile. False: it has no param of
 * that name and so many lanes. */
MATC_API bool matc_set_default(MatcDocument *document, const char *param, const double *lanes,
                               int count, double *before);

/* Programs with one key are one program: a hash, as 32 hexadecimal digits, of all that its text
 * depends on but for names of materials and of temporaries. Numbers that come from a buffer do not
 * count. */
MATC_API const char *matc_key(MatcProgram *program);
/* Key of the program without its constants: programs of one shape differ in constants only. */
MATC_API const char *matc_shape(MatcProgram *program);

/* A number or vector of a program: a member of its block `Constants` (std140; plain uniforms in
 * GLSL 1.10), or a place of its text that may become one (name is then NULL). */
typedef struct {
    const char *name;
    const char *type; /* "float", "vec2", "vec3", "vec4", "uint", "uvec4" */
    int lanes;
    int offset;       /* of a member, in bytes */
    int member;       /* of those that the options named, else -1 */
    double values[4]; /* of the material that the program was compiled for */
} MatcConstant;
MATC_API int matc_place_count(MatcProgram *program);
MATC_API const MatcConstant *matc_place(MatcProgram *program, int index);
MATC_API int matc_constant_count(const MatcProgram *program);
MATC_API const MatcConstant *matc_constant(const MatcProgram *program, int index);
MATC_API int matc_constant_bytes(const MatcProgram *program); /* of the block */
/* Writes the block as a buffer holds it: matc_constant_bytes bytes. */
MATC_API void matc_constant_block(const MatcProgram *program, void *block);

/* A texture that the program samples; owned by the program, but its texels by the document, which
 * must still be there. Row 0 is at v = 0. */
typedef struct {
    const char *name; /* of its sampler */
    /* of the picture, or NULL for one that matc made; "a.glb#/images/2": it lies within that
     * file */
    const char *path;
    int width, height;
    int lanes;                  /* 1 or 4 a texel */
    const unsigned char *bytes; /* a byte a lane, over 255; or NULL */
    const float *floats;        /* a float a lane; or NULL */
    /* give it all mipmaps and filter linearly in and between them; else: nearest texels */
    bool mipmaps;
    /* of a texel, by OpenGL's name: "RGBA8", "SRGB8_ALPHA8", "RGBA16", "R32F", ... */
    const char *format;
    const unsigned short *words; /* 16 bits a lane, over 65535; or NULL */
    int anisotropy;              /* of its sampler, at most, where the driver can; 1: none */
    /* of its sampler: "repeat", "mirrored_repeat", "clamp_to_edge", or "clamp_to_border", which is
     * 0 in all lanes */
    const char *wrap;
} MatcTexture;
MATC_API int matc_texture_count(const MatcProgram *program);
/* Made on first request, from the document; NULL: there is no such texture. */
MATC_API const MatcTexture *matc_texture(MatcProgram *program, int index);

/* Render targets of the passes gbuffer and plane; none for other passes. The format is "RGBA16F",
 * "RGBA32UI", ...; a target whose name ends in UI holds whole numbers: the shader's output and the
 * sampler that reads it do, too. */
MATC_API int matc_target_count(const MatcProgram *program);
/* The number of the layout's case by which it packs, from 0, below 32; -1: its pass packs
 * nothing. */
MATC_API int matc_case(const MatcProgram *program);
MATC_API const char *matc_target_format(const MatcProgram *program, int index);

/* A uniform that the document's `param` made; owned by the program, but its names by the document,
 * which must still be there. */
typedef struct {
    const char *name;  /* in the shader */
    const char *param; /* in the document */
    int lanes;         /* 1 to 4 */
    bool whole;        /* an int */
    double initial[4]; /* its default */
} MatcUniform;
MATC_API int matc_uniform_count(const MatcProgram *program);
MATC_API const MatcUniform *matc_uniform(const MatcProgram *program, int index);

/* Attributes that the program reads from the mesh beside position, normal, texture coordinate and
 * tangents. The list is owned by the program, its names by the document, which must still be there.
 * */
typedef struct {
    const char *name;      /* in the document: "color", "wetness" */
    const char *attribute; /* in the vertex program */
    const char *varying;   /* in the fragment program */
    int lanes;             /* 1 to 4 */
    /* of the attribute; in GLSL that declares none it is bound there by its name, or anywhere */
    int location;
    double initial[4]; /* where a mesh has none of that name */
} MatcAttribute;
MATC_API int matc_attribute_count(const MatcProgram *program);
MATC_API const MatcAttribute *matc_attribute(const MatcProgram *program, int index);

/* Values of all slots of a material at a point, by the C reference, in double: one line a slot, its
 * name, then its lanes. `point` sets channels, and attributes of the mesh: "u=0.3 v=0.4 x=1 ...
 * front=0 @wetness=1 @color.r=0.5". NULL and a message in *fault if it cannot be read. The text is
 * from malloc. */
MATC_API char *matc_eval(const MatcDocument *document, int material, const char *point,
                         const MatcOptions *options, const char **fault);
/* Value of one slot, that of the options (NULL: "diffuse"), as numbers. */
typedef struct {
    int lanes; /* of the slot, 1 to 4; 0: see fault */
    double lane[4];
    const char *fault;
} MatcNumbers;
MATC_API MatcNumbers matc_eval_slot(const MatcDocument *document, int material, const char *point,
                                    const MatcOptions *options);

typedef enum { MATC_TEXT, MATC_JSON } MatcForm;
/* All diagnostics so far, as gcc prints them or as a JSON array; owned by the document or program.
 * "" in both forms when there are none. */
MATC_API const char *matc_diagnostics(MatcDocument *document, MatcForm form);
MATC_API const char *matc_program_diagnostics(MatcProgram *program, MatcForm form);
MATC_API int matc_error_count(const MatcDocument *document);

/* A layout from a file in YAML or JSON; docs/reference/layouts.md has its keys. Never NULL. Not ok:
 * see its diagnostics. */
MATC_API MatcLayout *matc_layout_read(const char *name, const char *text, size_t size,
                                      const MatcOptions *options);
MATC_API bool matc_layout_ok(const MatcLayout *layout);
MATC_API const char *matc_layout_diagnostics(MatcLayout *layout, MatcForm form);
MATC_API const char *matc_layout_name(const MatcLayout *layout);
/* Of a pixel. */
MATC_API int matc_layout_bytes(const MatcLayout *layout);
/* The layout as a file, and a page for people: its fields, their places, bits, ranges and errors.
 * Owned by the layout. */
MATC_API const char *matc_layout_text(const MatcLayout *layout);
MATC_API const char *matc_layout_report(const MatcLayout *layout);
MATC_API void matc_layout_free(MatcLayout *layout);

/* Ranges of the slots of a set of materials, for the smallest layout that holds it. Plain data:
 * copy it, keep it as long as the library is of the same number; with another one it may have
 * another size. */
enum { MATC_SLOTS = 30, MATC_SETS = 256 };
typedef struct {
    double low[4], high[4]; /* of each lane, over those that count */
    int counted;            /* materials to which the slot matters */
    int absent;             /* of them: those that say nothing about it */
    int alike;              /* of them: those whose lanes are all alike */
    int drawn;              /* further ones, to which whoever draws tells it */
} MatcSlotRange;
/* Materials that have the same slots to be stored. */
typedef struct {
    unsigned slots; /* 1 << slot of each */
    int materials;
} MatcSlotSet;
typedef struct {
    int materials;
    int set_count;
    MatcSlotRange slot[MATC_SLOTS]; /* in the order of --list */
    MatcSlotSet sets[MATC_SETS];    /* all different, those with the most slots first */
    MatcSlotSet others;             /* what has no place there: materials with any of these slots */
} MatcRanges;
MATC_API void matc_ranges_init(MatcRanges *ranges);
/* Adds a material; its constants must not be uniforms. False: it does not compile, and *fault, from
 * malloc, says why. */
MATC_API bool matc_ranges_add(MatcRanges *ranges, const MatcDocument *document, int material,
                              const MatcOptions *options, char **fault);
/* Adds what another one has; in whatever order, the result is the same. */
MATC_API void matc_ranges_join(MatcRanges *ranges, const MatcRanges *other);
/* The smallest layout that holds them, in up to eight cases. `error` is what a colour may be off,
 * as its square root; other slots in proportion; 0: half a step of 8 bits. Its report also says
 * what was left out, and why. Never NULL. Not ok: there are no materials. */
MATC_API MatcLayout *matc_layout_for(const MatcRanges *ranges, double error,
                                     const MatcOptions *options);

/* Descriptions made from the tables of matc; from malloc. JSON Schema of "document" (or NULL),
 * "layout", "manifest" or "reflection"; NULL for others. The list of kinds. The page of one name.
 * */
MATC_API char *matc_schema(const char *of);
MATC_API char *matc_list(void);
/* One of its parts, "maps", "slots", "noise", ...; NULL of others. */
MATC_API char *matc_list_of(const char *kind);
/* NULL if there is nothing of that name. */
MATC_API char *matc_explain(const char *name);

#ifdef __cplusplus
}
#endif
#endif
