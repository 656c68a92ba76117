#!/bin/sh
# Tests batches by matc's command line: shared programs, the content of the output folder, and the
# use of the cache. batch.sh MATC. Run from the project's root.
set -u
matc=$1
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
. tests/check.sh
unset MATC_CACHE

silent() { ! [ -s "$work/stderr" ]; }
same() { diff -r "$1" "$2" >&2; }
differ() { ! diff -r "$1" "$2" >/dev/null; }
programs() { [ "$(ls "$1" | grep -c 'frag$')" = "$2" ] || { ls "$1" >&2 && false; }; }
# Names, bytes, inodes and times of all that is in a folder
snapshot() { (cd "$1" && find . -type f -exec stat -c '%n %i %y' {} + | sort && find . -type f -exec cksum {} + | sort); }
lacks() { ! grep -q -- "$1" "$2"; }
has() { grep -q -- "$1" "$2" || { echo "$2 lacks $1" >&2 && false; }; }

fast="$matc --no-validate"
picture=examples/engine/materials/images/weave.png

# -- programs that are one

# 4,000 colours, a line each: black, white, greys, equal ones, ones with 0 or 1 in some lanes
colors() {
    awk -v first="$1" -v last="$2" -v name="$3" 'BEGIN {
        print "materials:"
        for (i = first; i < last; i++) {
            r = i % 17 / 16; g = int(i / 17) % 17 / 16; b = int(i / 289) % 16 / 16
            if (i % 10 == 3) g = b = r
            printf "  %s%d: { material: Phong, diffuse: { map: RGBColor, r: %.4g, g: %.4g, b: %.4g } }\n", name, i, r, g, b
        }
    }'
}
colors 0 4000 c >"$work/colors.yaml"
check "4,000 colours" status 0 $fast -d "$work/uniform" --constants=uniform --stats "$work/colors.yaml"
check "are one program" only "$work/uniform" c0.frag manifest.json
check "of 4,000 materials" has '"materials": 4000' "$work/uniform/manifest.json"
check "counted so" says '4000 materials, 1 programs (1 gbuffer), 1 with numbers from a buffer'
# One, too: the packing of a constant colour is folded to words, and a word is a number whatever the colour.
check "with --constants=auto" status 0 $fast -d "$work/auto" "$work/colors.yaml"
check "they are one, too" only "$work/auto" c0.frag manifest.json
# Without that, a program for each of the colours that differ once packed: more than 1,000 of 17 x 17 x 14
head -41 "$work/colors.yaml" >"$work/forty.yaml"
check "with --constants=baked" status 0 $fast -d "$work/baked" --constants=baked "$work/forty.yaml"
check "every colour is a program" programs "$work/baked" "$(sed 1d "$work/forty.yaml" | cut -d: -f3- | sort -u | wc -l)"

# Documents that differ in names only are one program, which has the first one's words: with any number of threads, from the cache too
for word in clay loam sand; do
    printf 'defs:\n  %s: { map: Granite, frequency: 3 }\nmaterial: Phong\ndiffuse: { map: Blend, input: { ref: %s }, blend: [{ value: 0, input: red }, { value: 0.3, input: blue }, { value: 1, input: { ref: %s } }] }\n' \
        $word $word $word >"$work/$word.yaml"
done
for jobs in 1 3 8; do
    check "names alone, -j $jobs" status 0 $fast -d "$work/words$jobs" -j $jobs --cache="$work/wordsCache" "$work/loam.yaml" "$work/clay.yaml" "$work/sand.yaml"
    check "one program" only "$work/words$jobs" loam.frag manifest.json
    check "with the first one's words" has ' loam = ' "$work/words$jobs/loam.frag"
    check "the same bytes" same "$work/words1" "$work/words$jobs"
done
check "another is the first" status 0 $fast -d "$work/words" -j 3 --cache="$work/wordsCache" "$work/sand.yaml" "$work/loam.yaml"
check "its words" has ' sand = ' "$work/words/sand.frag"

