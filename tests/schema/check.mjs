// What matc reads and writes against the schemas that it prints, by ajv: node check.mjs MATC ROOT FOLDER. FOLDER is scratch.
// - every schema is one, in ajv's strict mode;
// - examples are accepted; documents with faults are refused, but for those in unseen.txt, whose faults no schema can see;
// - what matc writes (reflections, manifests) is accepted, and with a member more, or one less, it is refused.
import Ajv2020 from 'ajv/dist/2020.js';
import {parse} from 'yaml';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const [matc, root, folder] = process.argv.slice(2).map(p => path.resolve(p));
let passed = 0;
const failures = [];
function check(what, ok, why = '') {
  if (ok) passed++;
  else failures.push(`${what}${why && ': '}${why}`);
}

const ajv = new Ajv2020({strict: true, allowUnionTypes: true, strictRequired: false, strictTypes: false, allErrors: false});
const validate = {};
for (const of of ['document', 'layout', 'manifest', 'reflection']) {
  const text = execFileSync(matc, [`--schema=${of}`], {encoding: 'utf8'});
  try {
    validate[of] = ajv.compile(JSON.parse(text));
    passed++;
  } catch (error) {
    check(`--schema=${of}`, false, error.message);
    validate[of] = () => true;
  }
}

const said = of => ajv.errorsText(validate[of].errors).slice(0, 300);
const files = (dir, test) => fs.readdirSync(path.join(root, dir), {recursive: true}).map(f => path.join(dir, f)).filter(f => test.test(f)).sort();
function read(file) { // undefined: not YAML, or not JSON
  const text = fs.readFileSync(path.resolve(root, file), 'utf8');
  try {
    return file.endsWith('.json') ? JSON.parse(text) : parse(text, {merge: true, maxAliasCount: 1000});
  } catch {
    return undefined;
  }
}

// A document that contains itself is accepted by none.
function accepts(of, value) {
  try {
    return validate[of](value);
  } catch (error) {
    if (error instanceof RangeError) return false;
    throw error;
  }
}

const documents = [];
for (const file of files('examples', /\.(yaml|json)$/)) {
  const tree = read(file);
  const of = tree?.layout && !tree.material ? 'layout' : 'document';
  check(file, accepts(of, tree), said(of));
  if (of === 'document') documents.push(file);
}
check('examples are there', documents.length > 100);

// Faults: the list names exactly those that the schema accepts.
const unseen = [];
for (const file of files('tests/errors', /\.(yaml|json)$/)) {
  if (file.includes('/parts/')) continue;
  const tree = read(file);
  const of = file.includes('/layouts/') ? 'layout' : 'document';
  if (tree !== undefined && accepts(of, tree)) unseen.push(path.relative('tests/errors', file));
}
const list = fs.readFileSync(path.join(root, 'tests/schema/unseen.txt'), 'utf8').split('\n').filter(line => line && !line.startsWith('#'));
for (const name of unseen) check(name, list.includes(name), 'has a fault that the schema does not see; if none can, unseen.txt lists it');
for (const name of list) check(name, unseen.includes(name), 'is in unseen.txt, and is no longer accepted');

// What is written
function* objects(value) {
  if (value && typeof value === 'object') {
    if (!Array.isArray(value)) yield value;
    for (const inner of Object.values(value)) yield* objects(inner);
  }
}
function checkWritten(of, file) {
  const value = JSON.parse(fs.readFileSync(file, 'utf8'));
  check(`${of} ${file}`, validate[of](value), said(of));
  return value;
}
const runs = [[], ['--pass=shadow'], ['--pass=gbuffer,shadow,depth', '--constants=uniform'], ['--constants=baked', '--layout=thesis'],
              ['--pass=plane'], ['--pass=sky'], ['--pass=value', '--slot=normal'], ['--target=glsl110', '--layout=thin'],
              ['--target=glsl450', '--noise=groimp'], ['--target=essl300', '--aa=box'], ['--target=spirv'],
              ['--layout=auto'], ['--layout=examples/engine/layout.yaml'], ['--target=glsl450', '--emit=reflect,compute']];
// A batch wants each name once; what a scene calls its materials is its own affair.
const batch = documents.filter(file => !file.startsWith(path.join('examples', 'scenes')));
let sample;
for (const [i, options] of runs.entries()) {
  const out = path.join(folder, `run${i}`);
  fs.rmSync(out, {recursive: true, force: true});
  execFileSync(matc, ['-d', out, '--no-validate', '--emit=glsl,vertex,unpack,reflect,layout', ...options, ...batch], {cwd: root});
  const manifest = checkWritten('manifest', path.join(out, 'manifest.json'));
  for (const program of manifest.programs) checkWritten('reflection', path.join(out, program.reflection));
  for (const name of fs.readdirSync(out).filter(name => name.endsWith('.layout.yaml')))
    check(`layout ${name}`, accepts('layout', read(path.join(out, name))), said('layout'));
  sample ??= {manifest, reflection: JSON.parse(fs.readFileSync(path.join(out, manifest.programs[0].reflection)))};
}

// The schemas are tight: nothing may be added to any object but those whose members have free names; what must be is missed.
for (const of of ['manifest', 'reflection']) {
  const free = new Set([...objects(sample[of])].flatMap(o => ['uniforms', 'textures'].map(key => o[key]).filter(v => v && !Array.isArray(v))));
  for (const object of objects(sample[of])) {
    if (free.has(object)) continue;
    object.surplus = 1;
    check(`${of}: a member more in {${Object.keys(object).join(', ')}}`, !validate[of](sample[of]));
    delete object.surplus;
  }
  for (const key of ['matc', 'target']) {
    const {[key]: gone, ...rest} = sample[of];
    check(`${of} without ${key}`, !validate[of](rest));
  }
}

for (const failure of failures.slice(0, 30)) console.log(`FAILED: ${failure}`);
console.log(`${passed} passed, ${failures.length} failed`);
process.exit(failures.length ? 1 : 0);
