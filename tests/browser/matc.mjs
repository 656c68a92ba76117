// What matc writes, as the page's jobs.
import {execFile, execFileSync} from 'node:child_process';
import {promisify} from 'node:util';
import {texelsOf} from './pictures.mjs';
import fs from 'node:fs';
import path from 'node:path';

const execute = promisify(execFile);

// The examples; those that hold definitions alone, which others include, are none. Scenes may name their materials as others do, and all are
// written into one folder: they are left out.
export function exampleDocuments(root) {
  const all = fs.readdirSync(path.join(root, 'examples'), {recursive: true}).filter(file => /^(?!scenes\/).*\.(yaml|json)$/.test(file));
  const holdsMaterials = file => /^ *"?materials?"?:/m.test(fs.readFileSync(path.join(root, file), 'utf8'));
  return all.map(file => path.join('examples', file)).filter(holdsMaterials).sort();
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
        constants: Object.fromEntries((reflected.vertex?.attributes ?? []).filter(a => a.default).map(a => [a.location, a.default])),
        uniforms: reflected.uniforms.filter(u => u.default).map(u => ({name: u.name, type: u.type, value: use.uniforms?.[u.name] ?? u.default})),
        block: program.constants && {name: program.constants.block, size: program.constants.size,
                                     members: members.map((m, i) => ({...m, value: use.constants[i]}))},
        textures: reflected.textures.map(t => ({name: t.name, key: this.texture(out, t, use.textures?.[t.name])}))
      }
    };
  }

  // As texture units take it, from the picture's file or from what matc made.
  texture(out, {name, file, filter, format, colorspace, wrap, anisotropy}, used) {
    const at = path.resolve(this.root, used ?? file ?? path.join(out, `${name}.ktx`)), key = [at, filter, format, colorspace, wrap, anisotropy].join(' ');
    if (!this.textures.has(key)) {
      this.textures.set(key, {key, mipmaps: filter === 'mipmaps', format, wrap, anisotropy, sent: false, ...texelsOf(at, colorspace)});
    }
    return key;
  }

  slots() {
    return [...execFileSync(this.program, ['--list=slots'], {encoding: 'utf8'}).matchAll(/^  (\w+)/gm)].map(([, name]) => name);
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
