#!/bin/sh
# Untrusted documents: root.sh MATC MATVIEW. Run from the project's root. With --root=DIR no file
# outside of DIR is read, by any key, path or link of a document; with and without the option no
# message quotes a file that is not a document.
set -u
matc=$(realpath "$1")
matview=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh
secret=s3cret-$$
mkdir -p "$work/outside" "$work/root/below" "$work/library"
printf '%s:x:0:0\n' $secret >"$work/outside/passwd"
printf '%s = "b"\n' $secret >"$work/outside/settings"
printf '%s: 1\n' $secret >"$work/outside/daemon.yaml"
printf '{"%s": 1}\n' $secret >"$work/outside/daemon.json"
printf 'defs:\n  paint: { map: Checker }\n' >"$work/outside/paint.yaml"
cp "$work/outside/paint.yaml" "$work/root/paint.yaml"
cp "$work/outside/paint.yaml" "$work/library/varnish.yaml"
cp examples/tiles.png "$work/outside/tiles.png"
cp examples/tiles.png "$work/root/tiles.png"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/outside/mesh.obj"
cp "$work/outside/mesh.obj" "$work/root/mesh.obj"
ln -s "$work/outside/paint.yaml" "$work/root/leads-out.yaml"
ln -s ../paint.yaml "$work/root/below/leads-in.yaml"
ln -s "$work/outside" "$work/root/folder"
ln -s "$work/root" "$work/by-link"

# document TEXT: as root/below/document.yaml
document() { printf '%b\n' "$1" >"$work/root/below/document.yaml"; }
compile() { "$matc" --no-validate "$@" "$work/root/below/document.yaml" -o "$work/out.frag"; }
draw() { "$matview" --size=8 "$@" "$work/root/below/document.yaml" -o "$work/out.png"; }
is_secret() { ! grep -q $secret "$work/stderr"; }

# -- what is no document is not quoted

for file in passwd settings daemon.yaml daemon.json; do
    for path in "../../outside/$file" "$work/outside/$file"; do
        document "include: $path\nmaterial: Phong"
        for form in text json; do
            check "$path is no document" status 1 compile --diagnostics=$form
            check "$path is not quoted ($form)" is_secret
            check "which is said at its name ($form)" grep -q 'is not a document' "$work/stderr"
        done
    done
done

# -- what lies outside is ignored

picture="material: Phong\ndiffuse: { map: ImageMap, image: PATH }"
include="include: PATH\nmaterial: Phong\ndiffuse: { ref: paint }"
mesh="objects:\n  - { object: Mesh, file: PATH, material: { material: Phong } }\nlights: [{ light: Directional }]"
gltf='{"asset":{"version":"2.0"},"buffers":[{"uri":"PATH","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0}'
zeros12='\000\000\000\000\000\000\000\000\000\000\000\000' one='\000\000\200\077'
printf "$zeros12$one$zeros12$one\000\000\000\000" >"$work/outside/points.bin" # (0, 0, 0) (1, 0, 0) (0, 1, 0)
mv "$work/outside/points.bin" "$work/root/points.bin"
cp "$work/root/points.bin" "$work/outside/apart.bin" # of another name: assimp looks for a lost file beside the mesh
fill() { printf '%s' "$1" | sed "s|PATH|$2|"; }

for path in ../../outside/paint.yaml "$work/outside/paint.yaml" ../leads-out.yaml ../folder/paint.yaml; do
    document "$(fill "$include" "$path")"
    check "$path without --root" status 0 compile
    check "$path with --root" status 1 compile --root="$work/root"
    check "is outside" says "document.yaml:1:10: error: .*it is outside the root folder"
    check "$path in a batch" status 1 "$matc" --root="$work/root" -d "$work/batch" "$work/root/below/document.yaml"
    check "is outside, too" says 'it is outside the root folder'
    check "and from the cache" status 0 "$matc" --cache "$work/cache" -d "$work/batch" "$work/root/below/document.yaml"
    check "of a run without --root" status 1 "$matc" --cache "$work/cache" --root="$work/root" -d "$work/batch" "$work/root/below/document.yaml"
done
for path in ../../outside/absent.yaml ../folder/../../outside/paint.yaml; do
    document "$(fill "$include" "$path")"
    check "$path with --root" status 1 compile --root="$work/root"
    check "does not say whether it is there" says 'it is outside the root folder'
done
document "$(fill "$include" ../paint.yaml)"
for root in "$work/root" "$work/root/" "$work/by-link" "$work/outside/../root" /; do
    check "below $root" status 0 compile --root="$root"
done
check "a relative root" status 0 sh -c "cd '$work/root' && '$matc' --no-validate --root=. below/document.yaml -o '$work/out.frag'"
check "a root above" status 0 sh -c "cd '$work/root/below' && '$matc' --no-validate --root=.. document.yaml -o '$work/out.frag'"
check "a root below the include" status 1 compile --root="$work/root/below"
check "a root that is absent" status 1 compile --root="$work/none"
document "$(fill "$include" leads-in.yaml)"
check "a link that stays" status 0 compile --root="$work/root"
document "include: varnish.yaml\nmaterial: Phong"
check "a folder of -I outside" status 1 compile --root="$work/root" -I "$work/library"
document "include: bricks.yaml\nmaterial: Phong\ndiffuse: { ref: bricks }"
check "what comes with matc" status 0 compile --root="$work/root"

for path in ../../outside/tiles.png "$work/outside/tiles.png" ../folder/tiles.png; do
    document "$(fill "$picture" "$path")"
    check "picture $path without --root" status 0 compile
    check "picture $path with --root" status 1 compile --root="$work/root"
    check "drawn, too" status 1 draw --root="$work/root"
done
document "$(fill "$picture" ../tiles.png)"
check "a picture below" status 0 compile --root="$work/root"

for path in ../../outside/mesh.obj ../folder/mesh.obj; do
    document "$(fill "$mesh" "$path")"
    check "mesh $path without --root" status 0 draw
    check "mesh $path with --root" status 1 draw --root="$work/root"
    check "is outside" says 'it is outside the root folder'
done
document "$(fill "$mesh" ../mesh.obj)"
check "a mesh below" status 0 draw --root="$work/root"
document "$(fill "$mesh" ../mesh.gltf)"
fill "$gltf" points.bin >"$work/root/mesh.gltf"
check "a mesh whose buffer lies below" status 0 draw --root="$work/root"
fill "$gltf" ../outside/apart.bin >"$work/root/mesh.gltf"
check "a mesh whose buffer lies outside, without --root" status 0 draw
check "with it" status 1 draw --root="$work/root"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
