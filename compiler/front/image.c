/* Pictures that documents name: PNG, JPEG or OpenEXR, told by their first bytes. The numbers are the file's: gamma, profiles and all else
 * that says how they are to be shown is passed over. */
#include "compiler/front/image_file.h"
#include <stdlib.h>
#include <string.h>

static const char *decode(ImageFile *file)
{
    static const struct {
        const char *begin;
        size_t size;
        const char *(*read)(ImageFile *);
    } formats[] = {{"\x89PNG", 4, image_png}, {"\xFF\xD8", 2, image_jpeg}, {"\x76\x2F\x31\x01", 4, image_exr}};
    const size_t size = (size_t)(file->end - file->at);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (size >= formats[i].size && !memcmp(file->at, formats[i].begin, formats[i].size))
            return formats[i].read(file);
    return "it is neither PNG nor JPEG nor OpenEXR";
}

/* Bytes that the document's pictures take, all decoded. */
static size_t bytes_of_all(const Resolver *r)
{
    size_t bytes = 0;
    for (size_t i = 0; i < r->image_count; i++)
        bytes += image_file_size(r->images[i]);
    return bytes;
}

const Image *image_load(Resolver *r, const char *path, Span span)
{
    Session *session = r->session;
    const char *full = session_path_beside(session, session->sources[span.file].name, path), *why = "";
    int found = names_find(&r->image_paths, full);
    if (found >= 0)
        return r->images[found];
    size_t size;
    session_depend_on(session, full);
    char *file = session_read_file(session, full, &size, &why);
    if (!file)
        return diag_add(session, span, DIAG_no_image, path, why);
    Image *image = ARENA_NEW(session->arena, Image);
    image->path = full;
    image->index = (int)r->image_count;
    ImageFile picture = {.session = session, .at = file, .end = file + size, .image = image};
    const size_t taken = bytes_of_all(r), most = (size_t)LIMIT_PIXELS_MIB << 20;
    picture.room = taken < most ? most - taken : 0;
    why = decode(&picture);
    free(file);
    if (why)
        return diag_add(session, span, DIAG_no_image, path, why);
    const Image *kept = image;
    ARENA_PUSH(session->arena, r->images, r->image_count, r->image_room, kept);
    names_add(session->arena, &r->image_paths, full);
    return image;
}
