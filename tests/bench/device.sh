#!/bin/sh
# Run time against error, and frame times, on another machine with a GPU, without compiler and
# packages.
#   device.sh pack          here: copies build/matbench and its libraries to .device/
#   device.sh run FOLDER    there, from the project's root: CSV, plot and page into FOLDER, in under
#                           5 minutes
#   device.sh render FOLDER there: frame times, as text and CSV, in under 4 minutes
#   device.sh pack-tests    here: all tests that draw, built with the preset gpu, and their
#                           dependencies, to .device/
#   device.sh tests FOLDER  there: runs the tests on the GPU, in about 3 minutes; reports into
#                           FOLDER. Exit status 1: a test failed that tests/bench/gpu.txt does not
#                           list
set -eu
cd "$(dirname "$0")/../.."

pack() {
    rm -rf .device
    mkdir -p .device/lib
    cp build/matbench .device/
    # what every glibc system has stays behind
    ldd build/matbench | awk '$3 ~ /^\// { print $3 }' | grep -v -E '/(libc|libm|ld-linux[^/]*)\.so' |
        while read -r library; do cp -L "$library" .device/lib/; done
    ls -l .device .device/lib
}

run() {
    LD_LIBRARY_PATH=$PWD/.device/lib .device/matbench error --gl=egl --seconds=10 --csv "$1/accuracy-gpu.csv" \
        --plot "$1/accuracy-gpu" --page "$1/accuracy-gpu.md"
    sed -i "s#$1/#docs/#g" "$1/accuracy-gpu.md" # the command as it is given here, and no path of that machine
}

render() {
    LD_LIBRARY_PATH=$PWD/.device/lib .device/matbench render --gl=egl --csv "$1/render-gpu.csv" | tee "$1/render-gpu.txt"
}

# glslang as one library instead of seven megabytes in each test. Sets $options of cmake.
share_glslang() {
    folder=$(dirname "$(find /usr/lib /usr/local/lib -name libglslang.a | head -n 1)")
    names="glslang-default-resource-limits glslang SPIRV MachineIndependent GenericCodeGen OGLCompiler OSDependent SPIRV-Tools-opt SPIRV-Tools"
    archives=""
    options=""
    for name in $names; do
        [ ! -f "$folder/lib$name.a" ] || archives="$archives $folder/lib$name.a"
        options="$options -DGLSLANG_$name=$PWD/build-gpu/libglslang-all.so"
    done
    mkdir -p build-gpu
    # shellcheck disable=SC2086
    c++ -shared -o build-gpu/libglslang-all.so -Wl,--whole-archive $archives -Wl,--no-whole-archive -lpthread
}

pack_tests() {
    share_glslang
    # shellcheck disable=SC2086
    cmake --preset gpu $options >/dev/null
    cmake --build build-gpu
    rm -rf .device
    mkdir -p .device/tests/lib
    for file in $(grep -lF 'the driver has no gl' build-gpu/tests/test_*) build-gpu/matc build-gpu/matview; do
        strip -o ".device/tests/$(basename "$file")" "$file"
    done
    for file in build-gpu/tests/test_frame build-gpu/tests/test_gl; do ldd "$file"; done | awk '$3 ~ /^\// { print $3 }' |
        grep -v -E '/(libc|libm|ld-linux[^/]*)\.so' | sort -u | while read -r library; do cp -L "$library" .device/tests/lib/; done
    pwd >.device/tests/root
    tar cf - -C .device tests | xz -T0 --block-size=200MiB --lzma2=preset=2,dict=64MiB >.device/tests.tar.xz
    rm -r .device/tests
    ls -l .device
}

# Tests name this folder by its path on the machine that built them, and the programs in its build-gpu.
run_tests() {
    tar xJf .device/tests.tar.xz -C .device
    root=$(cat .device/tests/root)
    [ -e "$root" ] || { mkdir -p "$(dirname "$root")" && ln -s "$PWD" "$root"; }
    mkdir -p build-gpu "$1/logs"
    mv .device/tests/matc .device/tests/matview build-gpu/
    export LD_LIBRARY_PATH="$PWD/.device/tests/lib"
    ls .device/tests | grep '^test_' | xargs -P "$(nproc)" -I{} sh -c \
        'timeout 280 ".device/tests/$1" >"$2/logs/$1" 2>&1; echo "$? $1"' - {} "$1" | sort -k 2 >"$1/results.txt"
    unexpected=0
    while read -r status name; do
        reason=$(sed -n "s/^$name  *//p" tests/bench/gpu.txt)
        case $status in
        0) [ -z "$reason" ] || echo "$name passes, though: $reason" ;;
        77) echo "$name was skipped" ;;
        *)
            [ -n "$reason" ] || unexpected=$((unexpected + 1))
            echo "$name fails: ${reason:-NOT EXPECTED}"
            ;;
        esac
    done <"$1/results.txt"
    echo "$(grep -c '^0 ' "$1/results.txt") of $(grep -c . "$1/results.txt") pass, $unexpected fail that are not expected to"
    tar cJf "$1/logs.tar.xz" -C "$1" logs
    rm -r "$1/logs"
    [ "$unexpected" = 0 ]
}

case "${1:-}" in
pack) pack ;;
run) run "${2:?a folder}" ;;
render) render "${2:?a folder}" ;;
pack-tests) pack_tests ;;
tests) run_tests "${2:?a folder}" ;;
*)
    sed -n '2,8p' "$0" | cut -c3-
    exit 2
    ;;
esac
