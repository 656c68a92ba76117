// A browser as a second judge of what matc writes for WebGL 2: node check.mjs MATC ROOT FOLDER BROWSER [--all] [--part=K/N]. FOLDER is
// scratch. Faults are printed as they are found, and every ten seconds how far it is.
// - every program links, draws without an error, and writes finite numbers;
// - the pass `value` of every slot of every example has the values of `matc --eval`;
// - what one program packs, another unpacks within the layout's stated errors.
// --all takes all combinations of pass, layout, noise, antialiasing and precision, instead of some of each: 840, whose programs are tens of thousands
// of texts. Those that linked and drew are kept in FOLDER/judged and not drawn again by the same browser, so that --all --minutes=20
// goes on where it ended, and after a change of matc draws what has changed. --part=2/5 takes of the combinations the 2nd, the 7th and so on.
// BROWSER_PART=drawValues in the environment does that part alone.
import {chromium} from 'playwright-core';
import {Matc, exampleDocuments} from './matc.mjs';
import {linkAndDraw} from './programs.mjs';
import {drawValues} from './values.mjs';
import {roundTrips} from './gbuffer.mjs';
import {Judged} from './judged.mjs';
import fs from 'node:fs';
import path from 'node:path';

const [program, root, folder, executablePath] = process.argv.slice(2, 6).map(p => path.resolve(p));
const all = process.argv.includes('--all'), atOnce = 64, timeout = 600_000;
const [, number, count] = /^--part=(\d+)\/(\d+)$/.exec(process.argv.find(a => a.startsWith('--part=')) ?? '--part=1/1') ?? [];
if (!(number >= 1 && +number <= +count)) {
  console.log('FAILED: --part=K/N takes the Kth part of N');
  process.exit(2);
}
const minutes = +(process.argv.find(a => a.startsWith('--minutes='))?.slice('--minutes='.length) ?? Infinity), end = Date.now() + minutes * 60_000;
if (!(minutes > 0)) {
  console.log('FAILED: --minutes=N takes a number above 0');
  process.exit(2);
}
const isOver = () => Date.now() > end;
const inPart = list => list.filter((_, i) => i % count === number - 1);

// In software, as root too, and without a network.
const args = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run', '--disable-background-networking',
              '--disable-component-update', '--disable-sync', '--host-resolver-rules=MAP * ~NOTFOUND'];
if (!process.getuid()) args.push('--no-sandbox');
const browser = await chromium.launch({executablePath, headless: true, args, timeout});
const page = await browser.newPage();
page.setDefaultTimeout(timeout);
await page.setContent('<canvas></canvas>');
await page.addScriptTag({path: path.join(import.meta.dirname, 'page.js')});
const {floats, renderer} = await page.evaluate(() => about());
console.log(`Chromium ${browser.version()}, ${renderer}`);
if (!floats) {
  console.log('SKIPPED: this browser draws no floats (EXT_color_buffer_float)');
  process.exit(77);
}

const matc = new Matc(program, root, folder), documents = exampleDocuments(root);
// Runs jobs in the page, many at once; textures are sent when they are first needed.
async function run(jobs) {
  const results = [];
  for (let i = 0; i < jobs.length; i += atOnce) {
    const some = jobs.slice(i, i + atOnce), keys = some.flatMap(job => job.textures.map(t => t.key));
    const fresh = [...new Set(keys)].map(key => matc.textures.get(key)).filter(texture => texture && !texture.sent);
    for (const texture of fresh) texture.sent = true;
    results.push(...await page.evaluate(async ({fresh, some}) => {
      for (const texture of fresh) await addTexture(texture);
      return some.map(run);
    }, {fresh, some}));
  }
  return results;
}

// Without --all a combination of options is for some of the documents, others than the one before it.
const SHARE = 6, share = turn => documents.filter((_, i) => i % SHARE === turn % SHARE);
const MOST_PRINTED = 30, BETWEEN = 10_000; // faults; milliseconds
let faults = 0, saidAt = Date.now();
function report(...texts) {
  for (const text of texts) if (faults++ < MOST_PRINTED) console.log(`FAILED: ${text}`);
}
function progress(done, of, what) {
  if (Date.now() - saidAt < BETWEEN) return;
  saidAt = Date.now();
  console.log(`  ${done} of ${of} ${what}, ${faults} faults`);
}
const asked = ['page.js', 'programs.mjs'].map(file => fs.readFileSync(path.join(import.meta.dirname, file), 'utf8'));
const unknown = {has: () => false, add() {}}; // ctest draws all that it asks for
const judged = all ? new Judged(path.join(folder, 'judged'), [browser.version(), renderer, ...asked].join('\0')) : unknown;
const context = {matc, documents, share, root, run, all, inPart, report, progress, judged, isOver};
const only = process.env.BROWSER_PART, parts = [linkAndDraw, drawValues, roundTrips].filter(part => !only || part.name === only);
for (const part of parts) {
  if (isOver()) break;
  const start = Date.now(), found = faults, said = await part(context);
  console.log(`${said}; ${faults - found} faults; ${((Date.now() - start) / 1000).toFixed(1)} s`);
}
await browser.close();
if (faults > MOST_PRINTED) console.log(`${faults - MOST_PRINTED} more faults`);
process.exit(faults ? 1 : 0);
