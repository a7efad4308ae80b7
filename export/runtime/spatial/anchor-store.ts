import type { Anchor, AnchorService, AnchorState } from '../../../nodes/kit/anchors.ts';
import type { Hit } from '../../../nodes/kit/hit-test.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import type { SessionFrame, XrAccess } from '../../../nodes/kit/session.ts';
import { setRigidInverse } from '../sessions/matrix.ts';
import type { FoundHit } from './hit-test.ts';
import type { WebXrLedger } from './webxr-hits.ts';

/** All anchors of a player. */
export interface AnchorStore extends AnchorService {
  /** Anchors that were not deleted. */
  readonly count: number;
  /** Once a frame, before nodes are updated. */
  update(frame: SessionFrame): void;
  /** The session ended: its world is gone. */
  leave(): void;
}

// Filled and read within one call.
const scratchInverse = new Float32Array(16);

class StoredAnchor implements Anchor {
  state: AnchorState = 'pending';
  readonly worldFromAnchor = new Float32Array(16);
  xr: XRAnchor | null = null;
  /** The pose that was asked for, in the space of the browser's anchor; null where they are the same. */
  xrFromAnchor: Float32Array | null = null;
  wasTracked = false;
  /** The node or the session is done with it. */
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

export function createAnchorStore(frameNow: () => SessionFrame, ledger: WebXrLedger): AnchorStore {
  const anchors: StoredAnchor[] = [];
  let made = 0;
  const forget = (anchor: StoredAnchor): void => {
    const index = anchors.indexOf(anchor);
    if (index >= 0) anchors.splice(index, 1);
  };

  function request(anchor: StoredAnchor, at: Hit | ArrayLike<number>, xr: XrAccess): void {
    const result = 'worldFromHit' in at ? (at as FoundHit).xrResult : null;
    const createAnchor = (at as FoundHit).anchorable ? result?.createAnchor?.bind(result) : undefined;
    if (createAnchor) {
      setRigidInverse(scratchInverse, (at as FoundHit).worldFromXrHit);
      anchor.xrFromAnchor = new Float32Array(16);
      multiplyMatrices(anchor.xrFromAnchor, scratchInverse, anchor.worldFromAnchor);
    }
    ledger.pending++;
    void created(
      () => createAnchor?.() ?? (xr.frame as XRFrame).createAnchor?.(toXrTransform(anchor.worldFromAnchor), xr.referenceSpace as XRSpace),
    )
      .then((made) => {
        if (!made) throw new Error('The browser makes no anchors.');
        if (anchor.over) made.delete();
        else anchor.xr = made;
      })
      .catch(() => {
        if (!anchor.over) anchor.state = 'unsupported';
      })
      .finally(() => {
        ledger.pending--;
      });
  }
  return {
    get count() {
      return anchors.length;
    },
    create: (at) => {
      const matrix = 'worldFromHit' in at ? at.worldFromHit : at;
      const anchor = new StoredAnchor(`anchor-${++made}`, forget);
      for (let i = 0; i < 16; i++) {
        const value = matrix[i];
        if (value === undefined || !Number.isFinite(value)) throw new RangeError('An anchor needs a pose of 16 finite numbers.');
        anchor.worldFromAnchor[i] = value;
      }
      anchors.push(anchor);
      const { xr } = frameNow();
      if (!xr) anchor.state = 'tracked';
      else if (xr.capabilities.has('anchors')) request(anchor, at, xr);
      else anchor.state = 'unsupported';
      return anchor;
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

/** The space of an anchor that was deleted throws. */
function poseOf(anchor: XRAnchor, frame: XRFrame, xr: XrAccess): Float32Array | undefined {
  try {
    return frame.getPose(anchor.anchorSpace, xr.referenceSpace as XRReferenceSpace)?.transform.matrix;
  } catch {
    return undefined;
  }
}

/** `create` may throw at once, and the method may be missing. */
async function created(create: () => Promise<XRAnchor> | undefined): Promise<XRAnchor | undefined> {
  return create();
}

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
