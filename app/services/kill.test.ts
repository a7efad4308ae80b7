import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { bundleHostChild } from '../../tests/support/host-child.ts';
import { startHost, stopHosts } from '../../tests/support/host-kit.ts';
import type { HostService } from './host.ts';

const KILLS = 24;
/** Saves take some 5 ms here: the kill falls anywhere in the first dozen of them. */
const LONGEST_MS = 60;

/**
 * Saves version after version, each a change of every file, a shader more or less, and an autosave; says `ready` when the first
 * is on the disk.
 */
const SAVER = `
  const [path, first] = args;
  const opened = await call('project.open', { path });
  let { revision } = opened;
  for (let version = Number(first); ; version++) {
    const text = version + ' ' + 'x'.repeat(version % 7 === 0 ? 200_000 : 20);
    const sources = { 'always.fs': text, ...(version % 2 === 0 ? { 'even.fs': text } : { 'odd.fs': text }) };
    const files = { project: JSON.stringify({ title: text }), layout: JSON.stringify({ at: text }), sources };
    await call('project.autosave', { handle: opened.handle, files });
    ({ revision } = await call('project.save', { handle: opened.handle, files, revision, overwrite: false }));
    if (version === Number(first)) console.log('ready');
  }`;

let base = '';
let project = '';
let saver = '';
let host: HostService;
const children = new Set<ChildProcess>();

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-kill-'));
  project = join(base, 'project');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), JSON.stringify({ title: '0 ' }));
  saver = await bundleHostChild(base, SAVER);
  host = startHost();
});
afterAll(async () => {
  for (const child of children) child.kill('SIGKILL');
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

interface Opened {
  readonly handle: string;
  readonly files: { readonly project: string; readonly layout: string | null; readonly sources: Readonly<Record<string, string>> };
  readonly recovery: unknown;
}

async function open(): Promise<Opened> {
  const answer = await host.dispatch('project.open', { path: project });
  if (!('output' in answer)) throw new Error(JSON.stringify(answer));
  return answer.output as Opened;
}

/** The version that every file is of; throws where two differ. */
function versionOf({ project: text, layout, sources }: Opened['files']): number {
  const version = Number.parseInt((JSON.parse(text) as { title: string }).title, 10);
  if (version === 0) return 0;
  const { at } = JSON.parse(layout ?? '{}') as { at: string };
  expect(Object.keys(sources).sort()).toEqual(['always.fs', version % 2 === 0 ? 'even.fs' : 'odd.fs']);
  expect([at, ...Object.values(sources)].map((other) => Number.parseInt(other, 10))).toEqual([version, version, version]);
  return version;
}

/** Runs the saver and kills it `afterMs` after its first save. */
async function saveUntilKilled(first: number, afterMs: number): Promise<void> {
  const { NODE_OPTIONS: _, ...env } = process.env;
  const child = spawn(process.execPath, [saver, project, String(first)], { stdio: ['ignore', 'pipe', 'inherit'], env });
  children.add(child);
  const ended = once(child, 'exit');
  const line = await Promise.race([once(createInterface(child.stdout), 'line'), ended]);
  if (line[0] !== 'ready') throw new Error('The saver ended by itself.');
  await new Promise((done) => setTimeout(done, afterMs));
  child.kill('SIGKILL');
  await ended;
  children.delete(child);
}

test('a project is whole, and rid of leftovers, wherever the process that saves it is killed', async () => {
  let seed = 20_260_401;
  const random = () => {
    seed = (seed * 48_271) % 2_147_483_647;
    return seed / 2_147_483_647;
  };
  let last = 0;
  let found = 0;
  for (let kill = 0; kill < KILLS; kill++) {
    await saveUntilKilled(last + 1, random() * LONGEST_MS);
    const left = await readdir(join(project, '.scrim'));
    if (left.some((name) => /^(?:lock|save|temp)/.test(name))) found++;
    const opened = await open();
    const version = versionOf(opened.files);
    expect(version).toBeGreaterThan(last);
    last = version;
    // Of Scrim's own folder stay what keeps it out of version control, this window's sign, and work that was not saved yet.
    const stayed = (await readdir(join(project, '.scrim'))).filter((name) => !/^(?:\.gitignore$|window-|unsaved-)/.test(name));
    expect(stayed).toEqual([]);
    expect((await readdir(join(project, '.scrim'))).filter((name) => name.startsWith('window-'))).toHaveLength(1);
    const files = opened.recovery === null ? null : (opened.recovery as Opened['files']);
    if (files !== null) expect(versionOf(files)).toBe(version + 1);
    await host.dispatch('project.autosave', { handle: opened.handle, files: null });
    await host.dispatch('project.close', { handle: opened.handle });
  }
  // Else the kills fell beside the saves, and nothing was proved.
  expect(found).toBeGreaterThan(0);
  expect(await readFile(join(project, '.scrim', '.gitignore'), 'utf8')).toBe('*\n');
});
