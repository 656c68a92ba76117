#!/bin/sh
# Tests the documented effects of options: options.sh MATC. Run from the project's root.
set -u
matc=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
fast="$matc --no-validate"
example=examples/checker.yaml

# -- --cases: of a set

check "--cases=some is wrong usage" status 2 $fast -d "$work/none" --cases=some $example
check "and it is said" says "--cases"
check "a document alone has all cases" status 2 $fast --cases=used $example
check "which is said" says '--cases is of the set that -d writes'
check "nothing is written" test ! -e "$work/none"

# -- --layout-error: above 0, at most 0.5

auto="$fast --layout=auto --emit=layout -o $work/layout.yaml $example"
for error in 0 -0 -0.1 -0.5 0.5000001 0.51 0.6 1 5 inf -inf nan -nan 1e999 1e-999 0.1x x '' 0,1; do
    rm -f "$work/layout.yaml"
    check "--layout-error=$error is wrong usage" status 2 $auto --layout-error="$error"
    check "and it is said" says '--layout-error expects a number above 0, at most 0.5'
    check "nothing is written" test ! -e "$work/layout.yaml"
    check "nor by a batch" status 2 $fast --layout=auto -d "$work/none" --layout-error="$error" $example
done
bits() { sed -n 's/.*slot: diffuse.*bits: \([0-9]*\).*/\1/p' "$work/layout.yaml"; }
last=99
for error in 1e-9 0.001 0.01 0.1 0.5; do
    check "--layout-error=$error" status 0 $auto --layout-error=$error
    check "takes no more bits than a smaller one" test "$(bits)" -le $last
    last=$(bits)
done
check "the greatest takes two" test "$last" = 2

# -- --aa: cells of a formula are those of the map, over the pixel, too

printf 'material: Phong\ndiffuse: { map: Cells }\n' >"$work/map.yaml"
printf 'material: Phong\ndiffuse: "= cells(p)"\n' >"$work/formula.yaml"
for aa in none box aniso; do
    $fast --aa=$aa --emit=ir --pass=value "$work/map.yaml" >"$work/map.ir" 2>"$work/stderr"
    $fast --aa=$aa --emit=ir --pass=value "$work/formula.yaml" >"$work/formula.ir" 2>>"$work/stderr"
    check "--aa=$aa: cells(p) is Cells" cmp -s "$work/map.ir" "$work/formula.ir"
done

# -- --precision: the same program as with what the manual says it chooses; each choice counts in it

