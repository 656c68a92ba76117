#!/bin/sh
# File names with special meaning in JSON, terminals or programs that read matc's output:
# names.sh MATC. Run from the project's root.
set -u
matc=$(realpath "$1")
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/check.sh
fast="$matc --no-validate"

# Only tabs, ends of lines and characters that can be seen; by the bytes, so that U+0080 to U+009F count
plain() { ! LC_ALL=C grep -q "$(printf '[\001-\010\013-\037\177]\|\302[\200-\237]')" "$1"; }

# A string of JSON is json_write.h's, wherever it is written: no other file puts quotes around a %s, or makes an escape. The schemas'
# frames have names of rows in them, which are identifiers; ir_print.c writes DOT, plot.c SVG, common_error.c, hint_value.c, hint_assigned.c and describe_explain.c quote YAML, and the reader takes escapes apart.
check "nothing writes strings of JSON but json_write.c" test -z "$(find compiler runtime examples -path compiler/gen -prune -o -name '*.[ch]' -print |
    grep -v '/json_write.c$\|/describe_schema.c$\|/describe_scene.c$\|/describe_value.c$\|/describe_files.c$\|/ir_print.c$\|/plot.c$\|/common_error.c$\|/hint_value.c$\|/hint_assigned.c$\|/describe_explain.c$' | xargs grep -n '\\"%[-.*0-9]*s\|%[-.*0-9]*s\\"\|\\\\u%0' /dev/null)"

# -- JSON

odd="$work/odd"
mkdir "$odd"
for name in 'a"b' 'a\b' 'a\nb' 'a\033[31mb' 'a\037b' 'a\177b' 'a\302\233b' '{"a":1}' '\\u0041' "'" 'gr\303\274n' '\360\235\204\236'; do
    cp examples/granite.yaml "$odd/$(printf "$name" | sed 's/\\n/\n/')x.yaml"
