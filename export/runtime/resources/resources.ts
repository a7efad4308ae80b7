import { type CapturedPlace, createCapturedPlace } from '../../../nodes/kit/captured-place.ts';
import { IDENTITY } from '../../../nodes/kit/matrices.ts';
import type { BodyList } from '../../../nodes/kit/physics.ts';
import { createPose, type PoseOutput } from '../../../nodes/kit/pose.ts';
import { type LayerOutput, MAY_CHANGE } from '../../../nodes/kit/runtime.ts';
import type { EnvironmentOutput, LightList, ObjectList, RoomDepthOutput } from '../../../nodes/kit/scene-lists.ts';
import type { Writable } from '../../../nodes/kit/value-views.ts';
import type { Program, Resource, ResourceId } from '../../program/program.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createLivePixels, type LivePixels } from '../pixels/live-pixels.ts';
import { createLiveSound, type LiveSound } from '../sound/live-sound.ts';
import type { Multisampling } from '../targets/multisampling.ts';
import { createTarget, MAX_VIEWS } from '../targets/target.ts';
import { createPulseQueue, type PulseQueue } from '../values/pulses.ts';
import type { Slots } from '../values/slots.ts';
import { createLiveCurve } from './live-curve.ts';
import { createLiveGradient } from './live-gradient.ts';
import type { LiveTable } from './live-table.ts';
import { createLiveTechnique, type LiveLayer, type LiveTechnique, type TechniqueParts } from './live-technique.ts';

/** The runtime object of a program's resource. */
export type LiveResource =
  | LiveLayer
  | { readonly kind: 'room-depth'; readonly depth: RoomDepthOutput }
  | { readonly kind: 'objects'; readonly list: ObjectList }
  | { readonly kind: 'lights'; readonly list: LightList }
  | { readonly kind: 'environment'; readonly environment: EnvironmentOutput }
  | { readonly kind: 'sound'; readonly live: LiveSound }
  | { readonly kind: 'table'; readonly table: LiveTable }
  | { readonly kind: 'pulses'; readonly queue: PulseQueue }
  | { readonly kind: 'pose'; readonly pose: PoseOutput }
  | { readonly kind: 'bodies'; readonly list: BodyList }
  | { readonly kind: 'capture'; readonly place: Writable<CapturedPlace> }
  | { readonly kind: 'pixels'; readonly pixels: LivePixels }
  | { readonly kind: 'technique'; readonly technique: LiveTechnique }
  /** Shadow maps have no object here: their operation creates them. */
  | { readonly kind: 'shadow-maps' };

/** The parts of the engine that create render targets. */
export interface TargetParts {
  readonly objects: GlObjects;
  /** Created at the first call. */
  readonly multisampling: Multisampling;
}

export type LiveResources = ReadonlyMap<ResourceId, LiveResource>;

/** Creates the resources of a program and reuses unchanged ones of `before`. The caller disposes the rest with `disposeUnused`. */
export function createResources(program: Program, parts: TargetParts, before: LiveResources | null): LiveResources {
  const viewed = new Set(Object.values(program.taps).flatMap((layer) => [layer.color, layer.depth?.resource ?? layer.color]));
  const live = new Map<ResourceId, LiveResource>();
  const taken = new Set<LiveResource>();
  for (const resource of program.resources) {
    if (sharedWith(resource) !== null) continue;
    const old = before?.get(resource.id);
    // Two resources that shared a texture may have separate ones now.
    const isViewed = viewed.has(resource.id);
    const kept = old && !taken.has(old) && isSame(old, resource, isViewed);
    const made = kept ? old : create(resource, parts, isViewed);
    taken.add(made);
    live.set(resource.id, made);
  }
  for (const resource of program.resources) {
    const owner = sharedWith(resource);
    if (owner !== null) live.set(resource.id, liveResource(live, owner, 'target'));
  }
  return live;
}

function sharedWith(resource: Resource): ResourceId | null {
  return (resource.kind === 'target' && resource.shares) || null;
}

/** Connects techniques, curves and gradients to the shader texts and slots of a new program, before it is drawn. */
export function pointResources(
  program: Program,
  live: LiveResources,
  engine: Pick<TechniqueParts, 'images' | 'state'>,
  slots: Slots,
): void {
  const { images, state } = engine;
  const layer = (id: ResourceId): LiveLayer | undefined => {
    const resource = live.get(id);
    return resource?.kind === 'target' || resource?.kind === 'external' ? resource : undefined;
  };
  for (const resource of program.resources) {
    if (resource.kind === 'table') liveResource(live, resource.id, 'table').table.point(slots, resource.slot);
    if (resource.kind === 'technique')
      liveResource(live, resource.id, 'technique').technique.point(resource, { layer, slots, images, state });
  }
}

