import { join, relative, resolve } from 'node:path';
import { expect } from '@jest/globals';

export const TESTS_FOLDER = resolve(import.meta.dirname, '..');
/** Folder for the output of failing tests. Ignored by Git. */
export const OUTPUT_FOLDER = join(TESTS_FOLDER, 'output');

/** The running test file, and its Jest project. */
export function currentTest(): { readonly path: string; readonly project: string } {
  const { testPath } = expect.getState();
  if (testPath === undefined) throw new Error('No test is running.');
  const path = relative(resolve(TESTS_FOLDER, '..'), testPath);
  return { path, project: /^tests\/(browser|xr|electron|slow)\//.exec(path)?.[1] ?? 'unit' };
}

export function updatesGoldens(): boolean {
  return process.env.UPDATE_GOLDENS === '1';
}

/** Command that updates the goldens of the running test file. */
export function refreshCommand(): string {
  const { path, project } = currentTest();
  return `UPDATE_GOLDENS=1 npm run test:one ${project} ${path}`;
}