# In a Checker black and white, 0 and 1 are folded away where they can be. Shapes differ by what is left of the select:
# a colour in all lanes, a grey, which is one number for all lanes, black or white.
awk 'BEGIN {
    print "materials:"
    for (i = 0; i < 400; i++) {
        r = i % 5 / 4; g = int(i / 5) % 5 / 4; b = int(i / 25) % 5 / 4
        printf "  x%d: { material: Phong, diffuse: { map: Checker, color1: [%g, %g, %g], color2: [%g, 0.3, %g] } }\n", i, r, g, b, g, b
    }
}' >"$work/checkers.yaml"
check "Checkers of 400 colours" status 0 $fast -d "$work/checkers" --constants=uniform "$work/checkers.yaml"
check "are one program" only "$work/checkers" manifest.json x0.frag
check "with --constants=auto" status 0 $fast -d "$work/checkers" "$work/checkers.yaml"
check "they are few" test "$(ls "$work/checkers" | grep -c 'frag$')" -le 8

# -- programs that are not

waves='Sin Cos Triangle Ramp Abs Sqr Sqrt Exp Ceil Floor Tan Atan'
{
    echo "materials:"
    for wave in $waves; do
        echo "  $wave: { material: Phong, diffuse: { map: Blend, blend: [{ value: 0, input: '#102030' }, { value: 1, input: '#405060' }]," \
            "input: { map: Gradient, direction: [1, 2, 3], waveForm: $wave } } }"
    done
} >"$work/waves.yaml"
check "waves" status 0 $fast -d "$work/waves" "$work/waves.yaml"
check "never meet" programs "$work/waves" "$(echo $waves | wc -w)"
cat >"$work/operations.yaml" <<'EOF'
materials:
  add: { material: Phong, diffuse: { map: Checker, color1: "#102030", color2: "#405060", input: { map: UVTransform, offsetU: 0.3 } } }
  times: { material: Phong, diffuse: { map: Checker, color1: "#102030", color2: "#405060", input: { map: UVTransform, scaleU: 0.3 } } }
  more: { material: Phong, diffuse: { map: Checker, color1: "#102030", color2: "#405060", input: { map: UVTransform, offsetU: 0.4 } } }
EOF
for mode in auto uniform baked; do
    check "add and multiply" status 0 $fast -d "$work/operations" --constants=$mode "$work/operations.yaml"
    if [ $mode = baked ]; then few=3; else few=2; fi # two that add share, but in baked programs
    check "never meet with $mode" programs "$work/operations" $few
    check "which has its own" test -s "$work/operations/times.frag"
done

# -- names and pipes

check "a document through a pipe" status 0 sh -c "cat '$work/forty.yaml' | $fast -d '$work/piped' /dev/stdin"
check "is read once" only "$work/piped" c0.frag manifest.json

sed 's/^  c/  other/' "$work/forty.yaml" >"$work/names.yaml"
check "equal materials of other names" status 0 $fast -d "$work/names" --constants=baked "$work/forty.yaml" "$work/names.yaml"
check "add no program" same "$work/names/c1.frag" "$work/baked/c1.frag"
check "add no file" programs "$work/names" "$(ls "$work/baked" | grep -c 'frag$')"
check "in the other order" status 0 $fast -d "$work/order" --constants=baked "$work/names.yaml" "$work/forty.yaml"
check "the first gives the name" test -s "$work/order/other0.frag" -a ! -e "$work/order/c0.frag"
check "of the same bytes" same "$work/names/c0.frag" "$work/order/other0.frag"

# -- threads

colors 100 140 k >"$work/k.yaml"
set -- "$work/forty.yaml" "$work/k.yaml" "$work/checkers.yaml" "$work/waves.yaml" "$work/operations.yaml" examples/checker.yaml \
    examples/carpenter.yaml examples/wood.yaml examples/image.yaml examples/materials/marble.yaml "$work/names.yaml"
