/* manifest.json as matc writes it: programs, and what each material gives to its program. */
#ifndef ENGINE_MANIFEST_H
#define ENGINE_MANIFEST_H

enum { MAX_TEXTURES = 8, MAX_UNIFORMS = 8, MAX_TARGETS = 8 };

/* What a program's reflection says of a picture and its sampler. */
typedef struct {
    int mipmaps, srgb, anisotropy;
    const char *wrap; /* "repeat", "mirrored_repeat", "clamp_to_edge", "clamp_to_border" */
} Sampling;

typedef struct {
    const char *name;
    const char *file; /* of a picture */
    Sampling sampling;
    int components; /* of a uniform */
    float numbers[4];
} Setting;

typedef struct {
    char *vertex, *fragment; /* GLSL */
    const char *file;        /* the fragment's, for messages */
    int block_bytes;         /* of its uniform block `Constants`; 0: it has none */
    const void *textures;    /* JSON of its reflection */
} Program;

typedef struct {
    const char *name;
    int program;
    unsigned char *block; /* std140, block_bytes of its program; NULL */
    int texture_count, uniform_count;
    Setting textures[MAX_TEXTURES], uniforms[MAX_UNIFORMS];
} Material;

typedef struct {
    const char *layout;
    int bytes; /* a pixel, of the G-buffer */
    int target_count;
    const char *targets[MAX_TARGETS]; /* "RGBA32UI", ... */
    char *unpack;                     /* GLSL that reads them */
    int program_count, material_count;
    Program *programs;
    Material *materials;
} Manifest;

/* Reads the programs of the pass gbuffer and all files that they name; fails with a message. Kept
 * until the engine ends. */
Manifest manifest_read(const char *path);
char *read_text(const char *path); /* a whole file, zero-terminated */
#endif
