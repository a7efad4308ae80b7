import process from 'node:process';
import { describe, test } from '@jest/globals';

/** What a machine may lack: an Electron that starts, or the real data beside the repository. */
export type Requirement = 'electron' | 'data';

/** Whether `SCRIM_REQUIRE`, as in `SCRIM_REQUIRE=electron,data`, says that this machine has it. */
export function isRequired(what: Requirement): boolean {
  return (process.env.SCRIM_REQUIRE ?? '').split(',').some((word) => word.trim() === what);
}

/** A suite that cannot run here: skipped with the reason, or failed where `SCRIM_REQUIRE` names what it lacks. */
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
