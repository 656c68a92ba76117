// What runs in the page: WebGL 2 programs are linked, drawn into targets of their own, and read back. A job is
//   {vertex, fragment, formats: [...], width, height, points: how many, or 0 for a triangle, attributes: {location: {lanes, values}},
//    constants: {location: values} of attributes that are alike at all vertices, uniforms: [{name, type, value}], block: {name, size, members: [{type, offset, value}]}, textures: [{name, key}], keep: key}
// run(job) gives {error}, or {pixels: [numbers of each target], offsets: {name: byte}, drawn: whether anything is}. With `keep`
// the targets stay as textures key + number, for other jobs. Programs and textures are remembered. There is always a depth buffer.
const gl = document.querySelector('canvas').getContext('webgl2', {antialias: false});
const floats = gl.getExtension('EXT_color_buffer_float'), anisotropic = gl.getExtension('EXT_texture_filter_anisotropic');
const programs = new Map(), textures = new Map(), mostPrograms = 200;
const buffers = Array.from({length: 6}, () => gl && gl.createBuffer()); // of five attributes, and a block's

const formats = {
  float: [gl.RGBA32F, gl.RGBA, gl.FLOAT, Float32Array, 4], RGBA32F: [gl.RGBA32F, gl.RGBA, gl.FLOAT, Float32Array, 4],
  RGBA16F: [gl.RGBA16F, gl.RGBA, gl.FLOAT, Float32Array, 4],
  RGBA16UI: [gl.RGBA16UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array, 4],
  R32UI: [gl.R32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array, 4],
  RG32UI: [gl.RG32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array, 4],
  RGBA32UI: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array, 4]
};
const untouchedWord = 0x7ea5ed00, untouchedFloat = -4096; // what targets hold before something is drawn

function about() {
  const info = gl && gl.getExtension('WEBGL_debug_renderer_info');
  return {floats: !!floats, renderer: info && gl.getParameter(info.UNMASKED_RENDERER_WEBGL)};
}

function shader(kind, text) {
  const made = gl.createShader(kind);
  gl.shaderSource(made, text);
  gl.compileShader(made);
  return made;
}

// A program, or a text: why it is none. Comments, which name the slot and the choices, make no other program.
function link(vertex, fragment) {
  const key = (vertex + fragment).replace(/^\/\/.*$/gm, '');
  if (programs.has(key)) return programs.get(key);
  if (programs.size === mostPrograms) {
    for (const old of programs.values()) typeof old === 'string' || gl.deleteProgram(old);
    programs.clear();
  }
  const program = gl.createProgram(), parts = [shader(gl.VERTEX_SHADER, vertex), shader(gl.FRAGMENT_SHADER, fragment)];
  for (const part of parts) gl.attachShader(program, part);
  gl.linkProgram(program);
  const linked = gl.getProgramParameter(program, gl.LINK_STATUS);
  const why = [...parts.map(part => gl.getShaderInfoLog(part)), gl.getProgramInfoLog(program)].join(' ').trim();
  for (const part of parts) gl.deleteShader(part);
  programs.set(key, linked ? program : `does not link: ${why.slice(0, 200)}`);
  return programs.get(key);
}

const setters = {
  float: 'uniform1fv', vec2: 'uniform2fv', vec3: 'uniform3fv', vec4: 'uniform4fv', int: 'uniform1iv', bool: 'uniform1iv',
  ivec2: 'uniform2iv', mat3: 'uniformMatrix3fv', mat4: 'uniformMatrix4fv'
};
// Those of a program that a job does not set.
function unset(program, job) {
  const set = new Set([...job.uniforms, ...job.textures, ...job.block?.members ?? []].map(({name}) => name));
  const active = [...Array(gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS)).keys()].map(i => gl.getActiveUniform(program, i).name);
  return active.filter(name => !set.has(name));
}
function setUniforms(program, uniforms) {
  for (const {name, type, value} of uniforms) {
    const at = gl.getUniformLocation(program, name);
    if (at && type.startsWith('mat')) gl[setters[type]](at, false, value);
    else if (at) gl[setters[type]](at, value);
  }
}

function setBlock(program, block) {
  const index = gl.getUniformBlockIndex(program, block.name);
  if (index === gl.INVALID_INDEX) return;
  const bytes = new ArrayBuffer(Math.max(block.size, gl.getActiveUniformBlockParameter(program, index, gl.UNIFORM_BLOCK_DATA_SIZE)));
  const view = new DataView(bytes);
  for (const {type, offset, value} of block.members)
    value.forEach((number, i) => (type.startsWith('uint') || type.startsWith('uvec')) ? view.setUint32(offset + 4 * i, number, true)
                                                                                     : view.setFloat32(offset + 4 * i, number, true));
  gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, buffers[5]);
  gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.STREAM_DRAW);
  gl.uniformBlockBinding(program, index, 0);
}

// Where the driver puts the members of uniform blocks.
function offsetsOf(program) {
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS), all = [...Array(count).keys()], offsets = {};
  if (count)
    gl.getActiveUniforms(program, all, gl.UNIFORM_OFFSET).forEach((offset, i) => {
      if (offset >= 0) offsets[gl.getActiveUniform(program, i).name] = offset;
    });
  return offsets;
}

