#!/bin/sh
# Naming and size rules: the name of every exported function begins with a prefix of its file's name
# (layout_read.c: layout_), its folder's name, or a type of the header that declares it (KeySet:
# key_set_, FieldRow: field_); no function takes more than five parameters; no file is longer than
# 700 lines. Names are read from a build's object files. Prints violations and counts. Run:
# exports.sh BUILD.
# Worked example: compiler/base/hash.c may export hash_bytes, base_hash, and, as hash.h defines Key,
# key_read.
set -eu
build=${1:?exports.sh BUILD}
most=5
longest=700
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# -- "file name" of every exported function

find "$build" -name '*.c.o' | grep -E '\.dir/(compiler|runtime|grammar)/' | grep -v '/compiler/gen/' |
    while read -r object; do source=${object#*.dir/} && [ ! -f "${source%.o}" ] || echo "$object"; done | xargs nm -A |
    awk '{ sub(/\.o:/, ".o ") } NF == 4 && $3 == "T" { f = $1; sub(/.*\.dir\//, "", f); sub(/\.o$/, "", f); print f, $4 }' | sort -u >"$work/exports"

# -- "header type" and "header name" of every type and every function that a header of the product has

find compiler runtime grammar -name '*.h' | xargs awk '
    function snake(name) { while (match(name, /[a-z0-9][A-Z]/)) name = substr(name, 1, RSTART) "_" substr(name, RSTART + 1); return tolower(name) }
    /^} [A-Z][A-Za-z0-9]*;/ { print "type", FILENAME, snake(substr($2, 1, length($2) - 1)) }
    /^typedef / { n = split($0, word, /[ ;*(),]+/); for (i = n; i > 1; i--) if (word[i] ~ /^[A-Z]/) { print "type", FILENAME, snake(word[i]); break } }
    /^[a-zA-Z].*\(/ && !/^typedef/ { line = $0; while (match(line, /[a-z_][A-Za-z0-9_]*\(/)) { print "has", FILENAME, substr(line, RSTART, RLENGTH - 1); line = substr(line, RSTART + RLENGTH) } }' >"$work/headers"

awk -v headers="$work/headers" '
    function begins(name, prefix) { return name == prefix || index(name, prefix "_") == 1 }
    function fits(name, word) {
        return begins(name, word) || begins(name, word "s") || word ~ /s$/ && begins(name, substr(word, 1, length(word) - 1)) || sub(/_row$/, "", word) && begins(name, word)
    }
    BEGIN { while ((getline line < headers) > 0) { split(line, w); if (w[1] == "type") types[w[2]] = types[w[2]] " " w[3]; else where[w[3]] = where[w[3]] " " w[2] } }
    $2 == "main" || $2 ~ /^(matc|reference)_/ { next }
    {
        n = split($1, path, "/"); stem = path[n]; sub(/\.c$/, "", stem); folder = path[n - 1]; fine = fits($2, folder)
        for (part = stem; part != ""; ) { if (fits($2, part)) fine = 1; if (!sub(/_[^_]*$/, "", part)) part = "" }
        m = split(where[$2], header, " ")
        for (i = 1; i <= m; i++) { k = split(types[header[i]], type, " "); for (j = 1; j <= k; j++) if (fits($2, type[j])) fine = 1 }
        if (!fine) { print "exports.sh: " $1 ": " $2 " has no prefix"; bad = 1 }
    }
    END { exit bad }' "$work/exports" >"$work/said" || true

# -- Parameters of every definition, in the layout that clang-format gives: a line at the left margin, up to its brace

find compiler runtime grammar tests -name '*.[ch]' | xargs awk -v most="$most" '
    FNR == 1 { head = "" }
    /^[A-Za-z]/ && /\(/ && !/^(typedef|#)/ && !/^[A-Z_]+\(/ { head = $0; line = FNR }
    head != "" && FNR > line { head = head $0 }
    head != "" && /[;={]/ {
        if ((head ~ /\) *\{/ || $0 ~ /^\{/) && head !~ /exr_stream_error_func_ptr_t/) { # OpenEXR calls these with six
            depth = parameters = 0; seen = ""
            for (i = index(head, "("); i <= length(head); i++) {
                c = substr(head, i, 1)
                if (c == "(") depth++
                else if (c == ")" && --depth == 0) break
                else if (c == "," && depth == 1) parameters++
                else if (depth == 1) seen = seen c
            }
            if (seen !~ /^ *(void)? *$/) parameters++
            defined++
            if (parameters > most) {
                name = head; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
                print "exports.sh: " FILENAME ":" line ": " name " takes " parameters " parameters"
            }
        }
        head = ""
    }
    END { print "count", defined > "/dev/stderr" }' 2>"$work/count" >>"$work/said"

# -- Lines of a file

find compiler runtime grammar tests cmake examples setup -name golden -prune -o -type f \
    \( -name '*.[ch]' -o -name '*.def' -o -name '*.glsl' -o -name '*.sh' -o -name '*.awk' -o -name '*.js' -o -name '*.cmake' -o -name setup \) -print |
    xargs awk -v longest="$longest" '
    function end() { if (lines > longest) print "exports.sh: " file " has " lines " lines" }
    FNR == 1 { if (file != "") end(); file = FILENAME }
    { lines = FNR }
    END { end() }' >>"$work/said"

cat "$work/said"
[ -s "$work/said" ] || echo "exports.sh: $(wc -l <"$work/exports") exported names, $(cut -d' ' -f2 "$work/count") functions, all with a prefix and at most $most parameters; no file is longer than $longest lines"
[ ! -s "$work/said" ]
