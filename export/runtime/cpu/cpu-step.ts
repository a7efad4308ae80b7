import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import type { CpuOperation, NodeOperation } from '../../program/program.ts';
import type { Step } from '../program-instance/step.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { CpuFilter } from './run-cpu-filter.ts';

export function isCpu(operation: NodeOperation): operation is CpuOperation {
  return operation.kind === 'cpu';
}

/** Creates the step that passes the input image to a CPU filter and draws its result, per view or once for all views. */
export function createCpuStep(operation: CpuOperation, runtime: NodeRuntime, resources: LiveResources): Step {
  if (!isCpuFilter(runtime)) throw new Error(`The node type ${operation.type} has no worker.`);
  const image = liveResource(resources, operation.picture, 'target');
  const into = liveResource(resources, operation.target, 'target');
  return {
    run: ({ viewIndex }) => {
      const index = into.domain === 'view' ? viewIndex : 0;
      runtime.exchange(index, image.target.front(index), into.target.back(index));
      into.target.finish(index);
    },
  };
}

function isCpuFilter(runtime: NodeRuntime): runtime is CpuFilter {
  return 'exchange' in runtime;
}
