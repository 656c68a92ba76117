// G-buffers: one program packs, the layout's companion text unpacks in another, and each slot is within the layout's stated error
// of what `matc --eval` says.
import {execFileSync} from 'node:child_process';
import {Reference, atPoints} from './values.mjs';

// Documents, the layouts that hold their materials, and by material the titles of the case that it is stored in, in some layout or other;
// where a layout has none of these, it is the first.
const phong = {document: 'tests/browser/surfaces.yaml', layouts: ['compact', 'thin', 'thesis', 'radix', 'integer'], titles: {
  opaque: [], clear: ['Transparent, and neither emissive nor ambient.'], glow: ['Transparent, without diffuse transparency.'], all: ['All slots at once.']
}};
const principled = {document: 'tests/browser/principled.yaml', layouts: ['compact', 'integer'], titles: {
  plain: ['The model Principled.'], coated: ['Principled with a coat.', 'The model Principled, with a coat and fuzz.'],
  velvet: ['Principled with fuzz.', 'The model Principled, with a coat and fuzz.']
}};
const sets = [phong, principled].flatMap(({document, layouts, titles}) => layouts.map(layout => ({document, layout, titles})));

// "emissive.b, diffuseTransparency.r" as [{slot, lane}]; no letters: all lanes.
function lanesOf(text) {
  return text.split(', ').flatMap(name => {
    const [slot, lanes] = name.split('.');
    return lanes ? [...lanes].map(letter => ({slot, lane: 'rgba'.indexOf(letter)})) : [{slot, lane: undefined}];
  });
}

// The fields of each case of a layout as `--explain` tells them, by the case's title, the first by '': encoding, range, error, whether
// that is relative, a part or an angle; or what a slot is always.
function explain(matc, layout) {
  let fields = [];
  const cases = new Map([['', fields]]);
  for (const line of execFileSync(matc.program, ['--explain', layout], {encoding: 'utf8'}).split('\n')) {
    const title = /^Case \d+: (.*)$/.exec(line)?.[1];
    if (title) cases.set(title, fields = []);
    const [, lanes, encoding, range, error] = line.trim().split(/ {2,}/), numbers = /^(\S+) to (\S+)$/.exec(range ?? '');
    if (numbers)
      fields.push({lanes: lanesOf(lanes), encoding, low: +numbers[1], high: +numbers[2], error: parseFloat(error),
                         unit: error.endsWith('%') ? 'percent' : error.endsWith('degrees') ? 'degrees' : 'absolute'});
  }
  return cases;
}

// Reads the slot by its number into a float target. The companion text stands before everything but the version.
function reader(unpack, slots) {
  const value = ({name, lanes}) => `vec4(s.${name}${', 0.0'.repeat(4 - lanes)})`;
  return `#version 300 es\n${unpack}\nprecision highp float;\nuniform int which;\nlayout(location = 0) out vec4 color;\nvoid main() {\n` +
         '    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n    color = vec4(0.0);\n' +
         slots.map((slot, i) => `    if (which == ${i}) color = ${value(slot)};\n`).join('') + '}\n';
}
const screen = '#version 300 es\nvoid main() {\n    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n';
const members = unpack => [...unpack.matchAll(/^    (float|vec2|vec3|vec4) (\w+);/gm)];
const storedSlots = unpack => members(unpack).map(([, type, name]) => ({name, lanes: type === 'float' ? 1 : +type[3]}));

const angle = (a, b) => {
  const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return Math.atan2(cross, dot) * 180 / Math.PI;
};
// Arithmetic in floats, in front of the encoding; and where a relative error ends: half floats and exponents have a least step.
const ROUNDING = 5e-6, least = encoding => /^log/.test(encoding) ? 1 / 32 : /^(raw|plain)/.test(encoding) ? 2 ** -14 : 2 ** -20;

function missOf(field, wanted, read, lane) {
  if (field.unit === 'degrees') return {off: angle(wanted, read), bound: field.error + 1e-4};
  const within = value => Math.min(Math.max(value, field.low), field.high), value = within(wanted[lane]);
  const of = /^sharedExponent/.test(field.encoding) ? Math.max(...wanted.map(within)) : Math.abs(value);
  const bound = field.unit === 'percent' ? (field.error / 100 * 1.001 + ROUNDING) * of + least(field.encoding) : field.error * 1.001 + ROUNDING;
  return {off: Math.abs(read[lane] - value), bound};
}

function compareSlot(fields, slot, wanted, read) {
  const own = fields.flatMap(field => field.lanes.filter(l => l.slot === slot.name).map(({lane}) => ({field, lane})));
  const isWhole = ({field, lane}) => lane === undefined && field.unit !== 'degrees';
  const whole = own.flatMap(part => isWhole(part) ? wanted.map((_, lane) => ({field: part.field, lane})) : [part]);
  if (!own.length) return wanted.every((value, lane) => value === read[lane]) ? [] : [`${read} came back, and an absent one is ${wanted}`];
  return whole.map(({field, lane}) => ({field, lane, ...missOf(field, wanted, read, lane)})).filter(({off, bound}) => !(off <= bound))
      .map(({field, lane, off, bound}) => `lane ${lane ?? 'all'} (${field.encoding}): ${wanted} came back as ${read}; ${off} off, ${bound} allowed`);
}

export async function roundTrips({matc, run, inPart, report, progress}) {
  const reference = new Reference(matc);
  let count = 0;
  const part = inPart(sets);
  for (const [done, {document, layout, titles}] of part.entries()) {
    progress(done, part.length, `sets and layouts, ${count} numbers`);
    const cases = explain(matc, layout);
    for (const draw of matc.batch([`--layout=${layout}`, '--trigonometry=bounded'], [document])) {
      const slots = storedSlots(draw.unpack), keep = `${layout} ${draw.material} `, pack = {...atPoints(draw.job), keep};
      const unpack = slots.map((_, i) => ({
        vertex: screen, fragment: reader(draw.unpack, slots), formats: ['float'], width: pack.width, height: 1, points: 0, attributes: {},
        uniforms: [{name: 'which', type: 'int', value: [i]}], textures: draw.job.formats.map((_, k) => ({name: `matc_gbuffer${k}`, key: keep + k}))
      }));
      const [packed, ...read] = await run([pack, ...unpack]), error = packed.error ?? read.find(r => r.error)?.error;
      if (error) {
        report(`${draw.what}: ${error}`);
        continue;
      }
      const fields = cases.get(titles[draw.material].find(title => cases.has(title)) ?? '');
      for (let point = 0; point < pack.points; point++) {
        const wanted = await reference.atPoint(draw, point, []);
        slots.forEach((slot, i) => {
          const numbers = read[i].pixels[0].slice(4 * point, 4 * point + slot.lanes).map(Number);
          count += slot.lanes;
          report(...compareSlot(fields, slot, wanted[slot.name], numbers).map(text => `${draw.what}, point ${point}, ${slot.name}: ${text}`));
        });
      }
    }
  }
  return `${count} numbers of ${part.length} sets and layouts come back`;
}
