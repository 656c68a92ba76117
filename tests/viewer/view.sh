#!/bin/sh
# Tests matview's command line, its options and --watch: view.sh MATVIEW. Run from the project's
# root.
set -u
matview=$(realpath "$1")
work=$(mktemp -d)
pid=
trap '[ -z "$pid" ] || kill $pid 2>/dev/null; rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
draw="$matview --size=24 --samples=1"
example=examples/checker.yaml
differ() { test -s "$work/$1.png" -a -s "$work/$2.png" && ! cmp -s "$work/$1.png" "$work/$2.png"; }
same() { cmp -s "$work/$1.png" "$work/$2.png"; }

# -- outputs that cannot be what was asked for

mkdir "$work/one" "$work/other"
cp $example "$work/one/same.yaml"
cp examples/wood.yaml "$work/other/same.yaml"
check "two documents of one name into one folder" status 1 $draw -d "$work/drawn" "$work/one/same.yaml" "$work/other/same.yaml"
check "are told apart" says "drawn/same.png: this image was rendered from .*one/same.yaml"
check "the first is kept" status 0 $draw -o "$work/first.png" "$work/one/same.yaml"
check "as it was drawn" cmp -s "$work/first.png" "$work/drawn/same.png"
check "a document twice" status 0 $draw -d "$work/drawn" "$work/one/same.yaml" "$work/one/same.yaml"
closed() { "$@" >&-; }
full() { "$@" >/dev/full; }
for stream in closed full; do
    $stream $draw -o - $example 2>"$work/stderr"
    check "a picture for a $stream standard output fails" test $? = 1
    check "and says so" says '^matview: error: -: '
    $stream $draw -d "$work/drawn" $example 2>"$work/stderr"
    check "the list of pictures as well" test $? = 1
    check "and says so" says '^matview: error: standard output: '
done
check "a temporary folder that takes nothing" sh -c "mkdir '$work/bare' && TMPDIR='$work/none' $draw -d '$work/bare' $example"
(ulimit -v 200000 && $draw -d "$work/bare" $example) 2>"$work/stderr"
check "no memory for the driver is no missing driver" says 'osmesa: .*: failed to map segment\|Cannot allocate memory'

lit='lights: [{ light: Ambient }]'
for camera in 'near: 20' 'position: [0, 5, 0], target: [0, 9, 0]' 'position: [9, 5, 0], target: [9, 0, 0], angle: 5'; do
    printf 'camera: { camera: Perspective, %s }\nobjects: [{ object: Sphere, material: { material: Phong } }]\n%s\n' "$camera" "$lit" >"$work/unseen.yaml"
    check "a scene of which nothing is in view, by $camera" status 0 $draw "$work/unseen.yaml" -o "$work/unseen.png"
    check "says so" says 'warning: no object is in view'
done
printf 'camera: { camera: Perspective }\nobjects: [{ object: Sphere, material: { material: Phong } }]\n%s\n' "$lit" >"$work/seen.yaml"
check "a scene of which something is in view" status 0 $draw "$work/seen.yaml" -o "$work/seen.png"
check "says nothing" test ! -s "$work/stderr"

# -- what each option does

check "a picture" status 0 $draw $example -o "$work/plain.png"
check "--layout=auto is wrong usage" status 2 $draw --layout=auto $example -o "$work/none.png"
check "which says whose it is" says '^matview: --layout=auto needs a set of materials (matc -d)'
check "of standard input" status 0 sh -c "cd '$work' && $draw -" <$example
check "a picture has a name that a shell takes" test -s "$work/stdin.png"
for option in --shape=cloth --shape=ground --camera=front --camera=left --camera=top --camera=low --camera=close --camera=3,-4,1 \
    --slot=diffuse --slot=normal; do
    check "$option" status 0 $draw $option $example -o "$work/other.png"
    check "shows something else" differ plain other
