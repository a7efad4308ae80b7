import type { Program } from '../../program/program.ts';
import type { Engine } from '../engine.ts';

/**
 * Reports at the first node with a scene layer that the GPU cannot draw 16-bit floats, so scene layers are stored in 8 bits as display
 * layers are.
 */
export function reportMissingFloats({ resources, operations }: Program, { objects, host }: Engine): void {
  if (objects.limits.halfFloatTargets) return;
  const scenes = new Set(
    resources.flatMap((resource) => (resource.kind === 'target' && resource.format === 'scene16f' ? [resource.id] : [])),
  );
  const first = operations.find(({ writes }) => writes.some((id) => scenes.has(id)));
  if (!first) return;
  host.board.report(first.node, {
    code: 'SCR055',
    severity: 'warning',
    message: 'This GPU cannot draw to 16-bit floats, so scene layers lose what is brighter than white.',
    fix: 'Use display layers, or keep the light of the scene below white.',
  });
}
