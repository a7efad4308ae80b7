import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe } from '@jest/globals';
import { describeMissing } from './required.ts';

/** Real inputs are kept beside the repository, never in it. */
const FOLDER = resolve(import.meta.dirname, '../../../shared/data');

/** Tests on real input: where it is missing, they are skipped with one line that says so. */
export function describeWithData(name: string, path: string, tests: (path: string) => void): void {
  const file = resolve(FOLDER, path);
  if (existsSync(file)) {
    describe(name, () => tests(file));
    return;
  }
  describeMissing(name, 'data', `${file} is missing`);
}
