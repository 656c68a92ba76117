// Programs: that each links with its own vertex program, draws into its targets without an error, and writes finite numbers.
const size = 4, SOME = 64, corners = [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]];
const attributes = {
  0: {lanes: 3, values: corners.flat()}, 1: {lanes: 3, values: [0, 0, 1, 0.3, 0, 1, 0, 0.4, 1]},
  2: {lanes: 2, values: [0.1, 0.2, 2.3, 0.4, 0.5, 2.6]},
  3: {lanes: 3, values: [1, 0, 0, 1, 0, 0, 1, 0, 0]}, 4: {lanes: 3, values: [0, 1, 0, 0, 1, 0, 0, 1, 0]}
};
const unit = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], unit3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];
// An eye at (0, 0, 3) that looks down at the plane z = 0.
const uniforms = [
  {name: 'matc_worldFromLocal', type: 'mat4', value: unit}, {name: 'matc_clipFromWorld', type: 'mat4', value: unit},
  {name: 'matc_worldNormalFromLocal', type: 'mat3', value: unit3}, {name: 'matc_eyeNormalFromLocal', type: 'mat3', value: unit3},
  {name: 'matc_worldFromClip', type: 'mat4', value: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -4.95, 0, 0, -1, 5.05]},
  {name: 'matc_eyePosition', type: 'vec3', value: [0, 0, 3]}, {name: 'matc_ior', type: 'float', value: [1]},
  {name: 'matc_eyeFromWorld', type: 'mat3', value: unit3},
  {name: 'matc_planeOrigin', type: 'vec3', value: [0, 0, 0]}, {name: 'matc_planeU', type: 'vec3', value: [1, 0, 0]},
  {name: 'matc_planeV', type: 'vec3', value: [0, 1, 0]}, {name: 'matc_depthZ', type: 'vec4', value: [0, 0, -1.005, 2.915]},
  {name: 'matc_clipW', type: 'vec4', value: [0, 0, -1, 3]}, {name: 'matc_viewer', type: 'vec4', value: [0, 0, 3, 1]},
  {name: 'matc_time', type: 'float', value: [0.25]}, {name: 'matc_object', type: 'float', value: [0.5]}
];

const product = (...lists) => lists.reduce((rows, list) => rows.flatMap(row => list.map(more => [...row, ...more])), [[]]);
const choice = (name, values) => values.map(value => [`--${name}=${value}`]);
const noises = choice('noise', ['lattice', 'groimp', 'simplex']), filters = choice('aa', ['auto', 'none', 'box', 'aniso']);
const layouts = choice('layout', ['compact', 'thin', 'thesis', 'radix', 'integer']);
const precisions = [...choice('precision', ['fast', 'balanced', 'exact']), ['--constants=uniform'], ['--constants=baked', '-O0']];
const packing = choice('pass', ['gbuffer', 'plane']), others = choice('pass', ['sky', 'shadow', 'depth', 'value']);

export const some = [
  ...others, ...product(packing, layouts), ...noises.slice(1), ...filters.slice(1), ...precisions.slice(1),
  ['--aa=box', '--noise=simplex', '--precision=exact', '--pass=value'], ['--pass=sky', '--aa=aniso']
];
export const every = [...product(packing, layouts, noises, filters, precisions), ...product(others, noises, filters, precisions)];

// "float" and half floats: infinities and NaN come as texts.
const notFinite = pixels => pixels.some(numbers => numbers.some(n => typeof n === 'string'));
// Where the driver puts a block's members and where matc says that they are.
const misplaced = (job, offsets) => job.block?.members.find(({name, offset}) => name in offsets && offsets[name] !== offset);

// Its text without the first comments, which name the document: equal ones are one program.
const textOf = job => job.vertex + job.fragment.replace(/^\/\/ .*\n/gm, '');
const whole = job => ({...job, width: size, height: size, points: 0, attributes, uniforms: [...uniforms, ...job.uniforms]});

// What is wrong with a program that ran; undefined: nothing.
function faultOf(job, {error, pixels, offsets, drawn}) {
  if (error) return error;
  if (!drawn) return 'draws nothing';
  if (notFinite(pixels)) return 'draws a number that is none';
  const member = misplaced(job, offsets);
  return member && `${member.name} is at ${offsets[member.name]} in its block, not at ${member.offset}`;
}

// Of what `matc` wrote by one combination, the programs that no other wrote and that are not known to be good.
async function judge(batch, seen, {run, judged, report, isOver}) {
  const fresh = batch.map(draw => ({...draw, text: textOf(draw.job)})).filter(({text}) => !seen.has(text) && seen.add(text) && !judged.has(text));
  for (let i = 0; i < fresh.length && !isOver(); i += SOME) {
    const some = fresh.slice(i, i + SOME), results = await run(some.map(({job}) => whole(job)));
    const faults = some.map(({job}, k) => faultOf(job, results[k]));
    some.forEach(({what}, k) => faults[k] && report(`${what}: ${faults[k]}`));
    judged.add(some.filter((_, k) => !faults[k]).map(({text}) => text));
  }
  return fresh.length;
}

export async function linkAndDraw(context) {
  const {matc, documents, share, all, inPart, progress, isOver} = context, seen = new Set();
  const combinations = inPart([...(all ? every : some).entries()]);
  let done = 0, drawn = 0;
  for (const [turn, options] of combinations) {
    progress(done, combinations.length, `combinations, ${seen.size} programs, ${drawn} of them drawn in this run`);
    drawn += await judge(matc.batch(options, all ? documents : share(turn)), seen, context);
    if (isOver()) return `time is over at combination ${done + 1} of ${combinations.length}: the same command goes on from here`;
    done++;
  }
  return `${seen.size} programs link and draw, ${drawn} of them in this run`;
}
