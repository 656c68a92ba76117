/* The tables of grammar/ as enums and const arrays, independent of GLSL text and algorithms. */
#ifndef MATC_TABLES_H
#define MATC_TABLES_H
#include <stdbool.h>
#include <stdint.h>

typedef enum {
#define TYPE(name, glsl, components, doc) TYPE_##name,
#include "types.def"
    TYPE_COUNT
} Type;

typedef struct {
    const char *name; /* name in the IR's text and in GLSL */
    int components;   /* number of components */
    const char *doc;
} TypeRow;
extern const TypeRow type_table[TYPE_COUNT];

typedef enum {
#define GROUP(name, type, doc) GROUP_##name,
#include "channels.def"
    GROUP_COUNT
} Group;

/* Returns true for groups that the draw call sets, independent of the queried maps. */
static inline bool group_is_draws(Group group) { return group > GROUP_IOR; }

enum { COMPONENTS_OF_GROUP = 4 }; /* a channel's id is COMPONENTS_OF_GROUP * group + component */

typedef struct {
    const char *name; /* name of the channel for --eval: "px", "u", ... */
    Group group;
    int component;
    const char *doc;
} ChannelRow;
enum {
#define CHANNEL(name, group, component, doc) CHANNEL_ROW_##name,
#include "channels.def"
    CHANNEL_COUNT
};
extern const ChannelRow channel_table[CHANNEL_COUNT];

typedef enum {
#define SLOT(name, type, low, high, absent, doc) SLOT_##name,
#include "slots.def"
    SLOT_COUNT
} Slot;

typedef struct {
    const char *name;
    Type type;
    double low, high; /* range of a valid surface */
    double absent;    /* value for materials without the slot */
    const char *doc;
} SlotRow;
extern const SlotRow slot_table[SLOT_COUNT];
/* Surface models: the values of the slot `model`. */
typedef enum {
#define MODEL(name, doc) MODEL_##name,
#include "slots.def"
    MODEL_COUNT
} Model;
/* Method by which the values of two materials are mixed: slots.def. */
typedef enum { MIXING_LINEAR, MIXING_DIRECTION, MIXING_EXPONENT } Mixing;
Mixing slot_mixing(Slot slot);
/* Returns the slot that weights each side; SLOT_COUNT: none. */
Slot slot_weight(Slot slot);

/* Kinds of nodes with parameters: materials first, then maps. */
typedef enum {
#define MATERIAL(name, sort, doc)                KIND_##name,
#define MAP(name, function, lowering, cost, doc) KIND_##name,
#include "materials.def"
#include "maps.def"
    KIND_COUNT
} Kind;

typedef enum {
    PARAM_Map,       /* a ChannelMap */
    PARAM_Material,  /* a material */
    PARAM_Float,     /* a number, or a uniform */
    PARAM_Int,       /* an integer, or a uniform */
    PARAM_Bool,      /* true or false */
    PARAM_Vec3,      /* three numbers, or a uniform */
    PARAM_Wave,      /* a waveform */
    PARAM_Transform, /* a transform of space */
    PARAM_Image,     /* an image file */
    PARAM_Maps,      /* maps by name */
    PARAM_Formula,   /* a formula; compiler/formula/ */
    PARAM_List,      /* a list of maps */
    PARAM_Items,     /* a list of blend items */
/* A keyword of a list of words.def. */
#define WORDS(list) PARAM_##list,
#include "words.def"
    PARAM_KIND_COUNT
} ParamKind;

/* Keywords of parameters. A parameter's number is its Word. */
typedef enum {
#define WORD(list, name, doc) KEYWORD_##list##_##name,
#include "words.def"
    WORD_COUNT
} Keyword;
typedef struct {
    ParamKind list;
    const char *name, *doc;
} WordRow;
extern const WordRow keyword_table[WORD_COUNT];
/* Returns the keyword of the list that false or true is equivalent to; -1: none. */
int word_of_truth(ParamKind list, bool yes);

typedef struct {
    Kind kind; /* the kind that has the parameter */
    const char *name;
    ParamKind type;
    int components; /* number of components of the default; 0: no default */
    double init[3]; /* value of the default */
    double low, high;
    const char *doc;
} ParamRow;

/* Index over all parameters; P_Checker_color1 is that of Checker's color1. */
enum {
#define PARAM(kind, name, type, init, range, doc) P_##kind##_##name,
#include "materials.def"
#include "maps.def"
    PARAM_COUNT
};
extern const ParamRow param_table[PARAM_COUNT];
/* param_is_colored: the color of the map or material depends on the color of this parameter's
 * map. */
