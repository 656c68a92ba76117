// What a browser has judged well, kept in a file from run to run: a text that linked and drew is not drawn again by the same browser.
import {createHash} from 'node:crypto';
import fs from 'node:fs';

export class Judged {
  #file;
  #judge;
  #known;

  // `judge` is all that a verdict hangs on but the text: the browser, how it draws, and the page that asks it.
  constructor(file, judge) {
    this.#file = file;
    this.#judge = judge;
    this.#known = new Set(fs.existsSync(file) ? fs.readFileSync(file, 'utf8').split('\n') : []);
  }

  #key(text) {
    return createHash('sha256').update(this.#judge).update('\0').update(text).digest('hex');
  }

  has(text) {
    return this.#known.has(this.#key(text));
  }

  // Each with its line at once: a run that is ended loses nothing.
  add(texts) {
    const keys = texts.map(text => this.#key(text)).filter(key => !this.#known.has(key));
    for (const key of keys) this.#known.add(key);
    if (keys.length) fs.appendFileSync(this.#file, keys.map(key => `${key}\n`).join(''));
  }
}