done
cp examples/granite.yaml "$odd/$(printf 'c\nd').yaml"
out="$work/all"
check "a batch of odd names" status 0 $fast -d "$out" --constants=uniform --emit=glsl,vertex,reflect,ir "$odd"/*.yaml
for file in "$odd"/*.yaml; do
    check "and each alone" status 0 $fast "$file" --emit=reflect -o "$work/$(basename "$file" .yaml).json"
done
check "with a program each" status 0 $fast -d "$work/each" --constants=baked --pass=gbuffer,depth --emit=glsl,vertex,reflect "$odd"/*.yaml
if command -v node >"$work/found"; then
    cat >"$work/judge.js" <<'JS'
const fs = require('fs'), path = require('path');
const [odd, ...folders] = process.argv.slice(2);
const sources = fs.readdirSync(odd).map(name => path.join(odd, name)).sort();
for (const folder of folders) {
  const manifest = JSON.parse(fs.readFileSync(path.join(folder, 'manifest.json'), 'utf8'));
  const named = new Set(['manifest.json']);
  for (const program of manifest.programs)
    for (const key of ['fragment', 'vertex', 'reflection', 'ir']) if (program[key]) named.add(program[key]);
  const there = fs.readdirSync(folder);
  if (JSON.stringify([...named].sort()) !== JSON.stringify(there.sort())) throw `${folder} has ${there}, the manifest ${[...named]}`;
  if (JSON.stringify(manifest.materials.map(m => m.source).sort()) !== JSON.stringify(sources)) throw 'sources differ';
  for (const name of there.filter(name => name.endsWith('.json') && name !== 'manifest.json')) {
    const reflection = JSON.parse(fs.readFileSync(path.join(folder, name), 'utf8'));
    if (!sources.includes(reflection.sources[0])) throw `${name}: ${reflection.sources}`;
  }
}
JS
    check "node reads what it wrote" node "$work/judge.js" "$odd" "$out" "$work/each"
else
    echo "SKIPPED: node is not installed (./setup installs it), so names in JSON were not read back"
    skipped=77
fi
check "and so does the next run" status 0 $fast -d "$work/each" examples/checker.yaml
check "which removes what is stale" test "$(ls -A "$work/each" | tr '\n' ' ')" = "checker.frag manifest.json "

latin="$work/$(printf 'gr\374n')"
mkdir "$latin"
cp examples/checker.yaml "$latin/$(printf 'bl\344u').yaml"
cp examples/checker.yaml "$latin/blue.yaml"
check "a name that is not UTF-8" status 1 $fast -d "$work/latin" "$latin/$(printf 'bl\344u').yaml"
check "is said" says 'bl\\xe4u: the material.s name is not UTF-8'
check "and nothing is written" test ! -e "$work/latin"
check "in a folder whose name is not" status 0 $fast -d "$work/latin" --emit=glsl,reflect "$latin/blue.yaml"
check "the manifest is UTF-8" iconv -f UTF-8 -t UTF-16 -o "$work/utf16" "$work/latin/manifest.json"
check "and the reflection" iconv -f UTF-8 -t UTF-16 -o "$work/utf16" "$work/latin/blue.json"
check "with a mark where it is not" grep -q 'gr\\ufffdn/blue.yaml' "$work/latin/manifest.json"

# -- what looks like standard input

mkdir "$work/input"
printf 'material: Phong\ndiffuse: { ref: wood }\ninclude: "<stdin>"\n' >"$work/input/a.yaml"
cd "$work/input" || exit 1
check "no file called <stdin>" status 1 $fast - <a.yaml
check "is missed" says "<stdin>:3:10: error: cannot read '<stdin>': No such file"
printf 'defs: { wood: { map: Wood } }\n' >'<stdin>'
check "one that is there" status 0 $fast - <a.yaml
check "as a document" status 0 $fast a.yaml --emit=reflect
check "is the file" grep -q '"./<stdin>"' "$work/stdout"
cd "$root" || exit 1

# -- terminals

bad="$work/$(printf 'bad\033[31m\037\302\233.yaml')"
printf 'material: Phong\ndiffuse: { map: "Che\\e\\x1f\\x9b\\x7fker" } # \302\233\033\n' >"$bad"
printf 'material: Phong\ndiffuse: { map: "Che\\e\\x1f\\x9b\\x7fker" }\n' >"$work/$(printf 'one\033').yaml"
for form in text json; do
    for file in "$bad" "$work/$(printf 'one\033').yaml" "$work/$(printf 'none\033\302\233').yaml"; do
        check "$form of a fault" status 1 $fast --diagnostics=$form "$file"
        check "holds no control characters" plain "$work/stderr"
        check "nor of a batch" status 1 $fast --diagnostics=$form -d "$work/bad" "$file"
        check "does it" plain "$work/stderr"
    done
done
check "a fault" status 1 $fast "$work/$(printf 'one\033').yaml"
check "shows them escaped" says 'one\\x1b.yaml:2:17: error: unknown map .Che\\x1b\\x1f\\xc2\\x9b\\x7fker'
check "in JSON" status 1 $fast --diagnostics=json "$work/$(printf 'one\033').yaml"
check "as JSON does" says 'Che\\u001b\\u001f\\u009b\\u007fker'
printf 'material: Phong # \033\037\ndiffuse: "\t\303\244\033 \033" # \033\n' >"$work/caret.yaml"
check "a character that is none" status 1 $fast "$work/caret.yaml"
printf 'materials:\n  "\\e[2J": { material: Phong }\n' >"$work/key.yaml"
check "a name" status 1 $fast "$work/key.yaml"
check "is shown" says '\\x1b\[2J'
check "without effect" plain "$work/stderr"
mkdir "$work/foreign"
printf '{"matc": "1", "files": {"a\\u001b.frag": "00000000000000000000000000000000"}}' >"$work/foreign/manifest.json"
echo foreign >"$work/foreign/$(printf 'a\033').frag"
check "a file that a manifest names" status 0 $fast -d "$work/foreign" examples/checker.yaml
check "and that matc did not make" says 'warning: a\\x1b.frag: '
check "is shown" plain "$work/stderr"
check "a layout that is not there" status 1 $fast --layout="$work/$(printf '\033').yaml" examples/checker.yaml
check "neither" plain "$work/stderr"
check "a material that is not there" status 1 $fast --material="$(printf '\033')" examples/checker.yaml
check "neither" plain "$work/stderr"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ] && exit "$skipped"
