/* A material in a pass, as a batch keeps it after its IR is freed: its program, and its own
 * numbers. */
#ifndef MATC_UNIT_H
#define MATC_UNIT_H
#include "compiler/base/bytes.h"
#include "compiler/ir/key.h"
#include "compiler/matc.h"

/* Data about a written program, in addition to its files. */
typedef struct {
    char *json;   /* members of the manifest's program: constants, tables; "" for none */
    int *members; /* per member of the block: index of the unit's number */
    int member_count;
} Written;

/* Cache keys of a program written for the unit: `members` identifies the constants in the
 * uniform block, `files` is the key of the files. */
typedef struct {
    Key members, files;
} UnitFiles;

enum { UNIT_WORDS = 4, MAX_UNIT_FILES = 4 /* max cached programs, newest first */ };

typedef struct Unit {
    Key key, shape;  /* keys of the program: matc_key and matc_shape */
    int pass;        /* pass of the program: depth for an opaque material's shadow */
    int layout_case; /* layout case that the program writes; -1: none */
    /* number of values that may be in a uniform block: places, or members already */
    int count;
    uint8_t *components; /* components of each value: 1 to 4 floats; plus UNIT_WORDS for words */
    uint32_t *bits;      /* all components in sequence: bits of floats, or plain words */
    int bit_count;
    /* Members of the manifest's JSON: uniforms and textures, each preceded by ", ". */
    char *own;
    UnitFiles *files; /* cached programs; NULL: none */
    int file_count;
    bool changed; /* the cache entry does not list the last of `files` */
    /* data of the written program; NULL: not written for this material */
    Written *written;
    struct Unit *next;               /* next unit of the program, in the order of the inputs */
    int program;                     /* index of the program, set last */
    int document, material, request; /* `request` is the index of the requested pass */
} Unit;

/* Returns the number of the pass whose program it is. */
int unit_pass(const MatcProgram *program);
/* Copies the data that the unit needs after the program is freed. The unit's numbers are those in
 * the program's uniform block if `buffered`, else all that could be there (matc_place()). */
void unit_fill(Unit *unit, MatcProgram *program, bool buffered, const char *textures);
/* Returns data about the written program. `buffered` as in unit_fill(). */
Written *unit_written(MatcProgram *program, bool buffered);
/* Return a number's component count, and whether it consists of words. */
static inline int unit_components(const Unit *unit, int number)
{
    return unit->components[number] > UNIT_WORDS ? unit->components[number] - UNIT_WORDS
                                                 : unit->components[number];
}
static inline bool unit_is_word(const Unit *unit, int number)
{
    return unit->components[number] > UNIT_WORDS;
}
void unit_free(Unit *unit);
void written_free(Written *written);
/* Returns the index in `bits` of each number's first component; from malloc. */
int *unit_offsets(const Unit *unit);

/* Returns the key of its files with these members; NULL: unknown. */
const Key *unit_find_files(const Unit *unit, Key members);
void unit_add_files(Unit *unit, Key members, Key files);

/* Serialize a unit; loading returns false for invalid bytes. */
void unit_store(Bytes *to, const Unit *unit);
bool unit_load(BytesReader *from, Unit *unit);
void written_store(Bytes *to, const Written *written);
Written *written_load(BytesReader *from);
#endif