for threads in 1 2 7; do
    check "-j$threads" status 0 $fast -j$threads -d "$work/j$threads" --pass=gbuffer,shadow,depth --emit=glsl,vertex,unpack,reflect,ir "$@"
    check "says nothing" silent
done
check "two threads write the same" same "$work/j1" "$work/j2"
check "seven threads write the same" same "$work/j1" "$work/j7"
check "--layout=auto" status 0 $fast -j1 -d "$work/auto1" --layout=auto --emit=glsl,unpack,layout "$@"
check "by two threads" status 0 $fast -j2 -d "$work/auto2" --layout=auto --emit=glsl,unpack,layout "$@"
check "writes the same" same "$work/auto1" "$work/auto2"

# -- faults

echo 'material: Fong' >"$work/bad1.yaml"
printf 'materials:\n  a: { material: Phong, difuse: 1 }\n  b: { material: Phong, specular: { map: Chekcer } }\n' >"$work/bad2.yaml"
: >"$work/bad3.yaml"
snapshot "$work/j1" >"$work/before"
for threads in 1 2 7; do
    check "faults with -j$threads" status 1 $fast -j$threads -d "$work/j1" "$work/bad1.yaml" examples/checker.yaml "$work/bad2.yaml" \
        "$work/none.yaml" "$work/forty.yaml" "$work/bad3.yaml"
    cp "$work/stderr" "$work/said$threads"
done
check "all are said, in the order of the inputs" test "$(grep -o '[a-z0-9]*\.yaml.*error\|none.yaml: No' "$work/said1" | sed 's/:.*//' | tr '\n' ' ')" = \
    "bad1.yaml bad2.yaml bad2.yaml none.yaml bad3.yaml "
check "the same by two threads" same "$work/said1" "$work/said2"
check "and by seven" same "$work/said1" "$work/said7"
snapshot "$work/j1" >"$work/after"
check "the folder is as it was" same "$work/before" "$work/after"
awk 'BEGIN {
    print "materials:"
    for (i = 0; i < 60; i++)
        printf "  m%d: { material: Phong, specular: %g, diffuse: { map: VolumeTurbulence, octaves: { param: n, default: 2 } } }\n", i, i / 60
}' >"$work/faulty.yaml"
for threads in 1 2 7; do
    check "faults of many materials" status 1 $fast -j$threads -d "$work/j1" "$work/faulty.yaml"
    check "are all said" test "$(grep -c 'error: octaves' "$work/stderr")" = 60
    cp "$work/stderr" "$work/said$threads"
done
check "in their order by two threads" same "$work/said1" "$work/said2"
check "and by seven, too" same "$work/said1" "$work/said7"
sed 's/octaves: .*default: 2 }/octaves: 2/' "$work/faulty.yaml" >"$work/shiny.yaml"
cat examples/layouts/lambert.yaml - >"$work/dull.yaml" <<'EOF'
constants:
  specular: [0, 0, 0]
EOF
sed -i 's/layout: lambert/layout: dull/' "$work/dull.yaml"
for threads in 1 7; do
    check "warnings of many materials" status 0 $fast -j$threads -d "$work/shiny" --layout="$work/dull.yaml" "$work/shiny.yaml"
    check "are all said, once" test "$(grep -c 'warning: layout dull' "$work/stderr")" = 59
