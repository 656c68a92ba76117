# Reads the table of mutants. Variables: `act`, the action; `row`, the name of a row; `root`, the
# project's root.
#   act=list   prints a line for each row: name, file, tests
#   act=check  reports stale rows, whose text does not occur in their file exactly once
#   act=apply  prints the row's file with the text replaced
# An empty line, or the end of the table, ends a row.

function joined(text, line, first) { return first ? line : text "\n" line }

function contents(path, line, text) {
    text = ""
    while ((getline line < path) > 0)
        text = text line "\n"
    close(path)
    return text
}

function occurrences(text, part, count, at) {
    count = 0
    while ((at = index(text, part)) > 0) {
        count++
        text = substr(text, at + 1)
    }
    return count
}

function finish(text, at, times) {
    if (name == "")
        return
    if (name in seen || old_lines == 0 || fault == "" || tests == "" || old == new) {
        print name ": a row has a name of its own, a file, tests, the fault in words, and text before and after" > "/dev/stderr"
        bad++
    }
    seen[name] = 1
    rows++
    if (act == "list")
        print name "\t" file "\t" tests "\t" fault
    if (act == "check") {
        times = occurrences(contents(root "/" file), old)
        if (times != 1) {
            print name ": stale: its text stands in " file " " times " times" > "/dev/stderr"
            bad++
        }
    }
    if (act == "apply" && row == name) {
        text = contents(root "/" file)
        at = index(text, old)
        if (occurrences(text, old) != 1)
            bad++
        else
            printf "%s", substr(text, 1, at - 1) new substr(text, at + length(old))
    }
    name = ""
}

/^#/ { next }
/^$/ { finish(); next }
/^[+-]/ {
    line = substr($0, 3)
    if (/^-/)
        old = joined(old, line, !old_lines++)
    else
        new = joined(new, line, !new_lines++)
    next
}
/^  / { fault = fault (fault == "" ? "" : " ") substr($0, 3); next }
{
    finish()
    name = $1
    file = $2
    tests = ""
    for (i = 3; i <= NF; i++)
        tests = tests (i > 3 ? " " : "") $i
    old = new = fault = ""
    old_lines = new_lines = 0
}
END {
    finish()
    if (act == "check" && !bad)
        print rows " rows, none stale"
    exit bad > 0
}
