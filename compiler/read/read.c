/* Text -> Tree: checks the encoding, then selects the reader by the file's name. */
#include "compiler/read/gltf_chunks.h"
#include "compiler/read/read.h"
#include <string.h>

static bool ends_in(const char *name, const char *ending)
{
    const size_t size = strlen(name), end = strlen(ending);
    return size > end && !strcmp(name + size - end, ending);
}

static bool check_utf8(const TreeBuilder *b, const Source *source)
{
    const unsigned char *text = (const unsigned char *)source->text, *end = text + source->size;
    for (const unsigned char *at = text + b->start; at < end;) {
        /* nearly all characters are ASCII */
        const int length = *at < 0x80 ? 1 : text_utf8_length(at, end);
        if (!length) {
            uint32_t offset = (uint32_t)(at - text);
            diag_add(b->session, (Span){offset, offset + 1, b->file}, DIAG_bad_utf8);
            return false;
        }
        at += length;
    }
    return true;
}

typedef Tree *Read(TreeBuilder *b);

static Tree *read_by(Session *session, uint32_t file, Read *read)
{
    const Source *source = &session->sources[file];
    TreeBuilder builder = {.session = session, .file = file};
    if (source->size >= 3 && !memcmp(source->text, "\xEF\xBB\xBF", 3))
        builder.start = 3;
    if (!check_utf8(&builder, source))
        return NULL;
    Tree *tree = read(&builder);
    tree_build_done(&builder);
    if (tree && builder.zero.end)
        diag_add(session, builder.zero, DIAG_zero_byte);
    return tree;
}

Tree *read_json_of(Session *session, uint32_t file) { return read_by(session, file, read_json); }

Tree *read_document(Session *session, uint32_t file)
{
    const char *name = session->sources[file].name;
    if (session->sources[file].size > (size_t)LIMIT_DOCUMENT_MIB << 20)
        return diag_add(session, (Span){0, 0, file}, DIAG_too_large, LIMIT_DOCUMENT_MIB);
    if (!gltf_chunks_open(session, file))
        return NULL;
    return read_by(session, file,
                   ends_in(name, ".gltf") || ends_in(name, ".glb") ? read_gltf
                   : ends_in(name, ".json")                        ? read_json
                                                                   : read_yaml);
}
