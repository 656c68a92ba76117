#!/bin/sh
# Links, pipes and folders planted where matc and matview write: files elsewhere stay unchanged, and
# the output is the same as without them. links.sh MATC MATVIEW. Run from the project's root.
set -u
matc=$1
matview=$2
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
. tests/check.sh
unset MATC_CACHE
fast="$matc --no-validate"

# Kinds of what can be planted under a name: a link to a file, one to nothing, another name of a file, a pipe
kinds='link nowhere name pipe'
# plant KIND PATH
plant() {
    rm -rf "$2"
    case $1 in
    link) ln -s "$work/victim" "$2" ;;
    nowhere) ln -s "$work/outside/new" "$2" ;;
    name) ln "$work/victim" "$2" ;;
    pipe) mkfifo "$2" ;;
    esac
}
fresh() {
    rm -rf "$work/cache" "$work/made" "$work/outside" "$work/victim"
    mkdir "$work/cache" "$work/outside"
    echo precious >"$work/victim"
    touch "$work/mark"
}
# The victim is as it was, and nothing came into the folder outside
unharmed() { [ "$(cat "$work/victim")" = precious ] && [ -z "$(ls -A "$work/outside")" ] && [ -z "$(find "$work/victim" -newer "$work/mark")" ]; }
is_file() { [ -f "$1" ] && ! [ -L "$1" ] && [ "$(stat -c %h "$1")" = 1 ]; }
counts() { "$matc" --cache-stats --cache "$work/cache" | awk -v key="$1" '$1 == key { print $2 }'; }

# -- the cache

for file in statistics trim.lock; do
    for kind in $kinds; do
        fresh
        plant $kind "$work/cache/$file"
        check "$file: a $kind" status 0 timeout 20 $fast --cache "$work/cache" -d "$work/made" examples/checker.yaml
        check "$file: harms nobody" unharmed
        check "$file: is the cache's own" is_file "$work/cache/$file"
        check "$file: and counts" test "$(counts misses)" -gt 0
    done
done
for kind in $kinds; do
    fresh
    plant $kind "$work/cache/CACHEDIR.TAG"
    check "the tag: a $kind" status 0 timeout 20 $fast --cache "$work/cache" -d "$work/made" examples/checker.yaml
    check "the tag: harms nobody" unharmed
done

# All folders of entries are links to one outside
fresh
for above in $(awk 'BEGIN { for (i = 0; i < 256; i++) printf "%02x ", i }'); do ln -s "$work/outside" "$work/cache/$above"; done
check "links for folders" status 0 $fast --cache "$work/cache" -d "$work/made" examples/checker.yaml
check "get no entry" unharmed
check "which is told" says 'warning: the cache'

# Entries that are planted
for kind in $kinds; do
    fresh
    $fast --cache "$work/cache" -d "$work/made" examples/checker.yaml
    cp -r "$work/made" "$work/right"
    find "$work/cache" -mindepth 2 -type f | while read -r entry; do plant $kind "$entry"; done
    rm -rf "$work/made"
    check "entries: a $kind" status 0 timeout 20 $fast --cache "$work/cache" -d "$work/made" examples/checker.yaml
    check "entries: harms nobody" unharmed
    check "entries: are made anew" test -z "$(find "$work/cache" -mindepth 2 ! -type d ! -type f)"
    check "entries: the program is right" diff -r "$work/right" "$work/made"
    rm -rf "$work/right"
done

# -- what a batch writes

$fast -MD -d "$work/right" --emit=glsl,reflect examples/checker.yaml
sed -i "s#$work/right#$work/made#" "$work/right/manifest.d"
for file in checker.frag checker.json manifest.json manifest.d; do
    for kind in $kinds; do
        [ $file-$kind = manifest.json-pipe ] && continue # special.sh
        fresh
        mkdir "$work/made"
        plant $kind "$work/made/$file"
        check "$file: a $kind" status 0 timeout 20 $fast -MD -d "$work/made" --emit=glsl,reflect examples/checker.yaml
        check "$file: harms nobody" unharmed
        check "$file: is a file" is_file "$work/made/$file"
        check "$file: of the right bytes" diff -r "$work/right" "$work/made"
    done
