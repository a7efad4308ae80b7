import { createCannonEngine } from './cannon-engine.ts';
import type { StepAnswer, StepMessage } from './protocol.ts';
import { createStepper } from './run-step.ts';

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: StepMessage }) => void) | null;
  postMessage(answer: StepAnswer, transfer: ArrayBuffer[]): void;
}

/** Runs the engine in a worker: answers each message, in the buffers of the message. */
export function serve(scope: WorkerScope): void {
  const step = createStepper(createCannonEngine);
  scope.onmessage = ({ data }) => {
    const answer = step(data);
    scope.postMessage(answer, [answer.poses.buffer, answer.touches.buffer]);
  };
}
