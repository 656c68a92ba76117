/* matc: compiles material trees (YAML, JSON) to GLSL and SPIR-V. The library's only public
 * header.
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
 * The library has no global state, does not print and does not exit. Threads may work in
 * parallel on their own documents, and may compile one document in parallel. Exhausted memory
 * ends the process: "matc: out of memory" on standard error, then abort().
 *
 * Invalid arguments are handled by every function. For an index outside its count, a document
 * with faults, a program or layout that is not ok, and a NULL handle, functions return NULL, 0
 * or false unless documented otherwise. Functions that create a handle never return NULL: a NULL
 * text or document becomes an error in the diagnostics of the new handle. Diagnostics of a NULL
 * handle are "". NULL options mean the defaults. A NULL name matches nothing. NULL is allowed
 * for result pointers (`size`, `fault`, `before`) that are not needed. Two conditions cannot be
 * checked: that a pointer refers to enough memory, and that a handle has not been freed.
 *
 * Binary compatibility: a program runs with any later libmatc.so of the same number. Functions
 * and enumerators are stable, and structs grow only at their end. MatcOptions records its size;
 * other structs are owned by the library and accessed by pointer. */
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

/* -- Version and options */

#define MATC_VERSION "0.2.0"
/* Returns the version of the loaded library, which may differ from this header's. */
MATC_API const char *matc_version(void);

typedef struct MatcDocument MatcDocument;
typedef struct MatcProgram MatcProgram;
typedef struct MatcLayout MatcLayout;
/* Cache of vertex programs that glslang has linked, for a host that compiles many materials: a
 * vertex program is parsed once for all fragment programs with the same inputs. Thread-safe. */
typedef struct MatcLinked MatcLinked;

/* Returns the bytes of a file in memory from malloc, or NULL and a reason. */
typedef char *(*MatcReadFile)(void *user, const char *path, size_t *size, const char **why);

/* Options, with the names of the command line; NULL selects the default. Initialize by
 * matc_options_init, then change members. */
