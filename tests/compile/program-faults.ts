import type { Operation, Program, ResourceId } from '../../export/program/program.ts';

/** What a runtime would stumble over, in words: an empty list for a program that can be played in its order. */
export function programFaults(program: Program): string[] {
  const { operations, resources, shaders, slots, taps } = program;
  const faults: string[] = [];
  const fault = (is: boolean, words: string) => {
    if (is) faults.push(words);
  };
  const known = new Map(resources.map((resource) => [resource.id, resource]));
  fault(known.size < resources.length, 'two resources have the same id');
  fault(new Set(operations.map(({ id }) => id)).size < operations.length, 'two operations have the same id');

  const written = new Set<ResourceId>();
  let last = 'once';
  let onScreen = false;
  let left = false;
  for (const operation of operations) {
    const { id, view, reads, writes } = operation;
    fault(last === 'each' && view === 'once', `${id} runs once after operations that run per view`);
    last = view;
    for (const read of reads) {
      const resource = known.get(read);
      const waits = 'delay' in operation && operation.delay === true;
      const lasts = resource?.kind === 'target' && resource.lifetime === 'persistent';
      fault(!resource, `${id} reads ${read}, which is not there`);
      fault(!written.has(read) && !lasts && !waits, `${id} reads ${read} before it is written`);
    }
    for (const write of writes) {
      fault(!known.has(write), `${id} writes ${write}, which is not there`);
      written.add(write);
    }
    const toScreen = 'target' in operation && operation.target === 'screen';
    fault(left && toScreen, `${id} comes back to the screen`);
    onScreen ||= toScreen;
    left ||= onScreen && !toScreen;
    for (const slot of slotsOf(operation)) fault(slots.slots[slot] === undefined, `${id} names the slot ${slot}`);
    if (operation.kind === 'pass') fault(shaders[operation.shader] === undefined, `${id} names the shader ${operation.shader}`);
  }
  for (const resource of resources) {
    fault(!written.has(resource.id), `${resource.id} is never written`);
    if (resource.kind === 'target') fault(resource.size.base !== 'view' && !known.has(resource.size.base), `${resource.id} has no size`);
  }
  for (const { color, depth } of Object.values(taps)) {
    fault(!written.has(color) || (depth !== null && !written.has(depth.resource)), `a tap shows ${color}, which is not drawn`);
  }
  return faults;
}

function slotsOf(operation: Operation): number[] {
  if (operation.kind === 'shadow-maps') return [];
  if (operation.kind === 'pass') return operation.uniforms.flatMap(({ source }) => ('slot' in source ? [source.slot] : []));
  const ports = [...Object.values(operation.inputs).flat(), ...Object.values(operation.outputs)];
  return [...Object.values(operation.params), ...ports.flatMap((ref) => (ref.kind === 'slot' ? [ref.slot] : []))];
}
