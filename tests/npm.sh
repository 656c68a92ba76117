# Functions shared by tests with packages from npm; sourced with `.` from the project's root.

# skip WORDS: ends the test as one that could not run
skip() {
    echo "SKIPPED: $1"
    exit 77
}

# npm_fetch FROM TO FILE...: the packages that FROM/package-lock.json names lie in TO/node_modules, beside copies of the files.
# They are fetched once. Skips where there is no npm or no registry answers; a package that is another than the lock says fails.
npm_fetch() {
    from=$1
    to=$2
    shift 2
    command -v node >/dev/null && command -v npm >/dev/null || skip "node or npm is not installed (./setup test installs both)"
    mkdir -p "$to"
    for file in package.json package-lock.json; do
        cmp -s "$from/$file" "$to/$file" || rm -rf "$to/node_modules"
    done
    for file in package.json package-lock.json "$@"; do
        cp "$from/$file" "$to/$file"
    done
    [ ! -f "$to/node_modules/.package-lock.json" ] || return 0
    (cd "$to" && npm ci --loglevel=error --no-audit --no-fund --ignore-scripts --fetch-retries=1 --fetch-retry-mintimeout=1000) \
        >"$to/log" 2>&1 && return 0
    tail -5 "$to/log"
    ! grep -qE 'code (ENOTFOUND|EAI_AGAIN|ECONN[A-Z]+|E[A-Z]*TIMEDOUT|E(HOST|NET)UNREACH|ERR_SOCKET_TIMEOUT|E5[0-9][0-9])' "$to/log" ||
        skip "no registry of npm answers"
    echo "FAILED: npm cannot fetch what $from/package-lock.json names"
    exit 1
}
