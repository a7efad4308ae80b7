import type { Hit, HitList, HitRecord, HitSource, HitTest, HitTestOptions, Ray } from '../../../nodes/kit/hit-test.ts';
import { createHit } from '../../../nodes/kit/hit-test.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import { handOf } from '../../../nodes/kit/pointers.ts';
import type { Pointer, SessionFrame } from '../../../nodes/kit/session.ts';
import { castAtRoom, HIT_SOURCES, type RoomSources, writeHit } from './cast/cast-room.ts';
import { createMeeting, createRay, setRay } from './ray.ts';
import { createWebXrHits, type WebXrLedger } from './webxr-hits.ts';

/** Maximum number of hits in a frame: the nearest ones of a ray, or one for each pointer. */
const MAX_HITS = 8;

/** A hit with the data that the browser needs to create an anchor at it. */
export interface FoundHit extends HitRecord {
  xrResult: XRHitTestResult | null;
  /** Pose of the hit as the device reports it, column-major 4×4. */
  readonly worldFromXrHit: Float32Array;
}

export interface HitTestParts {
  readonly options: HitTestOptions;
  /** The current frame. */
  readonly frame: () => SessionFrame;
  /** A number that increases with each frame. */
  readonly round: () => number;
  readonly room: RoomSources;
  readonly ledger: WebXrLedger;
  readonly onClose: () => void;
}

// Filled and read within one call.
const scratchRay = createRay();
const scratchMeeting = createMeeting();
const scratchViewer = new Float32Array(16);
const scratchWorldFromRay = new Float32Array(16);

/**
 * The hits of one frame. Those of the previous frame are kept in a second object, because a press that ends no longer has an input source.
 */
class Hits implements HitList {
  count = 0;
  readonly hits: readonly FoundHit[] = Array.from({ length: MAX_HITS }, createFoundHit);

  at(index: number): Hit {
    const hit = index < this.count ? this.hits[index] : undefined;
    if (!hit) throw new RangeError(`There is no hit ${index} of ${this.count}.`);
    return hit;
  }
}

