#!/bin/sh
# Tests the command line of matc: command_line.sh MATC. Run from the project's root.
set -u
matc=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/check.sh

prints() { grep -q -- "$1" "$work/stdout"; }
# The second file names the same bytes as the first
same() { cmp -s "$1" "$2"; }

example=examples/checker.yaml
fast="$matc --no-validate"

check "writes to standard output" status 0 $fast $example
check "a shader" prints '^#version 330 core'
check "-o FILE" status 0 $fast $example -o "$work/a.frag"
$fast $example >"$work/b.frag"
check "the same bytes" same "$work/a.frag" "$work/b.frag"
check "-oFILE" status 0 $fast $example -o"$work/c.frag"
check "-o -" status 0 $fast $example -o -
$fast - <$example | sed "s/<stdin>:/$(basename $example):/" >"$work/d.frag"
check "standard input" same "$work/a.frag" "$work/d.frag"
check "validates" status 0 "$matc" $example -o "$work/a.frag"

# A transform and a turbulence over one another: each has three components, which all come from three components of the one below
{
    echo 'defs:'
    echo '  k0: { map: XYZTransform, transform: { rotation: [0.1, 0.2, 0.3] } }'
    for i in $(seq 1 60); do
        [ $((i % 2)) = 1 ] && echo "  k$i: { map: Turbulence, input: { ref: k$((i - 1)) } }" ||
            echo "  k$i: { map: XYZTransform, transform: { rotation: [0.1, 0.2, 0.3] }, input: { ref: k$((i - 1)) } }"
    done
    echo 'material: Phong'
    echo 'diffuse: { map: Wood, input: { ref: k60 } }'
} >"$work/chain.yaml"
check "a chain of 60 ends under --coordinates=long" status 0 timeout 10 $fast --coordinates=long "$work/chain.yaml"
check "and under --precision=exact" status 0 timeout 10 $fast --precision=exact "$work/chain.yaml"
# Filters within filters, over maps
{
    printf 'material: Phong\ndiffuse: '
    for i in 1 2 3 4; do printf '{ map: Smooth3D, input: '; done
    for i in $(seq 1 40); do printf '{ map: Blend, input: '; done
    printf 0.5
    for i in $(seq 1 44); do printf ' }'; done
    echo
} >"$work/filters.yaml"
check "--eval is bounded" status 2 timeout 60 "$matc" --eval 'u=0.5' "$work/filters.yaml"
check "and says so" says 'too many operations'
check "so is measuring" status 1 timeout 60 $fast --max-error=0.1 "$work/filters.yaml" -o "$work/none.frag"
check "which says so" says '^matc: error: --max-error: its values at 2048 points take .* too many operations'
{
    printf 'material: Phong\ndiffuse: { map: Blend, blend: ['
    for i in $(seq 1 300); do printf '{ value: { param: p%d, default: %d }, input: 0.5 }, ' $i $i; done
    echo '] }'
} >"$work/refused.yaml"
for option in --max-error=0.1 --pareto; do
    check "$option of a refused material" status 1 $fast $option "$work/refused.yaml"
    check "says why, where" says 'refused.yaml:2:31: error: more than 256 items'
done

