#!/bin/sh
# Checks that the generated reference pages contain every map, material, formula function and
# definition file, each with its picture, and that the pictures exist:
# pictured.sh MATC REFERENCE_FOLDER. Run from the project's root. Status 77: the build omitted them.
set -u
matc=$1
pages=$2
[ -f "$pages/stamp" ] || {
    echo "SKIPPED: the build made no reference pages (-DMATC_REFERENCE=ON)"
    exit 77
}
missing=0
miss() {
    echo "pictured.sh: $1"
    missing=1
}
# section NAME: from its heading to the next
section() { awk -v head="### $1" '$0 == head { inside = 1; next } /^##/ { inside = 0 } inside' "$pages/reference.md"; }
has() {
    section "$1" | grep -q '^!\[' || miss "$1 has no section with a picture"
}
for name in $("$matc" --list=maps | sed -n 's/^  \([A-Za-z0-9]*\)  .*/\1/p') $("$matc" --list=materials | sed -n 's/^  \([A-Za-z0-9]*\)  .*/\1/p'); do
    has "$name"
done
for name in $("$matc" --list=functions | sed -n '/^Functions/,/^$/s/^  \([a-z0-9A-Z]*\)(.*)  .*/\1/p' | grep -vx attribute); do
    has "$name()"
done
for file in grammar/library/*.yaml; do
    has "$(basename "$file" .yaml)"
done
absent=$(grep -o 'pictures/[A-Za-z0-9._-]*[.]png' "$pages/reference.md" | sort -u | while read -r picture; do
    [ -s "$pages/$picture" ] || echo "$picture"
done)
[ -z "$absent" ] || miss "no such pictures: $(echo "$absent" | tr '\n' ' ')"
exit "$missing"