export function createHitTest(parts: HitTestParts): HitTest {
  const { options, room } = parts;
  const { from } = options;
  const sources: readonly HitSource[] = options.sources ?? HIT_SOURCES;
  const offsetRay = options.offsetRay ? Float32Array.from(options.offsetRay) : null;
  const device = createWebXrHits(parts.ledger, offsetRay);
  let current = new Hits();
  let previous = new Hits();
  /** The list that readers hold, which shows the current hits. */
  const list: HitList = {
    get count() {
      return current.count;
    },
    at: (index) => current.at(index),
  };
  let readRound = -1;
  let closed = false;

  function addDeviceHits(results: readonly XRHitTestResult[], ray: Ray, frame: SessionFrame, pointer: number, most: number): boolean {
    const xr = frame.xr;
    let added = 0;
    for (let i = 0; i < results.length && added < most && current.count < MAX_HITS && xr; i++) {
      const result = results[i];
      const matrix = result?.getPose(xr.referenceSpace as XRReferenceSpace)?.transform.matrix;
      const hit = current.hits[current.count];
      if (!result || !matrix || !hit) continue;
      hit.worldFromXrHit.set(matrix);
      hit.xrResult = result;
      writeDeviceHit(hit, ray, frame);
      hit.anchorable = xr.capabilities.has('anchors') && 'createAnchor' in result;
      hit.pointer = pointer;
      current.count++;
      added++;
    }
    return added > 0;
  }
  function addRoomHit(ray: Ray, frame: SessionFrame, pointer: number): void {
    const hit = current.hits[current.count];
    if (!hit || !castAtRoom(hit, ray, frame, room, sources)) return;
    hit.xrResult = null;
    hit.pointer = pointer;
    current.count++;
  }
  /**
   * Adds the hit that the device reported for a press in the previous frame, if the press has ended and its input source no longer exists.
   */
  function addLastHit({ id, phase }: Pointer): boolean {
    if (phase !== 'end' && phase !== 'cancel') return false;
    for (let i = 0; i < previous.count; i++) {
      const last = previous.hits[i];
      const hit = current.hits[current.count];
      if (!last || !hit || last.pointer !== id || last.source !== 'session') continue;
      copyHit(hit, last);
      current.count++;
      return true;
    }
    return false;
  }
  function castFrom(worldFromSpace: ArrayLike<number>, frame: SessionFrame, pointer: Pointer | null): void {
    if (offsetRay) multiplyMatrices(scratchWorldFromRay, worldFromSpace as Float32Array, offsetRay);
    else scratchWorldFromRay.set(worldFromSpace);
    if (!setRay(scratchRay, scratchWorldFromRay)) return;
    const id = from === 'pointers' ? (pointer?.id ?? 0) : 0;
    if (frame.xr?.capabilities.has('hit-test') && sources.includes('session')) {
      const results = pointer ? device.ofPointer(frame.xr, pointer) : device.ofViewer(frame.xr);
      if (addDeviceHits(results, scratchRay, frame, id, from === 'pointers' ? 1 : MAX_HITS)) return;
      if (pointer && addLastHit(pointer)) return;
    }
    addRoomHit(scratchRay, frame, id);
  }
  function compute(frame: SessionFrame): void {
    [current, previous] = [previous, current];
    current.count = 0;
    if (from === 'viewer') {
      if (frame.viewCount > 0) castFrom(viewerPose(frame), frame, null);
    } else {
      for (let i = 0; i < frame.input.pointerCount && current.count < MAX_HITS; i++) {
        const pointer = frame.input.pointers[i];
        if (pointer && (from === 'pointers' || handOf(pointer.by) === from)) castFrom(pointer.worldFromRay, frame, pointer);
      }
    }
    if (from !== 'viewer' && frame.xr?.capabilities.has('hit-test') && sources.includes('session'))
      device.sweep(frame.xr, from === 'pointers');
  }
  return {
    read: () => {
      const round = parts.round();
      if (round !== readRound && !closed) compute(parts.frame());
      readRound = round;
      return list;
    },
    close: () => {
      if (closed) return;
      closed = true;
      current.count = 0;
      device.close();
      parts.onClose();
    },
  };
}

/** The pose of the viewer: between the eyes, with the rotation of the first view. */
function viewerPose({ views, viewCount }: SessionFrame): Float32Array {
  scratchViewer.set(views[0]?.worldFromView ?? []);
  const second = viewCount > 1 ? views[1]?.worldFromView : undefined;
  if (second) for (let row = 12; row < 15; row++) scratchViewer[row] = ((scratchViewer[row] ?? 0) + (second[row] ?? 0)) / 2;
  return scratchViewer;
}

/** Writes a hit of the device: its point and normal, with the axes that all hits have. */
function writeDeviceHit(hit: FoundHit, ray: Ray, frame: SessionFrame): void {
  const m = hit.worldFromXrHit;
  const x = m[12] ?? 0;
  const y = m[13] ?? 0;
  const z = m[14] ?? 0;
  scratchMeeting.distanceM = Math.hypot(x - ray.ox, y - ray.oy, z - ray.oz);
  scratchMeeting.nx = m[4] ?? 0;
  scratchMeeting.ny = m[5] ?? 1;
  scratchMeeting.nz = m[6] ?? 0;
  writeHit(hit, scratchMeeting, ray, frame);
  // The device's point, which may lie beside the ray by what it rounds.
  hit.worldFromHit[12] = x;
  hit.worldFromHit[13] = y;
  hit.worldFromHit[14] = z;
  hit.source = 'session';
}

function copyHit(to: FoundHit, from: FoundHit): void {
  to.worldFromHit.set(from.worldFromHit);
  to.worldFromXrHit.set(from.worldFromXrHit);
  to.distanceM = from.distanceM;
  to.source = from.source;
  to.anchorable = from.anchorable;
  to.label = from.label;
  to.pointer = from.pointer;
  to.frame = from.frame;
  to.xrResult = from.xrResult;
}

function createFoundHit(): FoundHit {
  return { ...createHit(), xrResult: null, worldFromXrHit: new Float32Array(16) };
}
