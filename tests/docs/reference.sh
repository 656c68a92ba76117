#!/bin/sh
# Makes the reference pages of the target `reference`, without pictures, and checks them: each
# diagnostic, layout, kind and key of scenes, and each function, type and constant of the public
# headers has an entry; links lead to pages of docs/ or to each other; the prose keeps the rules of
# tests/words.sh. reference.sh DOCS_PROGRAM. Run from the project's root. Status 77: without Python,
# only the pages of tables were checked, without their links.
set -eu
docs=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
missing=0
# entries PAGE: each line of $work/expected, at least one, is a line of $work/found, the page's.
entries() {
    [ -s "$work/expected" ] || { echo "reference.sh: no entries to look for in $1" && missing=1; }
    absent=$(grep -vxFf "$work/found" "$work/expected" || true)
    [ -z "$absent" ] || { echo "$absent" | sed "s/^/$1 has no entry: /" && missing=1; }
}

"$docs" "$work" examples

sed -n 's/^DIAG(\([a-z0-9_]*\),.*/### \1/p' grammar/diags.def >"$work/expected"
grep '^### ' "$work/diagnostics.md" >"$work/found"
entries diagnostics.md

sed -n 's/^LAYOUT(\([A-Za-z0-9]*\),.*/## \1/p' grammar/layouts*.def >"$work/expected"
grep '^## ' "$work/layout-tables.md" >"$work/found"
entries layout-tables.md

# Headings, and keys behind the heading above them: `## image`, `### Sphere`, `### Sphere radius`. A
# kind that is the only one of its sort has no heading of its own.
awk -F '[(,] *' '
    /^SCENE_SORT\(/ { sub(/\).*/, "", $2); print "## " $2 }
    /^SCENE_KIND\(/ { kinds[$2]++; sort[$3] = $2 }
    /^ *SCENE_(PARAM|PART)\(/ { key[++keys] = $3; of[keys] = $2 }
    function heading(kind) { return kinds[sort[kind]] == 1 ? "## " sort[kind] : "### " kind }
    END {
        for (kind in sort) print heading(kind)
        for (i = 1; i <= keys; i++) print heading(of[i]) " " key[i]
    }' grammar/scene.def >"$work/expected"
awk '/^##/ { heading = $0; print } /^- `/ { split($0, part, "`"); print heading " " part[2] }' \
    "$work/scenes.md" >"$work/found"
entries scenes.md
set -- "$work/diagnostics.md" "$work/layout-tables.md" "$work/scenes.md"

if command -v python3 >/dev/null; then
    python3 docs/api.py compiler/matc.h >"$work/api-matc.md"
    python3 docs/api.py runtime/renderer/matc_render.h >"$work/api-matc-render.md"
    set -- "$@" "$work/api-matc.md" "$work/api-matc-render.md"
    for name in $(grep -ohE '\b(matc_[a-z_]+\(|MATC_[A-Z]+ = |Matc[A-Za-z]+;$)' compiler/matc.h runtime/renderer/matc_render.h |
        sed 's/[(;]$//; s/ = $//' | sort -u); do
        grep -qE "^(###|-) .*$name" "$work/api-matc.md" "$work/api-matc-render.md" || {
            echo "api-matc.md and api-matc-render.md have no entry: $name"
            missing=1
        }
    done
    python3 docs/site.py check "$work" || missing=1
fi
sh tests/words.sh "$@" || missing=1
[ "$missing" = 0 ] || exit 1
command -v python3 >/dev/null || {
    echo "SKIPPED: python3 is not installed, so neither the headers' pages nor links were checked"
    exit 77
}