done
check "a fault" status 1 $fast -d "$work/no" "$work/bad1.yaml"
check "makes no folder" test ! -e "$work/no"
check "--layout=auto of nothing" status 1 $fast -d "$work/no" --layout=auto "$work/none.yaml"
check "says it once" test "$(wc -l <"$work/stderr")" = 1
check "a folder that cannot be made" status 1 $fast -d "$work/no/such" examples/checker.yaml
check "a depfile that cannot be" status 1 $fast -d "$work/no" -MD -MF "$work/no/such/file" examples/checker.yaml
check "leaves nothing" test ! -e "$work/no"
mkdir -p "$work/way/wood.frag"
check "a folder in the way" status 1 $fast -d "$work/way" examples/checker.yaml examples/wood.yaml
check "is said" says 'wood.frag: Is a directory'
check "before anything is written" only "$work/way" wood.frag
mkdir "$work/pipe" && mkfifo "$work/pipe/checker.frag"
check "a pipe in the way" status 0 timeout 20 $fast -d "$work/pipe" examples/checker.yaml
check "is replaced" test -f "$work/pipe/checker.frag"
printf 'materials:\n  a: { material: Phong, transparency: { map: Checker } }\n  a.shadow: { material: RGBA, r: 0.5 }\n' >"$work/dotted.yaml"
check "a material called as another's shadow" status 1 $fast -d "$work/no" --pass=gbuffer,shadow "$work/dotted.yaml"
check "is told" says 'have the same name'
check "alone it may" status 0 $fast -d "$work/dotted" "$work/dotted.yaml"

mkdir "$work/own" && printf '{"material": "RGBA", "r": 1}\n' >"$work/own/rock.json" && cp "$work/own/rock.json" "$work/rock"
check "an output that would replace its document" status 1 $fast -d "$work/own" --emit=glsl,reflect "$work/own/rock.json"
check "is refused" says 'rock.json: an output would overwrite this input file'
check "and the document still there" same "$work/rock" "$work/own/rock.json"
check "from within the folder" sh -c "cd '$work/own' && ! '$(realpath "$matc")' --no-validate -d . --emit=reflect rock.json"
check "it is there, too" only "$work/own" rock.json
check "other outputs may" status 0 $fast -d "$work/own" "$work/own/rock.json"

# -- what was there

check "again" status 0 $fast -j2 -d "$work/j1" --pass=gbuffer,shadow,depth --emit=glsl,vertex,unpack,reflect,ir "$@"
snapshot "$work/j1" >"$work/after"
check "writes nothing" same "$work/before" "$work/after"
echo mine >"$work/j1/mine.frag"
echo mine >"$work/j1/notes"
check "fewer documents" status 0 $fast -d "$work/j1" "$work/forty.yaml"
check "leave what is theirs, and what is not matc's" only "$work/j1" c0.frag manifest.json mine.frag notes
sed -i 's/r: 0,/r: 0.9,/' "$work/forty.yaml"
ls -i "$work/j1/c0.frag" >"$work/inode"
check "other numbers" status 0 $fast -d "$work/j1" --stats "$work/forty.yaml"
check "change the manifest" says '1 files written'
check "but not the program" test "$(ls -i "$work/j1/c0.frag")" = "$(cat "$work/inode")"

# -- being ended in the middle; test_kill does it at every call

snapshot "$work/uniform" >"$work/before"
for pause in 0.01 0.03 0.05 0.08; do
    timeout -s INT $pause $fast -j2 -d "$work/uniform" --constants=baked "$work/colors.yaml" 2>/dev/null
    [ $? = 124 ] || continue
    ls "$work/uniform" | grep -q '^c1\.frag' && break # it was at its last step
    snapshot "$work/uniform" | grep -v 'matc-stage' >"$work/after"
    check "an interrupt" same "$work/before" "$work/after"
done
check "the next run" status 0 $fast -d "$work/uniform" --constants=uniform "$work/colors.yaml"
check "leaves nothing of the stage" test -z "$(ls -A "$work/uniform" | grep matc-stage)"

# -- lists, depfiles, passes, targets

printf 'examples/checker.yaml\r\n\r\n\n%s\r\n' "$work/operations.yaml" >"$work/list"
check "a list" status 0 $fast -d "$work/list.d" @"$work/list" examples/wood.yaml -MD
check "is what it names" has '"source": "examples/checker.yaml"' "$work/list.d/manifest.json"
for file in "$work/list" examples/checker.yaml "$work/operations.yaml" examples/wood.yaml; do
    check "the depfile" has "$file" "$work/list.d/manifest.d"
