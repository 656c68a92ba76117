#!/bin/sh
# Adds the map, the rule, the target, the pass and the light of docs/design/add-a-*.md to a copy of
# the project, from the blocks of these pages, and changes only the files that they name; builds the
# copy, and runs the tests that must then pass. Run from the project's root.
# usage: tests/docs/add.sh [build folder]   whose objects are reused where the rows cannot change
#                                           them
set -eu
. tests/share.sh
share_or_skip 1 3
build=${1:-}
pages="docs/design/add-a-map.md docs/design/add-a-rule.md docs/design/add-a-target.md docs/design/add-a-pass.md docs/design/add-a-light.md"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
copy=$work/source
mkdir "$copy"
tar -cf - --exclude=./.git --exclude='./build*' . | tar -xf - -C "$copy"

# A block stands below a line "`FILE`:", which makes the file, or "`FILE`, before `TEXT`:", which puts the block above the first line
# that begins with the text. A file that is there, one that is not, and a text that is not found are faults of the page.
add_blocks() {
    awk -v folder="$copy/" '
        function fault(why) { print FILENAME ": " file ": " why >"/dev/stderr"; failed = 1; exit 1 }
        function take(path,   line, text, done) {
            while ((getline line <path) > 0) {
                if (before != "" && !done && index(line, before) == 1) { text = text block; done = 1 }
                text = text line "\n"
            }
            close(path)
            if (before == "" && text != "") fault("is there")
            if (before != "" && !done) fault("no line begins with " before)
            printf "%s", before == "" ? block : text >path
            close(path)
            print file
        }
        /^`[^`]+`(, before `[^`]+`)?:$/ {
            split($0, parts, "`")
            file = parts[2]
            before = parts[4]
            next
        }
        /^```/ && open { if (file != "") take(folder file); open = 0; file = ""; next }
        /^```/ { open = 1; block = ""; next }
        open { block = block $0 "\n" }' "$1"
}
for page in $pages; do
    add_blocks "$page" >"$work/named"
    [ -s "$work/named" ] || { echo "$page: names no file" && exit 1; }
    cat "$work/named" >>"$work/files"
done

# For C, rows change the numbers of enumerators, and the compiler says of which. A file is compiled anew where it names one of these, pastes
# names of their kind, reads a table that the pages change, or includes a header that does. Every other object is that of the build folder,
# unless something that it was made of is younger there. Without a build folder all are compiled.
# numbers FOLDER: "name number" of every enumerator of its tables
numbers() {
    printf '#include "grammar/%s"\n' layout_tables.h scene_tables.h >"$work/tables.c"
    cc -E -P -I"$1" "$work/tables.c" >"$work/numbers.c"
    tr -d '\n' <"$work/numbers.c" | grep -o 'enum *{[^}]*}' | sed 's/^enum *{//' | tr ',' '\n' | sed -nE 's/^ *([A-Za-z]\w*).*/\1/p' >"$work/enumerators"
    { echo 'int printf(const char *, ...); int main(void) {' && sed 's/.*/printf("& %d\\n", (int)&);/' "$work/enumerators" && echo 'return 0; }'; } >>"$work/numbers.c"
    cc -std=c11 -o "$work/numbers" "$work/numbers.c" && "$work/numbers" | LC_ALL=C sort
}
numbers . >"$work/before"
numbers "$copy" >"$work/after"
LC_ALL=C comm -3 "$work/before" "$work/after" | sed 's/^\t//; s/ .*//' | sort -u >"$work/names"
{ sed 's/_.*/_##/; s/^/\\b/' "$work/names" && sed -n 's,^grammar/\(.*\)[.]def$,/\1[.]def",p' "$work/files"; } | sort -u >"$work/parts"

