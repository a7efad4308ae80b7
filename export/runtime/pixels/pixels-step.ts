import type { Clock } from '../../../nodes/kit/runtime.ts';
import type { Operation, ReadbackOperation } from '../../program/program.ts';
import type { Step } from '../program-instance/step.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';

export function isReadback(operation: Operation): operation is ReadbackOperation {
  return operation.kind === 'readback';
}

/** Creates the step that reads a small image back. Of several views only the first is read. */
export function createReadbackStep(operation: ReadbackOperation, resources: LiveResources, clock: Clock): Step {
  const { target } = liveResource(resources, operation.picture, 'target');
  const { pixels } = liveResource(resources, operation.pixels, 'pixels');
  return {
    run: ({ viewIndex }) => {
      if (viewIndex === 0) pixels.take(target.front(0), clock.held);
    },
  };
}
