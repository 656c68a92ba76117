#!/bin/sh
# Run time against error, and of frames, on another machine with a GPU, which has neither compiler nor packages.
#   tests/bench/device.sh pack          here: build/matbench and the libraries it needs, into .device/
#   tests/bench/device.sh run FOLDER    there, from the project's root: CSV, plot and page into FOLDER, in under 5 minutes
#   tests/bench/device.sh render FOLDER there: what frames take, as text and CSV, in under 4 minutes
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

case "${1:-}" in
pack) pack ;;
run) run "${2:?a folder}" ;;
render) render "${2:?a folder}" ;;
*)
    sed -n '2,5p' "$0" | cut -c3-
    exit 2
    ;;
esac