typedef struct {
    size_t size; /* sizeof(MatcOptions) of the calling program, in bytes */
    /* target language: "glsl110", "glsl330" (default), "glsl450", "essl300", "spirv" */
    const char *target;
    /* pass of the program: "gbuffer" (default), "plane", "sky", "shadow", "depth", "value",
     * "displacement" */
    const char *pass;
    const char *slot; /* slot of the pass "value": "diffuse" (default), "normal", ... */
    /* G-buffer layout: "compact" (default; "thin" for glsl110), "thesis", "radix", "integer",
     * ... */
    const char *layout;
    /* precision, which sets the following choices that are NULL: "fast" (default), "balanced",
     * "exact" */
    const char *precision;
    const char *noise;       /* noise: "lattice" (default), "groimp", "simplex" */
    const char *aa;          /* antialiasing: "auto" (default), "none", "box", "aniso" */
    const char *derivatives; /* slopes of maps: "auto" (default), "finite", "analytic" */
    /* precision of coordinates for noise and checkers: "plain" (default), "long" */
    const char *coordinates;
    const char *powers;       /* integer powers: "squaring" (default), "pow", "compensated" */
    const char *trigonometry; /* sine and cosine: "native" (default), "bounded" */
    const char *
        /* "baked" (default; also "auto", which applies to batches), "uniform": the document's
         * constants are read from a uniform block */
        constants;
    /* Per place (matc_place): the uniform block member that replaces the literal, -1 for none.
     * NULL: all literals stay. */
    const int *members;
    int member_count;
    /* level of optimization: 0, none; 1 and 2 (default), all passes of the optimizer */
    int optimize;
    bool validate; /* validate the output by glslang (default) */
    bool measure;  /* collect times for MATC_STATS */
    unsigned
        /* Bits for MATC_STATS, one for each of noise ... trigonometry in this order, that
         * measuring selected. */
        measured;
    /* Check the IR after every pass of the optimizer (default in debug builds). */
    bool check;
    /* Decode images completely, for matc_eval and matc_texture; otherwise only their sizes are
     * read. */
    bool pixels;
    MatcReadFile read_file;   /* reads images and includes; NULL: the file system */
    void *user;               /* passed to read_file */
    const MatcLayout *custom; /* overrides `layout`; must outlive everything compiled with it */
    MatcLinked *linked;       /* cache of linked vertex programs; NULL: no cache */
    /* Settings of warnings, separated by commas: "no-NAME,error=NAME,error". The last setting
     * that applies to a warning is effective. NULL (default): all warnings are reported.
     * matc_explain("warnings") */
    const char *warnings;
    const char *normals; /* space of G-buffer normals: "eye" (default), "world" */
    /* Instanced drawing ("glsl450", passes that draw triangles): a call draws many objects with
     * any materials that share the program. Matrices and constants are in storage buffers,
     * indexed by the attribute matc_instance (docs/reference/renderer.md). Excludes
     * MATC_REFLECT. */
    bool instances;
    /* Meshes are already displaced, as by matc_move: the vertex program does not displace. Its
     * attribute `basePosition` (location 10) is the position before displacement, which maps
     * read. */
    bool moved;
    double time; /* time in seconds for matc_move; programs read it from a uniform */
    /* Folders searched for files of `include:` that are not in the document's folder; matc's own
     * library files follow. */
    const char *const *include;
    int include_count;
    /* Set of layout cases, 1 << matc_case of each program: MATC_UNPACK reads back only these
     * cases, and its Surface omits slots that none of them has. 0: all cases, independent of the
     * materials. */
    unsigned cases;
    /* MATC_COMPUTE will be requested by matc_emit: the program computes normals for it. Not
     * needed if matc_compile itself requests MATC_COMPUTE. */
    bool compute;
    /* Root folder of all files that documents refer to (includes, images, meshes and their
     * parts), after links are resolved. NULL: no restriction. Not applied to files that the
     * caller's read_file reads. */
    const char *root;
    /* storage of `warnings` for matc_options_set; used while `warnings` is NULL */
    char warning_text[256];
    /* The matrices, eye and viewer of a draw are relative to an origin near the camera, since
     * floats lose precision far from the world's origin. Code that reads the world position adds
     * the uniform matc_origin. */
    bool origin;
} MatcOptions;

MATC_API MatcLinked *matc_linked_new(void);
MATC_API void matc_linked_free(MatcLinked *linked);
/* Initializes options; the size lets members unknown to the caller keep their defaults. */
#define matc_options_init(options) matc_options_init_sized(options, sizeof(MatcOptions))
MATC_API void matc_options_init_sized(MatcOptions *options, size_t size);
/* Sets a member by name: "target", "noise", ...: any member above `optimize`, "warnings" or
 * "normals". Returns false without a change for another name or an unknown value. NULL is the
 * default. The value is copied: it may be freed, and the options may be assigned. A list of
 * warnings has at most 255 bytes. */
MATC_API bool matc_options_set(MatcOptions *options, const char *name, const char *value);
/* Returns the first option with an unknown value; "size" if matc_options_init was not called;
 * NULL if all are valid or `options` is NULL. A program compiled with such options reports the
 * valid values. */
MATC_API const char *matc_options_fault(const MatcOptions *options);

/* -- Documents */

/* Reads and resolves a document. Never returns NULL: faults are in its diagnostics. A document
 * with faults, or of definitions only, has no materials.
 * `name` is used in messages, for relative paths, and to distinguish JSON (".json") from YAML. */
MATC_API MatcDocument *matc_read(const char *name, const char *text, size_t size,
                                 const MatcOptions *options);
MATC_API void matc_document_free(MatcDocument *document);
MATC_API int matc_material_count(const MatcDocument *document);
/* Returns the name under `materials:`, or the file's stem; NULL if the index is invalid. */
MATC_API const char *matc_material_name(const MatcDocument *document, int material);
/* Returns the index of the material with that name; -1: none. */
MATC_API int matc_material_find(const MatcDocument *document, const char *name);
/* Files on which the document depends, itself first, including files that were missing; NULL for
 * an invalid index. */
