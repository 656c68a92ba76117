#!/bin/sh
# Checks how the project speaks: how comments begin, banned words, the width of lines, and long
# cells and sentences of pages. Prints each place that breaks a rule. With PAGES, checks these pages
# alone: words.sh [PAGES]. Run from the project's root.
#
#     openers    no comment begins with Of, What, Who, Whoever, Whose, Likewise, The same, That which
#     words      no word of tests/words.def is an identifier or stands in a comment or a page
#     columns    100 in code and Markdown; tables, pictures and code blocks of Markdown are exempt
#     cells      200 characters in a table of Markdown
#     sentences  40 words in docs/guide
set -eu
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
given=$*
code() {
    [ -z "$given" ] || return 0
    find compiler runtime grammar tests \( -path tests/golden -o -path tests/errors \) -prune -o \
        \( -name '*.[ch]' -o -name '*.def' -o -name '*.glsl' \) -print | sort
}
pages() {
    [ -z "$given" ] || { printf '%s\n' $given && return 0; }
    find . \( -path ./build\* -o -path ./.git -o -path ./tests/golden -o -name node_modules \) -prune -o \
        -name '*.md' -print | sed 's,^\./,,' | sort
}

code | xargs awk '
    FNR == 1 { above = 0 }
    { line = $0; sub(/^[ \t]+/, "", line) }
    match(line, /\/\* (Of|What|Who|Whoever|Whose|Likewise|The same|That which)[ ,:]/) ||
    (!above && line ~ /^\/\/ (Of|What|Who|Whoever|Whose|Likewise|The same|That which)[ ,:]/) {
        if (length($0) > 18) print FILENAME ":" FNR ": " line
    }
    length($0) > 100 { print FILENAME ":" FNR ": " length($0) " columns" }
    { above = line ~ /^\/\// }' >"$work/bad"

# Words: strings are exempt (names of other tools, texts of tests), and tables of aliases
sed -n 's/^BANNED(\([a-z]*\), "\(.*\)")$/\1 \2/p' tests/words.def >"$work/words"
[ -s "$work/words" ] || { echo "words.sh: no words in tests/words.def" && exit 1; }
code | grep -vE '^(tests/words\.def|grammar/foreign\.def|tests/near_misses\.def)$' | xargs awk -v words="$work/words" '
    BEGIN { while ((getline line < words) > 0) { word = line; sub(/ .*/, "", word); sub(/^[a-z]+ /, "", line); term[word] = line } }
    {
        line = $0
        gsub(/\\./, "", line)
        gsub(/"[^"]*"/, "", line)
        rest = line
        while (match(rest, /[A-Z]+[A-Z]|[A-Z]?[a-z]+/)) {
            word = tolower(substr(rest, RSTART, RLENGTH))
            if (word in term) print FILENAME ":" FNR ": " word ": " term[word]
            rest = substr(rest, RSTART + RLENGTH)
        }
    }' >>"$work/bad"
pages | grep -vE '^(CHANGELOG\.md|docs/design/glossary\.md|docs/reference/from-other-tools\.md)$' | xargs awk -v words="$work/words" '
    BEGIN { while ((getline line < words) > 0) { word = line; sub(/ .*/, "", word); sub(/^[a-z]+ /, "", line); term[word] = line } }
    FNR == 1 { fenced = 0; sentence = 0 }
    /^ *```/ { fenced = !fenced; next }
    fenced { next }
    /^\|/ {
        cells = split($0, cell, "|")
        for (i = 1; i <= cells; i++) { gsub(/^ +| +$/, "", cell[i]); if (length(cell[i]) > 200) print FILENAME ":" FNR ": a cell of " length(cell[i]) " characters" }
    }
    !/^(\||!|\[)/ && length($0) > 100 { print FILENAME ":" FNR ": " length($0) " columns" }
    {
        line = $0
        gsub(/`[^`]*`/, "x", line)
        rest = line
        while (match(rest, /[A-Za-z]+/)) {
            word = tolower(substr(rest, RSTART, RLENGTH))
            if (word in term) print FILENAME ":" FNR ": " word ": " term[word]
            rest = substr(rest, RSTART + RLENGTH)
        }
    }
    FILENAME ~ /^docs\/guide\// {
        if ($0 ~ /^(\||#|$|!|- |[0-9]+\. )/) sentence = 0
        if ($0 !~ /^(\||#|$|!)/) {
            n = split($0, part, / +/)
            for (i = 1; i <= n; i++) {
                if (part[i] == "") continue
                if (++sentence == 41) print FILENAME ":" FNR ": a sentence of over 40 words"
                if (part[i] ~ /[.!?:]["`)]*$/) sentence = 0
            }
        }
    }' >>"$work/bad"
[ ! -s "$work/bad" ] || { cat "$work/bad" && exit 1; }