done
check "--camera that says what is so anyway" status 0 $draw --camera=0,0,9,0,0,0,50 --camera=-0.5,-2.1,1.2,0,0,0.3,30 $example -o "$work/last.png"
check "the last one counts" status 0 $draw --camera=-0.5,-2.1,1.2,0,0,0.3,30 $example -o "$work/once.png"
check "alone" same last once
for option in --shape=teapot --camera=behind --camera=0,0,5 --camera=1,2 --slot=colour --param=tint --param= --param==1 --size=0 --no-such=1; do
    check "$option is wrong usage" status 2 $draw $option $example -o "$work/none.png"
    check "which is said" says '^matview: '
    check "and draws nothing" test ! -e "$work/none.png"
done
check "a value that no option has" status 2 $draw --aa=sharp $example -o "$work/none.png"
check "is told from those that are" says "^matview: --aa: unknown value 'sharp'; expected auto, none, box, aniso; see"
for wrong in "--shape=plan plane" "--slot=norml normal" "--gl=elg egl" "--edges=covrage coverage" "--format=pgn png" "--shadows=maps map" "--indirect=marsh march" \
    "--tools=grid,axis axes" "--emit=fram frame" "--transparency=list lists" "--lights=al all" "--shap=plane --shape"; do
    check "a misspelt word: ${wrong% *}" status 2 $draw "${wrong% *}" $example -o "$work/none.png"
    check "is quoted, and the right one guessed" says "unknown .*'.*; did you mean '${wrong#* }'"
done
for wrong in "--size=x not 'x'" "--samples=9 not '9'" "--bits=1 not '1'" "--memory=0 not '0'" "--camera=frnt not 'frnt'" "--watch=3 takes no value" \
    "--frames=x not 'x'" "--time=x not 'x'" "--frame=1-2 not '1-2'" "--contact=tea.exr not 'tea.exr'"; do
    check "a value: ${wrong%% *}" status 2 $draw "${wrong%% *}" $example -o "$work/none.png"
    check "is quoted" says "[, ]${wrong#* }; see matview --help"
done
check "a picture of another ending" status 2 $draw $example -o "$work/none.bmp"
check "is told" says "ends in .png or .exr, or --format, not '.*none.bmp'"
check "an ending that --format excludes" status 2 $draw --format=exr $example -o "$work/none.png"
check "is told" says "the extension of --format, not '.*none.png'"
check "an ending of its own, with --format" status 0 $draw --format=png $example -o "$work/plain.part"
check "is the picture" cmp -s "$work/plain.part" "$work/plain.png"
check "an option without its value" status 2 $draw $example -o
check "is told" says '^matview: -o expects a value;'
check "--slot of a layout without it" status 1 $draw --layout=compact --slot=ior $example -o "$work/none.png"
check "says so" says 'the layout does not store that slot'

# -- all methods of shadows side by side: cells of 40 x 30 pixels, 6 between them, 12 below for the name

cat >"$work/scene.yaml" <<'EOF_SCENE'
image: { width: 40, height: 30 }
materials: { m: { material: Phong, diffuse: .5 } }
shadowMaps: { size: 64 }
lights: [{ light: Directional, direction: [1, 1, -1] }, { light: Point, position: [1, -2, 3], shadows: none }]
objects: [{ object: Plane, material: m }, { object: Sphere, material: m, transform: { translation: [0, 0, 1] } }]
EOF_SCENE
check "--compare" status 0 "$matview" --compare=shadows "$work/scene.yaml" -o "$work/compared.png"
check "has a cell for none, map, exact, and three hybrid ones at least" test "$(od -An -tu1 -j20 -N4 "$work/compared.png" | awk '{ print ($3 * 256 + $4 - 6) / 48 }')" -ge 2
check "--compare=indirect" status 0 "$matview" --compare=indirect "$work/scene.yaml" -o "$work/compared.png"
check "--compare=displacement of a scene that has none" status 1 "$matview" --compare=displacement "$work/scene.yaml" -o "$work/none.png"
printf 'image: { width: 64, height: 48 }\ndisplacement: { triangles: 300 }\nobjects:\n- { object: Sphere, detail: 8, material: { material: Phong, displacement: { map: Granite }, displacementScale: 0.2 } }\n' >"$work/rock.yaml"
check "--compare=displacement" status 0 "$matview" --compare=displacement --view=wireframe "$work/rock.yaml" -o "$work/compared.png"
sed '2s/300/200000/; 2a lights: [{ light: Directional, direction: [1, 1, -1] }]\nshadowMaps: { size: 4096 }' "$work/rock.yaml" >"$work/fine.yaml"
check "--compare=displacement of what is much finer than its cells, in seconds" status 0 timeout 60 "$matview" --compare=displacement --progress "$work/fine.yaml" -o "$work/compared.png"
check "says how far it is" says '8 of 9 methods drawn'
check "of pictures that no file can hold side by side" status 1 timeout 20 "$matview" --compare=shadows --size=16384 "$work/scene.yaml" -o "$work/none.png"
check "is told before one is drawn" says 'larger than 16384'
check "of a material" status 2 $draw --compare=shadows $example -o "$work/none.png"
check "says so" says 'only apply to scenes'
for option in --shadows=map --indirect=none --frame=0 --stats --emit=frame --bits=16; do
    check "--compare with $option" status 2 "$matview" --compare=shadows $option "$work/scene.yaml" -o "$work/none.png"
    check "says so" says 'it does not accept'