MATC_API int matc_depend_count(const MatcDocument *document);
MATC_API const char *matc_depend(const MatcDocument *document, int index);
/* Returns the parsed document as text; owned by the document. */
MATC_API const char *matc_tree_text(MatcDocument *document);

/* Return the definitions of the document and its includes, one per line with its description;
 * the page of one definition. From malloc; NULL: none, unknown name, or the document has faults. */
MATC_API char *matc_definitions(const MatcDocument *document);
MATC_API char *matc_explain_definition(MatcDocument *document, const char *name);

/* Returns a JSON Schema of documents with the definitions of this document and its includes, so
 * that editors can complete and check their uses: names, parameters and descriptions. From
 * malloc; NULL: the document has faults. */
MATC_API char *matc_document_schema(MatcDocument *document);

/* -- Programs */

typedef enum {
    MATC_FRAGMENT = 1, /* GLSL of the fragment program */
    MATC_VERTEX = 2,   /* GLSL of the matching vertex program */
    MATC_UNPACK = 4,   /* GLSL that unpacks the layout */
    /* JSON: choices, inputs, uniforms, textures, outputs, opacity, sources, hash; for a sky its
     * sun. */
    MATC_REFLECT = 8,
    /* SPIR-V words of the fragment program; matc_spirv has those of all stages requested
     * together with it. */
    MATC_SPIRV = 16,
    MATC_IR = 32,  /* text of the optimized IR */
    MATC_DOT = 64, /* the IR as a graph for Graphviz */
    /* No text is generated: keys, places and constants only; matc_emit may follow. */
    MATC_KEY = 256,
    MATC_LAYOUT = 512, /* the layout as a file for matc_layout_read */
    /* GLSL of the tessellation programs, which replace the vertex program. This one passes
     * attributes on. */
    MATC_TESSVERTEX = 1024,
    MATC_TESSCONTROL = 2048, /* tessellation levels of each edge, from its two ends only */
    /* Interpolates attributes, and processes them as the vertex program does. GLSL 4 targets
     * only. */
    MATC_TESSEVAL = 4096,
    /* GLSL functions for hand-written stages: `vec3 matc_displaced(vec3 position, vec3
     * displacementNormal, vec2 displacementTexcoord, vec3 displacementTangentU, vec3
     * displacementTangentV)` returns a point in world space. */
    MATC_DISPLACE = 8192,
    /* GLSL of the vertex program that passes attributes to the geometry program. */
    MATC_GEOMETRYVERTEX = 16384,
    /* GLSL of the geometry program, which subdivides triangles and processes attributes as the
     * vertex program does. Desktop GLSL targets from 3.30 on. */
    MATC_GEOMETRY = 32768,
    /* GLSL of a compute program that reads vertices from a buffer, and writes their displaced
     * positions and normals. GLSL 4.5 targets only (docs/reference/displacement-programs.md). */
    MATC_COMPUTE = 65536,
    /* Table of stages and optimizer passes; the choices and their sources. */
    MATC_STATS = 128,
} MatcOutput;

/* Compiles a material into the requested outputs (MatcOutput, or-ed). Never returns NULL. */
MATC_API MatcProgram *matc_compile(const MatcDocument *document, int material, unsigned outputs,
                                   const MatcOptions *options);
/* Generates further outputs; the document must still exist. Returns false after reporting
 * faults. */
MATC_API bool matc_emit(MatcProgram *program, unsigned outputs);
MATC_API bool matc_ok(const MatcProgram *program);
/* Returns an output, zero-terminated, owned by the program; NULL if it was not requested or the
 * program is not ok. */
MATC_API const char *matc_output(const MatcProgram *program, MatcOutput output, size_t *size);
/* Returns the SPIR-V of a stage (MATC_FRAGMENT, MATC_VERTEX, MATC_TESSEVAL, MATC_COMPUTE, ...),
 * if MATC_SPIRV was requested with it; stages of one draw call are linked together. Otherwise
 * NULL. Size in bytes, words in the machine's byte order; owned by the program. */
