import type { SessionFrame } from '../../../nodes/kit/session.ts';

/**
 * The panel is 0.9 m from the eyes and 0.5 m below them, in the direction of the gaze on entry, and faces the viewer upright. It keeps its
 * place in the room. It is placed again after two seconds in which it was nearer than 0.3 m, farther than 1.5 m, higher than 0.15 m below
 * the eyes or more than 75° beside the gaze, but not while it is held.
 */
const AHEAD_M = Math.sqrt(0.9 ** 2 - 0.5 ** 2);
const BELOW_M = 0.5;
const NEAREST_M = 0.3;
const FARTHEST_M = 1.5;
const HIGHEST_M = -0.15;
const ASIDE_COS = Math.cos((75 * Math.PI) / 180);
const PATIENCE_S = 2;

export interface PanelPose {
  /** Rigid column-major 4×4: x to the right, y up, z towards the viewer; the origin is the center of the panel. */
  readonly worldFromPanel: Float32Array;
  /** Updates the pose. Call it once per frame. */
  update(frame: SessionFrame, held: boolean): void;
  /** Places the panel again in the next frame. */
  reset(): void;
}

export function createPanelPose(): PanelPose {
  const worldFromPanel = new Float32Array(16);
  let placed = false;
  let outS = 0;
  return {
    worldFromPanel,
    update: (frame, held) => {
      setHead(scratchHead, frame);
      outS = placed && !held && isOutOfReach(worldFromPanel, scratchHead) ? outS + frame.deltaS : 0;
      if (placed && outS < PATIENCE_S) return;
      place(worldFromPanel, scratchHead);
      placed = true;
      outS = 0;
    },
    reset: () => {
      placed = false;
    },
  };
}

interface Head {
  x: number;
  y: number;
  z: number;
  /** Horizontal direction of the gaze, unit vector. */
  aheadX: number;
  aheadZ: number;
}

// Filled before it is read, within one call.
const scratchHead: Head = { x: 0, y: 0, z: 0, aheadX: 0, aheadZ: -1 };

/** Reads the position between the eyes. If the gaze is vertical, its direction is that of the top of the head or the chin. */
function setHead(head: Head, { views, viewCount }: SessionFrame): void {
  let aheadX = 0;
  let aheadZ = 0;
  let upX = 0;
  let upZ = 0;
  let gazeY = 0;
  head.x = 0;
  head.y = 0;
  head.z = 0;
  for (let i = 0; i < viewCount; i++) {
    const m = views[i]?.worldFromView;
    if (!m) continue;
    head.x += (m[12] ?? 0) / viewCount;
    head.y += (m[13] ?? 0) / viewCount;
    head.z += (m[14] ?? 0) / viewCount;
    aheadX -= m[8] ?? 0;
    aheadZ -= m[10] ?? 0;
    upX += m[4] ?? 0;
    upZ += m[6] ?? 0;
    gazeY -= m[9] ?? 0;
  }
  const steep = Math.hypot(aheadX, aheadZ) < 0.2 * viewCount;
  const x = steep ? -Math.sign(gazeY) * upX : aheadX;
  const z = steep ? -Math.sign(gazeY) * upZ : aheadZ;
  const length = Math.hypot(x, z);
  head.aheadX = length > 0 ? x / length : 0;
  head.aheadZ = length > 0 ? z / length : -1;
}

function place(out: Float32Array, { x, y, z, aheadX, aheadZ }: Head): void {
  // Axis from the panel to the eyes.
  const distanceM = Math.hypot(AHEAD_M, BELOW_M);
  const back = AHEAD_M / distanceM;
  const up = BELOW_M / distanceM;
  out.set([-aheadZ, 0, aheadX, 0], 0);
  out.set([aheadX * up, back, aheadZ * up, 0], 4);
  out.set([-aheadX * back, up, -aheadZ * back, 0], 8);
  out.set([x + aheadX * AHEAD_M, y - BELOW_M, z + aheadZ * AHEAD_M, 1], 12);
}

function isOutOfReach(panel: Float32Array, { x, y, z, aheadX, aheadZ }: Head): boolean {
  const toX = (panel[12] ?? 0) - x;
  const toY = (panel[13] ?? 0) - y;
  const toZ = (panel[14] ?? 0) - z;
  const distanceM = Math.hypot(toX, toY, toZ);
  const asideCos = (toX * aheadX + toZ * aheadZ) / Math.max(1e-6, Math.hypot(toX, toZ));
  return distanceM < NEAREST_M || distanceM > FARTHEST_M || toY > HIGHEST_M || asideCos < ASIDE_COS;
}