# Files of the copy that have to be compiled anew; headers bring those that include them
search() { (cd "$copy" && grep -r --include='*.[ch]' "$@" compiler runtime tests || true); }
{ search -lwFf "$work/names" && search -lEf "$work/parts" && (cd "$copy" && ls grammar/*.c) && cat "$work/files"; } | sort -u >"$work/anew"
known=0
while [ "$known" != "$(wc -l <"$work/anew")" ]; do
    known=$(wc -l <"$work/anew")
    sed -n 's,^\(.*/\)*\([^/]*[.]h\)$,\2",p' "$work/anew" >"$work/headers"
    { cat "$work/anew" && search -lFf "$work/headers"; } | sort -u >"$work/more"
    mv "$work/more" "$work/anew"
done

# "object" of every object of the build folder that nothing it was made of is younger than
find compiler grammar runtime tests -type f -printf '%T@ %p\n' >"$work/times"
: >"$work/fresh"
[ -z "$build" ] || ninja -C "$build" -t deps | awk -v root="$PWD/" -v times="$work/times" '
    function end() { if (object != "" && fresh) print object }
    BEGIN { while ((getline line <times) > 0) { split(line, word, " "); at[word[2]] = word[1] } }
    /^[^ ].*: #deps/ { end(); object = $1; sub(/:$/, "", object); made = $6 / 1e9; fresh = /\(VALID\)/; next }
    NF == 1 { sub(/^(\.\.\/)+/, "", $1); if (index($1, root) == 1) $1 = substr($1, length(root) + 1); if ($1 in at && at[$1] > made) fresh = 0 }
    END { end() }' >"$work/fresh"
cat >"$work/compile" <<'end'
last=
for word; do
    case $last in -o) object=$word ;; -c) source=$word ;; -MF) depends=$word ;; esac
    last=$word
done
name=${source#"$copy"/}
[ "$name" != "$source" ] || exec "$@" # it is generated
case "$newline$anew$newline" in *"$newline$name$newline"*) exec "$@" ;; esac
case "$newline$fresh$newline" in *"$newline$object$newline"*) : >"$depends" && exec cp "$build/$object" "$object" ;; esac
exec "$@"
end
newline='
'
anew=$(cat "$work/anew")
fresh=$(cat "$work/fresh")
export build copy anew fresh newline

# Without optimisation: matc is built once and runs little
set -- -DCMAKE_BUILD_TYPE=None -DMATC_REFERENCE=OFF -DBUILD_SHARED_LIBS=OFF -DCMAKE_C_FLAGS=-O0
set -- "$@" "-DCMAKE_C_COMPILER_LAUNCHER=sh;$work/compile"
! command -v mold >/dev/null || set -- "$@" -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold
tests="test_tables test_defaults test_rules test_range_random test_companion test_function test_value test_valid test_scene_defaults test_frame_vignette test_frame_line"
cd "$copy"
# shellcheck disable=SC2086
{
    cmake -G Ninja -B "$work/build" "$@" && cmake --build "$work/build" --target matc golden $tests
} >"$work/log" 2>&1 || {
    grep -A 5 -E 'error|warning' "$work/log" || tail -20 "$work/log"
    exit 1
}

# What the pages have the reader run. What the rule makes stands in its page: it is compared before any golden is written
! "$work/build/golden" . | grep '^tests/ir/' || exit 1
env -u CI "$work/build/golden" . --update >"$work/log" || { cat "$work/log" && exit 1; }
sh tests/docs/lists.sh "$work/build/matc" --update >"$work/log"

failed=0
# expect NAME COMMAND...
expect() {
    name=$1
    shift
    "$@" >"$work/log" 2>&1 && return
    echo "$name fails"
    tail -30 "$work/log"
    failed=1
}
export FUNCTION_ONLY=onion VALUE_ONLY=onion
for test in $tests; do
    expect "$test" "$work/build/tests/$test"
done
expect golden "$work/build/golden" .
expect lists sh tests/docs/lists.sh "$work/build/matc"
expect "the map is described" "$work/build/matc" --explain Onion
expect "the target is written for" "$work/build/matc" --target=glsl400 examples/onion.yaml -o "$work/onion.frag"
expect "by its row" grep -q '^#version 400 core' "$work/onion.frag"

# Nothing else has changed: what the pages name, the goldens of the new example, and the lists
cd "$OLDPWD"
diff -rq . "$copy" | grep -vE '^Only in \.: (\.git|build.*)$' |
    sed -E "s,^Files (\./)?(.*) and .* differ$,\2,; s,^Only in $copy/?(.*): ,\1/," |
    LC_ALL=C sort >"$work/changed"
{
    cat "$work/files"
    printf '%s\n' tests/golden/onion.frag tests/golden/onion.ir tests/golden/onion.json README.md compiler/matc.h docs/reference/matc.1
} | LC_ALL=C sort -u >"$work/expected"
expect "only what the pages name is touched" diff "$work/expected" "$work/changed"
exit "$failed"
