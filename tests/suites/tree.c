/* Reads the named files, and prints a line of JSON for each: the faults, and the value with all
 * that a Tree stores about it, {"faults": ["duplicate_key"], "tree": {"object": [["a", {"plain":
 * "1"}], ["a", [{"text": "1"}]]]}}; a refused file has "tree": null. */
#include "compiler/base/file.h"
#include "compiler/base/json_write.h"
#include "tests/read_text.h"
#include <stdio.h>
#include <stdlib.h>

static void put_value(Text *out, const Tree *tree)
{
    if (tree->kind == TREE_scalar) {
        text_put(out, tree->plain ? "{\"plain\": " : "{\"text\": ");
        json_bytes(out, tree->text, tree->count);
        text_put(out, "}");
        return;
    }
    const bool list = tree->kind == TREE_list;
    text_put(out, list ? "[" : "{\"object\": [");
    for (uint32_t i = 0; i < tree->count; i++) {
        text_put(out, i ? ", " : "");
        if (!list) {
            text_put(out, "[");
            json_bytes(out, tree->members[i].key, tree->members[i].size);
            text_put(out, ", ");
        }
        put_value(out, list ? tree->items[i] : tree->members[i].value);
        text_put(out, list ? "" : "]");
    }
    text_put(out, list ? "]" : "]}");
}

static bool put_file(const char *path)
{
    ReadText r;
    size_t size;
    const char *why;
    char *text = file_read(path, &size, &why);
    if (!text) {
        fprintf(stderr, "%s: %s\n", path, why);
        return false;
    }
    read_text(&r, path, text, size);
    Text out = text_new(&r.arena);
    text_put(&out, "{\"faults\": [");
    for (size_t i = 0; i < r.session.diags.count; i++)
        text_format(&out, "%s\"%s\"", i ? ", " : "", diag_table[r.session.diags.at[i].kind].name);
    text_put(&out, "], \"tree\": ");
    if (r.tree)
        put_value(&out, r.tree);
    text_put(&out, r.tree ? "}" : "null}");
    puts(out.at);
    read_text_done(&r);
    free(text);
    return true;
}

int main(int argc, char **argv)
{
    bool fine = true;
    for (int i = 1; i < argc; i++)
        fine &= put_file(argv[i]);
    return !fine;
}
