#!/bin/sh
# Checks the pages of docs/guide/howto: a page is one screen, its documents compile without a warning,
# and its commands run: howto.sh MATC MATVIEW. Run from the project's root.
set -u
matc=$(realpath "$1")
matview=$(realpath "$2")
root=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
. tests/share.sh
number=0
mkdir "$work/bin" && ln -s "$matc" "$work/bin/matc" && ln -s "$matview" "$work/bin/matview"
PATH=$work/bin:$PATH

# A page names a file in a line of its own, `wall.yaml`:, and quotes it in the next block. Commands
# are blocks of the kind sh; what does not end, or needs a GPU, is left out.
for page in docs/guide/howto/*.md; do
    title=$(basename "$page" .md)
    mkdir "$work/$title" && cd "$work/$title" || exit 1
    awk '
        /^`[a-z0-9]*\.yaml`:$/ { name = $0; gsub(/[`:]/, "", name); print name >"../documents"; next }
        /^```/ { if (open) name = ""; open = !open; shell = open && $0 == "```sh"; next }
        open && name { print >name }
        shell { print >"../commands" }' "$root/$page"
    cd "$root" || exit 1
    check "$title is one screen" test "$(wc -w <"$page")" -le 350
    [ "$title" != README ] || continue
    number=$((number + 1))
    share_takes $number 2 || { rm -f "$work/documents" "$work/commands" && continue; }
    check "$title is in the list" grep -qF "($title.md)" docs/guide/howto/README.md
    check "$title has a document" test -s "$work/documents"
    check "$title has commands" test -s "$work/commands"
    cd "$work/$title" || exit 1
    while read -r document; do
        grep -q '^objects:' "$document" || check "$title: $document compiles without a warning" "$matc" --no-validate -Werror -d "$work/made" "$document"
    done <"$work/documents"
    while read -r line; do
        case $line in *--gl=egl*) continue ;; esac
        command -v "${line%% *}" >/dev/null || continue
        check "$title: $line" sh -c "$line"
    done <"$work/commands"
    rm -f "$work/documents" "$work/commands"
    cd "$root" || exit 1
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
