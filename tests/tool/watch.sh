#!/bin/sh
# Tests matc --watch: watch.sh MATC
set -u
matc=$(realpath "$1")
work=$(mktemp -d)
pid=
trap '[ -z "$pid" ] || kill $pid 2>/dev/null; rm -rf "$work"' EXIT
failed=0

fail() {
    failed=$((failed + 1))
    echo "FAILED: $1"
    sed 's/^/    /' "$work/log"
}
# within NAME COMMAND...: the command succeeds within some seconds
within() {
    name=$1
    shift
    tries=100
    while ! "$@" >/dev/null 2>&1; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || { fail "$name"; return; }
        sleep 0.1
    done
}
start() {
    : >"$work/log"
    "$matc" --no-validate --watch "$@" 2>"$work/log" &
    pid=$!
}
# The process must end by the signal's status
stop() {
    kill -TERM $pid
    wait $pid
    got=$?
    pid=
    [ $got = 143 ] || fail "exit status $got after SIGTERM"
}
has() { grep -q -- "$2" "$work/$1"; }
says() { grep -q -- "$1" "$work/log"; }
colour() { printf 'defs: { paint: "%s" }\n' "$1" >"$work/palette.yaml"; }

cd "$work" || exit 1
colour '#ff0000'
printf 'include: palette.yaml\nmaterial: Phong\nemissive: { map: Blend, blend: [{ value: 0, input: { ref: paint } }, { value: 1, input: 0 }], input: { map: Wood } }\n' >a.yaml
start --pass=value --slot=emissive a.yaml -o a.frag
within "-o writes" has a.frag 'vec3(1.0, 0.0, 0.0)'
sleep 0.1
colour '#00ff00'
within "a file that is included" has a.frag 'vec3(0.0, 1.0, 0.0)'
printf 'defs: { paint: [' >palette.yaml
within "a fault is told" says 'palette.yaml:.*error'
has a.frag 'vec3(0.0, 1.0, 0.0)' || fail "what was written stays"
rm palette.yaml
within "a file that is gone" says 'cannot read.*palette.yaml'
colour '#0000ff'
within "and comes back" has a.frag 'vec3(0.0, 0.0, 1.0)'
before=$(ls -i a.frag)
printf '# nothing new\n' >>a.yaml
within "a change of no consequence" sh -c '[ $(grep -c "watching" log) -ge 6 ]'
[ "$before" = "$(ls -i a.frag)" ] || fail "an output that stays the same is left alone"
stop

printf 'material: Phong\ndiffuse: red\n' >b.yaml
start b.yaml -o b.frag
within "one file is one" says 'watching 1 file$'
printf 'include: palette.yaml\nmaterial: Phong\ndiffuse: red\n' >b.yaml
within "two are files" says 'watching 2 files$'
stop
printf 'material: Phong\ndiffuse: red\n' >b.yaml
printf 'a.yaml\n' >list.txt
start -d out @list.txt
within "-d writes" test -s out/manifest.json
within "and tells" says 'files written'
sleep 0.1
printf 'b.yaml\n' >>list.txt
within "a list that grows" test -s out/b.frag
printf 'a.yaml\n' >list.txt
within "and shrinks" sh -c '! test -e out/b.frag'
stop

"$matc" --no-validate -d own --emit=glsl,layout --layout=auto b.yaml 2>log
cp own/auto.layout.yaml mine.yaml 2>/dev/null || cp own/*.yaml mine.yaml
start --layout=mine.yaml -d out b.yaml
within "-d by a layout of one's own" test -s out/b.frag
printf 'no layout' >mine.yaml
within "a layout that changes" says 'nothing written'
stop

"$matc" --watch a.yaml 2>log && fail "--watch without an output"
"$matc" --watch -o x.frag - 2>log </dev/null && fail "--watch of standard input"
[ $failed = 0 ]