done
check "is of the manifest" has "^$work/list.d/manifest.json: " "$work/list.d/manifest.d"
check "a list that is not there" status 2 $fast -d "$work/no" @"$work/nothing"
: >"$work/empty"
check "a list of nothing" status 2 $fast -d "$work/no" @"$work/empty"
check "is no document" says 'no document'
check "included files" status 0 $fast -d "$work/deps" -MD examples/materials/marble.yaml examples/image.yaml --layout=examples/layouts/lambert.yaml
for file in examples/materials/palette.yaml examples/tiles.png examples/layouts/lambert.yaml; do
    check "are in the depfile" has "$file" "$work/deps/manifest.d"
done

cat >"$work/opacities.yaml" <<'EOF'
materials:
  opaque: { material: Phong, diffuse: { map: Leopard } }
  other: { material: Phong, diffuse: { map: Wood }, specular: 0.2 }
  holes: { material: Phong, diffuse: { map: Granite }, transparency: { map: Checker, color1: "#000000", color2: "#ffffff" } }
EOF
check "passes" status 0 $fast -d "$work/passes" --pass=gbuffer,shadow,depth "$work/opacities.yaml"
check "an opaque shadow is the depth program, of all" only "$work/passes" holes.frag holes.shadow.frag manifest.json opaque.depth.frag opaque.frag other.frag
check "of five uses" has '"fragment": "opaque.depth.frag", "materials": 5' "$work/passes/manifest.json"
check "a Checker discards" has discard "$work/passes/holes.shadow.frag"
check "by itself" lacks 'noise\|granite\|Granite\|lattice\|out vec\|out uvec\|normal' "$work/passes/holes.shadow.frag"
check "one function" test "$(grep -c '^[a-z].*(.*) {$' "$work/passes/holes.shadow.frag")" = 1
check "--material" status 0 $fast -d "$work/passes" --material=other "$work/opacities.yaml"
check "is the one" only "$work/passes" manifest.json other.frag
check "which is nowhere" status 1 $fast -d "$work/passes" --material=none "$work/opacities.yaml"

carpenter() { echo "{ map: Blend, blend: [{ value: 0.2, input: '#000000' }, { value: 0.8, input: '#ffffff' }], input: { map: Carpenter, color: $1, noise: $2, roughness: 0.9 } }"; }
{
    echo "materials:"
    echo "  one: { material: Phong, diffuse: $(carpenter 0.4 0.7), transparency: $(carpenter 0.1 0.3) }"
    echo "  two: { material: Phong, diffuse: $(carpenter 0.5 0.2), transparency: $(carpenter 0.6 0.9) }"
} >"$work/reliefs.yaml"
check "--textures of two Carpenters" status 0 $fast -d "$work/reliefs" --textures "$work/ktx" --pass=gbuffer,shadow "$work/reliefs.yaml"
check "share programs" programs "$work/reliefs" 2
check "and write a file each, in each pass" only "$work/ktx" one.carpenterTexture0.ktx one.carpenterTexture1.ktx one.shadow.carpenterTexture0.ktx \
    two.carpenterTexture0.ktx two.carpenterTexture1.ktx two.shadow.carpenterTexture0.ktx
check "none of which is another" test "$(cksum "$work"/ktx/*Texture[01].ktx | cut -d' ' -f1,2 | sort -u | wc -l)" = 4
for material in one two; do
    # the shadow has the transparency's relief, whatever its number is in the gbuffer
    check "a shadow's relief" sh -c "cmp -s '$work/ktx/$material.shadow.carpenterTexture0.ktx' '$work/ktx/$material.carpenterTexture0.ktx' ||
        cmp -s '$work/ktx/$material.shadow.carpenterTexture0.ktx' '$work/ktx/$material.carpenterTexture1.ktx'"
    check "is in the manifest" has "$work/ktx/$material.shadow.carpenterTexture0.ktx" "$work/reliefs/manifest.json"
