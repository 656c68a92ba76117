#!/bin/sh
# Uses matc as a subfolder of another project, by add_subdirectory as FetchContent does: its
# library, its compiler, its CMake function. Run from the project's root.
set -eu
. tests/share.sh
share_or_skip 0 3
source=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/CMakeLists.txt" <<EOF
cmake_minimum_required(VERSION 3.22)
project(outer LANGUAGES C)
add_subdirectory($source matc EXCLUDE_FROM_ALL)
add_executable(embedded $source/examples/embed.c)
target_link_libraries(embedded PRIVATE matc::matc)
matc_add_materials(TARGET materials SOURCES rock.yaml)
add_custom_command(OUTPUT made.yaml COMMAND \${CMAKE_COMMAND} -E copy \${CMAKE_CURRENT_SOURCE_DIR}/rock.yaml made.yaml
  DEPENDS rock.yaml)
matc_add_materials(TARGET n SOURCES \${CMAKE_CURRENT_BINARY_DIR}/made.yaml LAYOUT thin PASSES gbuffer shadow EMIT glsl reflect TARGET_GLSL essl300
  CONSTANTS baked OUTPUT "a folder" CACHE cache OPTIONS -j 1 --precision=exact)
get_target_property(manifest n MATC_MANIFEST)
add_custom_target(check ALL DEPENDS n COMMAND \${CMAKE_COMMAND} -E copy \${manifest} copy.json)
# Names that a project is likely to have
foreach(name embed docs tests golden reference dictionary site)
  add_custom_target(\${name})
endforeach()
EOF
cp examples/checker.yaml "$work/rock.yaml"
{
    cmake -G Ninja -S "$work" -B "$work/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=-O0 -DMATC_PROGRAM_NAME=another
    cmake --build "$work/build"
    "$work/build/embedded" >"$work/printed"
} >"$work/said" 2>&1 || { tail -20 "$work/said" && exit 1; }
grep -q '^// uniform tint: 3 components' "$work/printed"
test -f "$work/build/materials/rock.frag"
test -x "$work/build/matc/another" -a ! -e "$work/build/matc/matc" # MATC_PROGRAM_NAME
test -f "$work/build/materials/manifest.json"
# All arguments
made=$work/build/a\ folder
cmp "$made/manifest.json" "$work/build/copy.json"
grep -q '"layout": {"name": "thin"' "$made/manifest.json"
grep -q '"pass": "depth"' "$made/manifest.json" # the shadow of what is opaque
grep -q '^#version 300 es' "$made/made.frag"
grep -q '"coordinates": "long"' "$made/made.json"
test ! -e "$made/made.vert"
test -d "$work/build/cache"
cmake --build "$work/build" --target embedded materials n | grep -q 'no work to do'
DESTDIR=$work/stage cmake --install "$work/build" >/dev/null
test ! -e "$work/stage" # what is inside is not installed with the project
echo "fine"
