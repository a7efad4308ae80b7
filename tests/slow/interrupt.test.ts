import { type ChildProcess, spawn } from 'node:child_process';
import { randomUUID } from 'node:crypto';
import { once } from 'node:events';
import { cp, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';

const ROOT = resolve(import.meta.dirname, '../..');
const EXAMPLE = join(ROOT, 'examples/first-light');

let base = '';
const children = new Set<ChildProcess>();
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-interrupt-'));
  // Built before anything is timed by a signal.
  await ended(scrim('--version'));
});
afterAll(async () => {
  for (const child of children) child.kill('SIGKILL');
  await rm(base, { recursive: true, force: true });
});

function scrim(...args: string[]) {
  const { NODE_OPTIONS: _, ...env } = process.env;
  const child = spawn(process.execPath, [join(ROOT, 'bin/scrim.mjs'), ...args], { cwd: base, env, stdio: ['ignore', 'pipe', 'pipe'] });
  children.add(child);
  child.once('exit', () => children.delete(child));
  const said: string[] = [];
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (chunk) => said.push(String(chunk)));
  return { child, said };
}

async function ended({ child, said }: ReturnType<typeof scrim>): Promise<{ status: number | null; said: string }> {
  if (child.exitCode === null && child.signalCode === null) await once(child, 'exit');
  return { status: child.exitCode, said: said.join('') };
}

/** As soon as something whose name begins so lies in the folder. */
async function until(folder: string, beginning: string, { child }: ReturnType<typeof scrim>): Promise<void> {
  while (child.exitCode === null) {
    const names = await readdir(folder).catch(() => []);
    if (names.some((name) => name.startsWith(beginning))) return;
    await new Promise((done) => setTimeout(done, 5));
  }
  throw new Error(`It ended before anything called ${beginning} was there.`);
}

describe('Ctrl-C', () => {
  test('ends a render: status 130, no pictures, nothing left aside', async () => {
    const out = join(base, 'frames');
    const running = scrim('render', EXAMPLE, '--out', out, '--frames', '0..59');
    await until(out, '.scrim-render-', running);
    running.child.kill('SIGINT');
    expect((await ended(running)).status).toBe(130);
    expect(await readdir(base)).toEqual([]);
  });

  test('ends an export: status 130 or, from another program, 143; the page that was there stays as it was', async () => {
    const site = join(base, 'site');
    expect(await ended(scrim('export', EXAMPLE, '--out', site))).toMatchObject({ status: 0 });
    const before = (await readdir(site)).sort();
    for (const [signal, status] of [
      ['SIGINT', 130],
      ['SIGTERM', 143],
    ] as const) {
      const running = scrim('export', EXAMPLE, '--out', site);
      await until(base, 'site.new-', running);
      running.child.kill(signal);
      expect((await ended(running)).status).toBe(status);
      expect(await readdir(base)).toEqual(['site']);
      expect((await readdir(site)).sort()).toEqual(before);
    }
    await rm(site, { recursive: true });
  });

  test('ends an acquisition: status 130, no photographs, and no folder that it made', async () => {
    const running = scrim('capture', EXAMPLE, '--out', join(base, 'deep/photos'), '--count', '500', '--size', '64x64');
    await until(join(base, 'deep'), 'photos.new-', running);
    const fresh = join(base, 'deep', (await readdir(join(base, 'deep')))[0] ?? '');
    await until(join(fresh, 'images'), '0001', running);
    running.child.kill('SIGINT');
    expect((await ended(running)).status).toBe(130);
    expect(await readdir(base)).toEqual([]);
  });
});

/** Between two looks at all processes, which take time from them. */
function pause(): Promise<void> {
  return new Promise((done) => setTimeout(done, 50));
}

/** Command lines of all processes below one, by id; Linux alone has them as files. */
async function below(pid: number): Promise<ReadonlyMap<number, string>> {
  const parents = new Map<number, number>();
  for (const id of (await readdir('/proc')).map(Number).filter(Number.isInteger)) {
    const stat = await readFile(`/proc/${id}/stat`, 'utf8').catch(() => '');
    parents.set(id, Number(stat.slice(stat.lastIndexOf(')') + 1).split(' ')[2]));
  }
  const isBelow = (id: number | undefined): boolean =>
    id !== undefined && id !== 0 && (parents.get(id) === pid || isBelow(parents.get(id)));
  const found = [...parents.keys()].filter(isBelow);
  return new Map(await Promise.all(found.map(async (id) => [id, await readFile(`/proc/${id}/cmdline`, 'utf8').catch(() => '')] as const)));
}

async function browsersBelow(pid: number): Promise<readonly number[]> {
  return [...(await below(pid))].flatMap(([id, line]) => (/headless/.test(line) ? [id] : []));
}

