import { describe } from '@jest/globals';
import { BLENDER, findTool } from '../../app/services/outside/outside-tools.ts';
import { describeMissing } from './required.ts';

const blender = await findTool(BLENDER, null).catch(() => null);

/** Tests that run Blender. Skipped with the reason where it is missing. */
export function describeWithBlender(name: string, tests: () => void): void {
  if (blender === null)
    describeMissing(name, 'blender', `Blender is in no folder of PATH (Debian: apt install blender; others: ${BLENDER.url})`);
  else describe(name, tests);
}