/* param_is_number: only the red component of the map is read */
bool param_is_colored(int param), param_is_number(int param);
/* Returns true if no slot stores this parameter: UNSTORED lines of materials.def. */
bool param_is_unstored(int param);
/* Returns how the parameter is modified if the parameter *weight is not 0: TILED lines; NULL:
 * not at all. */
const char *param_dropped(int param, int *weight);
static inline bool param_is_word(const ParamRow *row) { return row->type > PARAM_Items; }

typedef enum { LOWERING_MATERIAL, LOWERING_OWN, LOWERING_VOLUME } Lowering;

/* Filtering of a volume map by --aa; and the replacement of its samples in a pixel with many
 * cells. */
typedef enum { FILTER_samples, FILTER_point, FILTER_box, FILTER_octaves } FilterKind;
typedef enum { FAR_unknown, FAR_number, FAR_point } Far;

/* Coordinates that a transform map changes. */
typedef enum { MOVES_xyz = 1, MOVES_uv = 2, MOVES_both = MOVES_xyz | MOVES_uv } Moved;

typedef struct {
    const char *name;
    const char *function; /* name of the map's GLSL function, or stem of its temporaries */
    Lowering lowering;
    int cost;
    int first, count; /* range of the kind's rows in param_table */
    const char *doc;
    const char *answers; /* channels or slots that the kind provides, and the treatment of others */
    const char *formula; /* the computation, as lines of plain text */
    const char *example; /* an example document; NULL: the map with its defaults */
    FilterKind filter;
    int mean, variance, far; /* Functions of the filter, or FN_none; for samples a Far */
    unsigned moves;          /* Moved: coordinates that differ from its input's */
    double step;             /* step of the map's finite difference; 0: a texel */
    /* Number of coordinate components of the difference; 0: neither discontinuous nor an image. */
    int step_components;
} KindRow;
extern const KindRow kind_table[KIND_COUNT];

/* Headings of the list: each precedes the kinds from `first` up to the next heading's. */
typedef enum {
#define SECTION(name, title) SECTION_##name,
#include "materials.def"
#include "maps.def"
    SECTION_COUNT
} Section;
typedef struct {
    const char *title;
    int first; /* first Kind below the heading */
} SectionRow;
extern const SectionRow section_table[SECTION_COUNT];
Section section_of(Kind kind);

typedef struct {
    const char *alias;
    Kind kind;
} AliasRow;
extern const AliasRow alias_table[];
extern const int alias_count;

typedef struct {
    const char *name;
    Kind kind;
    int param; /* index in param_table */
    double init;
    const char *doc;
} PresetRow;
extern const PresetRow preset_table[];
extern const int preset_count;

typedef enum {
#define WAVE(name, reference, build, doc) WAVE_##name,
#include "waves.def"
    WAVE_COUNT,
    WAVE_Chain = WAVE_COUNT /* a Chain has parameters, so waves.def has no row for it */
} WaveKind;
typedef struct {
    const char *name;
    const char *doc;
} WaveRow;
extern const WaveRow wave_table[WAVE_COUNT];

/* Library functions: those of functions.def, then one for each map with the lowering VOLUME. */
typedef enum {
#define FUNCTION(name, result, arguments, range, cost, doc) FN_##name,
#include "functions.def"
    FN_FIRST_MAP
} Function;
/* A volume map's function is FN_FIRST_MAP + its Kind; not every value is in use. */
enum { FUNCTION_COUNT = FN_FIRST_MAP + KIND_COUNT, FN_none = FUNCTION_COUNT };

typedef struct {
    const char *name; /* name of the function; NULL: a map without a function */
    Type result;
    int cost;
    const char *doc;
} FunctionRow;
extern const FunctionRow function_table[]; /* has FUNCTION_COUNT rows */
static inline const FunctionRow *function_row(int function) { return &function_table[function]; }
/* Returns a letter for each argument: f i 2 3 4 s. */
const char *function_arguments(int function);

/* Method of differentiating a function. */
typedef enum {
    SLOPE_difference,
    SLOPE_flat,
    SLOPE_gradient,
    SLOPE_along,
    SLOPE_factor,
    SLOPE_limited,
    SLOPE_power
} SlopeKind;
typedef struct {
    SlopeKind kind;
    int argument;          /* index of the argument of differentiation */
    int by;                /* function that yields the derivative */
    const char *arguments; /* arguments of `by`, encoded as in slopes.def */
} SlopeRow;
const SlopeRow *slope_row(int function);

