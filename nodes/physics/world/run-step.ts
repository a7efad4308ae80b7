import type { PhysicsEngine, StepAnswer, StepMessage } from './protocol.ts';

/**
 * Creates a function that answers step messages with one engine. The worker and the main thread use the same function, so the results are
 * the same.
 */
export function createStepper(createEngine: () => PhysicsEngine): (message: StepMessage) => StepAnswer {
  let engine = createEngine();
  return ({ commands, deltaS, poses, touches }) => {
    try {
      for (const command of commands) {
        if (command.kind === 'clear') engine = createEngine();
        else engine.apply(command);
      }
      engine.step(deltaS);
      engine.writePoses(poses);
      return { poses, touches, bodyCount: engine.bodyCount, touchCount: engine.writeTouches(touches), failure: null };
    } catch (error) {
      const failure = error instanceof Error ? error.message : String(error);
      return { poses, touches, bodyCount: 0, touchCount: 0, failure };
    }
  };
}
