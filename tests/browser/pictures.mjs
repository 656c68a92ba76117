// Texels of picture files: of those that a browser does not decode, or not to all of their bits.
import {inflateSync} from 'node:zlib';
import fs from 'node:fs';

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

// A half float's number.
function half(bits) {
  const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, rest = bits & 1023;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + rest / 1024) : 2 ** -24 * rest);
}

const isExr = bytes => bytes.readUInt32LE(0) === 0x01312f76;
// A picture of half floats whose lines stand as they are, as those of a packed file do where packing makes them no shorter. In a line the
// channels follow one another, by their names.
function exr(bytes) {
  const attributes = {}, text = at => bytes.toString('latin1', at, bytes.indexOf(0, at));
  let at = 8;
  while (bytes[at]) {
    const name = text(at), kind = text(at + name.length + 1), size = at + name.length + kind.length + 2;
    attributes[name] = bytes.subarray(size + 4, size + 4 + bytes.readUInt32LE(size));
    at = size + 4 + bytes.readUInt32LE(size);
  }
  const box = i => attributes.dataWindow.readInt32LE(4 * i), width = box(2) - box(0) + 1, height = box(3) - box(1) + 1, names = [];
  for (let c = 0; attributes.channels[c]; c = attributes.channels.indexOf(0, c) + 17) names.push(String.fromCharCode(attributes.channels[c]));
  const texels = new Float32Array(4 * width * height).fill(1), line = 2 * width * names.length;
  for (let y = 0; y < height; y++) {
    const start = Number(bytes.readBigUInt64LE(at + 1 + 8 * y));
    if (bytes.readUInt32LE(start + 4) !== line) throw new Error('an EXR picture whose lines are packed, or not of half floats');
    names.forEach((name, c) => {
      for (let x = 0; x < width; x++)
        texels[4 * ((height - 1 - y) * width + x) + 'RGBA'.indexOf(name)] = half(bytes.readUInt16LE(start + 8 + 2 * (c * width + x)));
    });
  }
  return {width, height, lanes: 4, floats: Buffer.from(texels.buffer).toString('base64')};
}

export function texelsOf(file, colorspace) {
  const bytes = fs.readFileSync(file);
  return file.endsWith('.ktx') ? ktx(bytes) : isPngOfWords(bytes) ? pngOfWords(bytes, colorspace) : isExr(bytes) ? exr(bytes) : {picture: bytes.toString('base64')};
}
