#!/bin/sh
# Only compiler/base/text.c goes by the locale: no other file of the library, of matc and of matview reads a number by the C library,
# formats one with a fraction, asks ctype.h for a letter or the system for its words. The tables and plots of runtime/measure are printed
# by matc, which sets no locale. Run from the project's root.
set -eu
found=$(grep -nE '\b(strto(d|f|ld)(_l)?|atof|sscanf|strerror(_r|_l)?|perror|setlocale|newlocale|uselocale|localeconv|is(alpha|alnum|digit|xdigit|lower|upper|space|punct|print|graph|cntrl)|to(lower|upper)|str(n?casecmp|coll|xfrm))\(|%[-+ #0-9.*]*[aefgAEFG]\b|<(ctype|locale)\.h>' \
    compiler/*.[ch] compiler/*/*.[ch] compiler/library/*.[ch] compiler/library/maps/*.c runtime/draw/*.[ch] runtime/displace/*.[ch] runtime/cache/*.[ch] runtime/surface/*.[ch] runtime/exact/*.[ch] runtime/frame/*.[ch] runtime/shadow/*.[ch] runtime/shadow/*/*.[ch] runtime/light/*.[ch] runtime/indirect/*.[ch] runtime/indirect/*/*.[ch] runtime/picture/*.[ch] runtime/glass/*.[ch] runtime/render/*.[ch] runtime/scene/*.[ch] runtime/view/*.[ch] grammar/*.[ch] |
    grep -vE '^compiler/base/text\.[ch]:' || true)
[ -z "$found" ] || {
    echo "$found"
    echo "these go by the locale: compiler/base/text.h has words for them"
    exit 1
}
