import type { PhysicsEngine, StepAnswer, StepMessage } from './protocol.ts';

const NONE: StepAnswer['spent'] = [];

/**
 * Creates a function that answers step messages with one engine. The worker and the main thread use the same function, so the results are
 * the same.
 */
export function createStepper(createEngine: () => PhysicsEngine): (message: StepMessage) => StepAnswer {
  let engine = createEngine();
  return ({ commands, deltaS, poses, touches, wantsVoxels, wantsFile }) => {
    try {
      for (const command of commands) {
        if (command.kind === 'clear') engine = createEngine();
        else engine.apply(command);
      }
      engine.step(deltaS);
      engine.writePoses(poses);
      const voxels = wantsVoxels ? engine.voxels() : null;
      const file = wantsFile ? engine.roomFile() : null;
      const touchCount = engine.writeTouches(touches);
      return { poses, touches, bodyCount: engine.bodyCount, touchCount, voxels, file, spent: NONE, failure: null };
    } catch (error) {
      const failure = error instanceof Error ? error.message : String(error);
      return { poses, touches, bodyCount: 0, touchCount: 0, voxels: null, file: null, spent: NONE, failure };
    }
  };
}
