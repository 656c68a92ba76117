#!/bin/sh
# Checks that each test is run by at least one of the builds: ran.sh BUILD_FOLDER... Prints those
# that no build runs. Tests are those that cmake/tests.cmake and CMakeLists.txt name, every
# test_<name>.c in a folder of tests/ and every tests/fuzz/fuzz_<name>.c. A build's tests are read
# from its CTestTestfile.cmake, because a call of ctest would truncate the log of its run. A test
# that printed "SKIPPED: the build " does not count as run by that build; one that was skipped for a
# missing package does. Run from the project's root.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for build; do
    : >"$work/left"
    log=$build/Testing/Temporary/LastTest.log
    [ ! -f "$log" ] || sed -nE '/^[0-9]+\/[0-9]+ Testing: /{ s/.*: //; h; }; /^SKIPPED: the build /{ g; p; }' "$log" >"$work/left"
    sed -nE 's/^add_test\((\[=*\[)?([A-Za-z0-9_]+).*/\2/p' "$build/CTestTestfile.cmake" >"$work/has"
    [ ! -s "$work/left" ] || { grep -vxFf "$work/left" "$work/has" >"$work/rest" && mv "$work/rest" "$work/has"; }
    cat "$work/has"
done | sort -u >"$work/ran"
{
    sed -nE 's/^ *matc_test\(([A-Za-z0-9_]+) .*/\1/p' cmake/tests.cmake CMakeLists.txt
    sed -nE 's/^ *foreach\(tool (.*)\)/\1/p' cmake/tests.cmake | tr ' ' '\n' | sed 's/^/build_/'
    find tests -name "test_*.c" | sed "s,.*/,,; s,[.]c$,,"
    for file in tests/fuzz/fuzz_*.c; do echo "$(basename "$file" .c)_seeds"; done
} | sort -u >"$work/all"
[ "$(wc -l <"$work/all")" -gt 200 ] || { echo "ran.sh: hardly any test is named" && exit 1; }
! comm -23 "$work/all" "$work/ran" | sed 's/$/: no build runs it/' | grep .