done

# -- the manual page has the options that --help has, and the words of each

"$matview" --help | grep -oE -- '--[a-z]+' | grep -vx -e --list -e --explain | sort -u >"$work/help.txt"
sed -n 's/^\.It//p' docs/reference/matview.1 | grep -oE '\\-[a-z]+' | sed 's/^../--/' | sort -u >"$work/manual.txt"
check "docs/reference/matview.1 has all options" diff "$work/help.txt" "$work/manual.txt"
# words OPTION: those behind it, up to the next space that follows no comma; (default) and what is explained left out
words() { "$matview" --help | sed -n "s/^  $1=[A-Z]*  *//p" | grep -oE '^([a-z]+( \(default\))?, )*[a-z]+' | tr -d ' ' | sed 's/(default)//g' | tr , '\n'; }
for option in --shape --shadows --indirect --transparency --lights --format --pass --gl --view; do
    for word in $(words "$option"); do
        check "docs/reference/matview.1 has $option=$word" eval "sed -n '/^.It Fl .-${option#--} /,/^.[IE][tl]/p' docs/reference/matview.1 | grep -qwE '$word'"
    done
done

# -- --mesh: a square that lies as the plane does is the plane, but for its size

plane='v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n'
printf "${plane}f 1/1 2/2 3/3 4/4\n" >"$work/plane.obj"
check "a mesh" status 0 $draw --mesh="$work/plane.obj" --camera=0,-2,2,0,0,0 $example -o "$work/mesh.png"
check "the plane" status 0 $draw --shape=plane --camera=0,-2.82842712,2.82842712,0,0,0 $example -o "$work/square.png"
check "is the same" same mesh square
check "a mesh that is not there" status 1 $draw --mesh="$work/no.obj" $example -o "$work/none.png"
check "is told" says 'no.obj: No such file'
check "and nothing drawn" test ! -e "$work/none.png"

# -- a material is a scene: what there is for one is there for the other

check "a material's light" status 0 $draw --view=light $example -o "$work/other.png"
check "is not its picture" differ plain other
check "--stats" status 0 $draw --stats $example -o "$work/other.png"
check "says what ran" says '^light *depth, gbuffer'
check "and is the same picture" same plain other
check "--emit=frame" status 0 $draw --emit=frame $example
check "says what would" grep -q '^light *depth, gbuffer' "$work/stdout"
check "16 bits" status 0 $draw --bits=16 $example -o "$work/deep.png"
check "are said in the file" test "$(od -An -tu1 -j24 -N1 "$work/deep.png" | tr -d ' ')" = 16
check "OpenEXR" status 0 $draw $example -o "$work/plain.exr"
check "is that" test "$(od -An -tx1 -N4 "$work/plain.exr" | tr -d ' ')" = 762f3101
check "tools" status 0 $draw --tools=axes $example -o "$work/other.png"
check "are drawn" differ plain other
check "in tiles, with progress" status 0 $matview --size=700 --memory=1 --progress $example -o "$work/other.png"
check "says how far it is" says 'of 700 rows drawn'
check "--slot is for the eye" status 2 $draw --slot=normal $example -o "$work/none.exr"

