#!/bin/sh
# What the libraries give, against tests/abi.txt: abi.sh LIBRARY... A line may be added there; one that goes, or changes its
# version, breaks programs that are compiled already, and wants a new number of the library.
set -u
export LC_ALL=C
status=0
wanted=$(mktemp)
trap 'rm -f "$wanted"' EXIT
for library in "$@"; do
    case $library in
    *.a)
        nm -g --defined-only "$library" | awk 'NF == 3 { print $3 }' | sort >"$wanted.got"
        sed 's/@.*//' tests/abi.txt | sort >"$wanted"
        ;;
    *)
        nm -D --defined-only "$library" | awk '$2 != "A" { print $3 }' | sort >"$wanted.got"
        sort tests/abi.txt >"$wanted"
        ;;
    esac
    if ! diff "$wanted" "$wanted.got"; then
        echo "FAILED: $library gives other symbols than tests/abi.txt lists"
        status=1
    fi
    rm -f "$wanted.got"
done
exit $status
