#!/bin/sh
# Builds the sample engine with the installed package, outside of the source tree:
# install.sh BUILD_FOLDER [GENERATOR]. Then checks what is rebuilt after a change of a picture,
# definitions, a layout or nothing. Run from the project's root.
set -u
build=$1
generator=${2:-Ninja}
. tests/share.sh
[ "$generator" = Ninja ] || share_or_skip 2 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
engine="$work/the source"
out=$work/build/materials
: >"$work/stderr"
. tests/check.sh

make_it() { cmake --build "$work/build" >"$work/said" 2>&1 || { cat "$work/said" && false; }; }
# No command ran
idle() {
    case $generator in
    Ninja) grep -q 'no work to do' "$work/said" ;;
    *) ! grep -qE 'Compiling|Building|Linking|Generating' "$work/said" ;;
    esac
}
# The materials were compiled again, and the engine was not
materials_only() { grep -q 'Compiling materials' "$work/said" && ! grep -qE 'Building|Linking' "$work/said"; }
# Contents and times of what matc wrote
state() { (cd "$out" && for file in *; do echo "$file $(stat -c %y "$file" | tr -d ' ') $(cksum <"$file")"; done); }
# changed FILE...: since the last call exactly these were written, came, or went
changed() {
    state >"$work/now"
    got=$(diff "$work/before" "$work/now" | sed -n 's/^[<>] \([^ ]*\) .*/\1/p' | sort -u | tr '\n' ' ')
    mv "$work/now" "$work/before"
    [ "$got" = "$(echo "$*" | sed 's/$/ /; s/^ $//')" ] || { echo "changed: $got" && false; }
}
# rebuilds WHAT FILE...: after a change, which were written; then nothing is left to do
rebuilds() {
    what=$1
    shift
    check "$what: builds" make_it
    check "$what: the materials alone" materials_only
    check "$what: exactly what depends on it" changed "$@"
    check "$what: then again" make_it
    check "$what: nothing is left to do" idle
}
check "installs" cmake --install "$build" --prefix "$work/prefix"
cp -r examples/engine "$engine"
check "configures" cmake -G "$generator" -S "$engine" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix"
check "builds" make_it
check "a second time" make_it
check "does nothing" idle

# The frame
"$work/build/engine" "$work/frame.png" >"$work/printed" 2>&1
check "draws" grep -q 'materials, .* programs, layout' "$work/printed"
materials=$(sed -n 's/^\([0-9]*\) materials, .*/\1/p' "$work/printed")
programs=$(sed -n 's/.* \([0-9]*\) programs, .*/\1/p' "$work/printed")
check "a few dozen materials" test "${materials:-0}" -ge 36
check "in fewer programs" test "$((${programs:-99} * 2))" -lt "${materials:-0}"
check "which are the files" test "$(find "$out" -name '*.frag' | wc -l)" = "${programs:-0}"
rows=$(((${materials:-0} + 7) / 8))
size=$(od -An -tu1 -j16 -N8 "$work/frame.png" | awk '{print $3 * 256 + $4, $7 * 256 + $8}')
check "a picture of their size" test "$size" = "960 $((rows * 120))"
# Without a sphere it has 63 kB, with all 530
check "which is not empty" test "$(wc -c <"$work/frame.png")" -gt 300000

# What is drawn does not depend on the generator
other_hosts() {
    # The same engine for surfaces by their physics; coats are seen
    cp -r examples/engine "$work/physical"
    rm -r "$work/physical/materials"
    mkdir "$work/physical/materials"
    physical() {
        printf 'materials:\n  gold: { material: Principled, baseColor: [.9, .6, .2], metalness: 1 }\n  paint: { material: Principled, baseColor: [.3, .05, .05], roughness: .6, coat: %s }\n' "$1" >"$work/physical/materials/two.yaml"
        cmake -G "$generator" -S "$work/physical" -B "$work/physical/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DMODEL=principled -DLAYOUT=compact &&
            cmake --build "$work/physical/build" && "$work/physical/build/engine" "$work/$1.png"
    }
    check "draws coats" physical 1
    check "and without" physical 0
    coated() { [ "$(wc -c <"$work/0.png")" -gt 20000 ] && ! cmp -s "$work/0.png" "$work/1.png"; }
    check "which differs" coated

    # The renderer, on a context of the host's
    cp -r examples/host "$work/host"
    check "configures a host" cmake -G "$generator" -S "$work/host" -B "$work/host/build" -DCMAKE_PREFIX_PATH="$work/prefix"
    check "builds it" cmake --build "$work/host/build"
    check "draws a scene" "$work/host/build/host" "$work/host/scene.yaml" "$work/one.ppm" "$work/two.ppm"
    # pixel FILE X Y: of a picture of 320 x 200, from the top
    pixel() { od -An -tu1 -j$((15 + 3 * ($3 * 320 + $2))) -N3 "$1" | awk '{ print ($1 > $2) "" ($2 > $1) }'; }
    check "the sphere is red, on the left" test "$(pixel "$work/one.ppm" 110 110)" = 10
    check "and moves to the right, green" test "$(pixel "$work/two.ppm" 210 110)" = 01
    check "away from where it was" test "$(pixel "$work/two.ppm" 110 110)" = 00
}
[ "$generator" != Ninja ] || other_hosts

state >"$work/before"
touch "$engine/materials/images/bricks.png"
rebuilds "a picture touched"
cp "$engine/materials/images/mosaic.png" "$engine/materials/images/bricks.png"
rebuilds "a picture of the same size"
cp docs/pictures/checker.png "$engine/materials/images/bricks.png"
rebuilds "a picture of another size" bricks.frag bricks.json cloth.frag cloth.json cloth.vert manifest.json
sed -i 's/varnish: 0.9 /varnish: 0.8 /' "$engine/materials/palette.yaml"
rebuilds "a number in defs" manifest.json
sed -i '/swirl:/,/octaves:/ s/octaves: 5/octaves: 4/' "$engine/materials/palette.yaml"
rebuilds "octaves in defs" carrara.frag carrara.json manifest.json
sed -i 's/specular: 0.3$/specular: 0.31/' "$engine/materials/golf.yaml"
rebuilds "a document" manifest.json

# Only the stained glass packs what lies beside the shininess; to the others it is a number in the manifest
sed -i 's/encoding: logarithm, bits: 10/encoding: logarithm, bits: 9/' "$engine/layout.yaml"
rebuilds "a field of the layout" engine.unpack.glsl glassStained.frag glassStained.json manifest.json
sed -i 's/encoding: octahedral, bits: 12/encoding: octahedral, bits: 11/' "$engine/layout.yaml"
# shellcheck disable=SC2046
rebuilds "the layout's normals" $(cd "$out" && ls | grep -v 'vert$')
check "draws by it" "$work/build/engine" "$work/frame.png"

# Faults keep what was there
sed -i 's/map: Leopard/map: Leopart/' "$engine/materials/jaguar.yaml"
fails() { ! make_it && grep -q "unknown map 'Leopart'" "$work/said"; }
check "a fault ends the build" fails
check "and nothing is written" changed
sed -i 's/map: Leopart/map: Leopard/' "$engine/materials/jaguar.yaml"
rebuilds "the fault repaired"
rm "$engine/materials/jaguar.yaml"
check "a document less" make_it
check "its program goes" changed jaguar.frag jaguar.json jaguar.vert manifest.json
check "draws the rest" "$work/build/engine" "$work/frame.png"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