MATC_API const char *matc_spirv(const MatcProgram *program, MatcOutput stage, size_t *size);
MATC_API void matc_program_free(MatcProgram *program);
/* Returns the pass of the program: "depth" for the shadow of an opaque material. For a program
 * that is not ok returns the requested pass, or "gbuffer". */
MATC_API const char *matc_pass(const MatcProgram *program);
/* Returns "opaque" or "transparent" if that holds everywhere, otherwise "varying"; NULL: the
 * program is not ok. */
MATC_API const char *matc_opacity(MatcProgram *program);

/* -- Displacement, by the C reference */

/* Returns the max displacement of a vertex in world units: `displacementBound`, or a bound
 * proved from the maps. 0: no displacement; INFINITY: unknown. */
MATC_API double matc_displacement_bound(const MatcProgram *program);

/* Inputs of a displacement: none (not displaced); attributes and matrices, invariant under rigid
 * motion of the object; or also the world position. */
typedef enum { MATC_MOVES_none, MATC_MOVES_local, MATC_MOVES_world } MatcMoves;
MATC_API MatcMoves matc_moves(const MatcDocument *document, int material,
                              const MatcOptions *options);
/* A point of a mesh. The first four members are in world space; tangents are derivatives of the
 * position by u and v, the normal has any length. */
typedef struct {
    double position[3], normal[3], tangent_u[3], tangent_v[3];
    double local[3], local_u[3], local_v[3]; /* position and tangents in object space */
    double uv[2];
} MatcPoint;
/* Displaces positions like the vertex program, by the C reference in double precision. The
 * document must have been read with MatcOptions.pixels. Returns false if the document has
 * faults, or a value needs too many operations. */
MATC_API bool matc_move(const MatcDocument *document, int material, const MatcOptions *options,
                        MatcPoint *points, int count);

/* Returns true if the material replaces its surface by a volume (`displacementVolume`). */
MATC_API bool matc_has_volume(const MatcDocument *document, int material);
/* The solid intervals along the unit normal of a point, in world units: heights[0] to [1] and
 * [2] to [3]; an interval is empty unless its second bound is greater. */
typedef struct {
    MatcPoint at;
    double heights[4];
} MatcSolid;
/* Computes the heights by the C reference in double precision; returns like matc_move. */
MATC_API bool matc_solid(const MatcDocument *document, int material, const MatcOptions *options,
                         MatcSolid *points, int count);

/* Sets the default of a param, with its number of components; `before` (four components, or
 * NULL) receives the original default. Applies to later compilations, evaluations and
 * displacements; no other thread may use the document meanwhile. Returns false if no param has
 * that name and size. */
MATC_API bool matc_set_default(MatcDocument *document, const char *param, const double *components,
                               int count, double *before);

/* -- Keys, and constants of a program */

/* Returns a hash of everything that determines the program's text, as 32 hexadecimal digits:
 * programs with equal keys are equal. Excluded are names of materials and temporaries, and
 * numbers in the uniform block. */
MATC_API const char *matc_key(MatcProgram *program);
/* Returns the key of the program without its constants: programs of one shape differ only in
 * constants. */
MATC_API const char *matc_shape(MatcProgram *program);

/* A constant of a program: a member of its uniform block `Constants` (std140; plain uniforms in
 * GLSL 1.10), or a literal in its text that may become a member (name is then NULL). */
typedef struct {
    const char *name;
    const char *type; /* type of the constant: "float", "vec2", "vec3", "vec4", "uint", "uvec4" */
    int components;
    int offset;       /* offset of the member in bytes */
    int member;       /* index of the member in MatcOptions; -1: not a member */
    double values[4]; /* values of the constant in the compiled material */
} MatcConstant;
MATC_API int matc_place_count(MatcProgram *program);
MATC_API const MatcConstant *matc_place(MatcProgram *program, int index);
MATC_API int matc_constant_count(const MatcProgram *program);
MATC_API const MatcConstant *matc_constant(const MatcProgram *program, int index);
/* Returns the size of the uniform block in bytes. */
MATC_API int matc_constant_bytes(const MatcProgram *program);
/* Writes the content of the uniform block: matc_constant_bytes bytes. */
MATC_API void matc_constant_block(const MatcProgram *program, void *block);

