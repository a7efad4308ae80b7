import type { Operation, Program, ResourceId } from '../../export/program/program.ts';

const WHOLE = JSON.stringify([[{ op: 'width' }], [{ op: 'height' }]]);

type Target = Extract<Program['resources'][number], { kind: 'target' }>;

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

  // Techniques are texts and values, curves and gradients are values; no operation writes them.
  const written = new Set<ResourceId>(resources.filter(({ kind }) => kind === 'technique' || kind === 'table').map(({ id }) => id));
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
      // Both contain an earlier frame until they are written.
      const lasts = (resource?.kind === 'target' && resource.lifetime === 'persistent') || resource?.kind === 'pixels';
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
    if (resource.kind === 'table')
      fault(slots.slots[resource.slot]?.type !== resource.of, `${resource.id} is the ${resource.of} of no slot`);
    if (resource.kind === 'target') fault(resource.size.base !== 'view' && !known.has(resource.size.base), `${resource.id} has no size`);
  }
  for (const { color, depth } of Object.values(taps)) {
    fault(!written.has(color) || (depth !== null && !written.has(depth.resource)), `a tap shows ${color}, which is not drawn`);
  }
  faults.push(...sharingFaults(program));
  return faults;
}

/**
 * Plays a frame of two views with one name for what each texture holds at the time: an operation that reads a picture has to find it, and
 * nobody draws into what is being read.
 */
function sharingFaults({ operations, resources, taps }: Program): string[] {
  const faults: string[] = [];
  const textureOf = new Map<ResourceId, ResourceId>();
  const targets = new Map(resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource] as const] : [])));
  /** Where a size comes from that is handed on whole. */
  const originOf = ({ size }: Target): Target['size'] => {
    let at = size;
    for (let base = targets.get(at.base); base && JSON.stringify([at.width, at.height]) === WHOLE; base = targets.get(at.base))
      at = base.size;
    return at;
  };
  const kindOf = (target: Target) => {
    const { domain, format, depth, samples, lifetime } = target;
    return JSON.stringify([domain, originOf(target), format, depth, samples, lifetime]);
  };
  for (const [id, target] of targets) {
    textureOf.set(id, target.shares ?? id);
    const owner = target.shares === undefined ? null : targets.get(target.shares);
    if (owner === null) continue;
    if (!owner || owner.shares !== undefined) faults.push(`${id} shares ${target.shares}, which has no texture of its own`);
    else if (kindOf(owner) !== kindOf(target) || target.lifetime !== 'frame')
      faults.push(`${id} shares ${owner.id}, which is of another kind`);
  }
  const holds = new Map<ResourceId, ResourceId>();
  const each = operations.filter(({ view }) => view === 'each');
  const lasts = (id: ResourceId) => targets.get(id)?.lifetime === 'persistent';
  for (const { id, reads, writes } of [...operations, ...each]) {
    for (const read of reads.filter((resource) => targets.has(resource) && !lasts(resource))) {
      const texture = textureOf.get(read) ?? '';
      if (holds.get(texture) !== read) faults.push(`${id} reads ${read}, but finds ${holds.get(texture)}`);
      if (writes.some((write) => textureOf.get(write) === texture)) faults.push(`${id} draws into ${read} while it reads it`);
    }
    for (const write of writes) if (targets.has(write)) holds.set(textureOf.get(write) ?? '', write);
  }
  for (const { color, depth } of Object.values(taps)) {
    for (const seen of [color, depth?.resource ?? color]) {
      const texture = textureOf.get(seen);
      if (texture !== undefined && holds.get(texture) !== seen) faults.push(`a tap shows ${seen}, but finds ${holds.get(texture)}`);
    }
  }
  return faults;
}

function slotsOf(operation: Operation): number[] {
  if (operation.kind === 'shadow-maps' || operation.kind === 'readback') return [];
  if (operation.kind === 'pass') return operation.uniforms.flatMap(({ source }) => ('slot' in source ? [source.slot] : []));
  const ports = [...Object.values(operation.inputs).flat(), ...Object.values(operation.outputs)];
  return [...Object.values(operation.params), ...ports.flatMap((ref) => (ref.kind === 'slot' ? [ref.slot] : []))];
}
