/* A material in a pass, as a batch remembers it once its IR is gone: which program it is, and the
 * numbers that are its own. */
#ifndef MATC_UNIT_H
#define MATC_UNIT_H
#include "compiler/base/bytes.h"
#include "compiler/ir/key.h"
#include "compiler/matc.h"

/* Results of writing a program, beside its files. */
typedef struct {
    char *json;   /* members of the manifest's program: constants, tables; "" for none */
    int *members; /* for each number of the block, in its order: which of the unit's it is */
    int member_count;
} Written;

/* Where the cache has the files of a program that was written for the unit: by the members that it
 * was written with. */
typedef struct {
    Key members, files;
} UnitFiles;

enum { UNIT_WORDS = 4, MOST_UNIT_FILES = 4 /* the newest first */ };

typedef struct Unit {
    Key key, shape;  /* of the program: matc_key and matc_shape */
    int pass;        /* of the program: that of an opaque material's shadow is depth */
    int layout_case; /* of the layout, that it writes; -1: it writes none */
    int count;       /* numbers that may come from a buffer: places, or members already */
    uint8_t *lanes;  /* of each: 1 to 4 of floats; UNIT_WORDS more for words */
    uint32_t *bits;  /* all lanes, one after the other: of floats, or words */
    int bit_count;
    /* members of the manifest's JSON: uniforms and textures, each with ", " before it */
    char *own;
    UnitFiles *files; /* NULL: none */
    int file_count;
    bool changed;                    /* the cache does not know the last of them */
    Written *written;                /* NULL: its program was not written for this material */
    struct Unit *next;               /* of the same program, in the order of the inputs */
    int program;                     /* index, in the end */
    int document, material, request; /* the request is which of the passes asked for */
} Unit;

/* The pass whose program it is, by number. */
int unit_pass(const MatcProgram *program);
/* Takes from a program what outlives it. Buffered: the numbers are the members of its buffer; else
 * its places. */
void unit_fill(Unit *unit, MatcProgram *program, bool buffered, const char *textures);
/* Results of writing the program. Buffered as above. */
Written *unit_written(MatcProgram *program, bool buffered);
/* Lanes of a number, and whether they are words. */
static inline int unit_lanes(const Unit *unit, int number)
{
    return unit->lanes[number] > UNIT_WORDS ? unit->lanes[number] - UNIT_WORDS
                                            : unit->lanes[number];
}
static inline bool unit_is_word(const Unit *unit, int number)
{
    return unit->lanes[number] > UNIT_WORDS;
}
void unit_free(Unit *unit);
void written_free(Written *written);
/* The first lane of each number, in `bits`; from malloc. */
int *unit_offsets(const Unit *unit);

/* The key of its files with these members; NULL: none is known. */
const Key *unit_find_files(const Unit *unit, Key members);
void unit_add_files(Unit *unit, Key members, Key files);

/* As bytes and back; false: they are none. */
void unit_store(Bytes *to, const Unit *unit);
bool unit_load(BytesReader *from, Unit *unit);
void written_store(Bytes *to, const Written *written);
Written *written_load(BytesReader *from);
#endif
