import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { bundleHostChild } from '../support/host-child.ts';

const PROCESSES = 5;
const SAVES = 60;

/**
 * Adds one to the number in the project until that was saved so many times, as a person would who reloads whenever the folder
 * has changed. Every file holds the number: a mixed folder would be seen at the next opening.
 */
const COUNTER = `
  const [path, saves] = args;
  for (let saved = 0; saved < Number(saves); ) {
    const { handle, files, revision } = await call('project.open', { path });
    const { count } = JSON.parse(files.project);
    if (JSON.parse(files.layout).count !== count || files.sources['count.fs'] !== String(count)) throw new Error('torn');
    const next = { project: JSON.stringify({ count: count + 1 }), layout: JSON.stringify({ count: count + 1 }), sources: { 'count.fs': String(count + 1) } };
    const done = await call('project.save', { handle, files: next, revision, overwrite: false }, 'SCR063');
    if (done !== 'SCR063') saved++;
    await call('project.close', { handle });
  }
  host.dispose();`;

let base = '';
let project = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-race-'));
  project = join(base, 'project');
  await mkdir(join(project, 'shaders'), { recursive: true });
  await writeFile(join(project, 'project.scrim.json'), '{"count":0}');
  await writeFile(join(project, 'project.layout.json'), '{"count":0}');
  await writeFile(join(project, 'shaders', 'count.fs'), '0');
});
afterAll(() => rm(base, { recursive: true, force: true }));

test('of many processes that save one project at once, none writes over another, and none sees half a save', async () => {
  const counter = await bundleHostChild(base, COUNTER);
  const { NODE_OPTIONS: _, ...env } = process.env;
  const children = Array.from({ length: PROCESSES }, () =>
    spawn(process.execPath, [counter, project, String(SAVES)], { env, stdio: ['ignore', 'inherit', 'inherit'] }),
  );
  const statuses = await Promise.all(children.map(async (child) => (await once(child, 'exit'))[0] as number));
  expect(statuses).toEqual(children.map(() => 0));
  // A save that was lost would be missing in the sum.
  expect(JSON.parse(await readFile(join(project, 'project.scrim.json'), 'utf8'))).toEqual({ count: PROCESSES * SAVES });
  expect((await readdir(join(project, '.scrim'))).filter((name) => name !== '.gitignore')).toEqual([]);
});