/* -- Textures, render targets, uniforms and attributes of a program */

/* A texture that the program samples; owned by the program, but its texels by the document,
 * which must still exist. Row 0 is at v = 0. */
typedef struct {
    const char *name; /* name of the texture's sampler in the shader */
    /* Path of the image, NULL for a generated texture; "a.glb#/images/2" is an image inside the
     * file. */
    const char *path;
    int width, height;
    int components; /* components per texel: 1 or 4 */
    /* texels as a byte per component, divided by 255; NULL: another format */
    const unsigned char *bytes;
    const float *floats; /* texels as a float per component; NULL: another format */
    /* Needs all mipmap levels and trilinear filtering; otherwise nearest filtering. */
    bool mipmaps;
    /* Texel format by OpenGL's name: "RGBA8", "SRGB8_ALPHA8", "RGBA16", "R32F", ... */
    const char *format;
    /* texels as 16 bits per component, divided by 65535; NULL: another format */
    const unsigned short *words;
    int anisotropy; /* max anisotropy of the sampler, if supported; 1: none */
    /* Address mode: "repeat", "mirrored_repeat", "clamp_to_edge", or "clamp_to_border" with a
     * border of zeros. */
    const char *wrap;
} MatcTexture;
MATC_API int matc_texture_count(const MatcProgram *program);
/* Returns a texture, generated on the first call from the document; NULL if the index is
 * invalid. */
MATC_API const MatcTexture *matc_texture(MatcProgram *program, int index);

/* Render targets of the passes gbuffer and plane; other passes have none. The format is
 * "RGBA16F", "RGBA32UI", ...; a format that ends in UI holds unsigned integers, as do the
 * shader's output and the sampler that reads it. */
MATC_API int matc_target_count(const MatcProgram *program);
/* Returns the layout case that the program packs, 0 to 31; -1: its pass packs nothing. */
MATC_API int matc_case(const MatcProgram *program);
MATC_API const char *matc_target_format(const MatcProgram *program, int index);

/* A uniform created by a `param` of the document; owned by the program, but its names by the
 * document, which must still exist. */
typedef struct {
    const char *name;  /* name in the shader */
    const char *param; /* name in the document */
    int components;    /* number of components, 1 to 4 */
    bool whole;        /* the uniform has the type int */
    double initial[4]; /* default value of the uniform */
} MatcUniform;
MATC_API int matc_uniform_count(const MatcProgram *program);
MATC_API const MatcUniform *matc_uniform(const MatcProgram *program, int index);

/* Attributes that the program reads from the mesh in addition to position, normal, texture
 * coordinate and tangents. The list is owned by the program, its names by the document, which
 * must still exist. */
typedef struct {
    const char *name;      /* name in the document: "color", "wetness" */
    const char *attribute; /* name in the vertex program */
    const char *varying;   /* name in the fragment program */
    int components;        /* number of components, 1 to 4 */
    /* Location of the attribute; GLSL without locations may bind it by name, here or elsewhere. */
    int location;
    double initial[4]; /* default for meshes without the attribute */
} MatcAttribute;
MATC_API int matc_attribute_count(const MatcProgram *program);
MATC_API const MatcAttribute *matc_attribute(const MatcProgram *program, int index);

/* -- Values at a point */

/* Evaluates all slots of a material at a point by the C reference in double precision: a line
 * per slot, with its name and components. `point` sets channels and mesh attributes: "u=0.3
 * v=0.4 x=1 ... front=0 @wetness=1 @color.r=0.5". The text is from malloc; NULL and a message in
 * *fault if the point is invalid. */
MATC_API char *matc_eval(const MatcDocument *document, int material, const char *point,
                         const MatcOptions *options, const char **fault);
/* Value of the slot that the options select (NULL: "diffuse"), as numbers. */
typedef struct {
    int components; /* components of the slot, 1 to 4; 0: see fault */
    double component[4];
    const char *fault;
} MatcNumbers;
MATC_API MatcNumbers matc_eval_slot(const MatcDocument *document, int material, const char *point,
                                    const MatcOptions *options);

