#!/bin/sh
# Special files in place of regular ones: special.sh MATC. Run from the project's root. A pipe
# without a writer, a folder, endless and other devices cause an error at once; matc neither blocks
# nor writes. A document or list named on the command line may be a pipe.
set -u
matc=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
fast="timeout 20 $matc --no-validate"
example=examples/checker.yaml
is_empty() { [ -z "$(ls -A "$1" 2>/dev/null)" ]; }

mkfifo "$work/pipe" "$work/pipe.yaml" "$work/pipe.png"
mkdir "$work/folder" "$work/folder.yaml" "$work/folder.png"
for kind in zero null full random; do
    ln -s /dev/$kind "$work/$kind"
    ln -s /dev/$kind "$work/$kind.yaml"
    ln -s /dev/$kind "$work/$kind.png"
done
for kind in pipe folder zero null full random; do
    case $kind in
    pipe) why='the file is a pipe' && named='the pipe has no data' ;;
    folder) why='Is a directory' && named=$why ;;
    *) why='the file is a device' && named=$why ;;
    esac
    printf 'material: Phong\ninclude: %s.yaml\n' $kind >"$work/include.yaml"
    printf 'material: Phong\ndiffuse: { map: ImageMap, image: %s.png }\n' $kind >"$work/picture.yaml"
    check "$kind as a document" status 1 $fast "$work/$kind" -o "$work/none.frag"
    check "is said" says "$kind: $named"
    check "of a batch" status 1 $fast -d "$work/none" "$work/$kind.yaml" $example
    check "too" says "$kind.yaml: $named"
    check "as a list" status 2 $fast -d "$work/none" "@$work/$kind"
    check "too" says "$named"
    for way in "-o $work/none.frag" "-d $work/none" "-d $work/none --cache $work/cache"; do
        check "$kind as an included file" status 1 $fast "$work/include.yaml" $way
        check "has a place" says "include.yaml:2:10: error: cannot read '$kind.yaml': $why"
        check "$kind as a picture" status 1 $fast "$work/picture.yaml" $way
        check "has a place" says "picture.yaml:2:34: error: .*$kind.png.*$why"
    done
    check "$kind as a layout" status 1 $fast --layout="$work/$kind" $example -o "$work/none.frag"
    check "is said" says "$kind: $why"
    check "of a batch" status 1 $fast --layout="$work/$kind" -d "$work/none" $example
    check "too" says "$kind: $why"
    check "to be explained" status 1 $fast --explain "$work/$kind.yaml"
    check "too" says "$why"
    check "as a document that is read twice" status 1 $fast --layout=auto "$work/$kind" -o "$work/none.frag"
    check "too" says "$why"
    check "nothing is written" test ! -e "$work/none.frag" -a ! -e "$work/none"
done

for kind in pipe folder zero; do
    mkdir "$work/out.$kind"
    [ $kind = pipe ] && mkfifo "$work/out.$kind/manifest.json"
    [ $kind = folder ] && mkdir "$work/out.$kind/manifest.json"
    [ $kind = zero ] && ln -s /dev/zero "$work/out.$kind/manifest.json"
    check "$kind as a manifest" status 1 $fast -d "$work/out.$kind" $example
    check "is said" says 'manifest.json: '
    check "and nothing is written" test "$(ls -A "$work/out.$kind")" = manifest.json
done

$fast -d "$work/cached" --cache "$work/entries" $example 2>"$work/err"
for entry in "$work"/entries/??/*; do
    rm "$entry"
    mkfifo "$entry"
done
check "pipes as entries of a cache" status 0 $fast -d "$work/cached" --cache "$work/entries" $example
check "are replaced" test -z "$(find "$work/entries" -type p)"

# -- what comes out of a pipe

# Comments name the file that a map stands in
text() { sed 's,// .*,,'; }
$fast $example | text >"$work/wanted"
same() { text <"$work/stdout" | cmp -s "$work/wanted" -; }
$fast - <$example >"$work/stdout"
check "standard input" same
cat $example | $fast - >"$work/stdout"
check "from a pipe" same
cat $example | $fast /dev/stdin | sed 's/stdin/checker/' >"$work/stdout"
check "by its name" same
{ sleep .2 && cat $example; } | $fast /dev/stdin >"$work/stdout"
check "when it is slow" same
{ head -c 40 $example && sleep .2 && tail -c +41 $example; } >"$work/pipe" &
check "a pipe that somebody writes into" status 0 $fast "$work/pipe"
wait
check "is read to its end" same
printf '%s\n' $example | $fast -d "$work/listed" @/dev/stdin
check "a list from a pipe" test -s "$work/listed/checker.frag"
cat $example | $fast -d "$work/streamed" -MD /dev/stdin
check "a batch of one" test -s "$work/streamed/stdin.frag"
if command -v bash >"$work/found"; then
    check "process substitution" status 0 bash -c "$fast <(sleep .2; cat $example)"
    check "is a pipe" same
    check "that may be empty" status 1 timeout 20 bash -c "$fast <(true)"
else
    echo "SKIPPED: bash is not installed, so no process substitution was read"
    skipped=77
fi
check "endless standard input" status 1 $fast - </dev/zero
check "is too large" says 'the file is too large'
cat /dev/zero | timeout 20 "$matc" /dev/stdin 2>"$work/stderr"
check "by its name too" says 'the file is too large'

# -- a zero byte, which would end the path

for way in "-o $work/none.frag" "-d $work/none"; do
    printf 'material: Phong\ninclude: "none.yaml\\0x"\n' >"$work/zero1.yaml"
    check "a path with a zero byte" status 1 $fast "$work/zero1.yaml" $way
    check "has a place" says 'zero1.yaml:2:10: error: a string must not contain a zero byte'
    printf '{"material": "Phong", "diffuse": {"map": "ImageMap", "image": "none.png\\u0000x"}}' >"$work/zero2.json"
    check "of a picture, in JSON" status 1 $fast "$work/zero2.json" $way
    check "has a place" says 'zero2.json:1:63: error: a string must not contain a zero byte'
    printf 'material: Phong\n"diffuse\\0": 1\n' >"$work/zero3.yaml"
    check "a key" status 1 $fast "$work/zero3.yaml" $way
    check "too" says 'zero3.yaml:2:1: error: '
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ] && exit "$skipped"
