#!/bin/sh
# Checks docs/guide/tutorial.md: its documents and its program equal the files that they quote, which
# compile without a warning; every step has its picture: tutorial.sh MATC MATVIEW [--update].
# --update draws the pictures anew. Run from the project's root.
set -u
matc=$(realpath "$1")
matview=$(realpath "$2")
update=${3:-}
page=docs/guide/tutorial.md
folder=docs/pictures/tutorial
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh

# The page names a file in a line of its own, `step01.yaml`:, and quotes it in the next block.
awk -v work="$work" '
    /^`[a-z0-9]*\.(yaml|c)`:$/ { name = $0; gsub(/[`:]/, "", name); print name; next }
    /^```/ { if (open) name = ""; open = !open; next }
    open && name { print >(work "/" name) }' "$page" >"$work/names"
check "ten steps, a scene and a program" test "$(wc -l <"$work/names")" = 12

number=0
while read -r document; do
    case $document in *.c) original=examples/$document ;; *) original=$folder/$document ;; esac
    check "$document is quoted as it is" cmp "$work/$document" "$original"
    case $document in
    step*)
        number=$((number + 1))
        drawn=$folder/${document%.yaml}.png
        check "$document is step $number" test "$document" = "$(printf 'step%02d.yaml' $number)"
        check "it compiles without a warning" "$matc" --no-validate -Werror "$original" -o "$work/frag"
        options=$(sed -n "s/^matview --size=256 \(.*\) $document -o .*/\1/p" "$page")
        # shellcheck disable=SC2086
        [ -z "$update" ] || "$matview" --size=256 ${options#"$document"} "$original" -o "$drawn"
        ;;
    scene.yaml)
        drawn=$folder/scene.png
        check "its materials compile" status 0 "$matview" --emit=frame "$original"
        check "without a warning" test ! -s "$work/stderr"
        [ -z "$update" ] || "$matview" "$original" -o "$drawn"
        ;;
    *) continue ;;
    esac
    check "the page shows its picture" grep -qF "(../pictures/tutorial/${drawn##*/})" "$page"
    check "which is there" test -s "$drawn"
done <"$work/names"
check "the program has at most 60 lines" test "$(wc -l <"$work/draw.c")" -le 60
draws() {
    sed 's/width: 480, height: 300/width: 48, height: 30/' "$folder/scene.yaml" >"$work/scene.yaml"
    cp "$folder"/step*.yaml "$work"
    # shellcheck disable=SC2046
    ${CC:-cc} -Wall -Wextra -Werror "$work/draw.c" -I compiler -I runtime/renderer -L "${matc%/*}" -lmatc_render \
        $(pkg-config --cflags --libs osmesa) -o "$work/draw" &&
        (cd "$work" && LD_LIBRARY_PATH=${matc%/*} ./draw scene.yaml) &&
        [ "$(find "$work" -name 'frame[0-7].ppm' -size +4k | wc -l)" = 8 ] && ! cmp -s "$work/frame0.ppm" "$work/frame7.ppm"
}
[ ! -e "${matc%/*}/libmatc_render.so" ] || check "it draws eight frames, in which something moves" draws

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
