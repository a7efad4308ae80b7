import { relative } from 'node:path';

const LONG_MS = 300_000;

/** Names the test files that run for long, because Jest prints nothing of a file before it ends, and the run may be ended before that. */
export default class LongFiles {
  #timers = new Map();

  constructor({ rootDir }) {
    this.rootDir = rootDir;
  }

  onTestFileStart({ path }) {
    const startMs = Date.now();
    const name = relative(this.rootDir, path);
    const timer = setInterval(() => console.error(`RUNS ${name} (for ${Math.round((Date.now() - startMs) / 1000)} s)`), LONG_MS);
    timer.unref();
    this.#timers.set(path, timer);
  }

  onTestFileResult({ path }) {
    clearInterval(this.#timers.get(path));
    this.#timers.delete(path);
  }
}