export function disposeUnused(before: LiveResources, after: LiveResources | null): void {
  const kept = new Set(after?.values());
  for (const resource of new Set(before.values())) {
    if (kept.has(resource)) continue;
    if (resource.kind === 'target') resource.target.dispose();
    if (resource.kind === 'sound') resource.live.dispose();
    if (resource.kind === 'table') resource.table.dispose();
    if (resource.kind === 'pixels') resource.pixels.dispose();
  }
}

/** Clears the output of a node that was disposed; readers get a new version. */
export function clearOutput(resource: LiveResource): void {
  switch (resource.kind) {
    case 'objects':
    case 'lights':
      resource.list.items.length = 0;
      resource.list.version++;
      break;
    case 'external':
      for (const view of resource.layer.views) {
        view.texture = null;
        view.widthPx = 0;
        view.heightPx = 0;
        view.uvFromViewUv.set(IDENTITY);
        view.version = MAY_CHANGE;
      }
      break;
    case 'room-depth':
      resource.depth.views.fill(null);
      break;
    case 'environment':
      resource.environment.asset = null;
      break;
    case 'sound':
      resource.live.sound.channelCount = 0;
      resource.live.sound.version++;
      break;
    case 'pulses':
      resource.queue.clear();
      break;
    case 'bodies':
      resource.list.bodies.length = 0;
      resource.list.version++;
      break;
    case 'pose':
      resource.pose.valid = false;
      resource.pose.jumps++;
      break;
    case 'capture':
      resource.place.assetId = null;
      resource.place.facts = null;
      break;
    case 'target':
    case 'table':
    case 'technique':
    case 'pixels':
    case 'shadow-maps':
      break;
    default:
      resource satisfies never;
  }
}

function create(resource: Resource, parts: TargetParts, isViewed: boolean): LiveResource {
  const { objects } = parts;
  switch (resource.kind) {
    case 'target': {
      const target = createTarget(objects, resource, isViewed, resource.samples > 1 ? parts.multisampling : null);
      return { kind: 'target', domain: resource.domain, target, isViewed };
    }
    case 'external':
      return { kind: 'external', domain: resource.domain, layer: createExternalLayer(resource.domain === 'view' ? MAX_VIEWS : 1) };
    case 'room-depth':
      return { kind: 'room-depth', depth: { views: Array.from({ length: MAX_VIEWS }, () => null) } };
    case 'objects':
      return { kind: 'objects', list: { version: 0, items: [] } };
    case 'lights':
      return { kind: 'lights', list: { version: 0, items: [] } };
    case 'environment':
      return { kind: 'environment', environment: { asset: null, intensity: 1, rotationRad: 0 } };
    case 'sound':
      return { kind: 'sound', live: createLiveSound(objects) };
    case 'table':
      return { kind: 'table', table: resource.of === 'curve' ? createLiveCurve(objects) : createLiveGradient(objects) };
    case 'pulses':
      return { kind: 'pulses', queue: createPulseQueue() };
    case 'pose':
      return { kind: 'pose', pose: createPose() };
    case 'pixels':
      return { kind: 'pixels', pixels: createLivePixels(objects.gl) };
    case 'bodies':
      return { kind: 'bodies', list: { version: 0, bodies: [] } };
    case 'capture':
      return { kind: 'capture', place: createCapturedPlace() };
    case 'technique':
      return { kind: 'technique', technique: createLiveTechnique(resource.id) };
    case 'shadow-maps':
      return { kind: 'shadow-maps' };
  }
}

function createExternalLayer(count: number): LayerOutput {
  return {
    views: Array.from({ length: count }, () => ({
      texture: null,
      widthPx: 0,
      heightPx: 0,
      uvFromViewUv: IDENTITY.slice(),
      version: MAY_CHANGE,
    })),
  };
}

function isSame(old: LiveResource, resource: Resource, isViewed: boolean): boolean {
  if (old.kind !== resource.kind) return false;
  if (old.kind === 'external' && resource.kind === 'external') return old.domain === resource.domain;
  if (old.kind !== 'target' || resource.kind !== 'target') return true;
  const was = old.target.resource;
  // The size is not compared: a target can be resized.
  return (
    // Persistent targets have buffers per view in any case.
    (old.isViewed === isViewed || was.lifetime === 'persistent') &&
    was.depthRead === resource.depthRead &&
    was.domain === resource.domain &&
    was.format === resource.format &&
    was.depth === resource.depth &&
    was.samples === resource.samples &&
    was.lifetime === resource.lifetime
  );
}

/** Returns a resource of the given kind. A resource of another kind is a programming error. */
export function liveResource<K extends LiveResource['kind']>(
  resources: LiveResources,
  id: ResourceId,
  kind: K,
): Extract<LiveResource, { kind: K }> {
  const resource = resources.get(id);
  if (resource?.kind !== kind) throw new Error(`The program has no resource ${id} of kind ${kind}.`);
  return resource as Extract<LiveResource, { kind: K }>;
}
