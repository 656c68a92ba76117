// Programs: that each links with its own vertex program, draws into its targets without an error, and writes finite numbers.
const size = 4, corners = [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]];
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
  {name: 'matc_clipW', type: 'vec4', value: [0, 0, -1, 3]}
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

export async function linkAndDraw({matc, documents, share, run, all, inPart, report, progress}) {
  const seen = new Set(), combinations = inPart([...(all ? every : some).entries()]);
  for (const [done, [turn, options]] of combinations.entries()) {
    progress(done, combinations.length, `combinations, ${seen.size} programs`);
    const fresh = matc.batch(options, all ? documents : share(turn)).filter(({job}) => {
      const text = job.vertex + job.fragment.replace(/^\/\/ .*\n/gm, ''), known = seen.has(text);
      seen.add(text);
      return !known;
    });
    const whole = job => ({...job, width: size, height: size, points: 0, attributes, uniforms: [...uniforms, ...job.uniforms]});
    const results = await run(fresh.map(({job}) => whole(job)));
    results.forEach(({error, pixels, offsets, drawn}, i) => {
      const {what, job} = fresh[i], member = !error && misplaced(job, offsets);
      if (error) report(`${what}: ${error}`);
      else if (!drawn) report(`${what}: draws nothing`);
      else if (notFinite(pixels)) report(`${what}: draws a number that is none`);
      else if (member) report(`${what}: ${member.name} is at ${offsets[member.name]} in its block, not at ${member.offset}`);
    });
  }
  return `${seen.size} programs link and draw`;
}
