import { mkdir, rm } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { runCommand } from '../lib/run-command.ts';

/** Jest projects of `npm test`, from the fastest tests to the slowest. `slow` is not among them, because it runs separately. */
export const PROJECTS = ['unit', 'browser', 'xr', 'electron'] as const;

export interface JestRun {
  readonly root: string;
  readonly projects: readonly string[];
  /** Patterns for the paths of test files; empty for all files. */
  readonly paths: readonly string[];
  /** Path of the file to which Jest writes its counts. */
  readonly countsFile: string;
}

/** Runs Jest on native ES modules, and hides the warning of Node that these are experimental in Jest. */
export async function runJest({ root, projects, paths, countsFile }: JestRun): Promise<number> {
  await mkdir(dirname(countsFile), { recursive: true });
  await rm(countsFile, { force: true });
  return runCommand(
    process.execPath,
    [
      join(root, 'node_modules/jest/bin/jest.js'),
      ...paths,
      // Two files at a time, also where more cores are: what runs on SwiftShader takes all it gets.
      '--maxWorkers=2',
      // A part of the memory of finished test files stays.
      '--workerIdleMemoryLimit=2GB',
      '--passWithNoTests',
      '--json',
      `--outputFile=${countsFile}`,
      // Last, because it takes every word that follows.
      '--selectProjects',
      ...projects,
    ],
    // Something left open (a server, a browser) keeps Jest alive forever after its last test.
    {
      cwd: root,
      timeoutS: 50 * 60,
      env: { NODE_OPTIONS: '--experimental-vm-modules --disable-warning=ExperimentalWarning', SCRIM_ENDS_WITH: String(process.pid) },
    },
  );
}