cat >"$work/all.yaml" <<'YAML'
material: Phong
diffuse: { map: Wood, waveForm: Sqr, input: { map: XYZTransform, transform: { translation: [1000, 0, 0], scale: 3 } } }
specular: { map: Granite, input: { map: XYZTransform, transform: { translation: [1000, 0, 0], scale: 3 } } }
emissive: { map: Gradient, waveForm: Acos }
YAML
program() { $fast "$work/all.yaml" "$@" -o - >"$work/$name.frag" 2>"$work/stderr"; }
same() { cmp -s "$work/$1.frag" "$work/$2.frag"; }
differ() { test -s "$work/$1.frag" -a -s "$work/$2.frag" && ! same "$1" "$2"; }
# row NAME NOISE COORDINATES POWERS TRIGONOMETRY
row() {
    name=row && program --precision=$1
    name=named && program --noise=$2 --coordinates=$3 --powers=$4 --trigonometry=$5
    check "--precision=$1 is $2, $3, $4, $5" same row named
    name=other && program --precision=$1 --noise=simplex
    check "of which noise counts" differ row other
    for choice in coordinates=plain,long powers=squaring,compensated trigonometry=native,bounded; do
        name=first && program --precision=$1 --${choice%,*}
        name=second && program --precision=$1 --${choice%=*}=${choice#*,}
        check "and ${choice%=*}" differ first second
    done
}
row fast lattice plain squaring native
row balanced lattice long squaring bounded
row exact groimp long compensated bounded
name=none && program
name=fast && program --precision=fast
check "fast is the default" same none fast

# -- --no-validate: what was not validated is never taken for what was

hits() { "$matc" --cache "$work/cache" --cache-stats | sed -n 's/^hits *//p'; }
check "a batch that validates nothing" status 0 $fast -d "$work/batch" --cache "$work/cache" $example
check "finds nothing" test "$(hits)" = 0
check "one that validates" status 0 "$matc" -d "$work/batch" --cache "$work/cache" $example
check "takes nothing of it" test "$(hits)" = 0
check "the same again" status 0 "$matc" -d "$work/batch" --cache "$work/cache" $example
valid=$(hits)
check "finds its own" test "$valid" -gt 0
check "and the first again" status 0 $fast -d "$work/batch" --cache "$work/cache" $example
check "its own" test "$(hits)" -gt "$valid"

# -- parameters of a definition in its formulas: numbers, colours and maps; a built-in value, a local and a name of `with:` hide them

cat >"$work/scoped.yaml" <<'YAML'
defs:
  direct: { params: { k: 1, tint: "#f00" }, map: Expression, is: tint * k * u }
  with: { params: { k: 1 }, map: Expression, is: k * v, with: { k: 7 } }
  local: { params: { k: 1 }, map: Expression, is: k = 2; k * v }
  hidden: { params: { v: 9 }, map: Expression, is: v }
  within: { params: { rows: 2, m: { map: Gradient } }, map: Mix, a: "= rows * u", b: "= m", amount: "= .5 / rows * 2" }
  known: { params: { rows: 2 }, map: UVTransform, scaleU: "= rows * 3", input: null }
  outer: { params: { k: 5 }, map: Expression, is: inner, with: { inner: { ref: direct, k: { param: k } } } }
material: Phong
diffuse: { ref: direct, k: 3 }
specular: { ref: with, k: 3 }
emissive: { ref: local, k: 3 }
ambient: { ref: hidden, v: 3 }
transparency: { ref: within, rows: 4, m: 0 }
diffuseTransparency: { ref: outer, k: 2 }
YAML
slot() { sed -n "s/^$1 //p" "$work/stdout"; }
check "parameters in formulas" status 0 "$matc" --eval "u=0.25 v=0.5" "$work/scoped.yaml"
check "of an Expression" test "$(slot diffuse)" = "0.75 0.0 0.0"
check "hidden by with:" test "$(slot specular | cut -d' ' -f1)" = 3.5
check "hidden by a local" test "$(slot emissive | cut -d' ' -f1)" = 1.0
check "hidden by a built-in value" test "$(slot ambient | cut -d' ' -f1)" = 0.5
printf 'defs: { d: { params: { rows: 2 }, map: Mix, a: "= rows * u", b: 0, amount: "= rows / 8" } }\nmaterial: Phong\n' >"$work/mixed.yaml"
printf 'diffuse: { ref: d, rows: 4 }\nspecular: { ref: d }\nemissive: { map: Checker, color1: { ref: d, rows: "#00f" } }\n' >>"$work/mixed.yaml"
check "an argument of another type" status 1 "$matc" --eval "u=0.25" "$work/mixed.yaml"
sed -i '/emissive/s/rows: .*/rows: 1 } }/; s/emissive.*/emissive: { ref: d, rows: 1 }/' "$work/mixed.yaml"
check "arguments in shorthands" status 0 "$matc" --eval "u=0.25" "$work/mixed.yaml"
check "each use has its own" test "$(slot diffuse | cut -d' ' -f1) $(slot specular | cut -d' ' -f1) $(slot emissive | cut -d' ' -f1)" = "0.5 0.375 0.21875"

# -- what would have no effect, and what could not be read or written, is said, by its name

for useless in "-MF $work/x.d" "-MT x" "--cache $work/useless" "--cache-limit=4"; do
    check "$useless alone is wrong usage" status 2 $fast $useless $example -o "$work/x.frag"
    check "and says what it is for" says "^matc: ${useless%%[ =]*} "
done
check "MATC_CACHE may stand there always" status 0 env MATC_CACHE="$work/useless" $fast $example -o "$work/x.frag"
check "a list that is not there" status 2 $fast -d "$work/batch" @"$work/nope.txt"
check "is named" says "^matc: @$work/nope.txt: "
printf '# materials\n%s\n#examples/none.yaml\n' $example >"$work/list.txt"
check "comments in a list are none of its documents" status 0 $fast -d "$work/listed" @"$work/list.txt"
check "a batch of standard input" status 0 sh -c "$fast -d '$work/in' - <$example"
check "names its file so that a shell takes it" only "$work/in" manifest.json stdin.frag
mkdir "$work/taken" "$work/taken/manifest.json"
check "a file that cannot be written" status 1 $fast -d "$work/taken" $example
check "is named with its folder" says "^matc: error: $work/taken/manifest.json: "
if [ -c /dev/full ]; then
    check "standard output that is full" status 1 sh -c "$fast $example >/dev/full"
    check "is said once" test "$(cat "$work/stderr")" = "matc: error: standard output: No space left on device"
fi
printf 'defs: { a: { map: Cheker } }\nobjects: []\n' >"$work/scene.yaml"
check "a scene with a fault" status 1 $fast "$work/scene.yaml"
check "is not called definitions" test "$(grep -c -e note: "$work/stderr")" = 0
printf 'lights: [{ light: Point }]\nobjects: []\n' >"$work/scene.yaml"
check "a scene without one" status 1 $fast "$work/scene.yaml"
check "is called a scene" says 'note: this is a scene; draw it with matview'
printf 'include: none.yaml\nmaterial: Phong\ndiffuse: { ref: a }\nspecular: { ref: b }\n' >"$work/lacks.yaml"
check "what a file that is not there would define" status 1 $fast "$work/lacks.yaml"
check "is not asked for again" test "$(grep -c error: "$work/stderr")" = 1

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
