import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { PULSE_CAPACITY } from '../../../nodes/kit/runtime.ts';
import type { NodePorts } from './node-ports.ts';

/** Reports once for each output of a node that it emitted too many pulses in one frame. */
export function reportOverflows(outputs: NodePorts['pulseOutputs'], report: (diagnostic: Omit<Diagnostic, 'nodeId'>) => void): void {
  for (const [port, queue] of outputs) {
    queue.onOverflow = () => {
      queue.onOverflow = null;
      report(overflow(port));
    };
  }
}

function overflow(port: string): Omit<Diagnostic, 'nodeId'> {
  return {
    code: 'SCR056',
    severity: 'warning',
    port,
    message: `The output emitted more than ${PULSE_CAPACITY} pulses in one frame. The rest are lost.`,
    fix: 'Emit fewer pulses: lower the rate of the node, or add a Gate before it.',
  };
}
