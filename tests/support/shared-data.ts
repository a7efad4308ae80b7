import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe } from '@jest/globals';
import { describeMissing } from './required.ts';

/** Folder of real inputs beside the repository. They are never part of it. */
const FOLDER = resolve(import.meta.dirname, '../../../shared/data');

/** Tests on real inputs. Skipped with a message if these are missing. */
export function describeWithData(name: string, path: string, tests: (path: string) => void): void {
  const file = resolve(FOLDER, path);
  if (existsSync(file)) {
    describe(name, () => tests(file));
    return;
  }
  describeMissing(name, 'data', `${file} is missing`);
}
