# Functions shared by the scripts that run matc; sourced with `.` from the project's root. $work is
# their temporary folder.
passed=0
failed=0
skipped=0 # 77: a part was not tried, which is said

# check NAME COMMAND...: the command must succeed
check() {
    name=$1
    shift
    if "$@" >"$work/out" 2>"$work/err"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $name"
        tail -n 15 "$work/out" | sed 's/^/    /'
        sed 's/^/    /' "$work/err" | head -5
        sed 's/^/    | /' "$work/stderr" | head -5
    fi
}

# status WANTED COMMAND...
status() {
    wanted=$1
    shift
    "$@" >"$work/stdout" 2>"$work/stderr"
    got=$?
    [ "$got" = "$wanted" ] || echo "exit status $got, wanted $wanted: $*" >&2
    [ "$got" = "$wanted" ]
}

# only FOLDER NAME...: these are all that lies in the folder, hidden files included
only() {
    folder=$1
    shift
    found=$(ls -A "$folder" | tr '\n' ' ')
    [ "$found" = "$* " ] || echo "$folder has $found" >&2
    [ "$found" = "$* " ]
}

says() { grep -q -- "$1" "$work/stderr"; }