# -- a scene

scene="$matview --size=40 examples/scenes/solids.yaml"
check "a scene" status 0 $scene -o "$work/scene.png"
check "in its proportions" test "$(od -An -tx1 -j16 -N8 "$work/scene.png" | tr -d ' ')" = 0000002800000019
for view in light depth normal diffuse; do
    check "--view=$view" status 0 $scene --view=$view -o "$work/view.png"
    check "shows something else" differ scene view
done
check "--stats" status 0 $scene --stats -o "$work/view.png"
check "says what ran" says '^light *depth, gbuffer, shadow *light *[0-9][0-9.]*$'
check "and is the same picture" same scene view
check "--emit=frame" status 0 $scene --emit=frame
check "says what would" grep -q '^plane *depth, gbuffer *depth, gbuffer *the scene has an infinite plane$' "$work/stdout"
check "16 bits" status 0 $scene --bits=16 -o "$work/deep.png"
check "are said in the file" test "$(od -An -tu1 -j24 -N1 "$work/deep.png" | tr -d ' ')" = 16
check "OpenEXR" status 0 $scene -o "$work/scene.exr"
check "is that" test "$(od -An -tx1 -N4 "$work/scene.exr" | tr -d ' ')" = 762f3101
check "by its format, through a pipe" eval "$scene --format=exr -o - 2>/dev/null | cmp -s - '$work/scene.exr'"
check "of floats" status 0 $scene --bits=32 --view=normal -o "$work/floats.exr"
check "in a folder" status 0 $scene --format=exr -d "$work"
check "has its name" cmp -s "$work/solids.exr" "$work/scene.exr"
check "--edges=none" status 0 $scene --edges=none -o "$work/view.png"
check "is not so smooth" differ scene view
printf 'motion: { motion: Turntable, frames: 8 }\nobjects: [{ object: Box, material: { material: Phong, emissive: 1 } }]\n' >"$work/turn.yaml"
check "frames" status 0 $matview --size=16 --frames=0-2 "$work/turn.yaml" -o "$work/f-%02d.png"
check "are files" test -s "$work/f-00.png" -a -s "$work/f-01.png" -a -s "$work/f-02.png" -a ! -e "$work/f-03.png"
check "that differ" differ f-00 f-01
check "all in two frames" status 0 $matview --size=16 --frames=2 -d "$work" "$work/turn.yaml"
check "by the document's name" test -s "$work/turn-0001.png"
check "the second being the fourth of eight" status 0 $matview --size=16 --frame=4 "$work/turn.yaml" -o "$work/four.png"
check "as it is" same four turn-0001
check "a motion without the frame" status 2 $matview --frame=8 "$work/turn.yaml" -o "$work/none.png"
check "frames without a place for their number" status 2 $matview --frames=3 "$work/turn.yaml" -o "$work/none.png"
check "frames of what does not move" status 2 $scene --frames=3 -o "$work/none-%d.png"
check "in tiles" status 0 $matview --size=1200 --memory=1 --progress --view=depth examples/scenes/solids.yaml -o "$work/tiles.png"
check "says how far it is" says 'of 750 rows drawn'
check "no progress in a pipe" status 0 $scene -o "$work/view.png"
check "at all" test ! -s "$work/stderr"
check "to a folder that is not there" status 1 $scene -o "$work/no/scene.png"
check "is told by the file's name" says 'no/scene.png: No such file'
for option in --format=gif --edges=soft --bits=12 --bits=32 --memory=0 "--format=exr --bits=8"; do
    check "$option is wrong usage" status 2 $scene $option -o "$work/none.png"
    check "and draws nothing" test ! -e "$work/none.png"
done
for option in --shape=cube --camera=top --slot=normal --pass=sky --emit=ir; do
    check "$option is not for a scene" status 2 $scene $option -o "$work/none.png"
    check "and draws nothing" test ! -e "$work/none.png"
done
for option in --shadows=none --frames=3; do
    check "$option is not for a material" status 2 $draw $option $example -o "$work/none.png"
