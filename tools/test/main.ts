import { existsSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import process from 'node:process';
import { runCommand } from '../lib/run-command.ts';
import type { ToolContext } from '../lib/tool.ts';
import { readCounts, unmatchedPaths } from './counts.ts';
import { type Durations, mergeDurations, readDurations } from './durations.ts';
import { PROJECTS, runJest } from './jest.ts';

interface Phase {
  readonly name: string;
  readonly run: () => Promise<number>;
}

const USAGE = `Usage: npm test
       npm run test:one PROJECT [PATH…]   PROJECT: ${PROJECTS.join(', ')} or slow; PATH: part of a test file's path
       npm run test:slow
       npm run record-durations     of the last npm test and test:slow, for tests/support/longest-first.mjs

SCRIM_REQUIRE=electron,data,colmap,pycolmap,skimage,blender,instantmeshes,splat-transform makes tests fail that are else skipped where there is no
Electron, no real data, no COLMAP, no package pycolmap, scikit-image or pynanoinstantmeshes, no Blender, or no splat-transform.`;

/** Names of requirements, as `Requirement` of tests/support/required.ts lists them. */
const REQUIREMENTS = ['electron', 'data', 'colmap', 'pycolmap', 'skimage', 'blender', 'instantmeshes', 'splat-transform'];

/**
 * `npm test`: registry, types, lint, build, then every test project in one run of Jest. A failed phase does not stop the next, so that one
 * run reports all failures. Jest's own counts go to `tests/output/`.
 */
export async function main(args: readonly string[], { root }: ToolContext): Promise<number> {
  const [mode = 'all', project, ...paths] = args;
  const required = (process.env.SCRIM_REQUIRE ?? '').split(',').map((word) => word.trim());
  if (required.some((word) => word !== '' && !REQUIREMENTS.includes(word))) {
    console.error(`SCRIM_REQUIRE is "${required.join(',')}", but may only name ${REQUIREMENTS.join(', ')}, with a comma between them.`);
    return 1;
  }
  if (mode === 'record') return recordDurations(root);
  const jest = (projects: readonly string[], name: string, some: readonly string[] = []): Phase => ({
    name: 'tests',
    run: () => runJest({ root, projects, paths: some, countsFile: countsFile(root, name) }),
  });
  const prepare = [npm(root, 'gen'), ...((await hasScript(root, 'build')) ? [npm(root, 'build')] : [])];
  if (mode === 'all') {
    const checks = [npm(root, 'typecheck'), npm(root, 'lint')];
    return runPhases(root, [...prepare, ...checks, jest(PROJECTS, 'test')], 'test');
  }
  if (mode === 'slow') return runPhases(root, [...prepare, jest(['slow'], 'slow')], 'slow');
  if (mode !== 'one' || project === undefined || ![...PROJECTS, 'slow'].includes(project)) {
    console.error(USAGE);
    return 1;
  }
  return runPhases(root, [...(project === 'unit' ? [npm(root, 'gen')] : prepare), jest([project], 'one', paths)], 'one', paths);
}

async function runPhases(root: string, phases: readonly Phase[], name: string, paths: readonly string[] = []): Promise<number> {
  const failed: string[] = [];
  const times: string[] = [];
  for (const phase of phases) {
    console.log(`\n── ${phase.name}`);
    const startMs = performance.now();
    if ((await phase.run()) !== 0) failed.push(phase.name);
    times.push(`${phase.name} ${((performance.now() - startMs) / 1000).toFixed(1)} s`);
  }
  const counts = await readCounts(countsFile(root, name));
  console.log(`\n── summary\n${times.join(', ')}`);
  for (const line of counts?.lines ?? []) console.log(line);
  if (counts === null || counts.lines.length === 0) console.log('No test ran.');
  // Options of Jest, and what belongs to them, are no paths.
  const options = paths.findIndex((path) => path.startsWith('-'));
  for (const path of await unmatchedPaths(countsFile(root, name), options < 0 ? paths : paths.slice(0, options))) {
    failed.push(`no test file has "${path}" in its path`);
  }
  console.log(failed.length === 0 ? 'All is well.' : `Failed: ${failed.join(', ')}.`);
  return failed.length === 0 ? 0 : 1;
}

async function recordDurations(root: string): Promise<number> {
  const record = join(root, 'tests', 'support', 'durations.json');
  const runs = await Promise.all(['test', 'slow'].map((name) => readDurations(countsFile(root, name), root)));
  if (runs.every((run) => run === null)) {
    console.error('There are no durations: run `npm test` or `npm run test:slow` first.');
    return 1;
  }
  const recorded = JSON.parse(await readFile(record, 'utf8')) as Durations;
  const merged = mergeDurations(recorded, Object.assign({}, ...runs) as Durations, (path) => existsSync(join(root, path)));
  await writeFile(record, `${JSON.stringify(merged, null, 2)}\n`);
  console.log(`Recorded ${Object.keys(merged).length} durations.`);
  return 0;
}

function countsFile(root: string, name: string): string {
  return join(root, 'tests', 'output', `${name}.json`);
}

function npm(root: string, script: string): Phase {
  const command = process.platform === 'win32' ? 'npm.cmd' : 'npm';
  return { name: script, run: () => runCommand(command, ['run', '--silent', script], { cwd: root }) };
}

async function hasScript(root: string, name: string): Promise<boolean> {
  const manifest = JSON.parse(await readFile(join(root, 'package.json'), 'utf8')) as { scripts?: Record<string, string> };
  return manifest.scripts?.[name] !== undefined;
}
