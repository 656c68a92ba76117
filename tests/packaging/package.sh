#!/bin/sh
# Tests the installed package for C programs and for CMake, without the batch:
# package.sh BUILD_FOLDER. Run from the project's root.
set -u
build=$1
source=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh

# Installed below a stage, as packagers do: the prefix is then another than the files were told.
check "installs to a stage" env DESTDIR="$work/stage" cmake --install "$build" --prefix /opt/matc
prefix=$work/stage/opt/matc
libdir=$(dirname "$(find "$prefix" -name matc.pc)")/..
holds_no_path() { ! grep -rlE "$source|$build|/opt/matc|/usr/" "$prefix" --include='*.cmake' --include='*.pc'; }
check "no file of the package names a folder of the build, or a prefix" holds_no_path
check "the program runs there" "$prefix/bin/matc" --version

for of in document layout manifest reflection; do
    "$prefix/bin/matc" --schema=$of >"$work/schema"
    check "the schema of a $of is installed" cmp "$work/schema" "$prefix/share/matc/schema/$of.schema.json"
done

# pkg-config
export PKG_CONFIG_PATH="$libdir/pkgconfig"
compile() { # compile PROGRAM FLAGS...
    program=$1
    shift
    ${CC:-cc} "$source/examples/embed.c" "$@" -o "$work/$program"
}
runs() { "$work/$1" | grep -q '^// uniform tint: 3 components'; }
uses_library() { ldd "$work/$1" | grep -q "libmatc.so.0.2"; }
# shellcheck disable=SC2046
check "compiles with the shared library" compile shared $(pkg-config --cflags --libs matc) "-Wl,-rpath,$libdir"
check "which it uses" uses_library shared
check "and runs" runs shared
# shellcheck disable=SC2046
check "compiles with the archive" compile archive $(pkg-config --static --cflags --libs matc | sed 's/-lmatc /-l:libmatc.a /')
uses_none() { ! uses_library "$1"; }
check "which it has inside" uses_none archive
check "and runs" runs archive
check "says its version" test "$(pkg-config --modversion matc)" = "$("$prefix/bin/matc" --version | cut -d' ' -f2)"

# CMake: the kinds of the library
mkdir "$work/kinds"
cat >"$work/kinds/CMakeLists.txt" <<EOF
cmake_minimum_required(VERSION 3.22)
project(kinds LANGUAGES C)
find_package(matc 0.2 REQUIRED \${KIND})
add_executable(\${NAME} $source/examples/embed.c)
target_link_libraries(\${NAME} PRIVATE matc::matc)
set_target_properties(\${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY $work)
EOF
project() { # project NAME ARGUMENTS...
    name=$1
    shift
    cmake -G Ninja -S "$work/kinds" -B "$work/kinds-$name" -DNAME="$name" -DCMAKE_PREFIX_PATH="$prefix" "$@" &&
        cmake --build "$work/kinds-$name"
}
check "find_package" project plain
check "gives the shared library" uses_library plain
check "and runs" runs plain
check "BUILD_SHARED_LIBS=OFF" project off -DBUILD_SHARED_LIBS=OFF
check "gives the archive" uses_none off
check "and runs" runs off
check "COMPONENTS static" project static "-DKIND=COMPONENTS;static"
check "gives the archive" uses_none static
refuses() { # refuses PATTERN COMMAND...
    pattern=$1
    shift
    ! "$@" >"$work/said" 2>&1 && tr -s ' \n' ' ' <"$work/said" | grep -q -e "$pattern"
}
check "an unknown component is refused" refuses "no 'fast'" project fast "-DKIND=COMPONENTS;fast"

# CMake: wrong arguments of matc_add_materials
mkdir "$work/wrong"
cat >"$work/wrong/CMakeLists.txt" <<'EOF'
cmake_minimum_required(VERSION 3.22)
project(wrong LANGUAGES NONE)
include(${MATERIALS})
include(${CMAKE_CURRENT_SOURCE_DIR}/call.cmake)
EOF
echo 'material: Phong' >"$work/wrong/a.yaml"
wrong() { # wrong PATTERN CALL
    rm -rf "$work/wrong/build"
    echo "$2" >"$work/wrong/call.cmake"
    refuses "$1" cmake -G Ninja -S "$work/wrong" -B "$work/wrong/build" -DMATERIALS="$source/cmake/materials.cmake"
}
check "no target" wrong "TARGET is missing" "matc_add_materials(SOURCES a.yaml)"
check "no sources" wrong "m has no SOURCES" "matc_add_materials(TARGET m)"
check "empty sources" wrong "m has no SOURCES" "matc_add_materials(TARGET m SOURCES)"
check "a missing source" wrong "there is no file b.yaml in" "matc_add_materials(TARGET m SOURCES b.yaml)"
check "a folder" wrong "is a folder" "matc_add_materials(TARGET m SOURCES .)"
check "an unknown keyword" wrong "m: no keyword takes 'LAYUOT thin'" \
    "matc_add_materials(TARGET m LAYUOT thin SOURCES a.yaml)"
check "a keyword without a value" wrong "m: nothing follows LAYOUT" "matc_add_materials(TARGET m SOURCES a.yaml LAYOUT)"
check "a missing layout" wrong "there is no file my.yaml" "matc_add_materials(TARGET m SOURCES a.yaml LAYOUT my.yaml)"
check "a target that exists" wrong "there is a target m already" \
    "add_custom_target(m)
matc_add_materials(TARGET m SOURCES a.yaml)"
check "a folder of two targets" wrong "the targets m and n cannot both write to" \
    "matc_add_materials(TARGET m SOURCES a.yaml OUTPUT o)
matc_add_materials(TARGET n SOURCES a.yaml OUTPUT o)"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
