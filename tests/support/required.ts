import process from 'node:process';
import { describe, test } from '@jest/globals';

/** Things that a machine may lack: a working Electron, the real data beside the repository, COLMAP, its package for Python, scikit-image, Blender, the algorithm of Instant Meshes, splat-transform. */
export type Requirement = 'electron' | 'data' | 'colmap' | 'pycolmap' | 'skimage' | 'blender' | 'instantmeshes' | 'splat-transform';

/** Whether `SCRIM_REQUIRE`, such as `SCRIM_REQUIRE=electron,data`, requires it. */
export function isRequired(what: Requirement): boolean {
  return (process.env.SCRIM_REQUIRE ?? '').split(',').some((word) => word.trim() === what);
}

/** A suite that cannot run on this machine: skipped with the reason, or failed if `SCRIM_REQUIRE` requires it. */
export function describeMissing(name: string, what: Requirement, reason: string): void {
  if (isRequired(what)) {
    describe(name, () =>
      test(`has what SCRIM_REQUIRE names: ${what}`, () => {
        throw new Error(`${reason}.`);
      }),
    );
    return;
  }
  process.stderr.write(`SKIPPED ${name}: ${reason}.\n`);
  describe(name, () => test.skip(reason, () => {}));
}