/** Zombies have ended; their parent has not read the exit status yet. */
async function isAlive(pid: number): Promise<boolean> {
  const stat = await readFile(`/proc/${pid}/stat`, 'utf8').catch(() => null);
  return stat !== null && !/\) Z /.test(stat);
}

(process.platform === 'linux' ? describe : describe.skip)('a program with a browser, ended from outside', () => {
  test.each(['SIGTERM', 'SIGKILL'] as const)('by %s, leaves no browser behind', async (signal) => {
    const out = join(base, `left-${signal}`);
    const running = scrim('render', EXAMPLE, '--out', out, '--frames', '0..59');
    await until(out, '.scrim-render-', running);
    const pid = running.child.pid ?? 0;
    let browsers: readonly number[] = [];
    // A browser, and the page in it: that comes when all else is set up.
    while (running.child.exitCode === null && browsers.length < 3) {
      await pause();
      browsers = await browsersBelow(pid);
    }
    running.child.kill(signal);
    await ended(running);
    while ((await Promise.all(browsers.map(isAlive))).includes(true)) await pause();
    expect(browsers.length).toBeGreaterThanOrEqual(3);
    await rm(out, { recursive: true, force: true });
  });
});

/** Ids of the living processes that have this in their environment: children inherit it, also where their parent ends. */
async function marked(mark: string): Promise<readonly number[]> {
  const ids = (await readdir('/proc')).map(Number).filter(Number.isInteger);
  const has = await Promise.all(ids.map(async (id) => (await readFile(`/proc/${id}/environ`, 'latin1').catch(() => '')).includes(mark)));
  return ids.filter((_, i) => has[i]);
}

/** An npm script with a mark of its own, in a process group of its own, as a shell starts it. */
function npmRun(...args: string[]) {
  const mark = `SCRIM_INTERRUPT_MARK=${randomUUID()}`;
  const [name = '', value] = mark.split('=');
  const { NODE_OPTIONS: _, SCRIM_ENDS_WITH: __, ...env } = process.env;
  const child = spawn('npm', ['run', '--silent', ...args], {
    cwd: ROOT,
    env: { ...env, [name]: value },
    stdio: ['ignore', 'pipe', 'pipe'],
    detached: true,
  });
  const said: string[] = [];
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (chunk) => said.push(String(chunk)));
  return { child, said, mark };
}

async function hasBrowser(mark: string): Promise<boolean> {
  const lines = await Promise.all((await marked(mark)).map((id) => readFile(`/proc/${id}/cmdline`, 'utf8').catch(() => '')));
  return lines.some((line) => /headless/.test(line));
}

const BENCH = ['bench', 'canvas'] as const;
const ONE_TEST = ['test:one', 'slow', 'slow/live-glsl'] as const;
/** What each says at its end. */
const ITS_END = { bench: /median/, 'test:one': /Ran all test suites/ };

(process.platform === 'linux' ? describe : describe.skip)('an npm script with a browser, ended from outside', () => {
  const started = new Set<string>();
  afterAll(async () => {
    for (const mark of started) for (const id of await marked(mark)) process.kill(id, 'SIGKILL');
  });

  test.each([
    // Ctrl-C in a terminal reaches the whole group; other programs end npm alone.
    ['SIGINT', BENCH],
    ['SIGTERM', BENCH],
    ['SIGINT', ONE_TEST],
    ['SIGTERM', ONE_TEST],
  ] as const)('by %s, leaves no process: npm run %j', async (signal, script) => {
    const { child, said, mark } = npmRun(...script);
    started.add(mark);
    while (child.exitCode === null && !(await hasBrowser(mark))) await pause();
    expect(child.exitCode).toBeNull();
    process.kill(signal === 'SIGINT' ? -(child.pid ?? 0) : (child.pid ?? 0), signal);
    await gone(mark);
    expect(said.join('')).not.toMatch(ITS_END[script[0]]);
  });

  test('whose output has no reader any more, ends at its first line, before there is a browser: npm run bench 2>&1 | true', async () => {
    const { child, mark } = npmRun(...BENCH);
    started.add(mark);
    for (const stream of [child.stdout, child.stderr]) stream.destroy();
    let browser = false;
    while (!browser && (await marked(mark)).length > 0) {
      await pause();
      browser = await hasBrowser(mark);
    }
    expect(browser).toBe(false);
  });
});

/** As soon as all that was started with this mark has ended. */
async function gone(mark: string): Promise<void> {
  while ((await marked(mark)).length > 0) await pause();
}

describe('a reader who has read enough', () => {
  test('ends the words, and is no error', async () => {
    const running = scrim('plan', EXAMPLE, '--json');
    running.child.stdout.destroy();
    expect(await ended(running)).toEqual({ status: 0, said: '' });
  });
});

test('a folder with a name that begins like an option is named as ./-name', async () => {
  await cp(EXAMPLE, join(base, '-odd'), { recursive: true });
  expect(await ended(scrim('check', './-odd'))).toMatchObject({ status: 0 });
});
