#!/bin/sh
# The pages of docs/reference that are made from tables and headers are up to date: reference.sh
# DOCS_PROGRAM; with --update behind it, they are written anew. Run from the project's root.
set -eu
docs=$1
update=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$docs" "$work" examples
pages="scenes.md diagnostics.md layout-tables.md"
if command -v python3 >/dev/null; then
    python3 docs/api.py compiler/matc.h >"$work/api-matc.md"
    python3 docs/api.py runtime/renderer/matc_render.h >"$work/api-matc-render.md"
    pages="$pages api-matc.md api-matc-render.md"
else
    echo "SKIPPED: python3 is not installed, so the pages of the headers were not compared"
fi
stale=0
for page in $pages; do
    cmp -s "$work/$page" "docs/reference/$page" && continue
    if [ "$update" = --update ]; then
        cp "$work/$page" "docs/reference/$page" && echo "docs/reference/$page: written"
    else
        diff "docs/reference/$page" "$work/$page" | head -20
        echo "docs/reference/$page is stale: sh tests/docs/reference.sh $docs --update"
        stale=1
    fi
done
# Each function, type and constant of the headers has an entry.
for name in $(grep -ohE '\b(matc_[a-z_]+\(|MATC_[A-Z]+ = |Matc[A-Za-z]+;$)' compiler/matc.h runtime/renderer/matc_render.h |
    sed 's/[(;]$//; s/ = $//' | sort -u); do
    grep -qE "^(###|-) .*$name" docs/reference/api-matc.md docs/reference/api-matc-render.md || {
        echo "$name has no entry in docs/reference/api-matc.md or api-matc-render.md"
        stale=1
    }
done
exit "$stale"
