#!/bin/sh
# Checks how comments begin: a comment is a sentence or a noun phrase, and never begins with Of,
# What, Who, Whoever, Whose, Likewise, The same or That which. compiler/library/ is exempt until its
# comments, which emitted programs contain, are rewritten. Run from the project's root.
set -eu
bad=$(find compiler runtime grammar tests \( -path compiler/library -o -path tests/golden \) -prune -o \
    \( -name '*.[ch]' -o -name '*.def' -o -name '*.glsl' \) -print | LC_ALL=C sort | xargs awk '
    FNR == 1 { above = 0 }
    { line = $0; sub(/^[ \t]+/, "", line) }
    match(line, /\/\* (Of|What|Who|Whoever|Whose|Likewise|The same|That which)[ ,:]/) ||
    (!above && line ~ /^\/\/ (Of|What|Who|Whoever|Whose|Likewise|The same|That which)[ ,:]/) {
        if (length($0) > 18) print FILENAME ":" FNR ": " line
    }
    { above = line ~ /^\/\// }')
[ -z "$bad" ] || { echo "$bad" && exit 1; }
