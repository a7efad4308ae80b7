import type { Operation, PassOperation, PassUniform, Program, Resource } from './program.ts';

/**
 * Node types that list, place or draw objects and lights, or give the depth of the room, and say when they change (`NodeRuntime.version`). A test
 * compares them.
 */
export const STILL_TYPES: readonly string[] = [
  'layer/object-mask',
  'layer/scene',
  'layer/shadow',
  'light/directional',
  'light/environment',
  'light/point',
  'light/spot',
  'objects/apply-technique',
  'objects/at-pose',
  'objects/copies',
  'objects/group',
  'objects/phantom',
  'objects/primitive',
  'objects/text-3d',
  'objects/transform',
  'part/capture-place',
  'source/capture',
  'source/capture-mesh',
  'source/model',
  'source/panorama',
  'source/splats',
  'world/depth',
  'world/measure',
];

/**
 * Node types that list objects and do not say when they change, because what moves them gives no sign. Only places and flags of their objects
 * and the version of their list change by themselves, and the page compares these. What they show apart from that follows values, poses, the
 * view, and what only the session of a device measures: surfaces, hands.
 */
export const MOVED_TYPES: readonly string[] = [
  'objects/arrow',
  'objects/hands',
  'objects/label',
  'objects/line',
  'objects/place',
  'physics/body',
  'world/meshes',
  'world/planes',
  'world/surface-filter',
];

/**
 * Kinds of resources that change with what a page compares: values, poses, pulses, versions, the view, whether there is depth of the room, and
 * whether the pixels of an image have been read back.
 */
const COMPARED: ReadonlySet<Resource['kind']> = new Set([
  'bodies',
  'capture',
  'environment',
  'external',
  'lights',
  'objects',
  'pixels',
  'pose',
  'pulses',
  'room-depth',
  'shadow-maps',
  'table',
  'target',
  'technique',
]);
const TYPES: ReadonlySet<string> = new Set([...STILL_TYPES, ...MOVED_TYPES]);
const OBJECTS: ReadonlySet<Resource['kind']> = new Set(['environment', 'lights', 'objects']);
const CLOCKS: ReadonlySet<string> = new Set(['DATE', 'FRAMEINDEX', 'TIME', 'TIMEDELTA']);

/**
 * Whether frames of a program that draws objects or computes images on the CPU may repeat the last image: everything in it changes with values,
 * poses, files or the view, or says when it changes. Not if anything depends on the clock, on a sound, or on an earlier frame, unless that is
 * read back as pixels.
 *
 * @example
 * if (mayRest(program)) watch = createRestWatch(program, parts);
 */
export function mayRest({ operations, resources }: Program): boolean {
  const objects = new Set(resources.flatMap(({ id, kind }) => (OBJECTS.has(kind) ? [id] : [])));
  const isStill = (operation: Operation): boolean => {
    if (operation.kind === 'pass') return !readsClock(operation);
    if (!('type' in operation)) return true;
    if ('effects' in operation && operation.effects?.uniforms.some(isClock)) return false;
    if (operation.kind === 'cpu') return operation.stateful === undefined;
    // A label that is an object fades with what the room hides.
    if (operation.type === 'objects/label') return operation.config.where === 'page';
    return TYPES.has(operation.type) || (operation.kind !== 'draw' && !operation.writes.some((id) => objects.has(id)));
  };
  return operations.every(isStill) && resources.every(isCompared);
}

function readsClock({ uniforms, samplers }: PassOperation): boolean {
  return (
    uniforms.some(isClock) ||
    // An imported image may be loaded later, without a sign.
    samplers.some(({ source }) => source.kind === 'import')
  );
}

function isClock({ source }: PassUniform): boolean {
  return 'builtin' in source && CLOCKS.has(source.builtin);
}

function isCompared(resource: Resource): boolean {
  if (resource.kind === 'target') return resource.lifetime !== 'persistent';
  if (resource.kind === 'technique') return !`${resource.vertex}${resource.fragment}`.includes('a_TIME');
  return COMPARED.has(resource.kind);
}
