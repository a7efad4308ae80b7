import { chmod, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { eventually } from '../../../tests/support/patience.ts';
import { COLMAP, findTool } from './outside-tools.ts';
import { runTool } from './run-tool.ts';

const { PATH, SCRIM_COLMAP } = process.env;
let base = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-tools-'));
  delete process.env.SCRIM_COLMAP;
});
afterEach(async () => {
  process.env.PATH = PATH;
  if (SCRIM_COLMAP !== undefined) process.env.SCRIM_COLMAP = SCRIM_COLMAP;
  await rm(base, { recursive: true, force: true });
});

async function executable(path: string): Promise<string> {
  await mkdir(join(path, '..'), { recursive: true });
  await writeFile(path, '#!/bin/sh\n');
  await chmod(path, 0o755);
  return path;
}

test('a tool is found by an option, by its setting, or in PATH; an absent one is named with the place to get it', async () => {
  process.env.PATH = `relative:${join(base, 'empty')}`;
  await expect(findTool(COLMAP, null)).rejects.toMatchObject({
    diagnostic: { code: 'SCR078', message: expect.stringContaining('COLMAP is not installed'), fix: expect.stringContaining(COLMAP.url) },
  });
  const inPath = await executable(join(base, 'a folder/colmap'));
  process.env.PATH = `${join(base, 'empty')}:${join(base, 'a folder')}`;
  expect(await findTool(COLMAP, null)).toBe(inPath);
  process.env.SCRIM_COLMAP = await executable(join(base, 'set'));
  expect(await findTool(COLMAP, null)).toBe(join(base, 'set'));
  expect(await findTool(COLMAP, inPath)).toBe(inPath);
  await writeFile(join(base, 'text'), '');
  for (const wrong of ['text', 'missing', 'a folder']) {
    await expect(findTool(COLMAP, join(base, wrong))).rejects.toMatchObject({
      diagnostic: { code: 'SCR078', message: expect.stringContaining('is no executable file') },
    });
  }
});

/** Runs Node as a tool. */
const run = (script: string, args: readonly string[], more: Partial<Parameters<typeof runTool>[0]> = {}) =>
  runTool({
    tool: process.execPath,
    args: ['-e', script, '--', ...args],
    log: join(base, 'log'),
    onLine: () => {},
    interrupted: new AbortController().signal,
    ...more,
  });

test('arguments reach the tool as they are, and what it prints the log', async () => {
  const args = ['a b', '--dash', '$(id)', '"; echo', "it's", '*'];
  const lines: string[] = [];
  const script = 'console.error("to both"); for (const arg of process.argv.slice(1)) console.log(arg)';
  expect(await run(script, args, { onLine: (line) => lines.push(line) })).toEqual(expect.arrayContaining(args));
  expect(lines.filter((line) => line !== 'to both')).toEqual(args);
  const log = await readFile(join(base, 'log'), 'utf8');
  for (const line of ['to both', ...args]) expect(log.split('\n')).toContain(line);
});

test('a failure says what the tool said last, and names the log', async () => {
  await expect(run('console.log("out of stars"); process.exit(3)', [])).rejects.toMatchObject({
    diagnostic: { code: 'SCR078', message: expect.stringMatching(/with status 3: out of stars/), fix: expect.stringContaining('log') },
  });
  const broken = await executable(join(base, 'broken'));
  await writeFile(broken, Uint8Array.of(0, 1, 2, 3));
  await expect(run('', [], { tool: broken })).rejects.toMatchObject({ diagnostic: { code: 'SCR078' } });
});

test('an interrupt ends the tool and what it has started', async () => {
  const interruption = new AbortController();
  let id = 0;
  const child = 'setInterval(() => {}, 1000)';
  const script = `const { spawn } = require('child_process');
    process.on('SIGTERM', () => {});
    console.log(spawn(process.execPath, ['-e', ${JSON.stringify(child)}], { stdio: 'ignore' }).pid);
    setInterval(() => {}, 1000);`;
  const running = run(script, [], {
    interrupted: interruption.signal,
    onLine: (line) => {
      id = Number(line);
      interruption.abort();
    },
  });
  const error = await running.catch((reason: unknown) => reason);
  expect(error).toBe(interruption.signal.reason);
  expect(id).toBeGreaterThan(0);
  await eventually(() => expect(() => process.kill(id, 0)).toThrow('ESRCH'));
});

test('a tool that does not start is not mistaken for a log that cannot be written', async () => {
  await expect(run('', [], { tool: join(base, 'none') })).rejects.toMatchObject({ diagnostic: { code: 'SCR078' } });
  await expect(run('console.log(1)', [], { log: join(base, 'none', 'log') })).rejects.toMatchObject({ code: 'ENOENT', syscall: 'open' });
});

test('a tool that does not end in its time is ended, and so is one whose log cannot be written', async () => {
  const endless = 'setInterval(() => console.log("still here"), 20)';
  await expect(run(endless, [], { log: null, limitMs: 300 })).rejects.toMatchObject({
    diagnostic: { code: 'SCR078', message: expect.stringContaining('did not end within') },
  });
  await expect(run(endless, [], { log: '/dev/full' })).rejects.toMatchObject({ code: 'ENOSPC' });
});
