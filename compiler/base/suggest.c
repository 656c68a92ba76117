/* Spelling suggestions: the nearest name by Damerau-Levenshtein distance (optimal string
 * alignment), case-insensitive.
 *
 *     Cheker -> Checker: one letter is missing, distance 1
 *     Wodo -> Wood: two letters are swapped, distance 1
 *     Cheker has 6 letters, so a distance up to 3 is accepted */
#include "compiler/base/suggest.h"
#include "compiler/base/text.h"
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 64 };

static int least(int a, int b) { return a < b ? a : b; }
static bool same(char a, char b) { return text_lower(a) == text_lower(b); }

/* Returns the edit distance, or any value above `most` if an early test shows that it exceeds
 * `most`. */
static int distance(const char *a, const char *b, int most)
{
    int row[3][LONGEST + 1];
    int n = (int)strlen(a), m = (int)strlen(b);
    if (n > LONGEST || m > LONGEST || abs(n - m) > most)
        return most + 1;
    for (int j = 0; j <= m; j++)
        row[0][j] = j;
    for (int i = 1; i <= n; i++) {
        int *now = row[i % 3], *before = row[(i + 2) % 3], *second = row[(i + 1) % 3];
        now[0] = i;
        for (int j = 1; j <= m; j++) {
            now[j] =
                least(least(now[j - 1], before[j]) + 1, before[j - 1] + !same(a[i - 1], b[j - 1]));
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                now[j] = least(now[j], second[j - 2] + 1);
        }
    }
    return row[n % 3][m];
}

const char *suggest(Arena *arena, const char *name, SuggestName *names, const void *user, int count)
{
    const char *best = NULL;
    if (strnlen(name, LONGEST + 1) > LONGEST)
        return "";
    int size = (int)strlen(name), best_distance = size < 2 ? 0 : size < 5 ? 1 : size / 3 + 1;
    for (int i = 0; i < count; i++) {
        const char *candidate = names(user, i);
        int d = candidate ? distance(name, candidate, best_distance) : LONGEST;
        if (d <= best_distance && (!best || d < best_distance)) {
            best = candidate;
            best_distance = d;
        }
    }
    if (!best)
        return "";
    Text text = text_new(arena);
    text_format(&text, "; did you mean '%s'?%s", best,
                !text_same(name, best) ? "" : " Names are case-sensitive");
    return text.at;
}

const char *suggest_list(Arena *arena, const NameChoice *names)
{
    Text text = text_new(arena);
    text_put(&text, "");
    for (int i = 0; i < names->count; i++) {
        const char *name = names->name(names->user, i);
        if (name)
            text_format(&text, "%s%s", text.size ? ", " : "", name);
    }
    return text.at;
}
