import type { Anchor, AnchorKeeping, AnchorService, AnchorState } from '../../../nodes/kit/anchors.ts';
import type { Hit } from '../../../nodes/kit/hit-test.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import type { SessionFrame, XrAccess } from '../../../nodes/kit/session.ts';
import { setRigidInverse } from '../sessions/matrix.ts';
import type { AnchorMemory } from './anchor-memory.ts';
import { forgetAnchor, keepAnchor } from './keep-anchor.ts';
import type { FoundHit } from './open-hit-test.ts';
import type { WebXrLedger } from './webxr-hits.ts';

/** All anchors of a player. */
export interface AnchorStore extends AnchorService {
  /** Number of anchors that are not deleted. */
  readonly count: number;
  /** Updates the poses of anchors. Called once per frame, before nodes are updated. */
  update(frame: SessionFrame): void;
  /** Ends all anchors. Called when the session ends, and with it its world space. */
  leave(): void;
}

// Filled and read within one call.
const scratchInverse = new Float32Array(16);

class StoredAnchor implements Anchor {
  state: AnchorState = 'pending';
  readonly worldFromAnchor = new Float32Array(16);
  xr: XRAnchor | null = null;
  /** The requested pose in the space of the browser's anchor; null if both poses are the same. */
  xrFromAnchor: Float32Array | null = null;
  wasTracked = false;
  keeping: AnchorKeeping = 'not-asked';
  evicted = 0;
  /** Whether the anchor was deleted or its session has ended. */
  over = false;

  constructor(
    readonly id: string,
    private readonly onDelete: (anchor: StoredAnchor) => void,
  ) {}

  delete(): void {
    if (this.over) return;
    this.end();
    try {
      this.xr?.delete();
    } catch {
      // The session ended, and the anchor with it.
    }
    this.xr = null;
  }

  end(): void {
    this.over = true;
    this.state = 'deleted';
    this.onDelete(this);
  }
}

export function createAnchorStore(frameNow: () => SessionFrame, ledger: WebXrLedger, memory: AnchorMemory): AnchorStore {
  const anchors: StoredAnchor[] = [];
  let made = 0;
  const forget = (anchor: StoredAnchor): void => {
    const index = anchors.indexOf(anchor);
    if (index >= 0) anchors.splice(index, 1);
  };

  function request(anchor: StoredAnchor, at: Hit | ArrayLike<number>, xr: XrAccess, keepAs: string | undefined): void {
    const result = 'worldFromHit' in at ? (at as FoundHit).xrResult : null;
    const createAnchor = (at as FoundHit).anchorable ? result?.createAnchor?.bind(result) : undefined;
    if (createAnchor) {
      setRigidInverse(scratchInverse, (at as FoundHit).worldFromXrHit);
      anchor.xrFromAnchor = new Float32Array(16);
      multiplyMatrices(anchor.xrFromAnchor, scratchInverse, anchor.worldFromAnchor);
    }
    const { frame, referenceSpace } = xr;
    receive(
      anchor,
      () => createAnchor?.() ?? (frame as XRFrame).createAnchor?.(toXrTransform(anchor.worldFromAnchor), referenceSpace as XRSpace),
      () => {
        anchor.state = 'unsupported';
        if (keepAs !== undefined) anchor.keeping = 'refused';
      },
      keepAs === undefined ? undefined : (made) => void keep(anchor, made, xr.session as XRSession, keepAs),
    );
  }

  /**
   * Calls `make` and, when its promise resolves, stores the browser's anchor in `anchor`. If `make` throws or gives no anchor, calls
   * `refuse`.
   */
  function receive(
    anchor: StoredAnchor,
    make: () => Promise<XRAnchor> | undefined,
    refuse: () => void,
    then: ((made: XRAnchor) => void) | undefined,
  ): void {
    ledger.pending++;
    void created(make)
      .then((made) => {
        if (!made) throw new Error('The browser makes no anchors.');
        if (anchor.over) made.delete();
        else {
          anchor.xr = made;
          then?.(made);
        }
      })
      .catch(() => {
        if (!anchor.over) refuse();
      })
      .finally(() => {
        ledger.pending--;
      });
  }

  async function keep(anchor: StoredAnchor, made: XRAnchor, session: XRSession, name: string): Promise<void> {
    const anchorFromPose = anchor.xrFromAnchor && Array.from(anchor.xrFromAnchor);
    const { kept, evicted } = await keepAnchor(made, session, memory, { name, anchorFromPose });
    anchor.keeping = kept ? 'kept' : 'refused';
    anchor.evicted = evicted;
  }
  return {
    get count() {
      return anchors.length;
    },
    create: (at, keepAs) => {
      const matrix = 'worldFromHit' in at ? at.worldFromHit : at;
      const anchor = new StoredAnchor(`anchor-${++made}`, forget);
      for (let i = 0; i < 16; i++) {
        const value = matrix[i];
        if (value === undefined || !Number.isFinite(value)) throw new RangeError('An anchor needs a pose of 16 finite numbers.');
        anchor.worldFromAnchor[i] = value;
      }
      anchors.push(anchor);
      const { xr } = frameNow();
      const isGranted = xr?.capabilities.has('anchors') ?? false;
      if (keepAs !== undefined) anchor.keeping = isGranted ? 'pending' : 'refused';
      if (!xr) anchor.state = 'tracked';
      else if (isGranted) request(anchor, at, xr, keepAs);
      else anchor.state = 'unsupported';
      return anchor;
    },
    restore: (name) => {
      const { xr } = frameNow();
      const session = xr?.session as XRSession | undefined;
      const kept = memory.find(name);
      if (!kept || !session?.restorePersistentAnchor || !xr?.capabilities.has('anchors')) return null;
      const anchor = new StoredAnchor(`anchor-${++made}`, forget);
      anchor.keeping = 'kept';
      anchor.xrFromAnchor = kept.anchorFromPose && Float32Array.from(kept.anchorFromPose);
      anchors.push(anchor);
      receive(
        anchor,
        () => session.restorePersistentAnchor?.(kept.handle),
        // The place may be in another room, so its handle stays.
        () => anchor.end(),
        undefined,
      );
      return anchor;
    },
    forget: (name) => {
      const kept = memory.find(name);
      if (!kept) return;
      const { xr } = frameNow();
      if (xr) void forgetAnchor(xr.session as XRSession, memory, kept);
      else memory.remove(kept.handle);
    },
    update: ({ xr }) => {
      // Backwards: those that the device deleted leave the list.
      for (let i = anchors.length - 1; i >= 0; i--) {
        const anchor = anchors[i];
        if (anchor?.xr && xr) follow(anchor, anchor.xr, xr);
      }
    },
    leave: () => {
      for (const anchor of anchors.slice()) {
        anchor.xr = null;
        anchor.end();
      }
    },
  };
}

