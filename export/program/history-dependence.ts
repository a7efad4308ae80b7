import type { NodeOperation, Operation, Program, SlotTable } from './program.ts';

/**
 * Whether a frame of the program depends on all earlier ones, so that a render must play these first. Other programs depend on the previous
 * frame at most: for the time step, changed values and the result of one CPU filter.
 *
 * @example
 * const firstFrame = isHistoryDependent(program) ? 0 : range.first;
 */
export function isHistoryDependent({ operations, resources, slots }: Program): boolean {
  return (
    operations.some((operation) => isNode(operation) && isStateful(operation, slots)) ||
    resources.some((resource) => resource.kind === 'target' && resource.lifetime === 'persistent') ||
    // Each CPU filter is one frame late, so two in a row depend on more than the previous frame.
    operations.filter(({ kind }) => kind === 'cpu').length > 1
  );
}

function isNode(operation: Operation): operation is Extract<Operation, NodeOperation> {
  return 'type' in operation;
}

function isStateful({ stateful }: NodeOperation, { slots, numbers }: SlotTable): boolean {
  if (stateful === undefined || stateful === true) return stateful === true;
  return (numbers[slots[stateful.slot]?.offset ?? -1] ?? 0) > stateful.above;
}
