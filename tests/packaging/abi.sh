#!/bin/sh
# Compares the symbols that the libraries export with tests/packaging/abi.txt, and
# libmatc_render's own functions with tests/packaging/abi_render.txt: abi.sh LIBRARY...;
# abi.sh --update libmatc.so writes the list. Lines may be added; a line that disappears, or changes
# its version, breaks compiled programs and requires a new soname version.
set -u
export LC_ALL=C
status=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

dynamic() { nm -D --defined-only "$1" | awk '$2 != "A" { print $3 }' | sort; }

if [ "${1:-}" = --update ]; then
    dynamic "$2" >tests/packaging/abi.txt
    exit
fi
for library in "$@"; do
    case $library in
    *.a)
        nm -g --defined-only "$library" | awk 'NF == 3 { print $3 }' | sort >"$work/given"
        sed 's/@.*//' tests/packaging/abi.txt | sort >"$work/listed"
        ;;
    *matc_render*)
        dynamic "$library" >"$work/given"
        sort tests/packaging/abi.txt tests/packaging/abi_render.txt >"$work/listed"
        ;;
    *)
        dynamic "$library" >"$work/given"
        sort tests/packaging/abi.txt >"$work/listed"
        ;;
    esac
    if ! diff "$work/listed" "$work/given"; then
        echo "FAILED: $library gives other symbols (>) than tests/packaging/abi.txt lists (<)"
        status=1
    fi
done
exit $status