done
check "samples" status 0 $scene --samples=3 -o "$work/view.png"
check "are finer" differ scene view
check "as many as there may be" status 2 $scene --samples=9 -o "$work/none.png"
check "a view that there is not" status 1 $scene --view=deep -o "$work/none.png"
check "is told" says "unknown view 'deep'"
printf 'objects: [{ object: Spere }]\n' >"$work/faulty.yaml"
check "a scene with a fault" status 1 $matview "$work/faulty.yaml" -o "$work/none.png"
check "is told with its place" says "faulty.yaml:1:21: error: unknown object 'Spere'; did you mean 'Sphere'?"
check "and draws nothing" test ! -e "$work/none.png"

# -- --contact

# wide PICTURE, high PICTURE: what a PNG says of its size
wide() { printf %d "0x$(od -An -tx1 -j16 -N4 "$1" | tr -d ' ')"; }
high() { printf %d "0x$(od -An -tx1 -j20 -N4 "$1" | tr -d ' ')"; }
sheet="$draw --contact=$work/sheet.png"
check "a contact sheet" status 0 $sheet $example examples/wood.yaml examples/materials/chess.json
check "whose name is said" grep -qx "$work/sheet.png" "$work/stdout"
check "of five cells, in two rows" test "$(wide "$work/sheet.png")" -ge 72 -a "$(wide "$work/sheet.png")" -lt 120 -a "$(high "$work/sheet.png")" -ge 66
check "alone: no other picture" test "$(find "$work" . -maxdepth 1 -newer "$work/stderr" -name '*.png' | grep -vc sheet)" = 0
check "of one material" status 0 $sheet --material=board examples/materials/chess.json
check "in one cell" test "$(wide "$work/sheet.png")" -lt 48
rm "$work/sheet.png"
printf 'material: Phong\ndiffuse: { map: Cheker }\n' >"$work/faulty.yaml"
check "with a fault among the documents" status 1 $sheet $example "$work/faulty.yaml"
check "which is told" says "unknown map"
check "there is none" test ! -e "$work/sheet.png"
check "a contact sheet that no file can hold" status 1 timeout 20 "$matview" --size=16384 --contact="$work/large.png" $example $example
check "is told before it is drawn" says 'larger than 16384'
check "and is not there" test ! -e "$work/large.png"
check "--contact and -o" status 2 $sheet -o x.png $example
check "--contact and -d" status 2 $sheet -d x $example

# -- --param: as if it were written in the document

document() { printf 'material: Phong\ndiffuse: { param: tint, default: "%s" }\nshininess: { param: gloss, default: %s }\nspecular: 0.5\n' "$1" "$2" >"$work/$3.yaml"; }
document '#c04020' 0.2 before
document '#2040c0' 0.7 after
check "the document's values" status 0 $draw "$work/before.yaml" -o "$work/before.png"
check "others" status 0 $draw "$work/after.yaml" -o "$work/after.png"
check "show" differ before after
check "--param" status 0 $draw --param=tint=#2040c0 --param gloss=0.7 "$work/before.yaml" -o "$work/param.png"
check "is the same as in the document" same param after
check "a list" status 0 $draw --param='tint=[0.12549019607843137, 0.25098039215686274, 0.7529411764705882]' --param=gloss=0.7 "$work/before.yaml" -o "$work/param.png"
check "is that colour" same param after
{ echo 'colors: srgb' && cat "$work/before.yaml"; } >"$work/before_srgb.yaml"
{ echo 'colors: srgb' && cat "$work/after.yaml"; } >"$work/after_srgb.yaml"
check "where colours are sRGB" status 0 $draw --param=tint=#2040c0 --param=gloss=0.7 "$work/before_srgb.yaml" -o "$work/param.png"
check "in the document" status 0 $draw "$work/after_srgb.yaml" -o "$work/srgb.png"
check "they are so in --param" same param srgb
check "and others than linear ones" differ srgb after
check "one number for a colour" status 0 $draw --param=tint=0.3 "$work/before.yaml" -o "$work/grey.png"
check "of a param that is not there" status 1 $draw --param=hue=1 "$work/before.yaml" -o "$work/none.png"
check "names those that are" says "no param 'hue'; it has tint, gloss"
check "a colour for a number" status 1 $draw --param=gloss=#2040c0 "$work/before.yaml" -o "$work/none.png"
check "says how many it takes" says "'gloss' takes 1 numbers, not 3"
check "a map" status 2 $draw --param='gloss={ map: Wood }' "$work/before.yaml" -o "$work/none.png"
check "is no value" says 'no value of a param'
check "nothing was drawn" test ! -e "$work/none.png"