check "no document is wrong usage" status 2 "$matc"
check "an unknown option is wrong usage" status 2 "$matc" --frobnicate $example
check "and is quoted" says "unknown option '--frobnicate'; see"
check "a misspelt one" status 2 "$matc" --tarket=glsl330 $example
check "is guessed" says "unknown option '--tarket'; did you mean '--target'?"
check "a flag with a value" status 2 "$matc" --watch=yes $example
check "is told" says '--watch takes no value'
check "an option without its value" status 2 "$matc" $example --aa
check "lists the values" says '--aa expects a value: auto, none, box, aniso'
check "--cases without its value" status 2 "$matc" $example --cases
check "lists the values, too" says '--cases expects a value: used, all; see'
for wrong in "--target=gls330 glsl330" "--pass=gbufer gbuffer" "--slot=difuse diffuse" "--layout=compct compact" "--precision=exakt exact" \
    "--noise=latice lattice" "--constants=unifrom uniform" "--aa=boxx box" "--emit=glls glsl" "--diagnostics=jsn json" "--schema=layot layout" \
    "--gl=egll egl" "--list=map maps" "--explain=Cheker Checker" "--material=checkr checker" "--powers=sqaring squaring"; do
    value=${wrong% *} value=${value#*=}
    check "a misspelt value: ${wrong% *}" status "$([ "${wrong%%=*}" = --material ]; echo $((1 + ($? != 0))))" $fast "${wrong% *}" $example -o "$work/none.frag"
    check "is quoted, and the right one guessed" says "'$value'.*; did you mean '${wrong#* }'"
done
check "and what there is is listed" status 2 $fast --target=hlsl $example
check "by name" says "target: unknown value 'hlsl'; expected glsl110, glsl330, glsl450, essl300, spirv"
for wrong in "-O5 5 expected 0, 1, 2; see" "--eval=u=x x is not a number; a point" "--eval=w=3 w expected px, py, .*, ior, ex, .*, time, objectRandom, front; see" "--eval=fornt=1 fornt expected .*; did you mean 'front'" \
    "--eval=u u is not channel=number" "-Wno-foo foo expected unquoted_color, .*, flat_displacement; see"; do
    what=${wrong#* }
    check "a word: ${wrong%% *}" status 2 $fast "${wrong%% *}" $example -o "$work/none.frag"
    check "is quoted, with what there is" says "'${what%% *}'[,;]\{0,1\} ${what#* }"
done
for wrong in -j0 --cache-limit=none --max-error=x --range=-1 --layout-error=2; do
    check "a number: $wrong" status 2 $fast -d "$work/none" "$wrong" $example
    check "is quoted" says ", not '[-x0none2]*1*'"
done
for kind in materials maps presets aliases waves colors channels slots targets passes normals layouts encodings choices warnings noise aa; do
    check "--list=$kind" status 0 "$matc" --list=$kind
done
check "--list maps, too" status 0 "$matc" --list maps
check "lists them" prints '^  Checker '
check "and nothing else" test "$(grep -c -e Phong -e glsl330 "$work/stdout")" = 0
check "the list of all" test "$("$matc" --list | wc -l)" -gt 150
check "--layout" status 0 $fast --layout=compact $example
check "writes words" prints 'out uvec4 fragment0'
check "whole numbers are not for GLSL 1.10" status 1 $fast --layout=integer --target=glsl110 $example
check "and it says so" says 'layout integer needs integer render targets, which glsl110 does not support'
check "an unknown layout is wrong usage" status 2 "$matc" --layout=wide $example
check "an unknown target is wrong usage" status 2 "$matc" --target=hlsl $example
check "its name is said" says 'target'
check "a missing file" status 1 "$matc" "$work/none.yaml"
check "is named" says 'none.yaml'
check "-o and -d exclude each other" status 2 "$matc" $example -o x -d y
check "several documents need -d" status 2 "$matc" $example examples/wood.yaml -o "$work/x"

printf 'material: Phong\ndiffuse: { map: Cheker }\n' >"$work/bad.yaml"
echo precious >"$work/kept.frag"
check "a fault is status 1" status 1 "$matc" "$work/bad.yaml" -o "$work/kept.frag"
check "with its place" says 'bad.yaml:2:17: error: '
echo precious >"$work/precious"
check "an existing output is left as it was" same "$work/precious" "$work/kept.frag"
check "JSON diagnostics" status 1 "$matc" --diagnostics=json "$work/bad.yaml"
check "name the kind" says '"kind": "unknown_map"'
printf 'material: Phong\ndiffuse: #ff0000\nspecular: #00ff00\n' >"$work/doubtful.yaml"
check "a warning ends nothing" status 0 $fast "$work/doubtful.yaml"
check "and says what it is called" says 'doubtful.yaml:2:10: warning: .* \[-Wunquoted_color\]$'
check "and so does the next" says 'doubtful.yaml:3:11: warning: '
check "-Wno-NAME" status 0 $fast -Wno-unquoted_color "$work/doubtful.yaml"
check "says nothing" test ! -s "$work/stderr"
check "-Werror" status 1 $fast -Werror "$work/doubtful.yaml" -o "$work/none.frag"
check "is an error" says 'doubtful.yaml:2:10: error: .* \[-Werror=unquoted_color\]$'
check "and so are further ones" says 'doubtful.yaml:3:11: error: '
check "of a set, too" status 1 $fast -Werror -d "$work/none" "$work/doubtful.yaml"
check "-Werror=NAME" status 0 $fast -Werror=unordered_items "$work/doubtful.yaml"
check "the last counts" status 0 $fast -Werror -Wno-error=unquoted_color "$work/doubtful.yaml"
for way in "" -Wno-unquoted_color -Werror; do
    check "with a cache, first: $way" status "$([ "$way" = -Werror ]; echo $((1 - $?)))" $fast $way -d "$work/w" --cache "$work/wc" "$work/doubtful.yaml"
    cp "$work/stderr" "$work/first"
    check "and then: $way" status "$([ "$way" = -Werror ]; echo $((1 - $?)))" $fast $way -d "$work/w" --cache "$work/wc" "$work/doubtful.yaml"
    check "it says the same" same "$work/first" "$work/stderr"
done
printf 'material: Phong\ndiffuse: "#808080"\n' >"$work/hex.yaml"
check "hex colours without colors: are advised about" status 0 $fast "$work/hex.yaml"
check "in a note" says 'hex.yaml:2:10: note: .*`colors: srgb`.* \[-Wlinear_colors\]$'
check "which is no error" status 0 $fast -Werror "$work/hex.yaml"
check "is given once" test "$(grep -c note: "$work/stderr")" = 1
check "is silent by -Wno-linear_colors" status 0 $fast -Wno-linear_colors "$work/hex.yaml"
check "says nothing" test ! -s "$work/stderr"
check "nor in a batch" status 0 $fast "$work/hex.yaml" -d "$work/hexes"
check "says nothing" test ! -s "$work/stderr"
check "unless it is named" status 0 $fast -Wlinear_colors "$work/hex.yaml" -d "$work/hexes"
check "says so" says 'note: '
check "a warning that is none is wrong usage" status 2 $fast -Wno-unquoted_colour "$work/doubtful.yaml"
check "which suggests" says "^matc: -W: unknown value 'unquoted_colour'; expected unquoted_color, .*; did you mean 'unquoted_color'"
# Whatever is wrong, standard error is nothing but JSON
is_json() { grep -q . "$work/stderr" && ! grep -vE '^(\[|\]| \{"severity": .*"message": ".*\},?)$' "$work/stderr" >&2; }
printf 'materials: { a: { material: Phong }, b: { material: Phong } }\n' >"$work/several.yaml"
json="$fast --diagnostics=json"
check_json() {
    check "in JSON: $*" status "$@"
    check "all of it: $*" is_json
}
check_json 1 $json "$work/none.yaml"
check "names the file" says '"kind": "run".*"subject": ".*none.yaml"'
check_json 1 $json $example -o "$work/no/such/folder.frag"
check_json 1 $json -d "$work/jsons" $example "$work/none.yaml"
check_json 1 $json -d "$work/none.yaml/below" $example
check_json 1 $json --layout="$work/none.yaml" $example
check_json 1 $json --layout="$work/bad.yaml" $example
check_json 1 $json "$work/several.yaml"
check_json 1 $json --material=c "$work/several.yaml"
check_json 1 $json --max-error=1e-9 $example
check_json 2 $json --frobnicate $example
check_json 2 "$matc" --frobnicate $example --diagnostics=json
check_json 2 "$matc" --diagnostics=json
check_json 2 $json -o x -d y $example
check_json 2 $json --eval 'q=1' $example
check_json 2 $json @"$work/none.yaml"
check_json 2 $json --explain nothing
check_json 1 $json -d "$work/jsons" -j 1 --cache "$work/bad.yaml/cache" $example
mkdir "$work/none"
check "nothing is written" status 1 "$matc" "$work/bad.yaml" -d "$work/none"
check "not even a temporary file" test -z "$(ls "$work/none")"
check "an output that cannot be written" status 1 $fast $example -o "$work/no/such/folder.frag"
check "says why" says 'folder.frag'

check "-d DIR" status 0 $fast -d "$work/many" $example examples/wood.yaml --emit=glsl,vertex,unpack,reflect,ir,dot,tree
check "writes a file each" only "$work/many" checker.dot checker.frag checker.ir checker.json checker.tree \
    checker.vert compact.unpack.glsl manifest.json wood.dot wood.frag wood.ir wood.json wood.tree wood.vert
mkdir "$work/some"
check "one fault in a set" status 1 $fast -d "$work/some" "$work/bad.yaml" $example
check "writes nothing of it" test -z "$(ls -A "$work/some")"
printf 'materials:\n  red: { material: RGBA, r: 1 }\n  blue: { material: RGBA, b: 1 }\n' >"$work/two.yaml"
check "several materials need a choice" status 1 $fast "$work/two.yaml"
check "which lists them" says 'blue'
check "--material" status 0 $fast --material red "$work/two.yaml"
check "-d takes all" status 0 $fast -d "$work/two" "$work/two.yaml"
check "which differ in a number only" only "$work/two" manifest.json red.frag
check "unless it stands in the program" status 0 $fast -d "$work/two" --constants=baked "$work/two.yaml"
check "one file each" only "$work/two" blue.frag manifest.json red.frag
printf 'materials:\n  good: { material: RGBA }\n  bad: { material: Phong, diffuse: { map: VolumeTurbulence, octaves: { param: n, default: 2 } } }\n' >"$work/half.yaml"
mkdir "$work/half"
check "a fault in one material" status 1 $fast -d "$work/half" "$work/half.yaml"
check "writes none of the document" test -z "$(ls "$work/half")"
mkdir "$work/x" && cp $example "$work/x/"
printf 'defs: { paint: "#804020" }\n' >"$work/palette.yaml"
printf 'include: palette.yaml\nmaterial: Phong\ndiffuse: { ref: paint }\n' >"$work/painted.yaml"
printf '%s\n' "$work/palette.yaml" "$work/painted.yaml" >"$work/list"
check "definitions among documents" status 0 $fast -d "$work/painted" "$work/palette.yaml" "$work/painted.yaml"
check "are told" says 'palette.yaml:1:1: note: the document only contains definitions'
check "and make no file" only "$work/painted" manifest.json painted.frag
check "of a list, too" status 0 $fast -d "$work/painted" "@$work/list" --cache "$work/painted.cache"
check "and out of a cache" status 0 $fast -d "$work/painted" "@$work/list" --cache "$work/painted.cache"
check "and for --layout=auto" status 0 $fast -d "$work/painted" "@$work/list" --layout=auto
check "alone there is nothing to compile" status 1 $fast -d "$work/alone" "$work/palette.yaml"
check "which is an error" says 'error: no document has a material'
check "without -d, too" status 1 $fast "$work/palette.yaml" -o "$work/none.frag"
check "which is one" says 'error: the document has no material'
check "but it has a tree" status 0 $fast "$work/palette.yaml" --emit=tree
check "a fault in definitions is one" status 1 sh -c "printf 'defs: { paint: redd }' | $fast -d '$work/alone' - $example"
(cd examples/materials && "$matc" --no-validate -d "$work/readme" *.yaml) >"$work/stdout" 2>"$work/stderr"
check "README's matc -d out/ *.yaml, in examples/materials" test $? = 0 -a -s "$work/readme/marble.frag"
check "two documents of one name" status 1 $fast -d "$work/same" $example "$work/x/checker.yaml"
check "are not written over each other" says "two materials have this name"

check "spirv" status 0 "$matc" --target=spirv $example -o "$work/a.spv"
check "has its magic number" test "$(od -An -tx4 -N4 "$work/a.spv" | tr -d ' ')" = 07230203
rm "$work/a.spv"
check "spirv by the suffix" status 0 "$matc" $example -o "$work/a.spv"
check "has its magic number, too" test "$(od -An -tx4 -N4 "$work/a.spv" | tr -d ' ')" = 07230203
check "a vertex program's" status 0 "$matc" $example --emit=vertex -o "$work/a.vert.spv"
check "is SPIR-V" test "$(od -An -tx4 -N4 "$work/a.vert.spv" | tr -d ' ')" = 07230203
check "a suffix selects an output" status 0 $fast $example -o "$work/a.json"
check "which is JSON" grep -q '"target": "glsl330"' "$work/a.json"
check "also of a vertex program" status 0 $fast $example -o "$work/a.vert"
check "which is one" grep -q "vertex program" "$work/a.vert"
check "any other suffix selects none" status 0 $fast $example -o "$work/a.txt"
check "and holds the fragment program" grep -q "^#version" "$work/a.txt"
rm -f "$work/b.spv"
check "a target that the suffix contradicts" status 2 $fast $example --target=glsl450 -o "$work/b.spv"
check "is an error that names the option" says "-o $work/b.spv would hold GLSL: for SPIR-V give --target=spirv"
check "and writes nothing" test ! -e "$work/b.spv"
check "SPIR-V in a .frag" status 2 $fast $example --target=spirv -o "$work/b.frag"
check "is one, too" says "would hold SPIR-V: for GLSL ask for no SPIR-V, or name a file .spv"
check "an output that the suffix contradicts" status 2 $fast $example --emit=ir -o "$work/b.json"
check "is one" says "is the name of --emit=reflect, and would hold --emit=ir"

check "-MD" status 0 $fast -MD examples/image.yaml -o "$work/image.frag"
check "writes a depfile" grep -q "image.frag: examples/image.yaml" "$work/image.frag.d"
check "that names the picture" grep -q "examples/tiles.png" "$work/image.frag.d"
check "-MF and -MT" status 0 $fast -MD -MF "$work/deps" -MT goal examples/materials/marble.yaml -o "$work/m.frag"
check "with the goal" grep -q "^goal: examples/materials/marble.yaml" "$work/deps"
check "and the included file" grep -q "examples/materials/palette.yaml" "$work/deps"

mkdir -p "$work/include_a" "$work/include_b"
printf 'defs: { paint: "#ff0000" }\n' >"$work/include_a/shade.yaml"
printf 'defs: { paint: "#0000ff", other: 1 }\n' >"$work/include_b/shade.yaml"
printf 'include: shade.yaml\nmaterial: Phong\ndiffuse: { ref: paint }\n' >"$work/shaded.yaml"
check "an included file that is nowhere" status 1 $fast "$work/shaded.yaml" -o "$work/none.frag"
check "is told" says "shaded.yaml:1:10: error: cannot read 'shade.yaml': No such file or directory"
check "one in a folder of -I" status 0 "$matc" --eval "u=0" -I "$work/include_a" "-I$work/include_b" "$work/shaded.yaml"
check "is the first's" grep -q "^diffuse 1.0 0.0 0.0" "$work/stdout"
check "a depfile" status 0 $fast -MD -MF "$work/deps" -I "$work/include_b" "$work/shaded.yaml" -o "$work/shaded.frag"
check "names it" grep -q "include_b/shade.yaml" "$work/deps"
check "a batch with a cache" status 0 $fast -d "$work/shaded" --cache "$work/shaded.cache" -I "$work/include_a" "$work/shaded.yaml"
cp "$work/shaded/shaded.frag" "$work/red.frag"
check "of other folders" status 0 $fast -d "$work/shaded" --cache "$work/shaded.cache" -I "$work/include_b" "$work/shaded.yaml"
check "is another" test "$(cmp -s "$work/shaded/shaded.frag" "$work/red.frag"; echo $?)" = 1
printf 'defs: { paint: "#00ff00" }\n' >"$work/shade.yaml"
check "one beside the document" status 0 "$matc" --eval "u=0" -I "$work/include_a" "$work/shaded.yaml"
check "goes before" grep -q "^diffuse 0.0 1.0 0.0" "$work/stdout"
printf 'include: rust.yaml\nmaterial: Phong\ndiffuse: { ref: rust }\n' >"$work/rust.yaml"
check "one of matc's own name" status 0 $fast -MD -MF "$work/deps" "$work/rust.yaml" -o "$work/rust.frag"
check "is no file" test "$(grep -c matc "$work/deps")" = 0
check "a misspelt one" status 1 $fast -o "$work/none.frag" - <<'END'
include: brick.yaml
material: Phong
END
check "is guessed" says "cannot read 'brick.yaml': No such file or directory; did you mean 'bricks.yaml'?"
check "--list FILE" status 0 "$matc" --list "$work/rust.yaml"
check "lists what it includes" grep -q "^  rustiness  *Where such rust is" "$work/stdout"
check "--schema FILE" status 0 "$matc" --schema "$work/rust.yaml"
check "has what it includes" grep -q '"ref": {"const": "rustiness"}' "$work/stdout"
check "with its parameters" grep -q '"amount": {"description": "How much is rusty.".*"minimum": 0.0, "maximum": 1.0}' "$work/stdout"
check "--explain NAME FILE" status 0 "$matc" --explain rust "$work/rust.yaml"
check "is its page" grep -q "^  amount  *number  *0.5  *0 to 1  *How much is rusty." "$work/stdout"
check "of none" status 2 "$matc" --explain rusty "$work/rust.yaml"
check "is told, too" says "unknown name 'rusty'"
check "--explain describes a name of --list" sh -c "'$matc' --explain library | grep -q 'bricks.yaml'"
check "and a warning by its former name" sh -c "'$matc' --explain parted | grep -q '^dropped (diagnostic)'"

check "--textures" status 0 $fast --noise=groimp --textures "$work" examples/granite.yaml -o /dev/null
check "writes the tables" test -s "$work/matc_permutation.ktx" -a -s "$work/matc_random.ktx"
check "--eval" status 0 "$matc" --eval "u=0.3 v=0.4" $example
check "prints every slot" test "$(wc -l <"$work/stdout")" = "$(grep -c '^SLOT(' grammar/slots.def)"
check "--eval with a bad point" status 2 "$matc" --eval "q=1" $example
check "--stats" status 0 $fast --stats $example -o /dev/null
check "on standard error" says 'lower'
check "and what was chosen" says '^  noise  *lattice  *default$'
check "--stats of choices" status 0 $fast --stats --precision=exact --aa=box --powers=pow $example -o "$work/choices.frag"
check "by a row" says '^  coordinates  *long  *--precision=exact$'
check "by name, against the row" says '^  powers  *pow  *by name$'
check "that the shader names" grep -q '^// choices: noise=groimp aa=box coordinates=long powers=pow trigonometry=bounded$' "$work/choices.frag"
check "--max-error" status 0 $fast --max-error=0.1 --stats $example -o "$work/max.frag"
check "says what it chose" says '^chosen: .*layout='
check "and that it was measured" says '^  powers .*measured for --max-error$'
check "and compiles it" test -s "$work/max.frag"
check "an error that nothing keeps" status 1 $fast --max-error=1e-9 $example -o "$work/none.frag"
check "names the best" says 'no choice keeps every slot within 1e-09; the best is'
check "writes nothing" test ! -e "$work/none.frag"
check "old GLSL gets what it can" status 0 "$matc" --target=glsl110 --max-error=0.1 $example -o "$work/old.frag"
check "--max-error of nothing" status 2 $fast --max-error=0 $example
check "--pareto" status 0 "$matc" --pareto --noise=lattice --precision=fast --aa=none --derivatives=finite $example -o "$work/pareto"
check "says nothing of its progress in a pipe" test ! -s "$work/stderr"
check "prints a table" prints 'ns/pixel'
check "writes a CSV and a plot" test -s "$work/pareto.csv" -a -s "$work/pareto.svg"
if command -v script >/dev/null; then
    script -qec "$matc --pareto --noise=lattice --precision=fast --aa=none --derivatives=finite $example" /dev/null >"$work/stdout" </dev/null
    check "its progress, on a terminal" prints 'of [0-9]* programs measured'
    if [ -x "$(dirname "$matc")/matbench" ]; then
        script -qec "$(dirname "$matc")/matbench layout --untimed" /dev/null >"$work/stdout" </dev/null
        check "that of matbench" prints "$(printf '\033')\[KsharedExponent"
        "$(dirname "$matc")/matbench" layout --untimed >/dev/null 2>"$work/stderr" </dev/null
        check "and none of it where no terminal is" test ! -s "$work/stderr"
    fi
fi
check "--pareto of two documents" status 2 "$matc" --pareto $example $example
check "an unknown kind of GL" status 2 "$matc" --pareto --gl=vga $example
layout=examples/layouts/lambert.yaml
check "a layout from a file" status 0 $fast --layout=$layout -MD $example -o "$work/own.frag"
check "is the program's" grep -q 'layout lambert' "$work/own.frag"
check "and in the depfile" grep -q "$layout" "$work/own.frag.d"
check "and in that of a batch" status 0 $fast --layout=$layout -MD -d "$work/own" $example
check "with its name" grep -q "$layout" "$work/own/manifest.d"
check "--explain of a file" status 0 "$matc" --explain $layout
check "shows its fields" prints '0.r 24-31  diffuse.r'
check "a layout that is none" status 1 $fast --layout=$example $example
check "says so" says 'a layout must be an object'
check "a layout that is not there" status 1 $fast --layout=./nothing $example
check "says why" says 'nothing: No such file'
check "an unknown layout" status 2 $fast --layout=nothing $example
check "words in old GLSL" status 1 $fast --target=glsl110 --layout=$layout $example
check "are told" says 'layout lambert needs integer render targets'
check "--emit=layout" status 0 $fast --emit=layout --layout=integer $example -o "$work/integer.yaml"
check "reads back" status 0 "$matc" --explain "$work/integer.yaml"
cp "$work/stdout" "$work/page" && "$matc" --explain integer >"$work/builtin"
check "to the same page" same "$work/builtin" "$work/page"
check "--layout=auto" status 0 $fast --layout=auto --stats -d "$work/auto" --emit=glsl,unpack,layout tests/layouts/lambert.yaml
check "is small" says '^8 bytes a pixel for 5 materials'
check "says why" says '^specular .*dropped'
check "is one for all" test "$(cat "$work"/auto/*.layout.yaml | sort -u | wc -l)" = 6
check "of a mixed set" status 0 $fast --layout=auto --stats -d "$work/mixed" --emit=glsl,layout tests/layouts/mixed.yaml
check "has cases" says '^16 bytes a pixel in 4 cases for 11 materials; one case would take 28'
check "that it names" says '^1 .*normal, diffuse, specular, shininess, emissive$'
check "too much for each of them" status 1 $fast --layout="$work/mixed/auto.layout.yaml" examples/materials/phong.yaml
check "is told" says 'layout auto has no case that stores all slots of this material: diffuse, specular'
check "of one material" status 0 $fast --layout=auto $example -o "$work/one.frag"
check "with an error" status 0 $fast --layout=auto --layout-error=0.01 --emit=layout $example -o "$work/coarse.yaml"
check "that counts" grep -q 'slot: diffuse, encoding: [a-z]*, bits: [1-6]' "$work/coarse.yaml"
check "an error of nothing" status 2 $fast --layout=auto --layout-error=0 $example
check "standard input" status 1 $fast --layout=auto -
check "cannot be read twice" says 'standard input'
check "a faulty document" status 1 $fast --layout=auto -d "$work/none" "$work/bad.yaml"
check "measuring" status 2 $fast --layout=auto --max-error=0.1 $example
check "--list" status 0 "$matc" --list
check "knows Wood" prints Wood
check "--explain" status 0 "$matc" --explain Checker
check "--explain of nothing" status 2 "$matc" --explain Nothing
check "--schema" status 0 "$matc" --schema
for of in document layout manifest reflection; do
    check "--schema=$of" status 0 "$matc" --schema=$of
    check "is called so" prints "\"title\": \"matc .* $of\""
done
check "--schema of a document" status 0 "$matc" --schema examples/materials/brickwork.yaml
check "names its definitions" grep -q '"columns": {"description": "Bricks in a row."' "$work/stdout"
check "an unknown schema is wrong usage" status 2 "$matc" --schema=material
check "--help" status 0 "$matc" --help
check "--version" status 0 "$matc" --version

for level in 0 1 2; do
    check "-O$level" status 0 $fast -O$level $example
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
