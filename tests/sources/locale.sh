#!/bin/sh
# Only compiler/base/text.c goes by the locale: no other file of the library, of matc and of matview reads a number by the C library,
# formats one with a fraction, asks ctype.h for a letter or the system for its words. The tables and plots of runtime/autotune are printed
# by matc, which sets no locale. Run from the project's root.
set -eu
found=$(grep -nE '\b(strto(d|f|ld)(_l)?|atof|sscanf|strerror(_r|_l)?|perror|setlocale|newlocale|uselocale|localeconv|is(alpha|alnum|digit|xdigit|lower|upper|space|punct|print|graph|cntrl)|to(lower|upper)|str(n?casecmp|coll|xfrm))\(|%[-+ #0-9.*]*[aefgAEFG]\b|<(ctype|locale)\.h>' \
    $(find compiler grammar runtime -name '*.[ch]' ! -path 'runtime/autotune/*' ! -path 'runtime/gl/*') |
    grep -vE '^compiler/base/text\.[ch]:' || true)
[ -z "$found" ] || {
    echo "$found"
    echo "these go by the locale: compiler/base/text.h has words for them"
    exit 1
}
