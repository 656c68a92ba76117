#!/bin/sh
# Depfiles as make and ninja read them: depfile.sh MATC. Run from the project's root. Documents and
# included files get every name of one character, of the character before, after and between
# letters, and of sequences with a special meaning. matc either refuses the name and writes nothing,
# or both make and ninja rebuild exactly the outputs that depend on a changed file. No other command
# is ever executed.
set -u
matc=$(realpath "$1")
command -v make >/dev/null && command -v ninja >/dev/null || {
    echo "SKIPPED: make or ninja is not installed (./setup installs both), so no depfile was read"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/check.sh
mkdir "$work/here"
cd "$work/here" || exit 1
tab=$(printf '\t')
newline='
'
bits='1 2 4 8 16 32 64 128 256'

# -- every name is compiled: D4.frag is of the document that has the fourth name, I4.frag of one that includes it

compile() { "$matc" --no-validate --pass=depth -MD "$@" >"$work/stdout" 2>"$work/stderr"; }

# outcome FILE STATUS NAME: the program and its depfile, or neither and the name
outcome() {
    if [ "$2" = 0 ] && [ -e "$1.frag" ] && [ -e "$1.frag.d" ]; then
        kept="$kept $1"
    elif [ "$2" != 1 ] || [ -e "$1.frag" ] || [ -e "$1.frag.d" ] || ! says 'cannot both read this name'; then
        failed=$((failed + 1))
        echo "FAILED: $1, called '$3': status $2, and $(ls -d "$1".*)"
    fi
}

for bit in 0 $bits; do
    : >"$work/bit$bit"
done
count=0
kept=
name() {
    case $1 in */* | . | .. | - | '') return ;; esac
    [ -e "./$1" ] && return
    count=$((count + 1))
    printf 'material: Phong\n' >"./$1"
    for bit in $bits; do
        [ $((count & bit)) = 0 ] || printf './%s\0' "$1" >>"$work/bit$bit"
    done
    compile -o "D$count.frag" -- "$1"
    outcome "D$count" $? "$1"
    case $1 in *[[:cntrl:]]*) return ;; esac # not within quotes of YAML
    case $1 in *\'*) quoted=$(printf '%s' "$1" | sed "s/'/''/g") ;; *) quoted=$1 ;; esac
    printf "material: Phong\ninclude: '%s'\n" "$quoted" >"include$count.yaml"
    compile "include$count.yaml" -o "I$count.frag"
    outcome "I$count" $? "$1"
}

# Between letters, first, last
places() {
    name "q$1z.yaml"
    name "$1z"
    name "q$1"
}

code=1
while [ $code -lt 128 ]; do
    c=$(printf "\\$(printf '%03o' $code)/") # the slash keeps a newline
    c=${c%/}
    case $c in
    [a-zA-Y0-9]) ;;
    [[:cntrl:]]) name "q${c}z" ;;
    *) places "$c" ;;
    esac
    code=$((code + 1))
done
for pair in ' #' '#:' ': ' '  ' '$$' '$#' '\ ' '\\ ' '\\' '\#' '\:' '\$' '\=' '\%' '\!' '::' ':=' '+=' '!=' '==' '()' '$(' '${' '{}' '%%' \
    "\\$newline" 'ü' '𝄞'; do
    places "$pair"
done
for odd in 'a;touch${IFS}X;.yaml' 'a$(shell touch X).yaml' '$(shell touch X)' '`touch X`' 'a&touch X' "a${newline}all:;touch X${newline}b" \
    "a${newline}${tab}touch X" 'a:;touch X' 'x: y' '= x' '=x=' 'a b=c' 'a(b)' '(b)' 'a(b c)' 'lib.a(x.o)' '~root' '~nobody.yaml' define \
    undefine export override private include -include ifdef endif vpath .PHONY .SUFFIXES '@x' '-f' '<stdin>' '<x>' 'a[b]c' 'a{b,c}d' 'a b\ c' \
    '# b' '%.o' 'C:\a.yaml'; do
    name "$odd"
done
check "names are there" test "$count" -gt 250
for name in 'q#z.yaml' 'q z.yaml' 'q$z.yaml' 'q:z.yaml' 'q%z.yaml' 'q\z.yaml' 'q(z.yaml' 'qüz.yaml' define; do
    check "$name is taken" status 0 compile -o "$work/one.frag" -- "$name"
done
printf 'material: Phong\ninclude: ["q#z.yaml", "q=z.yaml"]\n' >"a=b.yaml"
check "a file without = stands first" status 0 compile -MF "$work/deps" -o "$work/one.frag" "a=b.yaml"
check "and the others behind it" test "$(tr -d "\\\\\n" <"$work/deps")" = "$work/one.frag: q#z.yaml   a=b.yaml   q=z.yaml"

# -- targets

for target in 'a=b' 'a%b' 'a;b' 'a&' '.PHONY' './.PHONY' 'x ' ''; do
    check "no target '$target'" status 1 compile "define" -o "$work/none.frag" -MT "$target"
    check "which is said" says "error: $target: make and ninja cannot both"
    check "and nothing is written" test ! -e "$work/none.frag"
done
check "a target with characters that are escaped" status 0 compile define -MT 'a b#c$d:e' -o "$work/one.frag"
check "has them so" grep -qxF 'a\ b\#c$$d\:e: ./define' "$work/one.frag.d"
check "a batch with such a name" status 1 compile -d "$work/batch" 'q;z.yaml' define
check "is a fault" says "q;z.yaml: make and ninja cannot both"
check "and writes nothing" test ! -e "$work/batch"
check "standard input" status 0 compile - -o "$work/one.frag" <define
check "is no file" grep -qxF "$work/one.frag:" "$work/one.frag.d"
check "nor in a batch" status 0 compile -d "$work/batch" - <define
check "of which it is all" grep -qxF "$work/batch/manifest.json:" "$work/batch/manifest.d"

# -- those that were not refused, in a makefile and for ninja

printf 'all:\n' >Makefile
printf 'rule r\n  command = echo $out; touch $out\n  depfile = $out.d\n' >build.ninja
for item in $kept; do
    printf 'all: %s.frag\n%s.frag:\n\t@echo $@; touch $@\ninclude %s.frag.d\n' "$item" "$item" "$item" >>Makefile
    printf 'build %s.frag: r\n' "$item" >>build.ninja
done
ninja >"$work/out" 2>&1 # writes its log, without which it makes all
ls -A | grep -v ninja_ >"$work/before"

# age BIT: files whose number has the bit are newer than all that is made; what should be made again is `wanted`
age() {
    find . -type f -exec touch -d 2002-01-01 {} +
    find . -name '*.frag' -exec touch -d 2003-01-01 {} +
    xargs -r0 touch -d 2004-01-01 -- <"$work/bit$1"
    for item in $kept; do
        [ $((${item#?} & $1)) = 0 ] || echo "$item.frag"
    done | sort >"$work/wanted"
}

# What a dry run would do: "echo D4.frag; touch D4.frag"
makes() {
    make -rn >"$work/out" 2>&1
    sed 's/^echo \([DI][0-9]*\.frag\); touch \1$/\1/' "$work/out" | grep -v '^make: Nothing to be done' | sort >"$work/made"
    cmp "$work/made" "$work/wanted" || { diff "$work/made" "$work/wanted" | head >"$work/stderr" && false; }
}
ninja_makes() {
    ninja -nv >"$work/out" 2>&1
    sed 's/^\[[0-9/]*\] echo \([DI][0-9]*\.frag\); touch \1$/\1/' "$work/out" | grep -v '^ninja: no work to do' | sort >"$work/made"
    cmp "$work/made" "$work/wanted" || { diff "$work/made" "$work/wanted" | head >"$work/stderr" && false; }
}
for bit in 0 $bits; do
    age $bit
    check "make, of files $bit" makes
    check "ninja, of files $bit" ninja_makes
done

# Now in earnest: all of them, and nothing else
age 1
make -rs >"$work/made" 2>&1
sort -o "$work/made" "$work/made"
check "make makes them" cmp "$work/wanted" "$work/made"
age 1
ninja --quiet >"$work/made" 2>&1
sort -o "$work/made" "$work/made"
check "ninja makes them" cmp "$work/wanted" "$work/made"
ls -A | grep -v ninja_ >"$work/after"
check "nothing else came about" cmp "$work/before" "$work/after"

echo "$passed passed, $failed failed; $count names"
[ "$failed" = 0 ]
