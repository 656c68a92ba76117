/* The definition files shipped with matc, grammar/library/, which `include:` searches last. */
#ifndef MATC_LIBRARY_TABLE_H
#define MATC_LIBRARY_TABLE_H

typedef struct {
    const char *name; /* name of the file, such as "bricks.yaml" */
    const char *text;
} LibraryFile;
extern const LibraryFile library_table[];
extern const int library_count;

/* A definition in one of these files. */
typedef struct {
    /* name, file and description, such as "bricks", "bricks.yaml", and a sentence about the
     * definition */
    const char *name, *file, *doc;
} LibraryName;
extern const LibraryName library_names[];
extern const int library_name_count;
#endif