done
targets=$("$matc" --list | sed -n '/^Targets/,/^$/s/^  \([a-z0-9]*\) .*/\1/p')
check "there are targets" test "$(echo "$targets" | wc -l)" -ge 5
for target in $targets; do
    check "$target" status 0 "$matc" --target=$target -d "$work/$target" "$work/checkers.yaml" examples/wood.yaml --pass=gbuffer,shadow
    check "has buffers" has '"constants": {"block": "Constants"' "$work/$target/manifest.json"
done
check "old GLSL has uniforms" has '^uniform .*_constant2*;' "$work/glsl110/x0.frag"
check "SPIR-V twice" status 0 "$matc" --target=spirv --emit=glsl,spirv -d "$work/spirv" examples/wood.yaml
check "is one file" only "$work/spirv" manifest.json wood.spv
check "named once" test "$(grep -o '"spirv": "wood' "$work/spirv/manifest.json" | wc -l)" = 1
for color in ff0000 00ff00; do
    printf 'material: Phong\ndiffuse: { param: tint, default: "#%s" }\n' $color >"$work/tint$color.yaml"
done
check "params" status 0 $fast -d "$work/params" "$work/tintff0000.yaml" "$work/tint00ff00.yaml"
check "are one program" only "$work/params" manifest.json tintff0000.frag
check "with the first one's default" has '"uniforms": {"tint": \[1.0, 0.0, 0.0\]}' "$work/params/manifest.json"
check "and the second one's" has '"uniforms": {"tint": \[0.0, 1.0, 0.0\]}' "$work/params/manifest.json"

# -- the cache

# run NAME OPTION...: with a cache and without, which must be the same
cached() {
    name=$1
    shift
    rm -rf "$work/without" "$work/with"
    check "$name" status 0 $fast -d "$work/with" -MD "$@"
    mv "$work/with" "$work/without"
    check "$name, with a cache" status 0 $fast -d "$work/with" -MD --cache "$work/cache" "$@"
    check "$name: the same" same "$work/without" "$work/with"
}
stored() { "$matc" --cache-stats --cache "$work/cache" | awk -v key="$1" '$1 == key { print $2 }'; }
mkdir "$work/docs"
cp examples/checker.yaml examples/image.yaml examples/tiles.png examples/wood.yaml examples/materials/marble.yaml examples/materials/palette.yaml \
    examples/layouts/lambert.yaml "$work/docs"
head -9 "$work/checkers.yaml" >"$work/docs/checkers.yaml"
set -- "$work/docs/checker.yaml" "$work/docs/image.yaml" "$work/docs/wood.yaml" "$work/docs/marble.yaml" "$work/docs/checkers.yaml" "$work/opacities.yaml"
cached "cold" -j1 "$@"
misses=$(stored misses)
cached "warm" -j1 "$@"
check "has all" test "$(stored misses)" = "$misses" -a "$(stored hits)" -gt 0
cached "by two threads" -j2 "$@"
all="$*"
set -- "$work/docs/image.yaml" "$work/docs/checkers.yaml" "$work/opacities.yaml"
# Every option that says what is written. None of these runs may get what another one kept.
for options in --target=glsl110 --target=glsl450 --target=essl300 --pass=depth --pass=shadow --pass=gbuffer,shadow --pass=shadow,gbuffer --pass=plane --pass=sky \
    --pass=value "--pass=value --slot=normal" --layout=thesis --layout=integer --layout=auto "--layout=auto --layout-error=0.02" \
    "--layout=$work/docs/lambert.yaml" --precision=exact --precision=balanced --constants=uniform --constants=baked --noise=groimp --noise=simplex \
    --coordinates=long --powers=pow --powers=compensated --trigonometry=bounded --aa=box --aa=aniso --derivatives=analytic -O0 -O1 \
    --emit=vertex --emit=glsl,reflect --emit=unpack --emit=layout --emit=ir,dot --emit=spirv --emit=tree "--target=glsl450 --emit=glsl" "--target=glsl450 --emit=glsl,compute" --check --stats --diagnostics=json; do
    cached "$options" $options "$@"
