#!/bin/sh
# Checks layering: every include and every call between folders is in tests/sources/layers.txt, the
# table has no cycle, and no files call each other in a cycle except those that it names. Calls are
# read from a build's object files, so that a handwritten declaration hides none. Run:
# layers.sh BUILD [TABLE].
# Worked example: ir_make in compiler/ir/ir.c calls fold_node of compiler/ir/fold.c: the edge
# ir.c -> fold.c; fold_node calling ir_make would close the cycle "ir.c fold.c", and tsort would
# name both.
set -eu
build=${1:?layers.sh BUILD}
table=${2:-tests/sources/layers.txt}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grep -v '^#' "$table" | grep -v '^circle' | grep . >"$work/short"
grep '^circle' "$table" >"$work/circles" || true
faults=0
fault() {
    cat
    faults=1
}

# -- The table itself, each folder by its whole path; for tsort, a folder stands behind what it sees

# A name is a folder within the row's own, one beside it, or else any whose path ends so
awk '{ n = split($1, part, "/"); full[part[n]] = row[NR] = $1; is[$1] = 1; sees[NR] = $0
       if (n > 2) full[part[n - 1] "/" part[n]] = $1 }
     function folder(row, name, above) {
         above = row; sub(/\/[^\/]*$/, "", above)
         return (row "/" name) in is ? row "/" name : (above "/" name) in is ? above "/" name : name in full ? full[name] : name }
     END { for (r = 1; r <= NR; r++) { n = split(sees[r], word); printf "%s", row[r]
               for (i = 2; i <= n; i++) printf " %s", folder(row[r], word[i])
               print "" } }' "$work/short" >"$work/sees"
awk '{ print $1, $1; for (i = 2; i <= NF; i++) print $1, $i }' "$work/sees" >"$work/order"
tsort "$work/order" >/dev/null 2>"$work/loop" || fault <<END
layers.sh: the table goes in a circle: $(grep -v 'contains a loop' "$work/loop" | sed 's/^tsort: //' | tr '\n' ' ')
END

# -- Includes: "user used", as files

find compiler runtime grammar -path compiler/gen -prune -o -name '*.[ch]' -print | while read -r file; do
    sed -nE "s,^ *# *include \"((compiler|runtime|grammar)/[^\"]*)\".*,$file \1,p" "$file"
done | grep -v ' compiler/matc\.h$' >"$work/includes"

# -- Calls: an edge from the object that wants a symbol to the one that defines it

find "$build" -path '*/mutants' -prune -o -name '*.c.o' -print | grep -E '\.dir/(compiler|runtime|grammar)/' | grep -v '/compiler/gen/' |
    while read -r object; do source=${object#*.dir/} && [ ! -f "${source%.o}" ] || echo "$object"; done | xargs nm -A |
    awk '{ sub(/\.o:/, ".o ") } { f = $1; sub(/.*\.dir\//, "", f); sub(/\.o$/, "", f) }
        NF == 4 && $3 ~ /[TDRBC]/ { print "def", $4, f } NF == 3 && $2 == "U" { print "use", $3, f }' | sort -u >"$work/symbols"
[ "$(grep -c '^def' "$work/symbols")" -gt 300 ] || fault <<END
layers.sh: $build has hardly any object files
END
awk '$1 == "def" { at[$2] = $3 } $1 == "use" { n++; name[n] = $2; by[n] = $3 }
     END { for (i = 1; i <= n; i++) if (name[i] in at && at[name[i]] != by[i]) print by[i], at[name[i]], name[i] }' "$work/symbols" >"$work/calls"

# -- Every edge between folders is in the table

cat "$work/includes" "$work/calls" | awk -v sees="$work/sees" '
    function folder(path,   up) { # the nearest that the table has: compiler/library/maps belongs to compiler/library
        sub(/\/[^\/]*$/, "", path)
        for (up = path; !(up in known) && sub(/\/[^\/]*$/, "", up); )
            ;
        return up in known ? up : path
    }
    BEGIN { while ((getline line < sees) > 0) { n = split(line, word); known[word[1]] = 1; for (i = 1; i <= n; i++) may[word[1], word[i]] = 1 } }
    { a = folder($1); b = folder($2); met[a] = met[a, b] = 1 }
    !((a, b) in may) { print "layers.sh: " $1 " must not see " $2 ($3 != "" ? " (calls " $3 ")" : ""); bad = 1 }
    END {
        for (pair in may) { split(pair, w, SUBSEP); if (w[1] != w[2] && (w[1] in met) && !((w[1], w[2]) in met)) { print "layers.sh: " w[1] " does not use " w[2] " any more: take it out of the table"; bad = 1 } }
        exit bad
    }' >"$work/said" || fault <"$work/said"

# -- No circle of files: those that may are one file here

awk -v circles="$work/circles" '
    BEGIN { while ((getline line < circles) > 0) { n = split(line, word); for (i = 2; i <= n; i++) one[word[i]] = word[2] } }
    { a = $1 in one ? one[$1] : $1; b = $2 in one ? one[$2] : $2; if (a != b) print a, b }' "$work/calls" | sort -u >"$work/files"
tsort "$work/files" >/dev/null 2>"$work/loop" || fault <<END
layers.sh: files call each other in a circle: $(grep -v 'contains a loop' "$work/loop" | sed 's/^tsort: //' | tr '\n' ' ')
END
# a circle of the table that is none any more
while read -r _ files; do
    for file in $files; do
        [ -f "$file" ] || echo "layers.sh: there is no $file, which a circle of the table names"
    done
    # shellcheck disable=SC2086
    awk -v files="$files" 'BEGIN { n = split(files, f); for (i = 1; i <= n; i++) in_it[f[i]] = 1 } ($1 in in_it) && ($2 in in_it) { print $1, $2 }' "$work/calls" |
        sort -u | tsort >/dev/null 2>&1 && echo "layers.sh: no circle any more: $files"
done <"$work/circles" >"$work/said"
[ ! -s "$work/said" ] || fault <"$work/said"
[ "$faults" = 0 ] && echo "layers.sh: $(wc -l <"$work/sees") folders, $(wc -l <"$work/includes") includes, $(sort -u "$work/files" | wc -l) calls between files"
exit "$faults"
