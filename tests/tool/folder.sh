#!/bin/sh
# What a batch removes from its output folder: outputs of an earlier batch, by its manifest, and
# leftovers of killed processes. folder.sh MATC. Run from the project's root.
set -u
matc=$1
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
. tests/check.sh
unset MATC_CACHE
fast="$matc --no-validate"

# hash FOLDER FILE: as the manifest has it
hash() { sed -n 's/.*"'"$2"'": "\([0-9a-f]*\)",*$/\1/p' "$1/manifest.json"; }

# -- what is no longer made

check "all that a batch can make" status 0 $matc -d "$work/all" --emit=glsl,vertex,unpack,reflect,ir,dot,layout,spirv,tree --target=spirv \
    --textures "$work/all" examples/carpenter.yaml examples/wood.yaml
check "another batch" status 0 $fast -d "$work/all" examples/checker.yaml
check "takes away" only "$work/all" checker.frag manifest.json

# Manifests that are anybody's: with the right hash even, nothing goes but a file of the folder that matc gives such a name
check "a program" status 0 $fast -d "$work/foreign" examples/checker.yaml
hash=$(hash "$work/foreign" checker.frag)
mkdir "$work/foreign/sub"
for file in "$work/precious.frag" "$work/foreign/sub/x.frag" "$work/foreign/plain"; do cp "$work/foreign/checker.frag" "$file"; done
foreign() { # a manifest's text
    printf '%s' "$1" >"$work/foreign/manifest.json"
    check "a foreign manifest" status 0 $fast -d "$work/foreign" examples/checker.yaml
    check "removes nothing" test -s "$work/precious.frag" -a -s "$work/foreign/sub/x.frag" -a -s "$work/foreign/plain" -a -d "$work/foreign/sub"
}
for name in ../precious.frag "$work/precious.frag" sub/x.frag ./../precious.frag plain sub .. . ''; do
    foreign '{"matc": "0.2.0", "files": {"'"$name"'": "'"$hash"'"}}'
done
foreign 'not JSON {'
foreign '[[[[]]]]'
foreign '{"matc": 1, "files": ["plain"]}'
foreign '{"matc": "0.2.0", "programs": {"fragment": 3}, "files": {"plain": 3, "sub": {}}}'
foreign ''
foreign '{"matc": "0.2.0", "files": {"checker.frag": "'"$hash"'"}}'
check "nor what is made again" test -s "$work/foreign/checker.frag"

# A name alone proves nothing: what goes has the bytes that a run wrote
cp "$work/foreign/checker.frag" "$work/foreign/was.frag"
cp "$work/foreign/checker.frag" "$work/foreign/edited.frag"
echo '// mine' >>"$work/foreign/edited.frag"
echo mine >"$work/foreign/mine.frag"
ln -s was.frag "$work/foreign/link.frag"
foreign '{"files": {"mine.frag": "'"$hash"'", "edited.frag": "'"$hash"'", "link.frag": "'"$hash"'", "was.frag": "'"$hash"'", "none.frag": "'"$hash"'"}}'
check "a program that is no longer made goes" test ! -e "$work/foreign/was.frag"
check "somebody's file stays" test "$(cat "$work/foreign/mine.frag")" = mine
check "an edited one, too" test -s "$work/foreign/edited.frag"
check "and a link" test -L "$work/foreign/link.frag"
for name in mine edited link; do check "which is said of $name" says "$name.frag: it is obsolete, but is kept because it was changed"; done
check "once" test "$(wc -l <"$work/stderr")" = 3

# A layout is written by one run and read by the next
check "a layout" status 0 $fast -d "$work/layout" --emit=glsl,layout --layout=compact examples/checker.yaml
check "is read by a run that makes none" status 0 $fast -d "$work/layout" --layout="$work/layout/compact.layout.yaml" examples/checker.yaml
check "and stays" test -s "$work/layout/compact.layout.yaml"

# -- what was left behind: a lock tells the folder of a process that lives from one that was left behind

mkdir -p "$work/ended/.matc-stage-abcdef" "$work/ended/.matc-stage-inuse0" "$work/ended/.matc-cache"
echo half >"$work/ended/.matc-stage-abcdef/0"
echo half >"$work/ended/.matc-stage-inuse0/0"
exec 9<"$work/ended/.matc-stage-inuse0"
flock 9
check "what was left behind" status 0 $fast -d "$work/ended" examples/checker.yaml
check "is removed, unless it is somebody's" only "$work/ended" .matc-cache .matc-stage-inuse0 checker.frag manifest.json
exec 9<&-
check "who is ended in turn" status 0 $fast -d "$work/ended" examples/checker.yaml
check "has it removed, too" only "$work/ended" .matc-cache checker.frag manifest.json

# -- an unreadable list of intents is an error, and no file changes; test_staging.c has more cases

refused() { # a command that damages the list of an interrupted run
    rm -rf "$work/broken" "$work/same"
    $fast -d "$work/broken" examples/wood.yaml
    mkdir -m 700 "$work/broken/.matc-stage-abcdef"
    (cd "$work/broken/.matc-stage-abcdef" && eval "$1")
    ls -lAR "$work/broken" >"$work/before"
    check "$1: a batch" status 1 timeout 10 $fast -d "$work/broken" examples/checker.yaml
    check "$1: gives the reason" says "error: $work/broken: .*\.matc-stage.*damaged"
    check "$1: a file" status 1 timeout 10 $fast -o "$work/broken/one.frag" examples/checker.yaml
    check "$1: gives the reason" says "error: .*\.matc-stage.*damaged"
    ls -lAR "$work/broken" >"$work/same"
    check "$1: and nothing changes" cmp "$work/before" "$work/same"
    rm -rf "$work/broken/.matc-stage-abcdef"
    check "$1: without it" status 0 $fast -d "$work/broken" examples/checker.yaml
    check "$1: all is well" only "$work/broken" checker.frag manifest.json
}
refused 'echo { >intents'
refused 'head -c 100 /dev/zero >intents'
refused 'truncate -s 1T intents'
refused 'mkdir intents'
refused 'mkfifo intents'
refused 'ln -s 0 intents'

# -- one name from several threads: every material of a noise has the same tables

tables() {
    for run in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        rm -rf "$work/tables"
        $fast -j 8 -d "$work/tables" --textures "$work/tables" --noise=groimp --pass=value --slot=diffuse \
            examples/granite.yaml examples/turbulence.yaml examples/volumeTurbulence.yaml examples/wrinkles.yaml || return 1
    done
}
check "tables that several threads write" tables
check "are there once" only "$work/tables" granite.frag manifest.json matc_permutation.ktx matc_random.ktx turbulence.frag \
    volumeTurbulence.frag wrinkles.frag

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
