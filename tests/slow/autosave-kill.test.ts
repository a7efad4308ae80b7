import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { bundleHostChild } from '../support/host-child.ts';
import { openWindow, startHost, stopHosts } from '../support/host-kit.ts';
import { projectText } from '../support/project-kit.ts';

/** How long somebody works without a pause, and how much of it a kill may cost. */
const WORK_MS = 12_000;
const LOST_AT_MOST_MS = 5000;

/** The editor without its page, with a real host and the time of day: a change every 200 ms, whose title says when it was made. */
const EDITOR = `
  import { setTitle } from './export/graph/commands/project-info.ts';
  import { HostError } from './app/contract/host-error.ts';
  import { pageClock } from './renderer/clock.ts';
  import { apply } from './renderer/state/document/apply.ts';
  import { createEditor } from './renderer/state/editor/editor.ts';
  import { openPath } from './renderer/state/files/files.ts';
  import { autosave } from './renderer/state/start.ts';
  import { DEFAULT_SIZES } from './renderer/state/editor/ui.ts';
  const real = {
    call: async (method, input) => {
      const { output, diagnostic } = await host.dispatch(method, input, 'window');
      if (diagnostic) throw new HostError(diagnostic);
      return output;
    },
    subscribe: (listener) => host.subscribe(listener),
  };
  const editor = createEditor({
    host: real, clock: pageClock, random: Math.random, library: { definitions: [], shaders: {} }, mac: false,
    clipboard: { read: async () => '', write: async () => {} }, keepFile: () => {}, sizes: DEFAULT_SIZES,
  });
  if (!(await openPath(editor, args[0]))) throw new Error(JSON.stringify(editor.ui.getState().toasts));
  autosave(editor);
  setInterval(() => {
    const title = String(Date.now());
    apply(editor, 'Title', setTitle(editor.document.getState().project, { title }));
    console.log(title);
  }, 200);`;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-autosave-'));
});
afterAll(async () => {
  stopHosts();
  await rm(base, { recursive: true, force: true });
});

test('who is killed in the middle of steady work loses no more than five seconds of it', async () => {
  const project = join(base, 'project');
  await mkdir(project);
  await writeFile(join(project, 'project.scrim.json'), projectText({ title: 'Before', nodes: {}, wires: [] }));
  const script = await bundleHostChild(base, EDITOR);
  const { NODE_OPTIONS: _, ...env } = process.env;
  const child = spawn(process.execPath, [script, project], { stdio: ['ignore', 'pipe', 'inherit'], env });
  const ended = once(child, 'exit');
  let firstMs = 0;
  let lastMs = 0;
  for await (const line of createInterface(child.stdout)) {
    lastMs = Number(line);
    firstMs ||= lastMs;
    if (lastMs - firstMs > WORK_MS) break;
  }
  child.kill('SIGKILL');
  await ended;
  expect(lastMs - firstMs).toBeGreaterThan(WORK_MS);
  const { recovery } = await openWindow(startHost(), 'a').call('project.open', { path: project });
  const { title } = JSON.parse(recovery?.project ?? '{}') as { title?: string };
  expect(lastMs - Number(title)).toBeLessThanOrEqual(LOST_AT_MOST_MS);
});
