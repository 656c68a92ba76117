# Shell counterpart of tests/value/share.h, sourced with `.` from the project's root: under CI a
# commit runs a share of many similar cases, and successive commits run all of them.

# share_takes NUMBER SHARES: this commit runs case NUMBER of its SHARES; without TESTS_SHARE always
share_takes() { [ -z "${TESTS_SHARE:-}" ] || [ $((($1 + TESTS_SHARE) % $2)) = 0 ]; }

# share_or_skip NUMBER SHARES: ends a whole test that this commit leaves out
share_or_skip() {
    share_takes "$1" "$2" && return
    echo "SKIPPED: under CI one commit in $2 runs this test, and another one is due"
    exit 77
}
