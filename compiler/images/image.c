/* Images that documents name, as files or parts of glTF files: PNG, JPEG, OpenEXR or BMP,
 * detected by their first bytes. Stored numbers are used unchanged: gamma, color profiles and
 * other display metadata are ignored. */
#include "compiler/hints/hint.h"
#include "compiler/images/image.h"
#include "compiler/images/image_file.h"
#include <stdlib.h>
#include <string.h>

/* Unsupported formats, by their first bytes, with advice. GIF has 256 colors and may be
 * animated, and its decoder would be another library in every host program. */
static const char *refusal(const char *at, size_t size)
{
    static const struct {
        const char *begin;
        size_t size;
        const char *why;
    } others[] = {{"GIF8", 4, "GIF is not supported; save it as PNG"},
                  {"RIFF", 4, "WebP is not supported; save it as PNG"},
                  {"II*", 3, "TIFF is not supported; save it as PNG or OpenEXR"},
                  {"MM\0", 3, "TIFF is not supported; save it as PNG or OpenEXR"},
                  {"#?", 2, "Radiance HDR is not supported; save it as OpenEXR"},
                  {"DDS ", 4, "DDS is not supported; save it as PNG"},
                  {"8BPS", 4, "PSD is not supported; save it as PNG"},
                  {"\xABKTX", 4, "KTX is not supported; save it as PNG"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (size >= others[i].size && !memcmp(at, others[i].begin, others[i].size))
            return others[i].why;
    return "the format is not PNG, JPEG, OpenEXR or BMP";
}

static const char *decode(ImageFile *file)
{
    static const struct {
        const char *begin;
        size_t size;
        const char *(*read)(ImageFile *);
    } formats[] = {{"\x89PNG", 4, image_png},
                   {"\xFF\xD8", 2, image_jpeg},
                   {"\x76\x2F\x31\x01", 4, image_exr},
                   {"BM", 2, image_bmp}};
    const size_t size = (size_t)(file->end - file->at);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (size >= formats[i].size && !memcmp(file->at, formats[i].begin, formats[i].size))
            return formats[i].read(file);
    return refusal(file->at, size);
}

/* Finds the bytes of an image; *file is to be freed, or NULL. Returns false and *why on failure. */
static bool find_bytes(Resolver *r, const char *path, ImageFile *picture, char **file,
                       const char **why)
{
    GltfBytes bytes = {0};
    *file = NULL;
    if (gltf_file_has(path)) {
        if (!gltf_file_picture(r->session, &r->gltf_files, path, &bytes, why))
            return false;
    } else {
        session_depend_on(r->session, path);
        bytes.at = *file = session_read_file(r->session, path, &bytes.size, why);
        if (!*file)
            return false;
    }
    picture->at = bytes.at, picture->end = bytes.at + bytes.size;
    return true;
}

static const Image *read_picture(Resolver *r, const char *full, const char **why)
{
    ImageFile picture = {.session = r->session};
    char *file;
    if (!find_bytes(r, full, &picture, &file, why))
        return NULL;
    Image *image = ARENA_NEW(r->session->arena, Image);
    image->path = full;
    image->index = (int)r->image_count;
    const size_t most = (size_t)LIMIT_PIXELS_MIB << 20;
    picture.image = image;
    picture.capacity = r->image_bytes < most ? most - r->image_bytes : 0;
    *why = decode(&picture);
    free(file);
    if (*why) {
        arena_free(&picture.memory);
        return NULL;
    }
    r->image_bytes += image_file_size(image);
    arena_adopt(r->session->arena, &picture.memory);
    return image;
}

/* An unreadable image is tried only once. */
const Image *image_load(Resolver *r, const char *path, Span span)
{
    Session *session = r->session;
    const char *full = session_path_beside(session, session->sources[span.file].name, path),
               *why = "";
    const int found = names_find(&r->image_paths, full),
              broken = found < 0 ? names_find(&r->broken_paths, full) : -1;
    if (found >= 0)
        return r->images[found];
    const Image *image = broken < 0 ? read_picture(r, full, &why) : NULL;
    if (image) {
        ARENA_PUSH(session->arena, r->images, r->image_count, r->image_capacity, image);
        names_add(session->arena, &r->image_paths, full);
        return image;
    }
    if (broken < 0) {
        size_t count = r->broken_paths.count;
        ARENA_PUSH(session->arena, r->broken, count, r->broken_capacity, why);
        names_add(session->arena, &r->broken_paths, full);
    }
    if (hint_backslash(session, span))
        return NULL;
    return diag_add(session, span, DIAG_no_image, path, broken < 0 ? why : r->broken[broken]);
}
