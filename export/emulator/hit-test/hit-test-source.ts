import type { XRAnchor, XRInputSource, XRPose } from 'iwer';
import { type GlobalSpace, XRSpace } from 'iwer';
import { Matrix4, Vector3 } from 'three';
import type { Room } from '../rooms/room.ts';
import { castRay, type HitKind, type RayHit } from './cast-ray.ts';
import { EmulatedRay } from './emulated-ray.ts';

export interface HitTestWishes {
  readonly space?: XRSpace;
  /** For transient input: profile of the input sources to follow. */
  readonly profile?: string;
  readonly entityTypes?: readonly HitKind[];
  readonly offsetRay?: EmulatedRay;
}

/**
 * A subscription of a page to hit tests, which `cancel` ends: `XRHitTestSource` or `XRTransientInputHitTestSource` of WebXR Hit Test §3.
 */
export class EmulatedHitTestSource {
  readonly #active: Set<EmulatedHitTestSource>;

  constructor(active: Set<EmulatedHitTestSource>) {
    this.#active = active;
    active.add(this);
  }

  cancel(): void {
    if (!this.#active.delete(this)) throw new DOMException('The hit test source is already canceled.', 'InvalidStateError');
  }
}

export class EmulatedTransientHitTestSource extends EmulatedHitTestSource {}

/** The part of an `XRFrame` that the hit test results of the frame use. */
interface HitFrame {
  getPose(space: XRSpace, baseSpace: XRSpace): XRPose;
  readonly session: { anchorAt(space: XRSpace): Promise<XRAnchor> };
}

export class EmulatedHitTestResult {
  readonly #frame: HitFrame;
  readonly #space: XRSpace;

  constructor(frame: HitFrame, space: XRSpace) {
    this.#frame = frame;
    this.#space = space;
  }

  getPose(baseSpace: XRSpace): XRPose {
    return this.#frame.getPose(this.#space, baseSpace);
  }

  /**
   * Creates an anchor at the hit. This also works after the frame has ended: pages keep the last result and create the anchor when the user
   * taps, which browsers allow.
   */
  createAnchor(): Promise<XRAnchor> {
    return this.#frame.session.anchorAt(this.#space);
  }
}

export class EmulatedTransientHitTestResult {
  readonly inputSource: XRInputSource;
  readonly results: readonly EmulatedHitTestResult[];

  constructor(inputSource: XRInputSource, results: readonly EmulatedHitTestResult[]) {
    this.inputSource = inputSource;
    this.results = results;
  }
}

/** “Compute hit test results” of WebXR Hit Test §6. Without `entityTypes`, only planes are tested. */
export function computeHits(
  frame: HitFrame,
  room: Room,
  world: GlobalSpace,
  space: XRSpace,
  { entityTypes = ['plane'], offsetRay = new EmulatedRay() }: HitTestWishes,
): EmulatedHitTestResult[] {
  const worldFromSpace = new Matrix4().fromArray(frame.getPose(space, world).transform.matrix);
  const { origin: o, direction: d } = offsetRay;
  const originWorld = new Vector3(o.x, o.y, o.z).applyMatrix4(worldFromSpace);
  const directionWorld = new Vector3(d.x, d.y, d.z).transformDirection(worldFromSpace);
  return castRay(room, originWorld, directionWorld, new Set(entityTypes)).map(
    (hit) => new EmulatedHitTestResult(frame, new XRSpace(world, worldFromHit(hit, directionWorld))),
  );
}

/** Pose of a hit: y along the normal, z along the surface towards the ray's origin. */
function worldFromHit({ pointWorld, normalWorld }: RayHit, directionWorld: Vector3): Float32Array {
  const y = normalWorld;
  const z = directionWorld.clone().negate();
  z.addScaledVector(y, -z.dot(y));
  if (z.lengthSq() < 1e-6) z.set(Math.abs(y.z) < 0.9 ? 0 : 1, 0, Math.abs(y.z) < 0.9 ? 1 : 0).addScaledVector(y, -y.z);
  z.normalize();
  const x = y.clone().cross(z);
  return new Float32Array(new Matrix4().makeBasis(x, y, z).setPosition(pointWorld).toArray());
}