/* -- Diagnostics */

typedef enum { MATC_TEXT, MATC_JSON } MatcForm;
/* Return all diagnostics so far, in gcc's form or as a JSON array; owned by the document or
 * program. "" in both forms if there are none. */
MATC_API const char *matc_diagnostics(MatcDocument *document, MatcForm form);
MATC_API const char *matc_program_diagnostics(MatcProgram *program, MatcForm form);
MATC_API int matc_error_count(const MatcDocument *document);

/* -- Layouts */

/* Reads a layout from YAML or JSON; docs/reference/layouts.md lists its keys. Never returns
 * NULL; if the layout is not ok, see its diagnostics. */
MATC_API MatcLayout *matc_layout_read(const char *name, const char *text, size_t size,
                                      const MatcOptions *options);
MATC_API bool matc_layout_ok(const MatcLayout *layout);
MATC_API const char *matc_layout_diagnostics(MatcLayout *layout, MatcForm form);
MATC_API const char *matc_layout_name(const MatcLayout *layout);
/* Returns the bytes per pixel. */
MATC_API int matc_layout_bytes(const MatcLayout *layout);
/* Return the layout as a file, and a report of its fields: places, bits, ranges and errors.
 * Owned by the layout. */
MATC_API const char *matc_layout_text(const MatcLayout *layout);
MATC_API const char *matc_layout_report(const MatcLayout *layout);
MATC_API void matc_layout_free(MatcLayout *layout);

/* Ranges of the slots of a set of materials, from which the smallest layout is derived. Plain
 * data that may be copied, and stored while the library has the same number; its size may differ
 * in other versions. */
enum { MATC_SLOTS = 30, MATC_SETS = 256 };
typedef struct {
    double low[4], high[4]; /* range of each component over the counted materials */
    int counted;            /* number of materials in which the slot has an effect */
    int absent;             /* number of counted materials without the slot */
    int alike;              /* number of counted materials whose components are equal */
    int drawn;              /* number of further materials, whose slot the draw call sets */
} MatcSlotRange;
/* Number of materials that store exactly these slots. */
typedef struct {
    unsigned slots; /* set of slots, 1 << slot */
    int materials;
} MatcSlotSet;
typedef struct {
    int materials;
    int set_count;
    MatcSlotRange slot[MATC_SLOTS]; /* one range per slot, in the order of --list */
    MatcSlotSet sets[MATC_SETS];    /* all different sets of slots, the largest first */
    MatcSlotSet others;             /* union of sets that do not fit into `sets` */
} MatcRanges;
MATC_API void matc_ranges_init(MatcRanges *ranges);
/* Adds a material, whose constants must not be uniforms. Returns false and *fault, from malloc,
 * if it does not compile. */
MATC_API bool matc_ranges_add(MatcRanges *ranges, const MatcDocument *document, int material,
                              const MatcOptions *options, char **fault);
/* Adds the ranges of `other`; the result does not depend on the order. */
MATC_API void matc_ranges_join(MatcRanges *ranges, const MatcRanges *other);
/* Returns the smallest layout for the ranges, in up to eight cases. `error` is the max error of
 * a color's square root, to which other slots are scaled; 0: half a step of 8 bits. Its report
 * also lists omitted slots with the reasons. Never returns NULL; not ok if there are no
 * materials. */
MATC_API MatcLayout *matc_layout_for(const MatcRanges *ranges, double error,
                                     const MatcOptions *options);

/* -- Reference pages and schemas */

/* Return descriptions from matc's tables, from malloc: the JSON Schema of "document" (or NULL),
 * "layout", "manifest" or "reflection" (NULL for other names); the list of all names. */
MATC_API char *matc_schema(const char *of);
MATC_API char *matc_list(void);
/* Returns a part of the list: "maps", "slots", "noise", ...; NULL for others. */
MATC_API char *matc_list_of(const char *kind);
/* Returns the page of a name; NULL if unknown. */
MATC_API char *matc_explain(const char *name);

#ifdef __cplusplus
}
#endif
#endif
