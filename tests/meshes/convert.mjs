// convert.mjs HOW FROM TO: a mesh as matc reads it. HOW is `3ds` (triangles of all objects of a 3D Studio file, z up, to OBJ, y up), `bunny` (a module with
// positions and cells, to OBJ) or `gz` (as it is, unpacked).
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';

const [, , how, from, to] = process.argv;

// OBJ counts from 1.
function objOf(positions, cells) {
    return positions.map((p) => `v ${p.join(' ')}\n`).join('') + cells.map((c) => `f ${c.map((i) => i + 1).join(' ')}\n`).join('');
}

// A chunk: two bytes of a name, four of its length with these six, then what it holds. Chunks of these names hold others.
const MAIN = 0x4d4d, EDITOR = 0x3d3d, OBJECT = 0x4000, TRIANGLES = 0x4100, VERTICES = 0x4110, FACES = 0x4120;
const FLOAT = 4, WORD = 2;

function read3ds(bytes, positions, cells) {
    let first = 0; // vertex of the object that is read
    function walk(at, end) {
        while (at + 6 <= end) {
            const name = bytes.readUInt16LE(at), next = at + bytes.readUInt32LE(at + 2);
            if (next <= at || next > end) throw new Error(`a chunk at ${at} ends at ${next}, beyond ${end}`);
            let inside = at + 6;
            if (name === OBJECT) inside = bytes.indexOf(0, inside) + 1; // behind its name
            if ([MAIN, EDITOR, OBJECT, TRIANGLES].includes(name)) walk(inside, next);
            if (name === VERTICES) {
                first = positions.length;
                for (let i = 0, count = bytes.readUInt16LE(inside); i < count; i++) {
                    const [x, y, z] = [0, 1, 2].map((k) => bytes.readFloatLE(inside + WORD + (3 * i + k) * FLOAT));
                    positions.push([x, z, -y]);
                }
            }
            if (name === FACES)
                for (let i = 0, count = bytes.readUInt16LE(inside); i < count; i++)
                    cells.push([0, 1, 2].map((k) => first + bytes.readUInt16LE(inside + WORD + (4 * i + k) * WORD)));
            at = next;
        }
    }
    walk(0, bytes.length);
}

if (how === 'gz') {
    writeFileSync(to, gunzipSync(readFileSync(from)));
} else {
    const positions = [], cells = [];
    if (how === '3ds') {
        read3ds(readFileSync(from), positions, cells);
    } else {
        const mesh = createRequire(import.meta.url)(resolve(from));
        positions.push(...mesh.positions);
        cells.push(...mesh.cells);
    }
    if (!cells.length) throw new Error(`${from} has no triangles`);
    writeFileSync(to, objOf(positions, cells));
}
