import { createCannonEngine } from './cannon-engine.ts';
import { depthOf, type StepAnswer, type StepMessage } from './protocol.ts';
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
    const spent = data.commands.flatMap((command) => depthOf(command) ?? []);
    scope.postMessage({ ...answer, spent }, [answer.poses.buffer, answer.touches.buffer, ...spent.map(({ buffer }) => buffer)]);
  };
}
