import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { projectText, writeProject } from '../support/project-kit.ts';

const SCRIM = resolve(import.meta.dirname, '../../bin/scrim.mjs');
const chromium = useBrowser();

let base = '';
let project = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-open-'));
  project = join(base, 'project');
  await writeProject(project, { 'project.scrim.json': projectText({ title: 'Opened here', nodes: {}, wires: [] }) });
});
afterAll(() => rm(base, { recursive: true, force: true }));

const running: ChildProcess[] = [];
afterEach(async () => {
  for (const child of running.splice(0)) await end(child);
});

function end(child: ChildProcess): Promise<number | null> {
  return new Promise((done) => {
    if (child.exitCode !== null || child.signalCode !== null) return done(child.exitCode);
    child.once('exit', (code) => done(code));
    child.kill('SIGINT');
  });
}

/** Starts `scrim` as a person does, without a display; gives its lines as they come. */
function scrim(...args: string[]) {
  const { DISPLAY: _, WAYLAND_DISPLAY: __, NODE_OPTIONS: ___, ...env } = process.env;
  const child = spawn(process.execPath, [SCRIM, ...args], { env, stdio: ['ignore', 'pipe', 'pipe'] });
  running.push(child);
  const lines = createInterface(child.stdout)[Symbol.asyncIterator]();
  const errors: string[] = [];
  child.stderr.on('data', (chunk) => errors.push(String(chunk)));
  return { child, nextLine: async () => (await lines.next()).value as string | undefined, errors };
}

/** See `app/cli/commands/open.ts`. */
const USUAL_PORT = 17_246;

async function isFree(port: number): Promise<boolean> {
  const server = createServer();
  const free = await new Promise<boolean>((done) => {
    server.once('error', () => done(false));
    server.listen(port, '127.0.0.1', () => done(true));
  });
  await new Promise((done) => server.close(done));
  return free;
}

describe('scrim open', () => {
  const linux = process.platform === 'linux';

  (linux ? test : test.skip)('says in one line why there is no window, and serves the same editor, until Ctrl-C', async () => {
    const { child, nextLine } = scrim('open', project);
    expect(await nextLine()).toBe('Electron cannot run here (there is no display). The editor opens in the browser instead.');
    const url = (await nextLine()) ?? '';
    expect(url).toMatch(/^http:\/\/127\.0\.0\.1:\d+\/#code=[0-9a-f]{32}$/);
    const page = await chromium.browser.newPage();
    await page.goto(url);
    await page.getByText('Opened here').first().waitFor();
    await page.close();
    expect(await end(child)).toBe(0);
    await expect(fetch(url)).rejects.toThrow();
  });

  test('ends and says so when the address is opened a second time', async () => {
    const { child, nextLine, errors } = scrim('open', project, '--browser');
    const url = (await nextLine()) ?? '';
    const ended = new Promise((done) => child.once('exit', done));
    const first = await chromium.browser.newPage();
    await first.goto(url);
    await first.getByText('Opened here').first().waitFor();
    const second = await chromium.browser.newPage();
    await second.goto(url);
    await second.getByText('The session has ended because its address was opened a second time.').waitFor();
    expect(await ended).toBe(1);
    expect(errors.join('')).toContain('SCR075');
    await first.close();
    await second.close();
  });

  test('has its preview at the port after its own, or at the one it is given', async () => {
    const port = await twoFreePorts();
    const first = scrim('open', project, '--browser', '--port', String(port));
    expect(await previewOf(await first.nextLine())).toBe(`http://127.0.0.1:${port + 1}`);
    await end(first.child);
    const second = scrim('open', project, '--browser', '--port', String(port + 1), '--preview-port', String(port));
    expect(await previewOf(await second.nextLine())).toBe(`http://127.0.0.1:${port}`);
    await end(second.child);
  });

  /** The origin that the editor's page may show in its frame. */
  async function previewOf(url: string | undefined): Promise<string | undefined> {
    const policy = (await fetch(url ?? '')).headers.get('content-security-policy') ?? '';
    return /frame-src ([^;]+)/.exec(policy)?.[1];
  }

  /** Two ports in a row below the ones that Linux gives to outgoing connections (32,768 and up), so no other program takes them meanwhile. */
  async function twoFreePorts(): Promise<number> {
    for (let port = 21_000; ; port += 2) if ((await isFree(port)) && (await isFree(port + 1))) return port;
  }

  test('prints one JSON value for a program that opens the address itself', async () => {
    const { nextLine, child } = scrim('open', project, '--browser', '--json');
    expect(JSON.parse((await nextLine()) ?? '')).toMatchObject({ ok: true, shell: 'server', url: expect.stringContaining('#code=') });
    await end(child);
    expect(await nextLine()).toBeUndefined();
  });

  test('takes the port it is given, and says when that is taken', async () => {
    const blocker = createServer();
    const port = await twoFreePorts();
    await new Promise<void>((done) => blocker.listen(port, '127.0.0.1', done));
    const refused = scrim('open', project, '--browser', '--port', String(port));
    expect(await new Promise((done) => refused.child.once('exit', done))).toBe(2);
    expect(refused.errors.join('')).toContain(`Port ${port} is taken`);
    await new Promise((done) => blocker.close(done));
    const { nextLine } = scrim('open', project, '--browser', '--port', String(port));
    expect(await nextLine()).toContain(`http://127.0.0.1:${port}/#code=`);
  });

  test('has the same address at every start, so that browsers find what was chosen; beside another one, a free address', async () => {
    if (!(await isFree(USUAL_PORT))) {
      process.stderr.write(`SKIPPED the same address at every start: another program has port ${USUAL_PORT}.\n`);
      return;
    }
    const start = async () => {
      const { child, nextLine } = scrim('open', project, '--browser');
      return { child, origin: new URL((await nextLine()) ?? '').origin };
    };
    const first = await start();
    const beside = await start();
    expect(beside.origin).not.toBe(first.origin);
    await end(first.child);
    expect((await start()).origin).toBe(first.origin);
  });

  test('says what is wrong with a project that is none', async () => {
    const { child, errors } = scrim('open', base, '--browser');
    expect(await new Promise((done) => child.once('exit', done))).toBe(1);
    expect(errors.join('')).toContain('SCR004');
  });
});
