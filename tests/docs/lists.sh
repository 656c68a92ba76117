#!/bin/sh
# Checks lists in documentation: the targets in README.md, docs/reference/matc.1 and compiler/matc.h
# against grammar/targets.def, as printed by matc --help; the warnings in matc.1 against
# grammar/diags.def, as printed by matc --explain warnings; and the stress test's modes in
# docs/reference/stability.md against tests/stress/modes.def: lists.sh MATC [--update]; --update
# rewrites the lists. Run from the project's root.
set -eu
matc=$1
update=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
list=$("$matc" --help | sed -n 's/^  --target=T *//p') # glsl110, glsl330 (default), ...
[ -n "$list" ]

# in the man page: names up to the default, those behind it, the last
in_man() {
    echo "$list" | awk -F ', ' '{
        line = ".Cm"
        for (i = 1; i < NF; i++) {
            name = $i
            is_default = sub(/ \(default\)/, "", name)
            line = line (line == ".Cm" ? " " : " , ") name
            if (is_default) { print line "\n.Pq default ,"; line = ".Cm" }
        }
        if (line != ".Cm") print line
        print "or\n.Cm " $NF " ."
    }'
}

# replaced FILE FIRST LAST: the file, with standard input from the line that begins with FIRST up to the one before that which
# begins with LAST
replaced() {
    first=$2 last=$3 awk 'FNR == NR { text = text $0 "\n"; next }
        !found && index($0, ENVIRON["first"]) == 1 { printf "%s", text; inside = found = 1; next }
        inside && index($0, ENVIRON["last"]) == 1 { inside = 0 }
        !inside
        END { exit !found }' - "$1"
}

# holds FILE FIRST LAST: that part of it is standard input
holds() {
    replaced "$@" >"$work/new" || {
        echo "$1: no line begins with $2"
        return 1
    }
    cmp -s "$work/new" "$1" && return
    if [ "$update" = --update ]; then
        cp "$work/new" "$1" && echo "$1: written"
    else
        diff "$1" "$work/new"
    fi
}

forms() {
    printf '%s\n```\n' '<!-- matc --list=foreign: forms -->'
    "$matc" --list=foreign | sed -n '/form of a value/,$s/^  //p'
    echo '```'
}
quoted() { echo "$list" | sed -E "s/ \(default\)/@/; s/[a-z0-9]+/$1&$1/g; s/@/$2/"; }
stale=0
echo "| targets | $(quoted '`' '') |" | holds README.md '| targets |' '|' || stale=1
echo "    /* target language: $(quoted '"' ' (default)') */" |
    holds compiler/matc.h '    /* target language: ' '    const char *target;' || stale=1
{ printf '%s\n' '.It Fl \-target Ns = Ns Ar target'; in_man; } | holds docs/reference/matc.1 '.It Fl \-target ' '.It Fl' || stale=1

forms | holds docs/reference/from-other-tools.md '<!-- matc --list=foreign: forms -->' '<!-- end of forms -->' || stale=1

warnings=$("$matc" --explain warnings | sed -n 's/^  \([a-z_]*\)  .*/\1/p')
[ -n "$warnings" ]
{
    echo ".It Fl W Ns Cm no- Ns Ar name , Fl W Ns Cm error , Fl W Ns Cm error= Ns Ar name"
    echo "Do not give that warning; take all warnings, or that one, as errors."
    echo "The last option that speaks of a warning counts."
    echo ".Fl \-explain Cm warnings"
    echo "tells what each is about:"
    echo "$warnings" | sed 's/^/.Cm /; $!s/$/ ,/; $s/$/ ./'
} | holds docs/reference/matc.1 '.It Fl W ' '.It Fl' || stale=1
modes=$(sed -n 's/^MODE(\([a-zA-Z]*\),.*/\1/p' tests/stress/modes.def | paste -sd ' ')
echo "for mode in $modes; do" | holds docs/reference/stability.md 'for mode in ' '    build/matbench stress --mode' || stale=1
exit "$stale"
