import type { Program } from './program.ts';

/**
 * Whether a frame depends on all before it: those have to be played then, to have it. All else depends on the one before at most,
 * which tells how much time has passed.
 */
export function remembersFrames({ operations, resources }: Program): boolean {
  return (
    operations.some(({ kind }) => kind === 'behaviour') ||
    resources.some((resource) => resource.kind === 'target' && resource.lifetime === 'persistent')
  );
}
