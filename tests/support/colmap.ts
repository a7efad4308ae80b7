import { describe } from '@jest/globals';
import { COLMAP, findTool } from '../../app/services/outside/outside-tools.ts';
import { describeMissing } from './required.ts';

const colmap = await findTool(COLMAP, null).catch(() => null);

/** Tests that run the program COLMAP. Skipped with the reason where it is missing. */
export function describeWithProgram(name: string, tests: () => void): void {
  if (colmap === null)
    describeMissing(name, 'colmap', `COLMAP is in no folder of PATH (Debian: apt install colmap; others: ${COLMAP.url})`);
  else describe(name, tests);
}