done
cached "--material" --material=holes "$work/opacities.yaml"
cached "another --material" --material=opaque "$work/opacities.yaml"
cached "no --material" "$work/opacities.yaml"
check "--textures" status 0 $fast --cache "$work/cache" -d "$work/with" --textures "$work/ktx2" "$work/reliefs.yaml"
check "are not kept" test -s "$work/ktx2/two.carpenterTexture1.ktx"
set -- $all
cached "before changes" "$@"
sed -i 's/#cebe9a/#ceb09a/' "$work/docs/checker.yaml"
cached "a document changed" "$@"
sed -i 's/[0-9]\.[0-9]/0.8/' "$work/docs/palette.yaml"
cached "an included file changed" "$@"
cp "$work/docs/tiles.png" "$work/small.png"
cp "$picture" "$work/docs/tiles.png"
cached "a picture changed" "$@"
check "a picture goes" status 0 mv "$work/docs/tiles.png" "$work/tiles.png"
check "is a fault" status 1 $fast -d "$work/with" --cache "$work/cache" "$@"
mv "$work/small.png" "$work/docs/tiles.png"
cached "it comes back" "$@"
sed 's/bits: 8/bits: 7/' examples/layouts/lambert.yaml >"$work/docs/lambert.yaml"
cached "a layout changed" "--layout=$work/docs/lambert.yaml" "$@"
cp "$work/docs/lambert.yaml" "$work/docs/other.yaml"
cached "a layout of another name" "--layout=$work/docs/other.yaml" --emit=glsl,unpack,layout "$@"
cached "all cases of the layout" --cases=all --emit=glsl,unpack "$@"
mkdir "$work/elsewhere" && cp "$work/docs/image.yaml" "$work/elsewhere" && cp "$work/docs/tiles.png" "$work/elsewhere"
cached "the same document elsewhere" "$work/elsewhere/image.yaml"

# A program is kept once, whichever documents come to it: each alone, all together, in the other order, with other numbers in the buffer
entries() { "$matc" --cache-stats --cache "$work/$1" | sed -n 's/^entries *//p'; }
mkdir "$work/equal" && sed -n '2,41p' "$work/colors.yaml" | awk -v to="$work/equal" '{ print "materials:" > (to "/d" NR ".yaml"); print > (to "/d" NR ".yaml") }'
for document in "$work"/equal/*; do $fast -d "$work/alone" --constants=uniform --cache "$work/once" "$document"; done
check "forty documents of one program" test "$(entries once)" = 41
check "together" status 0 $fast -d "$work/alone" --constants=uniform --cache "$work/once" "$work"/equal/*
check "in the other order" status 0 $fast -d "$work/alone" --constants=uniform --cache "$work/once" $(ls -r "$work"/equal/*)
check "are no more entries" test "$(entries once)" = 41
check "nor misses" test "$("$matc" --cache-stats --cache "$work/once" | sed -n 's/^misses *//p')" = 40

# Every entry damaged, one way after the other
for way in 'truncate -s -1 "$file"' ': >"$file"' 'printf X | dd of="$file" bs=1 seek=70 conv=notrunc 2>/dev/null' 'printf XX | dd of="$file" bs=1 conv=notrunc 2>/dev/null' \
    'echo more >>"$file"' 'head -c 300 /dev/zero >"$file"'; do
    find "$work/cache" -mindepth 2 -type f | while read -r file; do eval "$way"; done
    damaged=$(stored damaged)
    cached "entries damaged by $way" $all
    check "are found" test "$(stored damaged)" -gt "$damaged"
done

rm -rf "$work/two.d"
$fast -j2 -MD -MT "$work/with/manifest.json" --cache "$work/both" -d "$work/two.d" $all 2>"$work/one.err" &
first=$!
check "two at once" status 0 $fast -j2 -MD -MT "$work/with/manifest.json" --cache "$work/both" -d "$work/two.d" $all
wait $first
check "are both fine" test $? = 0
check "write the same" same "$work/without" "$work/two.d"
check "leave no stage" test -z "$(ls -A "$work/two.d" | grep matc-stage)"