typedef enum {
#define INPUT(name, type, source, glsl, doc) INPUT_##name,
#include "inputs.def"
    INPUT_COUNT
} Input;
typedef enum {
    SOURCE_varying,
    SOURCE_system,
    SOURCE_draw,
    SOURCE_change,
    SOURCE_vertex,
    SOURCE_object
} InputSource;
typedef struct {
    const char *name;
    Type type;
    InputSource source;
    const char *glsl;
    const char *doc;
} InputRow;
extern const InputRow input_table[INPUT_COUNT];
/* An input that is the screen-space derivative of another. */
typedef struct {
    Input input, of;
    const char *by; /* name of the GLSL function: "dFdx" or "dFdy" */
} ChangeRow;
extern const ChangeRow change_table[];
extern const int change_count;

typedef struct {
    const char *name;
    unsigned char rgb[3];
} ColorRow;
extern const ColorRow color_table[];
extern const int color_count;

typedef enum {
#define TARGET(name, ...) TARGET_##name,
#include "targets.def"
    TARGET_COUNT,
    TARGET_DEFAULT = TARGET_glsl330
} Target;
typedef struct {
    const char *name, *doc;
    const char *version;   /* text of the #version line */
    const char *enables;   /* extension that the target enables; NULL: none */
    const char *precision; /* precision of floats, integers and samplers; NULL: default */
    const char *index;     /* built-in vertex index; NULL: none */
    const char *library;   /* suffix of the library files that only this target uses; NULL: none */
    int number;            /* number of the GLSL version */
    int layout;            /* default layout, a Layout */
    bool in_out, blocks, locations, words, spirv, srgb_textures, word_textures, borders,
        /* see the columns of targets.def */
        float_filters, storage, tessellation, geometry, compute;
} TargetRow;
extern const TargetRow target_table[TARGET_COUNT];

typedef enum {
#define PASS(name, doc) PASS_##name,
#include "passes.def"
    PASS_COUNT
} Pass;
typedef struct {
    const char *name, *doc;
} PassRow;
extern const PassRow pass_table[PASS_COUNT];

typedef enum {
#define NORMALS(name, doc) NORMALS_##name,
#include "normals.def"
    NORMALS_COUNT
} Normals;
typedef struct {
    const char *name, *doc;
} NormalsRow;
extern const NormalsRow normals_table[NORMALS_COUNT];

typedef enum {
#define TEXELS(name, components, bits, doc) TEXELS_##name,
#include "textures.def"
    TEXELS_COUNT
} Texels;
typedef struct {
    const char *name;
    int components, bits; /* bits of a component */
    const char *doc;
} TexelsRow;
extern const TexelsRow texels_table[TEXELS_COUNT];

/* Variants of a program: an axis has choices, numbered over all axes. */
typedef enum {
#define AXIS(name, chunks, doc) AXIS_##name,
#include "variants.def"
    AXIS_COUNT
} Axis;
typedef enum {
#define CHOICE(axis, name, doc) CHOICE_##axis##_##name,
#include "variants.def"
    CHOICE_COUNT
} Choice;
typedef enum {
#define PRECISION(name, noise, coordinates, powers, trigonometry, doc) PRECISION_##name,
#include "variants.def"
    PRECISION_COUNT
} Precision;
typedef struct {
    const char *name;
    bool chunks; /* library files exist in variants of its choices */
    int first;   /* index in choice_table: the default, followed by the other choices */
    const char *doc;
} AxisRow;
typedef struct {
    Axis axis;
    const char *name, *doc;
} ChoiceRow;
typedef struct {
    const char *name, *doc;
    int choice[AXIS_COUNT]; /* choice of each axis; -1: the row does not set the axis */
} PrecisionRow;
extern const AxisRow axis_table[AXIS_COUNT];
int axis_choices(Axis axis);
extern const ChoiceRow choice_table[CHOICE_COUNT];
extern const PrecisionRow precision_table[PRECISION_COUNT];

/* Rows of files.def, in its order. */
typedef enum { FILE_ROW_file, FILE_ROW_object, FILE_ROW_member } FileRowKind;
typedef enum {
    MEMBER_text,
    MEMBER_name,
    MEMBER_key,
    MEMBER_whole,
    MEMBER_number,
    MEMBER_yes,
    MEMBER_flag,
    MEMBER_choice,
    MEMBER_object,
    MEMBER_texts,
    MEMBER_names,
    MEMBER_numbers,
    MEMBER_choiceList,
    MEMBER_objects,
    MEMBER_rows,
    MEMBER_textsByName,
    MEMBER_numbersByName,
    MEMBER_choices,
    MEMBER_identifier,
    MEMBER_label,
    MEMBER_encoding,
    MEMBER_pair,
    MEMBER_slotComponents,
    MEMBER_slotConstants
} MemberType;
typedef struct {
    FileRowKind kind;
    const char *name;
    bool must;
    MemberType type;
    const char *of, *doc;
} FileRow;
extern const FileRow file_table[];
extern const int file_row_count;
#endif
