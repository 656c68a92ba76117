// Values: the pass `value` of every slot, drawn at points and compared with `matc --eval` there.
import {together} from './matc.mjs';
import fs from 'node:fs';
import path from 'node:path';

// Odd multiples of 1/512: on no border of a Checker whose scale is a small whole number, and exact as floats, which what the
// vertex program makes of them by the matrices below is too. Each a local position, a normal, which dP/du never lies along as it
// would have no direction across it, and a texture coordinate.
const points = [
  [[173, -305, 411], [3, -1, 2], [357, 181]], [[-421, 97, 233], [1, 0, -1], [-143, 467]], [[611, 523, -189], [-2, 3, 1], [701, -389]],
  [[-55, -747, -1001], [0, 0, 1], [-873, -219]], [[1367, 31, 645], [1, 2, -2], [45, 1003]], [[9, 7, 5], [1, 1, 1], [13, 3]],
  [[-2311, 1805, 77], [0, -3, 1], [3071, 2557]], [[821, -1293, -3307], [-1, -1, 4], [-5, -7901]]
].map(([position, normal, texcoord]) => ({position: position.map(n => n / 512), normal, texcoord: texcoord.map(n => n / 512)}));

// A quarter turn about z, twice the size, moved. By columns.
const turn = [0, 1, 0, -1, 0, 0, 0, 0, 1], worldFromLocal = [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0.25, -0.5, 1, 1];
const turned = ([x, y, z]) => [-y, x, z];
const uniforms = [
  {name: 'matc_worldFromLocal', type: 'mat4', value: worldFromLocal}, {name: 'matc_worldNormalFromLocal', type: 'mat3', value: turn},
  {name: 'matc_eyeNormalFromLocal', type: 'mat3', value: turn}, {name: 'matc_clipFromWorld', type: 'mat4', value: worldFromLocal},
  {name: 'matc_ior', type: 'float', value: [1]}, {name: 'matc_eyeFromWorld', type: 'mat3', value: [1, 0, 0, 0, 1, 0, 0, 0, 1]},
  {name: 'matc_viewer', type: 'vec4', value: [5.5, -7.25, 9.125, 1]}, {name: 'matc_time', type: 'float', value: [1.375]},
  {name: 'matc_object', type: 'float', value: [0.6875]}
];
const attribute = values => ({lanes: values[0].length, values: values.flat()});
const attributes = {
  0: attribute(points.map(p => p.position)), 1: attribute(points.map(p => p.normal)), 2: attribute(points.map(p => p.texcoord)),
  3: attribute(points.map(() => [1, 0, 0])), 4: attribute(points.map(() => [0, 1, 0]))
};

// The same point as --eval takes it.
function channels({position, normal, texcoord: [u, v]}) {
  const [x, y, z] = position, [rx, ry, rz] = turned(position), [nx, ny, nz] = turned(normal);
  return {u, v, x, y, z, px: 2 * rx + 0.25, py: 2 * ry - 0.5, pz: 2 * rz + 1, nx, ny, nz,
          dpxdu: 0, dpydu: 2, dpzdu: 0, dpxdv: -2, dpydv: 0, dpzdv: 0,
          ex: 5.5, ey: -7.25, ez: 9.125, ew: 1, time: 1.375, objectRandom: 0.6875};
}

// A job that draws every point as a pixel, its varyings by matc's own vertex program.
export function atPoints(job) {
  const place = `    gl_PointSize = 1.0;\n    gl_Position = vec4((float(gl_VertexID) + 0.5) / ${points.length / 2}.0 - 1.0, 0.0, 0.0, 1.0);\n}\n`;
  return {...job, vertex: job.vertex.replace(/}\n$/, place), points: points.length, width: points.length, height: 1, attributes,
          uniforms: [...uniforms, ...job.uniforms]};
}

// Values of all slots at all points; asked once for each material and noise.
export class Reference {
  constructor(matc) {
    Object.assign(this, {matc, known: new Map()});
  }
  async at(draw, point, options) {
    const relevant = options.filter(option => /^--(noise|derivatives|precision)/.test(option));
    const key = JSON.stringify([draw.source, draw.material, point, relevant]);
    if (!this.known.has(key)) this.known.set(key, this.matc.evaluate(draw.source, draw.material, point, relevant));
    return this.known.get(key);
  }
  async atPoint(draw, i, options) {
    return this.at(draw, channels(points[i]), options);
  }
  // Lowest and highest value of a lane where every coordinate is moved by four steps of a float, one by one and together.
  async nearby(draw, i, slot, lane, options) {
    const here = channels(points[i]), groups = [['u'], ['v'], ['x', 'py'], ['y', 'px'], ['z', 'pz']];
    groups.push(groups.flat());
    const moved = groups.flatMap(names => [4, -4].map(steps => {
      const step = name => steps * 2 ** -23 * Math.max(1, Math.abs(here[name]));
      return {...here, ...Object.fromEntries(names.map(name => [name, here[name] + step(name)]))};
    }));
    const values = (await Promise.all(moved.map(point => this.at(draw, point, options)))).map(slots => slots[slot][lane]);
    values.push((await this.atPoint(draw, i, options))[slot][lane]);
    return {low: Math.min(...values), high: Math.max(...values)};
  }
}

