#!/bin/sh
# Follows docs/guide/build.md for another build tool, with the installed package:
# build_tools.sh BUILD_FOLDER ninja|make|meson. Builds twice; the second build must do nothing. Run
# from the project's root. Status 77: skipped.
set -u
build=$1
tool=$2
source=$(pwd)
command -v "$tool" >/dev/null || {
    echo "SKIPPED: $tool is not installed (./setup installs it), so what docs/guide/build.md says of it was not tried"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh

prefix=$work/prefix
check "installs" cmake --install "$build" --prefix "$prefix"
PATH=$prefix/bin:$PATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name matc.pc)")
export PKG_CONFIG_PATH
mkdir "$work/tools"
cd "$work/tools" || exit 1
cp "$source/examples/checker.yaml" rock.yaml
cp "$source/examples/embed.c" tool.c
echo '{ "materials": { "metal": { "material": "Phong", "diffuse": { "map": "ImageMap", "image": "a.png" } } } }' >metals.json
cp "$source/examples/tiles.png" a.png
printf 'rock.yaml\nmetals.json\n' >materials.txt

# block TOOL: the first text of that kind in the page
block() { awk -v "kind=\`\`\`$1" '$0 == kind { inside = 1; next } /^```/ { inside = 0 } inside' "$source/docs/guide/build.md"; }
tells() { # tells WORDS COMMAND...
    words=$1
    shift
    "$@" >"$work/told" 2>&1 && grep -q "$words" "$work/told"
}
# builds OUTPUT IDLE COMMAND...: makes the output, then has nothing to do and says so; again when a picture changes
builds() {
    output=$1
    idle=$2
    shift 2
    check "builds" "$@"
    check "a shader" test -f "$output"
    check "is done" tells "$idle" "$@"
    sleep 0.01
    touch a.png
    check "a picture is seen" tells 'matc.* -d ' "$@" $verbose
    check "is done again" tells "$idle" "$@"
}
verbose=""
case $tool in
ninja)
    block ninja >build.ninja
    verbose=-v
    builds out/rock.frag 'no work to do' ninja
    ;;
make)
    block make >Makefile
    builds out/metal.frag 'up to date' make
    ;;
meson)
    block meson >meson.build
    verbose=-v
    check "sets up" meson setup meson
    builds meson/out/metal.frag 'no work to do' ninja -C meson
    ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
