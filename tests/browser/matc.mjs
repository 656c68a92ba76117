// What matc writes, as the page's jobs.
import {execFile, execFileSync} from 'node:child_process';
import {promisify} from 'node:util';
import {inflateSync} from 'node:zlib';
import fs from 'node:fs';
import path from 'node:path';

const execute = promisify(execFile);

// The examples; those that hold definitions alone, which others include, are none.
export function exampleDocuments(root) {
  const all = fs.readdirSync(path.join(root, 'examples'), {recursive: true}).filter(file => /\.(yaml|json)$/.test(file));
  const holdsMaterials = file => /^ *"?materials?"?:/m.test(fs.readFileSync(path.join(root, file), 'utf8'));
  return all.map(file => path.join('examples', file)).filter(holdsMaterials).sort();
}

function ktx(bytes) {
  const word = i => bytes.readUInt32LE(12 + 4 * i), isFloat = word(1) === 0x1406, data = bytes.subarray(68).toString('base64');
  return {lanes: word(3) === 0x1908 ? 4 : 1, width: word(6), height: word(7), [isFloat ? 'floats' : 'bytes']: data};
}

const IHDR = 16, COLOUR_LANES = {0: 1, 2: 3, 4: 2, 6: 4}; // where a PNG's size, depth and kind of colour stand
const isPngOfWords = bytes => bytes.readUInt32BE(0) === 0x89504e47 && bytes[IHDR + 8] === 16;

function* pngChunks(bytes) {
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    yield {type: bytes.toString('latin1', at + 4, at + 8), data: bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at))};
}

// Undoes a row's filter: a byte is told from those to the left and above.
function unfilter(kind, row, above, step) {
  for (let i = 0; i < row.length; i++) {
    const left = i < step ? 0 : row[i - step], up = above[i], corner = i < step ? 0 : above[i - step];
    const near = [left, up, corner].map(n => Math.abs(left + up - corner - n));
    const paeth = near[0] <= near[1] && near[0] <= near[2] ? left : near[1] <= near[2] ? up : corner;
    row[i] += [0, left, up, (left + up) >> 1, paeth][kind];
  }
}

// A PNG of 16 bits, which a browser would decode to 8: its texels as floats, the lowest row first. No texture of 16 bits is sRGB: those
// colours are decoded here.
const linear = s => s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
function pngOfWords(bytes, colorspace) {
  const decoded = colorspace === 'srgb' ? linear : value => value;
  const width = bytes.readUInt32BE(IHDR), height = bytes.readUInt32BE(IHDR + 4), lanes = COLOUR_LANES[bytes[IHDR + 9]];
  const packed = inflateSync(Buffer.concat([...pngChunks(bytes)].filter(({type}) => type === 'IDAT').map(({data}) => data)));
  const size = 2 * lanes * width, texels = new Float32Array(4 * width * height);
  let above = Buffer.alloc(size);
  for (let y = 0; y < height; y++) {
    const start = y * (size + 1), row = packed.subarray(start + 1, start + 1 + size), word = i => row.readUInt16BE(2 * i) / 65535;
    unfilter(packed[start], row, above, 2 * lanes);
    for (let x = 0; x < width; x++) {
      const own = Array.from({length: lanes}, (_, lane) => word(x * lanes + lane)), alpha = lanes % 2 ? 1 : own.pop();
      texels.set([...[own[0], own[own.length - 2] ?? own[0], own.at(-1)].map(decoded), alpha], 4 * ((height - 1 - y) * width + x));
    }
    above = row;
  }
  return {width, height, lanes: 4, floats: Buffer.from(texels.buffer).toString('base64')};
}

function texelsOf(file, colorspace) {
  const bytes = fs.readFileSync(file);
  return file.endsWith('.ktx') ? ktx(bytes) : isPngOfWords(bytes) ? pngOfWords(bytes, colorspace) : {picture: bytes.toString('base64')};
}

export class Matc {
  constructor(program, root, folder) {
    Object.assign(this, {program, root, folder, textures: new Map(), runs: 0});
  }

  // Every draw of the documents' materials by these options, as {what, job, ...}.
  batch(options, documents) {
    const out = path.join(this.folder, `run${this.runs++}`), read = name => fs.readFileSync(path.join(out, name), 'utf8');
    fs.rmSync(out, {recursive: true, force: true});
    const fixed = ['--no-validate', '--target=essl300', '--emit=glsl,vertex,unpack,reflect', '--textures', out, '-d', out];
    execFileSync(this.program, [...fixed, ...options, ...documents], {cwd: this.root, stdio: 'pipe'}); // warnings are not asked for
    const manifest = JSON.parse(read('manifest.json'));
    const programs = manifest.programs.map(p => ({...p, fragmentText: read(p.fragment), vertexText: read(p.vertex),
                                                  reflected: JSON.parse(read(p.reflection))}));
    const unpack = manifest.layout && read(manifest.layout.unpack);
    return manifest.materials.flatMap(material => material.programs.map(
      use => this.draw(out, programs[use.program], material, use, options, unpack)));
  }

  draw(out, program, material, use, options, unpack) {
    const {reflected} = program, members = program.constants?.members ?? [];
    const colours = reflected.outputs.filter(output => output.kind === 'color').sort((a, b) => a.location - b.location);
    return {
      what: [material.source, material.name, program.pass, ...options].join(' '), material: material.name, source: material.source,
      program, reflected, unpack,
      job: {
        vertex: program.vertexText, fragment: program.fragmentText, formats: colours.map(output => output.format),
        uniforms: reflected.uniforms.filter(u => u.default).map(u => ({name: u.name, type: u.type, value: use.uniforms?.[u.name] ?? u.default})),
        block: program.constants && {name: program.constants.block, size: program.constants.size,
                                     members: members.map((m, i) => ({...m, value: use.constants[i]}))},
        textures: reflected.textures.map(t => ({name: t.name, key: this.texture(out, t, use.textures?.[t.name])}))
      }
    };
  }

  // Pictures are decoded by the browser, but for those of 16 bits; what matc makes is read from its files.
  texture(out, {name, file, filter, format, colorspace, wrap, anisotropy}, used) {
    const at = path.resolve(this.root, used ?? file ?? path.join(out, `${name}.ktx`)), key = [at, filter, format, colorspace, wrap, anisotropy].join(' ');
    if (!this.textures.has(key)) {
      this.textures.set(key, {key, mipmaps: filter === 'mipmaps', format, wrap, anisotropy, sent: false, ...texelsOf(at, colorspace)});
    }
    return key;
  }

  // The slots of a material at a point, {slot: [lanes]}, by the reference in double precision.
  async evaluate(source, material, point, options) {
    const channels = Object.entries(point).map(([name, value]) => `${name}=${value}`).join(' ');
    const named = /^ *"?materials"?:/m.test(fs.readFileSync(path.resolve(this.root, source), 'utf8')) ? [`--material=${material}`] : [];
    const {stdout} = await execute(this.program, ['--eval', channels, '--target=essl300', ...named, ...options, source], {cwd: this.root});
    return Object.fromEntries(stdout.trim().split('\n').map(line => line.split(' ')).map(([slot, ...lanes]) => [slot, lanes.map(Number)]));
  }
}

// All of the list by `most` at a time.
export async function together(list, most, work) {
  const rest = list.entries(), results = [];
  await Promise.all(Array.from({length: most}, async () => {
    for (const [i, item] of rest) results[i] = await work(item);
  }));
  return results;
}
