#!/bin/sh
# Checks each folder's README.md: it names every .c and .def of the folder and no missing file, and
# the README.md of the folder above links to it. Names are in backquotes, and may be patterns such as
# `lower_*.c`. Places in docs/design/glossary.md exist. Below tests/ each test, header and table
# begins with a comment that says what it is. No file may be a link or contain merge markers. Run
# from the project's root.
set -eu
all=$(find . \( -path './build*' -o -name .git \) -prune -o -type f -print)
end='
'
said=$(
    find compiler runtime grammar tests -name README.md | LC_ALL=C sort | while read -r page; do
        folder=${page%/README.md}
        above=$(dirname "$folder")
        grep -qF "(${folder##*/}/README.md)" "$above/README.md" || echo "$above/README.md does not lead to $page"
        names=$(grep -o '`[^` ]*`' "$page" | tr -d '`' | grep -E '^[A-Za-z0-9_/*.]+\.(c|h|def|glsl|sh|txt)$' | sort -u)
        for name in $names; do
            case $all$end in */$name"$end"*) ;; *) echo "$page names $name, which is not there" ;; esac
        done
        set -- "$folder"/*.c "$folder"/*.def
        [ "$folder" != runtime/displace ] || set -- "$@" "$folder"/*/*.c "$folder"/*/*.def
        case $folder in tests*) set -- ;; esac
        for file; do
            known=
            for name in $names; do
                case ${file##*/} in ${name##*/}) known=1 ;; esac
            done
            [ "$known" ] || [ ! -f "$file" ] || echo "$page does not name ${file##*/}"
        done
    done
)
stale=$(awk -F '|' 'NF == 5 && $4 ~ /\// { gsub(/,/, " ", $4); print $4 }' docs/design/glossary.md | tr ' ' '\n' | grep / | while read -r place; do
    # shellcheck disable=SC2086
    ls -d $place >/dev/null 2>&1 || echo "docs/design/glossary.md names $place, which is not there"
done)
bare=$(find tests -name 'test_*.c' -o -name '*.h' -o -name '*.def' | grep -vE '^tests/(golden|errors|examples)/' | while read -r file; do
    case $(head -c 2 "$file") in '/*' | '//') ;; *) echo "$file does not begin with a comment that says what it is" ;; esac
done)
links=$(find . \( -path './build*' -o -path './.*' \) -prune -o -type l -print | sed 's/$/ is a link: nothing here leads elsewhere/')
# The words of git begin a line; here a bracket keeps this file from being one of them.
merged=$(find . \( -path './build*' -o -name .git \) -prune -o -type f -exec grep -IlE '^([<]{7}|[>]{7}) ' {} + | sed 's/$/ holds both sides of a merge/')
[ -z "$said$stale$bare$links$merged" ] || printf '%s\n' "$said" "$stale" "$bare" "$links" "$merged"
[ -z "$said$stale$bare$links$merged" ]