check "--cache-stats" status 0 "$matc" --cache-stats --cache "$work/cache"
check "counts" test "$(stored entries)" -gt 10
check "--cache-limit" status 0 $fast --cache "$work/cache" --cache-limit=1 -d "$work/with" --constants=baked "$work/checkers.yaml"
check "keeps to it" test "$(stored bytes)" -le 1048576
check "is at least 1" status 2 $fast --cache "$work/cache" --cache-limit=0 -d "$work/with" examples/wood.yaml
check "MATC_CACHE" status 0 env MATC_CACHE="$work/env" $fast -d "$work/with" examples/wood.yaml
check "says the same" test -s "$work/env/statistics"
echo file >"$work/file"
check "a cache that cannot be" status 1 $fast --cache "$work/file/cache" -d "$work/no" examples/wood.yaml
check "writes nothing" test ! -e "$work/no"
mkdir "$work/full"
(cd "$work/full" && touch $(awk 'BEGIN { for (i = 0; i < 256; i++) printf "%02x ", i }')) # files, where its folders go
check "a cache that keeps nothing" status 0 $fast -j2 --cache "$work/full" -d "$work/with" -MD $all
check "is told once" test "$(grep -c 'warning: the cache' "$work/stderr")" = 1
check "and no reason to fail" same "$work/without" "$work/with"

# -- cases of the layout that are read back

cat >"$work/phongs.yaml" <<END
materials:
  rough: { material: Phong, diffuse: .5, specular: .2 }
  matt: { material: Phong, diffuse: .7 }
END
# the most common kinds of Principled, as tests/bench/surfaces.def has them
cat >"$work/common.yaml" <<END
materials:
  plastic: { material: Principled, baseColor: '= [u, v, .5 * u * v]', roughness: '= .1 + .9 * u', ior: '= 1.3 + .4 * v' }
  metal: { material: Principled, baseColor: '= [.9, .4 + .5 * u, .9 * v]', metalness: '= v', specularColor: '= [1, v, u]' }
  painted: { material: Principled, baseColor: '= [u, v, .02]', coat: '= v', coatRoughness: '= u', coatColor: '= [1, v, u]' }
  cloth: { material: Principled, baseColor: '= [u, .1, v]', fuzz: '= u', fuzzColor: '= [v, u, 1]', fuzzRoughness: '= v' }
END
unpacked() { wc -c <"$work/$1/compact.unpack.glsl"; }
for set in phongs common; do
    check "$set" status 0 $matc -d "$work/$set" --cache "$work/cases" --emit=glsl,unpack "$work/$set.yaml"
    check "$set with all cases" status 0 $matc -d "$work/$set-all" --cache "$work/cases" --emit=glsl,unpack --cases=all "$work/$set.yaml"
    check "$set again" status 0 $matc -d "$work/$set-again" --cache "$work/cases" --emit=glsl,unpack --cases=used "$work/$set.yaml"
    check "which are what the cache gives" cmp -s "$work/$set/compact.unpack.glsl" "$work/$set-again/compact.unpack.glsl"
    check "the manifest lists all" grep -q '"cases": \[0, 1, 2, .*, 31\]' "$work/$set-all/manifest.json"
    check "programs are the same" cmp -s "$(ls "$work/$set"/*.frag | head -1)" "$(ls "$work/$set-all"/*.frag | head -1)"
done
check "Phongs take the first case" grep -q '"cases": \[0\]' "$work/phongs/manifest.json"
check "which is read by 3 KB" test "$(unpacked phongs)" -le 3072
check "the common kinds by 8" test "$(unpacked common)" -le 8192
check "all cases take more" test "$(unpacked phongs-all)" -gt 20000
check "and are those of a document alone" status 0 $matc --emit=unpack examples/checker.yaml -o "$work/alone.glsl"
check "to the byte" cmp -s "$work/alone.glsl" "$work/phongs-all/compact.unpack.glsl"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