function follow(anchor: StoredAnchor, xrAnchor: XRAnchor, xr: XrAccess): void {
  const frame = xr.frame as XRFrame;
  const isListed = frame.trackedAnchors?.has(xrAnchor) ?? true;
  // Before it is listed for the first time, the device has not placed it.
  if (!isListed && !anchor.wasTracked) return;
  const matrix = isListed ? poseOf(xrAnchor, frame, xr) : undefined;
  if (!isListed) {
    anchor.xr = null;
    anchor.end();
  } else if (matrix) {
    anchor.wasTracked = true;
    anchor.state = 'tracked';
    if (anchor.xrFromAnchor) multiplyMatrices(anchor.worldFromAnchor, matrix, anchor.xrFromAnchor);
    else anchor.worldFromAnchor.set(matrix);
  } else if (anchor.wasTracked) anchor.state = 'lost';
}

/** The pose of a browser's anchor; undefined if it has none. Reading the space of a deleted anchor throws. */
function poseOf(anchor: XRAnchor, frame: XRFrame, xr: XrAccess): Float32Array | undefined {
  try {
    return frame.getPose(anchor.anchorSpace, xr.referenceSpace as XRReferenceSpace)?.transform.matrix;
  } catch {
    return undefined;
  }
}

/** Calls `create` so that an exception becomes a rejection. Resolves to undefined if the browser has no such method. */
async function created(create: () => Promise<XRAnchor> | undefined): Promise<XRAnchor | undefined> {
  return create();
}

/**
 * Converts a matrix to the form that `createAnchor` takes.
 *
 * @param m Column-major 4×4, rigid.
 */
function toXrTransform(m: Float32Array): XRRigidTransform {
  const at = (i: number): number => m[i] ?? 0;
  // Shepperd's method: the largest of the four components first.
  const trace = at(0) + at(5) + at(10);
  let q: [number, number, number, number];
  if (trace > at(0) && trace > at(5) && trace > at(10)) q = [at(6) - at(9), at(8) - at(2), at(1) - at(4), 1 + trace];
  else if (at(0) > at(5) && at(0) > at(10)) q = [1 + at(0) - at(5) - at(10), at(1) + at(4), at(8) + at(2), at(6) - at(9)];
  else if (at(5) > at(10)) q = [at(1) + at(4), 1 + at(5) - at(0) - at(10), at(6) + at(9), at(8) - at(2)];
  else q = [at(8) + at(2), at(6) + at(9), 1 + at(10) - at(0) - at(5), at(1) - at(4)];
  const length = Math.hypot(...q);
  const [x, y, z, w] = q;
  return new XRRigidTransform({ x: at(12), y: at(13), z: at(14) }, { x: x / length, y: y / length, z: z / length, w: w / length });
}
