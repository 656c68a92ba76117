#!/bin/sh
# Compares machine-independent figures in docs/results/performance.md, docs/reference/stability.md,
# docs/results/shadows.md, docs/results/displacement.md, docs/results/layouts.md and
# docs/results/thesis.md with the output of their commands: figures.sh BUILD_FOLDER [--update]. A
# block below `<!-- matbench WORDS -->` is that command's output; the command is run without times,
# for which it prints `-`. Every line of the block must be printed, in this order, with the same
# words and numbers, and any number in place of a `-`; fractions of docs/results/shadows.md, which
# are drawn, may differ by two in their last digit. --update rewrites the pages and keeps their
# times. Run from the project's root. Status 77: skipped.
set -u
. tests/share.sh
build=$1
update=${2:-}
pages="docs/results/performance.md docs/reference/stability.md docs/results/shadows.md docs/results/displacement.md docs/results/layouts.md docs/results/thesis.md"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command -v spirv-opt >/dev/null || {
    echo "SKIPPED: spirv-opt is not installed (Debian: spirv-tools), so no figure of $pages was looked at"
    exit 77
}
[ ! -w /dev/shm ] || export TMPDIR=/dev/shm # thousands of small files

cat >"$work/lines.awk" <<'EOF_AWK'
# lines.awk PRINTED BLOCK: each line of the block as it should be; "?" and the line where nothing like it is printed behind those
# before it. Lines are alike that begin with the same two words and have as many.
function alike(text, line,    words, printed) {
    return split(text, words) == split(line, printed) && words[1] == printed[1] && (words[2] == printed[2] || printed[2] ~ /^-/)
}
# Numbers with as many digits behind the point, and as good as equal
function near(a, b,    digits) {
    if (!off || a !~ /^[0-9]+[.][0-9]+$/ || b !~ /^[0-9]+[.][0-9]+$/) return 0
    digits = length(a) - index(a, ".")
    return digits == length(b) - index(b, ".") && (a - b) ^ 2 <= ((off + 0.01) / 10 ^ digits) ^ 2
}
# The printed line, each "-" replaced by the text's number; columns stay as they are.
function filled(text, line,    words, made, gap, word, i, more) {
    split(text, words)
    while (match(line, /[^ ]+/)) {
        gap = substr(line, 1, RSTART - 1)
        word = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        more = length(words[++i]) - length(word)
        if (near(word, words[i])) word = words[i]
        if (word ~ /^-[,;:]?$/) {
            word = words[i]
            if (length(gap) > 1)
                gap = sprintf("%" (length(gap) - more) "s", "")
        }
        made = made gap word
    }
    return made
}
NR == FNR { lines[++count] = $0; next }
!NF { print; next }
{
    for (next_line = at + 1; next_line <= count && !alike($0, lines[next_line]);)
        next_line++
    if (next_line <= count) at = next_line
    print next_line <= count ? filled($0, lines[at]) : "? " $0
}
EOF_AWK

# The block below the marker of a command
block() { awk -v "marker=<!-- matbench $1 -->" '$0 == marker { found = 1; next } /^```/ && found { inside++; next } inside == 1' "$page"; }
replace_block() { # replace_block COMMAND FILE
    awk -v "marker=<!-- matbench $1 -->" -v "file=$2" '
        /^```/ && found { inside++; if (inside == 1) { print; while ((getline line < file) > 0) print line; next } found = 0 }
        $0 == marker { found = 1; inside = 0 }
        !(found && inside == 1)' "$page" >"$work/page" && cp "$work/page" "$page"
}

failed=0
blocks=0
grep -o '^<!-- matbench .* -->$' $pages | sed 's/:<!-- matbench \(.*\) -->$/ \1/' >"$work/commands"
while read -r page command words; do
    name="$command${words:+ $words}"
    blocks=$((blocks + 1))
    share_takes $blocks 3 || continue
    block "$name" >"$work/block"
    # shellcheck disable=SC2086
    "$build/matbench" "$command" --untimed $words >"$work/printed" 2>"$work/said" || { failed=1 && cat "$work/said"; }
    off=0
    [ "$page" != docs/results/shadows.md ] || off=2
    awk -v off=$off -f "$work/lines.awk" "$work/printed" "$work/block" >"$work/wanted"
    if [ -n "$update" ] && [ -s "$work/wanted" ] && ! grep -q '^? ' "$work/wanted"; then
        replace_block "$name" "$work/wanted"
    elif [ ! -s "$work/block" ] || ! cmp -s "$work/block" "$work/wanted"; then
        failed=1
        echo "FAILED: $page has another matbench $name (tests/docs/figures.sh $build --update):"
        diff "$work/block" "$work/wanted"
    fi
done <"$work/commands"
echo "$blocks blocks"
[ "$failed" = 0 ] && [ "$blocks" -ge 9 ]
