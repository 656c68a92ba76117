#!/bin/sh
# Checks the pictures of docs/reference/materials.md, docs/guide/gallery.md,
# docs/reference/from-other-tools.md and docs/reference/language.md: every document compiles without
# a warning and its picture is not uniform; every picture exists: pictures.sh MATC MATVIEW
# [--update]. --update redraws the pictures. Run from the project's root.
set -u
matc=$(realpath "$1")
matview=$(realpath "$2")
update=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
. tests/share.sh
ten=$(sed -n "s/^matview --contact=materials.png //p" docs/reference/materials.md)

# The documents of the pages below a picture, each named after it; NAME.options has what the page says to matview, NAME.picture where it is
cp examples/tiles.png "$work" && mkdir "$work/images" && cp examples/tiles.png "$work/images/height.png"
awk -v work="$work" '
    /^<!-- matview / { options = $0; gsub(/^<!-- matview | -->$/, "", options) }
    /^!\[/ {
        name = picture = $0; gsub(/^!\[|\].*/, "", name); gsub(/.*\(|\).*/, "", picture)
        print name; print options >(work "/" name ".options"); sub(/^..\//, "docs/", picture); print picture >(work "/" name ".picture"); options = "" }
    /^```/ { if (open) name = ""; open = $0 == "```yaml"; next }
    open && name { print >(work "/" name ".yaml") }' docs/reference/from-other-tools.md docs/reference/language.md >"$work/names"
check "twenty documents, four of relief, and a Mix" test "$(wc -l <"$work/names")" = 25 -a "$(find "$work" -name '*.yaml' | wc -l)" = 25
check "of as many names" test "$(sort -u "$work/names" | wc -l)" = 25
check "ten materials" test "$(echo "$ten" | wc -w)" = 10
# varies DOCUMENT: its values are not the same everywhere on a sphere, by the C reference
points=$(awk 'BEGIN { for (i = 0; i < 12; i++) { u = (i + 0.5) / 12; v = (i * 5 % 12 + 0.5) / 12; a = 6.2831853 * u; b = 3.1415927 * (v - 0.5)
    printf "u=%g,v=%g,x=%g,y=%g,z=%g\n", u, v, cos(a) * cos(b), sin(a) * cos(b), sin(b) } }')
varies() {
    first=""
    for point in $points; do
        value=$("$matc" --eval "$(echo "$point" | tr , ' ')" "$1") || return
        [ "$value" = "${first:=$value}" ] || return 0
    done
    return 1
}
echo 'material: Phong' >"$work/plain.yaml"
small="$matview --size=64 --samples=1"
check "a plain surface" $small "$work/plain.yaml" -o "$work/plain.png"

number=0
while read -r document; do
    number=$((number + 1))
    share_takes $number 3 || continue
    check "$document compiles without a warning" "$matc" --no-validate -Werror "$work/$document.yaml" -o "$work/$document.frag"
    # shellcheck disable=SC2046
    check "$document is drawn" $small $(cat "$work/$document.options") "$work/$document.yaml" -o "$work/$document.png"
    check "$document varies" varies "$work/$document.yaml"
    check "and so does its picture" sh -c "! cmp -s '$work/$document.png' '$work/plain.png'"
    # shellcheck disable=SC2046
    [ -z "$update" ] || "$matview" --size=160 $(cat "$work/$document.options") "$work/$document.yaml" -o "$(cat "$work/$document.picture")"
    check "$document is in docs" test -s "$(cat "$work/$document.picture")"
done <"$work/names"

cd examples/materials || exit 1
# shellcheck disable=SC2086
check "the ten compile without a warning" "$matc" --no-validate -Werror -d "$work/ten" $ten
# shellcheck disable=SC2086
check "and are drawn" $small -d "$work/ten" $ten
for document in $ten; do
    check "$document varies" varies "$document"
    check "and so does its picture" sh -c "! cmp -s '$work/ten/${document%.yaml}.png' '$work/plain.png'"
done
# shellcheck disable=SC2086
[ -z "$update" ] || "$matview" --contact=../../docs/pictures/materials.png $ten
# README.md's: every map's example, and every material but the sky
# shellcheck disable=SC2010,SC2046
[ -z "$update" ] || (cd .. && "$matview" --contact=../docs/pictures/examples.png --size=120 *.yaml $(ls materials/*.yaml | grep -v -e sunSky -e palette))
cd ../.. || exit 1
check "their picture is in docs" test -s docs/pictures/materials.png

[ -z "$update" ] || "$matview" docs/pictures/shadows.yaml --compare=shadows -o docs/pictures/shadows.png
check "shadows by all methods are drawn" "$matview" docs/pictures/shadows.yaml --compare=shadows -o "$work/shadows.png"
check "and are in docs" test -s docs/pictures/shadows.png
[ -z "$update" ] || "$matview" docs/pictures/indirect.yaml --compare=indirect -o docs/pictures/indirect.png
check "indirect light by all methods is drawn" "$matview" docs/pictures/indirect.yaml --compare=indirect -o "$work/indirect.png"
check "and is in docs" test -s docs/pictures/indirect.png
sed 's/directional: true/directional: false/' docs/pictures/directional.yaml > "$work/undirected.yaml"
[ -z "$update" ] || "$matview" docs/pictures/directional.yaml -o docs/pictures/directional.png
[ -z "$update" ] || "$matview" "$work/undirected.yaml" -o docs/pictures/undirected.png
check "light of a sky is drawn" "$matview" "$work/undirected.yaml" -o "$work/undirected.png"
check "and is in docs" test -s docs/pictures/directional.png
check "and the one by openness" test -s docs/pictures/undirected.png
[ -z "$update" ] || "$matview" tests/reference/cycles/bounced.yaml -o docs/pictures/bounced.png
check "what a path tracer drew, too, is in docs" test -s docs/pictures/bounced.png
[ -z "$update" ] || "$matview" tests/reference/cycles/displaced.yaml -o docs/pictures/displaced-here.png
[ -z "$update" ] || "$matview" tests/reference/cycles/principled.yaml -o docs/pictures/principled-here.png
check "and balls of gloss" test -s docs/pictures/principled-here.png -a -s docs/pictures/principled-cycles.png
check "and what it displaced" test -s docs/pictures/displaced-here.png -a -s docs/pictures/displaced-cycles.png
check "beside that tracer's picture" test -s docs/pictures/cycles.png
[ -z "$update" ] || "$matview" docs/pictures/indirect.yaml --view=positions -o docs/pictures/positions.png
check "what its picture knows is drawn" "$matview" docs/pictures/indirect.yaml --view=positions -o "$work/positions.png"
check "and is in docs" test -s docs/pictures/positions.png
for view in volume:volume volumeWireframeAlone:volume-lines; do
    drawn=${view#*:}.png
    [ -z "$update" ] || "$matview" docs/pictures/volume.yaml --view="${view%:*}" -o "docs/pictures/$drawn"
    check "the view ${view%:*} is drawn" "$matview" docs/pictures/volume.yaml --view="${view%:*}" -o "$work/$drawn"
    check "and is in docs" test -s "docs/pictures/$drawn"
done

for rounded in hard push:0.42 bulge:0.75; do
    drawn=${rounded%:*}
    sed "s/method: bisection/&$(test $drawn = hard || echo ", $drawn: ${rounded#*:}")/" docs/pictures/hard.yaml >"$work/$drawn.yaml"
    [ -z "$update" ] || "$matview" "$work/$drawn.yaml" -o "docs/pictures/$drawn.png"
    check "hard bodies are drawn: $drawn" "$matview" --size=64 "$work/$drawn.yaml" -o "$work/$drawn.png"
    check "and are in docs" test -s "docs/pictures/$drawn.png"
done

for scene in examples/scenes/*.yaml; do
    shown=$(basename "$scene" .yaml)
    number=$((number + 1))
    share_takes $number 3 || continue
    [ -z "$update" ] || "$matview" --size=560 "$scene" -o "docs/pictures/gallery/$shown.png"
    check "$shown is in the gallery" grep -q "!\[$shown\](../pictures/gallery/$shown.png).*scenes/$shown.yaml" docs/guide/gallery.md
    check "and so is its picture" test -s "docs/pictures/gallery/$shown.png"
    check "its materials compile" status 0 "$matview" --emit=frame "$scene"
    check "without a warning" test ! -s "$work/stderr"
done
for frame in 9 18 27; do
    shown=$(printf 'carpaint-%02d' $frame)
    [ -z "$update" ] || "$matview" --size=280 --frame=$frame examples/scenes/carpaint.yaml -o "docs/pictures/gallery/$shown.png"
    check "$shown is in the gallery" grep -q "(../pictures/gallery/$shown.png)" docs/guide/gallery.md
    check "and so is its picture" test -s "docs/pictures/gallery/$shown.png"
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
