/* Finds included files: in the folder of the including file, then in the -I folders, then among
 * the library files shipped with matc. The first match is used. */
#include "compiler/hints/hint.h"
#include "compiler/resolve/include.h"
#include "compiler/read/read.h"
#include "grammar/library_table.h"
#include <stdlib.h>
#include <string.h>

/* Prefix of the paths of shipped files. No other path has it (session_path_beside). */
static const char SHIPPED[] = "<matc>/";
enum { SHIPPED_SIZE = sizeof SHIPPED - 1 };

static bool is_shipped(const char *path) { return !strncmp(path, SHIPPED, SHIPPED_SIZE); }

static const LibraryFile *shipped(const char *name)
{
    for (int i = 0; i < library_count; i++)
        if (!strcmp(library_table[i].name, name))
            return &library_table[i];
    return NULL;
}

static bool is_read(const Session *session, const char *path)
{
    for (size_t i = 0; i < session->source_count; i++)
        if (!strcmp(session->sources[i].name, path))
            return true;
    return false;
}

/* Returns true if the include has a valid name and does not exceed the nesting limit. */
static bool may_include(Session *session, const Tree *name, int depth)
{
    if (name->kind != TREE_scalar)
        diag_add(session, name->span, DIAG_wrong_type, "include", "a file name or a list of them",
                 tree_describe(session, name));
    else if (depth >= LIMIT_INCLUDE_DEPTH)
        diag_add(session, name->span, DIAG_include_depth, LIMIT_INCLUDE_DEPTH);
    return name->kind == TREE_scalar && depth < LIMIT_INCLUDE_DEPTH;
}

/* Result of a search: nothing yet (`why` has the reason), a file that was read before, or its
 * text. */
typedef struct {
    const char *path, *text, *why;
    size_t size;
    bool before;
} Found;

static bool look_shipped(Session *session, const char *name, Found *found)
{
    const LibraryFile *file = shipped(name);
    if (!file)
        return false;
    Text path = text_new(session->arena);
    text_format(&path, "%s%s", SHIPPED, name);
    *found = (Found){.path = path.at, .text = file->text, .size = strlen(file->text)};
    found->before = is_read(session, path.at);
    return true;
}

static bool look_at(Session *session, const char *path, Found *found)
{
    *found = (Found){.path = path, .why = "", .before = is_read(session, path)};
    if (found->before)
        return true;
    char *text = session_read_file(session, path, &found->size, &found->why);
    if (!text)
        return false;
    found->text = arena_string(session->arena, text, found->size);
    free(text);
    return true;
}

/* Searches the -I folders. */
static bool look_in_folders(Session *session, const char *name, Found *found)
{
    const MatcOptions *options = session->options;
    for (int i = 0; name[0] != '/' && i < options->include_count; i++) {
        Text from = text_new(session->arena);
        text_format(&from, "%s/", options->include[i]);
        if (look_at(session, session_path_beside(session, from.at, name), found))
            return true;
    }
    return false;
}

/* Finds an included file. Shipped files include only shipped files. A file that includes its own
 * name means another file: a document bricks.yaml may include matc's bricks.yaml. */
static bool find(Session *session, const char *from, const char *name, Found *found)
{
    if (is_shipped(from))
        return look_shipped(session, name, found);
    Found beside;
    const bool there = look_at(session, session_path_beside(session, from, name), &beside);
    *found = beside;
    if (there && strcmp(beside.path, from) != 0)
        return true;
    if (look_in_folders(session, name, found) || look_shipped(session, name, found))
        return true;
    *found = beside;
    return there;
}

static const char *shipped_file(const void *user, int i)
{
    (void)user;
    return library_table[i].name;
}

/* Appends the default extension: "bricks" -> "bricks.yaml". */
static const char *with_ending(Session *session, const char *name)
{
    Text text = text_new(session->arena);
    text_format(&text, "%s%s", name, strrchr(name, '.') ? "" : ".yaml");
    return text.at;
}

static void report_missing(Session *session, const Tree *name, const Found *found)
{
    const char *file = with_ending(session, name->text);
    const LibraryName *defined = hint_library_name(name->text);
    Text hint = text_new(session->arena);
    text_put(&hint, "");
    if (shipped(file))
        text_format(&hint, "; did you mean the file '%s'?", file);
    else if (defined)
        text_format(&hint, "; '%s' is in '%s'", name->text, defined->file);
    else
        text_put(&hint, diag_suggest(session, file, shipped_file, NULL, library_count));
    session_depend_on(session, found->path);
    if (!hint_backslash(session, name->span))
        diag_add(session, name->span, DIAG_cannot_include, name->text, found->why, hint.at);
}

/* Returns true if a text contains a top-level key of a document. Any other file, such as a password
 * file, is rejected before parsing, so that no message quotes it. */
static bool looks_like_document(const Found *found)
{
    static const char *const keys[] = {"defs", "include", "colors", "material", "materials", "ref"};
    static const char before[] = "\n \t{,\"'";
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        for (const char *at = found->text; (at = strstr(at, keys[i])); at++) {
            const char *end = at + strlen(keys[i]);
            end += *end == '"' || *end == '\'';
            if ((at == found->text || strchr(before, at[-1])) && end[strspn(end, " ")] == ':')
                return true;
        }
    return false;
}

Tree *include_read(Session *session, const Tree *name, int depth, bool *fine)
{
    Found found = {.path = ""};
    *fine = false;
    if (!may_include(session, name, depth))
        return NULL;
    const bool there = find(session, session->sources[name->span.file].name, name->text, &found);
    *fine = there && found.before;
    if (*fine)
        return NULL;
    if (session->depends.count > LIMIT_INCLUDES)
        return diag_add(session, name->span, DIAG_too_many_includes, LIMIT_INCLUDES);
    if (!there) {
        report_missing(session, name, &found);
        return NULL;
    }
    if (!is_shipped(found.path))
        session_depend_on(session, found.path);
    if (!looks_like_document(&found))
        return diag_add(session, name->span, DIAG_include_no_document, name->text);
    const Source source = {.name = found.path, .text = found.text, .size = found.size};
    ARENA_PUSH(session->arena, session->sources, session->source_count, session->source_capacity,
               source);
    Tree *tree = read_document(session, (uint32_t)session->source_count - 1);
    if (tree && tree->kind != TREE_object)
        return diag_add(session, tree->span, DIAG_include_not_object);
    *fine = tree != NULL;
    return tree;
}
