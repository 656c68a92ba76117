/* Writes depfiles, `target: files...`. make parses it as part of a makefile, in which a name
 * such as `a;touch b` would be a command; ninja has its own parser. Both read letters, digits,
 * bytes outside ASCII and `others` literally, provided ` `, `#` and `:` are preceded by a
 * backslash and `$` is doubled: `a b#1$.yaml` is `a\ b\#1$$.yaml`. No other character has a form
 * that both accept: ninja reads `\;` as two characters, and a bare `;` ends the name.
 * tests/tool/depfile.sh tests every character with both programs. */
#include "compiler/tool/depfile.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char others[] = "!#$%()+,-./:=@\\]_{}~ ";

const char depfile_why[] = "make and ninja cannot both read this name in a depfile";

static bool is_readable_byte(char c)
{
    return c & 0x80 || text_is_alphanumeric(c) || (c && strchr(others, c));
}

/* Skips leading `./`, which make ignores. */
static const char *without_here(const char *name)
{
    while (name[0] == '.' && name[1] == '/')
        name += 2 + strspn(name + 2, "/");
    return name;
}

/* Returns true if both programs read the escaped name correctly. */
static bool is_readable(const char *name)
{
    size_t size = strlen(name);
    for (size_t i = 0; i < size; i++)
        if (!is_readable_byte(name[i]) ||
            (name[i] == '\\' && name[i + 1] && strchr("#$:=", name[i + 1])))
            return false;
    if (!size || strchr(" :\\", name[size - 1]))
        return false;
    bool home = *without_here(name) == '~', of_archive = name[size - 1] == ')' && strchr(name, '(');
    return !home && !of_archive;
}

/* Returns true for a valid target name: `a=b` at the start of a line is a variable, `a%b` a
 * pattern, `.PHONY` a special target. */
static bool can_be_target(const char *name)
{
    const char *start = without_here(name);
    return is_readable(name) && !strpbrk(name, "=%") &&
           !(start[0] == '.' && text_is_upper(start[1]));
}

/* Returns true for a valid dependency name: `out: a=b` and `out: a =b` would set a variable. */
static bool can_be_file(const char *name)
{
    return is_readable(name) && name[strspn(name, "!+")] != '=';
}

static bool can_be_first(const char *name) { return !strchr(name, '='); }

/* Returns true if the name might be a keyword of make, such as `define`. */
static bool is_word(const char *name)
{
    while (text_is_lower(*name))
        name++;
    return !*name;
}

/* Writes an escaped name. Both programs read N backslashes before a space as N/2, so the name's
 * own are doubled. */
static void put_escaped(FILE *out, const char *name)
{
    size_t backslashes = 0;
    for (; *name; name++) {
        if (*name == ' ')
            for (size_t i = 0; i < backslashes; i++)
                fputc('\\', out);
        if (strchr(" #:", *name))
            fputc('\\', out);
        if (*name == '$')
            fputc('$', out);
        fputc(*name, out);
        backslashes = *name == '\\' ? backslashes + 1 : 0;
    }
}

static void put_file(FILE *out, const char *name, bool first)
{
    fputs(first ? " " : " \\\n  ", out);
    fputs(first && is_word(name) ? "./" : "", out);
    put_escaped(out, name);
}

/* Returns the index of a file that can be listed first; -1 if a name is not representable, which
 * *bad reports. */
static int check(const char *target, const char *const *files, int count, const char **bad)
{
    int first = 0;
    *bad = can_be_target(target) ? NULL : target;
    for (int i = 0; i < count && !*bad; i++)
        if (!can_be_file(files[i]))
            *bad = files[i];
    while (first < count && !can_be_first(files[first]))
        first++;
    if (count && first == count && !*bad)
        *bad = files[0];
    return *bad ? -1 : first;
}

char *depfile_text(const char *target, const char *const *files, int count, const char **bad)
{
    char *text = NULL;
    size_t size;
    int first = check(target, files, count, bad);
    FILE *out = first < 0 ? NULL : open_memstream(&text, &size);
    if (!out && first >= 0)
        memory_exhausted();
    if (!out)
        return NULL;
    put_escaped(out, target);
    fputc(':', out);
    if (count)
        put_file(out, files[first], true);
    for (int i = 0; i < count; i++)
        if (i != first)
            put_file(out, files[i], false);
    fputc('\n', out);
    if (fclose(out))
        memory_exhausted();
    return text;
}
