#!/bin/sh
# Checks that only compiler/base/text.c depends on the locale: no other file of the library, matc
# and matview parses a number with the C library, formats one with a fraction, uses ctype.h or the
# system's messages. The tables and plots of runtime/autotune are exempt: matc, which sets no
# locale, prints them. Run from the project's root.
set -eu
found=$(grep -nE '\b(strto(d|f|ld)(_l)?|atof|sscanf|strerror(_r|_l)?|perror|setlocale|newlocale|uselocale|localeconv|is(alpha|alnum|digit|xdigit|lower|upper|space|punct|print|graph|cntrl)|to(lower|upper)|str(n?casecmp|coll|xfrm))\(|%[-+ #0-9.*]*[aefgAEFG]\b|<(ctype|locale)\.h>' \
    $(find compiler grammar runtime -name '*.[ch]' ! -path 'runtime/autotune/*' ! -path 'runtime/gl/*') |
    grep -vE '^compiler/base/text\.[ch]:' || true)
[ -z "$found" ] || {
    echo "$found"
    echo "these go by the locale: compiler/base/text.h has words for them"
    exit 1
}