done
# In place of a staging folder of an interrupted run there is a link to a folder outside
fresh
mkdir "$work/made"
echo precious >"$work/outside/0"
ln -s "$work/outside" "$work/made/.matc-stage-abcdef"
check "a staging folder that is a link" status 0 timeout 20 $fast -MD -d "$work/made" --emit=glsl,reflect examples/checker.yaml
check "is not followed" test "$(cat "$work/outside/"*)" = precious
rm -f "$work/made/.matc-stage-abcdef"
check "beside it, the batch is right" diff -r "$work/right" "$work/made"
# A folder that is itself a link was named by its user
fresh
mkdir "$work/elsewhere"
ln -s "$work/elsewhere" "$work/made"
check "a folder by a link" status 0 $fast -MD -d "$work/made" --emit=glsl,reflect examples/checker.yaml
check "is that folder" diff -r "$work/right" "$work/elsewhere"
check "twice" status 0 $fast -MD -d "$work/made" --textures "$work/elsewhere" --emit=glsl,reflect examples/checker.yaml
check "is one folder" diff -r "$work/right" "$work/elsewhere"

# -- what a single run writes

$fast -MD examples/checker.yaml -o "$work/right/one" -MT one
for file in one one.d; do
    for kind in link nowhere name; do
        fresh
        mkdir "$work/made"
        plant $kind "$work/made/$file"
        check "$file: a $kind" status 0 $fast -MD -MT one examples/checker.yaml -o "$work/made/one"
        check "$file: harms nobody" unharmed
        check "$file: is a file" is_file "$work/made/$file"
        check "$file: of the right bytes" cmp "$work/right/$file" "$work/made/$file"
    done
done
mkdir "$work/folder"
ln -s folder "$work/named"
check "a link to a folder" status 1 $fast examples/checker.yaml -o "$work/named"
check "is not replaced" test -L "$work/named"
# What stands for an open file is that file, and is no less there afterwards
$fast examples/checker.yaml -o /dev/stdout >"$work/piped"
check "standard output by a name" cmp "$work/right/one" "$work/piped"
check "is still there" test -L /dev/stdout
mkfifo "$work/fifo"
timeout 5 cat "$work/fifo" >"$work/piped" &
check "a pipe" status 0 timeout 20 $fast examples/checker.yaml -o "$work/fifo"
wait
check "gets what is written" cmp "$work/right/one" "$work/piped"
check "and stays one" test -p "$work/fifo"

# -- pictures

draw="$matview --size=8 --samples=1 examples/checker.yaml"
$draw -o "$work/right/picture" >"$work/stdout"
is_png() { [ "$(od -An -tx1 -N8 "$1")" = ' 89 50 4e 47 0d 0a 1a 0a' ]; }
check "a picture" is_png "$work/right/picture"
check "whose name is said" test "$(cat "$work/stdout")" = "$work/right/picture"
for kind in link nowhere name; do
    fresh
    mkdir "$work/made"
    plant $kind "$work/made/picture"
    plant $kind "$work/made/picture.0.tmp"
    check "a picture: a $kind" status 0 $draw -o "$work/made/picture"
    check "a picture: harms nobody" unharmed
    check "a picture: is a file" is_file "$work/made/picture"
    check "a picture: of the right bytes" cmp "$work/right/picture" "$work/made/picture"
done
timeout 5 cat "$work/fifo" >"$work/piped" &
check "a picture into a pipe" status 0 timeout 20 $draw -o "$work/fifo"
wait
check "gets there" cmp "$work/right/picture" "$work/piped"
check "and the pipe stays" test -p "$work/fifo"
$draw -o /dev/stdout | head -c "$(stat -c %s "$work/right/picture")" >"$work/piped"
check "a picture to standard output by a name" cmp "$work/right/picture" "$work/piped"
$draw -o - >"$work/piped"
check "a picture to standard output" cmp "$work/right/picture" "$work/piped"
check "a picture into no folder" status 1 $draw -o "$work/none/picture"
check "a picture over a folder" status 1 $draw -o "$work/folder"
check "which stays" test -d "$work/folder"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