// The rows of a table of bounds that a document is made of: a map's, a wave's or a slot's name stands in one of its files.
export function readBounds(file) {
  const rows = [...fs.readFileSync(file, 'utf8').matchAll(/^(BOUND|DRIVERS)\((?:(\w+)\((\w+)\)|DEFAULT), ([\d.e-]+)/gm)];
  return rows.map(([, row, kind, name, bound]) => ({drivers: row === 'DRIVERS', kind, name, bound: Number(bound)}));
}
// What SwiftShader errs by where it decodes sRGB, 7.4e-6 seen, twice that; what is lost of 16 bits in a half float, which may be cut off.
const DRIVERS_TEXTURES = {SRGB8_ALPHA8: {name: "the driver's sRGB", bound: 1.5e-5}, RGBA16F: {name: 'half floats', bound: 2 ** -11}};
// SwiftShader's sine and cosine err by 1.9e-4 in [-pi, pi] (Vulkan allows 4.9e-4), and values by as much; twice that.
const DRIVERS_SINES = {name: "the driver's sines", bound: 4e-4};
const usesDriversSines = ({reflected, job}) => reflected.choices.trigonometry === 'native' && /\b(sin|cos|tan|asin|acos|atan)\(/.test(job.fragment);
function boundOf(bounds, draw, slot, root) {
  const documents = draw.reflected.sources.filter(file => /\.(yaml|json)$/.test(file));
  const text = documents.map(file => fs.readFileSync(path.resolve(root, file), 'utf8')).join('\n');
  const isOurs = draw.reflected.choices.trigonometry !== 'native';
  const takesPart = ({drivers, kind, name}) => drivers && isOurs ? false : !kind || (kind === 'SLOT' ? slot === name : new RegExp(`\\b${name}\\b`).test(text));
  const textures = draw.reflected.textures.map(({format}) => DRIVERS_TEXTURES[format]).filter(row => row);
  return [...bounds.filter(takesPart), ...textures, ...usesDriversSines(draw) ? [DRIVERS_SINES] : []].reduce((most, row) => row.bound > most.bound ? row : most);
}

const miss = (drawn, low, high, value) => {
  const beyond = Number.isFinite(drawn) ? Math.max(0, low - (high - low) - drawn, drawn - high - (high - low)) : Infinity;
  return beyond / Math.max(1, Math.abs(value));
};

// Compares the pixels of a draw; records the worst of every bound in `worst`, and gives the faults.
export async function compareValues({draw, slot, pixels, options, reference, bounds, worst, root}) {
  const bound = boundOf(bounds, draw, slot, root), faults = [];
  let count = 0;
  for (let i = 0; i < points.length; i++) {
    const wanted = (await reference.atPoint(draw, i, options))[slot];
    for (let lane = 0; lane < wanted.length; lane++, count++) {
      const drawn = Number(pixels[0][4 * i + lane]), value = wanted[lane];
      let off = miss(drawn, value, value, value);
      if (off > bound.bound / 2) {
        const {low, high} = await reference.nearby(draw, i, slot, lane, options);
        off = miss(drawn, low, high, value);
      }
      const name = bound.name ?? 'DEFAULT';
      if (off > (worst.get(name)?.off ?? -1)) worst.set(name, {off, bound: bound.bound, what: draw.what});
      if (!(off <= bound.bound))
        faults.push(`${draw.what}, point ${i}, lane ${lane}: drawn ${drawn}, --eval says ${value}; ` +
                    `${off.toExponential(1)} off, ${bound.bound} allowed`);
    }
  }
  return {count, faults};
}

// Sines and their inverses are as exact as the browser's driver likes, unless matc's own are taken. The first row is for all documents.
const variants = [
  ['--trigonometry=bounded'], ['--trigonometry=native'], ['--trigonometry=bounded', '--noise=groimp'], ['--trigonometry=bounded', '--noise=simplex'],
  ['--constants=baked', '--precision=exact'], ['--trigonometry=bounded', '--aa=box', '--derivatives=analytic'], ['--trigonometry=bounded', '--aa=none']
];

export async function drawValues({matc, documents, share, root, run, all, inPart, report, progress}) {
  const bounds = readBounds(path.join(root, 'tests/bounds.def')), reference = new Reference(matc), worst = new Map(), slots = matc.slots();
  const combinations = inPart([...variants.entries()].flatMap(([turn, options]) => slots.map(slot => ({turn, options, slot}))));
  let count = 0;
  for (const [done, {turn, options, slot}] of combinations.entries()) {
    progress(done, combinations.length, `variants and slots, ${count} values`);
    const draws = matc.batch(['--pass=value', `--slot=${slot}`, ...options], all || !turn ? documents : share(turn));
    const results = await run(draws.map(draw => atPoints(draw.job)));
    await together([...draws.entries()], 4, async ([i, draw]) => {
      if (results[i].error) return report(`${draw.what}: ${results[i].error}`);
      const found = await compareValues({draw, slot, pixels: results[i].pixels, options, reference, bounds, worst, root});
      count += found.count;
      report(...found.faults);
    });
  }
  for (const [name, {off, bound, what}] of worst) console.log(`  ${name}: ${off.toExponential(1)} seen, ${bound} stated (${what})`);
  return `${count} values are those of --eval`;
}