# -- --watch

# within NAME COMMAND...: the command succeeds within some seconds
within() {
    tries=100
    while [ $tries -gt 1 ] && ! eval "$2" >/dev/null 2>&1; do
        tries=$((tries - 1))
        sleep 0.1
    done
    check "$1" eval "$2"
}
drawn() { [ "$(grep -c "matview: drawn; watching $1 files" "$work/stderr")" = "$2" ]; }
colour() { printf 'defs: { paint: "%s" }\n' "$1" >"$work/palette.yaml"; }
colour '#ff0000'
printf 'include: palette.yaml\nmaterial: Phong\nemissive: { ref: paint }\n' >"$work/watched.yaml"
check "what red looks like" status 0 $draw "$work/watched.yaml" -o "$work/red.png"
colour '#00ff00'
check "and green" status 0 $draw "$work/watched.yaml" -o "$work/green.png"
colour '#ff0000'
$draw --watch "$work/watched.yaml" -o "$work/seen.png" 2>"$work/stderr" >"$work/stdout" &
pid=$!
within "--watch draws" 'same seen red && drawn 2 1'
sleep 0.1
colour '#00ff00'
within "a file that is included changes" 'same seen green && drawn 2 2'
printf 'defs: { paint: [' >"$work/palette.yaml"
within "a fault is told" 'says "palette.yaml:.*error" && says "not drawn"'
check "and the picture stays" same seen green
rm "$work/palette.yaml"
within "a file goes" 'says "cannot read.*palette.yaml"'
colour '#ff0000'
within "and comes back" 'same seen red'
mv "$work/watched.yaml" "$work/away.yaml"
within "the document goes" '[ $(grep -c "not drawn" "$work/stderr") -ge 3 ]'
mv "$work/away.yaml" "$work/watched.yaml"
within "and comes back" '[ $(grep -c "matview: drawn" "$work/stderr") -ge 4 ]'
check "no file is left beside the picture" test -z "$(find "$work" -name 'seen.png?*')"
kill -TERM $pid
wait $pid
check "a signal ends it, by its status" test $? = 143
pid=
# A .gltf is drawn again when its buffer changes: a triangle, whose third corner moves
floats() { for n in "$@"; do case $n in 0) printf '\000\000\000\000' ;; 1) printf '\000\000\200\077' ;; -1) printf '\000\000\200\277' ;; esac; done; }
cat >"$work/triangle.gltf" <<'END'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "buffers": [{"uri": "triangle.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]}]}
END
triangle="$draw --mesh=$work/triangle.gltf --camera=0,-3,0,0,0,0 $example"
floats -1 -1 0 1 -1 0 1 1 0 >"$work/triangle.bin"
check "a triangle" status 0 $triangle -o "$work/red.png"
floats -1 -1 0 1 -1 0 -1 1 0 >"$work/triangle.bin"
check "and another" status 0 $triangle -o "$work/green.png"
check "which looks else" differ red green
floats -1 -1 0 1 -1 0 1 1 0 >"$work/triangle.bin"
$triangle --watch -o "$work/seen.png" 2>"$work/stderr" >"$work/stdout" &
pid=$!
within "--watch draws a mesh" 'same seen red && drawn 3 1'
sleep 0.1
floats -1 -1 0 1 -1 0 -1 1 0 >"$work/triangle.bin"
within "its buffer changes" 'same seen green && drawn 3 2'
kill -TERM $pid
wait $pid
pid=

check "--watch of standard input" status 2 $draw --watch - </dev/null
check "--watch to standard output" status 2 $draw --watch $example -o -

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