function sampled(mipmaps, wanted) {
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, mipmaps ? gl.LINEAR : gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, mipmaps ? gl.LINEAR_MIPMAP_LINEAR : gl.NEAREST);
  if (wanted > 1 && anisotropic)
    gl.texParameteri(gl.TEXTURE_2D, anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, Math.min(wanted, gl.getParameter(anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT)));
  if (mipmaps) gl.generateMipmap(gl.TEXTURE_2D);
}
function newTexture(key) {
  const texture = gl.createTexture();
  textures.set(key, texture);
  gl.bindTexture(gl.TEXTURE_2D, texture);
}
// {key, format, picture: base64} is decoded by the browser; {key, format, width, height, lanes, floats | bytes: base64} are texels.
async function addTexture({key, format, picture, width, height, lanes, floats, bytes, mipmaps, wrap, anisotropy}) {
  const decode = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
  newTexture(key);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  if (picture) {
    const exact = {imageOrientation: 'flipY', premultiplyAlpha: 'none', colorSpaceConversion: 'none'};
    const decoded = await createImageBitmap(new Blob([decode(picture)]), exact);
    gl.bindTexture(gl.TEXTURE_2D, textures.get(key));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl[format], gl.RGBA, gl.UNSIGNED_BYTE, decoded);
  } else {
    const data = floats ? new Float32Array(decode(floats).buffer) : decode(bytes);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl[format], width, height, 0, lanes === 4 ? gl.RGBA : gl.RED, floats ? gl.FLOAT : gl.UNSIGNED_BYTE, data);
  }
  for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, axis, gl[wrap.toUpperCase()]);
  sampled(mipmaps, anisotropy);
}
function setTextures(program, list) {
  list.forEach(({name, key}, i) => {
    gl.activeTexture(gl.TEXTURE0 + i);
    gl.bindTexture(gl.TEXTURE_2D, textures.get(key));
    gl.uniform1i(gl.getUniformLocation(program, name), i);
  });
  gl.activeTexture(gl.TEXTURE0 + 15);
}

// A framebuffer whose targets are textures, each filled with what nobody draws.
function makeTargets(job) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const made = job.formats.map((name, i) => {
    newTexture(job.keep ? job.keep + i : `target ${i}`);
    const texture = gl.getParameter(gl.TEXTURE_BINDING_2D);
    gl.texStorage2D(gl.TEXTURE_2D, 1, formats[name][0], job.width, job.height);
    sampled(false, 1);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
    return texture;
  });
  gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, job.width, job.height);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, gl.getParameter(gl.RENDERBUFFER_BINDING));
  gl.clear(gl.DEPTH_BUFFER_BIT);
  gl.drawBuffers(job.formats.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
  job.formats.forEach((name, i) => formats[name][3] === Float32Array
                                       ? gl.clearBufferfv(gl.COLOR, i, Array(4).fill(untouchedFloat))
                                       : gl.clearBufferuiv(gl.COLOR, i, Array(4).fill(untouchedWord)));
  return made;
}
function dropTargets(job, made) {
  gl.deleteRenderbuffer(gl.getParameter(gl.RENDERBUFFER_BINDING));
  gl.deleteFramebuffer(gl.getParameter(gl.FRAMEBUFFER_BINDING));
  if (!job.keep) for (const texture of made) gl.deleteTexture(texture);
}
function readTargets(job) {
  return job.formats.map((name, i) => {
    const [, format, type, Numbers, lanes] = formats[name], numbers = new Numbers(job.width * job.height * lanes);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + i);
    gl.readPixels(0, 0, job.width, job.height, format, type, numbers);
    return [...numbers].map(n => Number.isFinite(n) ? n : String(n)); // JSON has no NaN
  });
}

// Some pixel of the first target, by its first lane; without targets nobody can tell.
function isDrawn(job, pixels) {
  const before = job.formats[0]?.endsWith('UI') ? untouchedWord : untouchedFloat;
  return !job.formats.length || pixels[0].some((n, i) => i % 4 === 0 && n !== before);
}

function setAttributes(attributes, constants) {
  for (let i = 0; i < 5; i++) gl.disableVertexAttribArray(i);
  for (const [location, {lanes, values}] of Object.entries(attributes)) {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[location]);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.STREAM_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, lanes, gl.FLOAT, false, 0, 0);
  }
  for (const [location, values] of Object.entries(constants)) gl.vertexAttrib4f(location, ...[0, 0, 0, 1].map((none, i) => values[i] ?? none));
}
function run(job) {
  const program = link(job.vertex, job.fragment);
  if (typeof program === 'string') return {error: program};
  if (unset(program, job).length) return {error: `no value is known for ${unset(program, job)}`};
  gl.useProgram(program);
  const made = makeTargets(job);
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) return {error: 'the targets are incomplete'};
  gl.viewport(0, 0, job.width, job.height);
  gl.enable(gl.DEPTH_TEST);
  setUniforms(program, job.uniforms);
  if (job.block) setBlock(program, job.block);
  setTextures(program, job.textures);
  setAttributes(job.attributes, job.constants ?? {});
  gl.drawArrays(job.points ? gl.POINTS : gl.TRIANGLES, 0, job.points || 3);
  const pixels = readTargets(job), offsets = offsetsOf(program), fault = gl.getError();
  dropTargets(job, made);
  return fault ? {error: `WebGL error 0x${fault.toString(16)}`} : {pixels, offsets, drawn: isDrawn(job, pixels)};
}
