#!/bin/sh
# Checks the examples in README.md and docs/: documents compile, programs and messages equal matc's
# output, excerpts equal their files, commands run: pages.sh MATC MATVIEW. Run from the project's
# root.
set -u
matc=$(realpath "$1")
matview=$(realpath "$2")
root=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh

# block PAGE KIND NUMBER: the text of the page's NUMBERth block of that kind
block() {
    awk -v "kind=\`\`\`$2" -v "number=$3" '
        /^```/ { if (open) open = wanted = 0; else { open = 1; wanted = $0 == kind && ++count == number } next }
        wanted' "$1"
}
# blocks PAGE KIND: how many
blocks() { grep -c "^\`\`\`$2\$" "$1"; }
without_comments() { grep -v '^#' "$1"; }
# excerpt PAGE KIND NUMBER FILE: the block stands in the file, line by line
excerpt() {
    block "$1" "$2" "$3" >"$work/excerpt"
    awk 'NR == FNR { lines[++count] = $0; next }
         { text[FNR] = $0; last = FNR }
         END { for (start = 0; start + count <= last; start++) {
                   for (i = 1; i <= count && text[start + i] == lines[i];) i++
                   if (i > count) exit !count
               }
               exit 1 }' "$work/excerpt" "$4"
}
# shows PAGE KIND NUMBER FILE: the lines of the block are in the file in that order; "..." leaves any out
shows() {
    block "$1" "$2" "$3" >"$work/excerpt"
    awk 'NR == FNR { if ($0 != "...") lines[++count] = $0; next }
         at < count && $0 == lines[at + 1] { at++ }
         END { if (at < count) print "not printed: " lines[at + 1] >"/dev/stderr"; exit at < count || !count }' "$work/excerpt" "$4"
}
# same_document PAGE NUMBER FILE: but for comments, of which the block's first names the file
same_document() {
    block "$1" yaml "$2" >"$work/block.yaml"
    [ "$(head -1 "$work/block.yaml")" = "# $3" ] &&
        [ "$(without_comments "$work/block.yaml")" = "$(without_comments "$3")" ]
}

# README.md
check "README's document is the example" same_document README.md 1 examples/checker.yaml
"$matc" examples/checker.yaml >"$work/checker.frag"
check "its program is what matc writes" excerpt README.md glsl 1 "$work/checker.frag"
check "from main() to the end" test "$(block README.md glsl 1)" = "$(sed -n '/^void main/,$p' "$work/checker.frag")"
mkdir "$work/use" && cd "$work/use" || exit 1
printf 'material: Phong\ndiffuse:\n  map: Cheker\n' >rock.yaml
"$matc" rock.yaml 2>said
sed '/^rock.yaml/!d; N; N' "$root/README.md" >fault
sed '/^rock.yaml/!d; N; N' "$root/docs/reference/language.md" >fault_of_language
check "its fault is what matc says" cmp fault said
check "and so is that of language.md" cmp fault_of_language said
printf 'material: Phong\ndiffuse: { map: Granite, input: { map: UVTransform, scaleU: 8 } }\n' >grain.yaml
"$matc" grain.yaml -o grain.frag 2>said
sed '/^grain.yaml/!d; N; N' "$root/docs/reference/language.md" >fault_of_language
check "a warning, in docs/reference/language.md" cmp -s said fault_of_language
cp "$root/examples/checker.yaml" rock.yaml
echo rock.yaml >materials.txt
mkdir bin && ln -s "$matc" bin/matc && ln -s "$matview" bin/matview
PATH=$work/use/bin:$PATH
{ block "$root/README.md" sh 2 && block "$root/docs/guide/commands.md" sh 1; } | grep -v -e '--pareto' >commands # which takes long, and which command_line.sh runs
check "it shows commands" test "$(grep -c '^matc' commands)" -ge 10
while read -r line; do
    check "$line" sh -c "$line"
done <commands
cd "$root" || exit 1

# docs/reference/language.md
mkdir "$work/images" && cp examples/tiles.png "$work/images/color.png" && cp examples/tiles.png "$work/images/packed.png" && cp examples/tiles.png "$work/images/label.png" && cp examples/tiles.png "$work/images/height.png"
for name in bark barkRough barkNormal; do cp examples/tiles.png "$work/$name.png"; done
number=0
while [ "$number" -lt "$(blocks docs/reference/language.md yaml)" ]; do
    number=$((number + 1))
    block docs/reference/language.md yaml "$number" >"$work/document$number.yaml"
    check "language.md's document $number compiles without a warning" "$matc" -Werror -d "$work/language" "$work/document$number.yaml"
done
check "language.md has documents" test "$number" -ge 7

# docs/reference/layouts.md
check "its layout is the example" same_document docs/reference/layouts.md 1 examples/layouts/lambert.yaml
for set in lambert mixed; do
    "$matc" --no-validate --layout=auto --stats -d "$work/$set" "tests/layouts/$set.yaml" 2>"$work/$set.report"
done
check "its first report" shows docs/reference/layouts.md "" 1 "$work/lambert.report"
check "its second" shows docs/reference/layouts.md "" 2 "$work/mixed.report"
"$matc" --no-validate --layout=auto --stats -d "$work/all" examples/materials/*.yaml examples/materials/*.json 2>"$work/all.report"
check "what examples/materials/ take" grep -q '^28 bytes a pixel' "$work/all.report"

# docs/results/indirect.md
"$matc" --explain Indirect >"$work/indirect"
check "what qualities set" shows docs/results/indirect.md "" 1 "$work/indirect"

# docs/design/architecture.md
check "its layers are the table's" test "$(block docs/design/architecture.md "" 2)" = "$(grep -v -e '^#' -e '^circle' -e '^$' tests/sources/layers.txt)"
"$matc" --emit=tree examples/checker.yaml >"$work/tree"
check "its tree" test "$(block docs/design/architecture.md yaml 1)" = "$(cat "$work/tree")"
"$matc" --eval "u=0.3 v=0.4" examples/checker.yaml >"$work/values"
check "its values" shows docs/design/architecture.md "" 3 "$work/values"
"$matc" -O0 --aa=none --emit=ir --pass=value examples/checker.yaml >"$work/ir0"
check "its IR as it is made" shows docs/design/architecture.md "" 4 "$work/ir0"
"$matc" --aa=none --emit=ir --pass=value examples/checker.yaml >"$work/ir2"
check "and as it is emitted" test "$(block docs/design/architecture.md "" 5)" = "$(cat "$work/ir2")"
check "their nodes" grep -q "$(grep -c '^%' "$work/ir0") nodes are $(grep -c '^%' "$work/ir2")\." docs/design/architecture.md
check "its program" test "$(block docs/design/architecture.md glsl 1)" = "$("$matc" --aa=none --pass=value examples/checker.yaml | sed -n '/^void main/,$p')"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
