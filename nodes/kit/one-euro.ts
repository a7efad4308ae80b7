import { setQuaternion, setRigid, turnToward } from './rigid.ts';

/**
 * The One Euro filter (Casiez, Roussel and Vogel, CHI 2012): a low-pass filter whose cutoff rises with the speed, so that a pose at rest
 * is calm and a moving one does not lag.
 */
export interface PoseFilter {
  /**
   * Filters the pose of a frame, in place.
   *
   * @param pose Column-major 4×4, rigid.
   * @param deltaS Seconds since the last frame. At 0 the filtered pose stays as it was.
   * @param minCutoffHz Cutoff at rest: lower is calmer.
   * @param beta How much the cutoff rises with the speed, Hz per m/s, and per rad/s of the rotation: higher lags less.
   */
  apply(pose: Float32Array, deltaS: number, minCutoffHz: number, beta: number): void;
  /** Makes the filter pass the next pose unchanged and start again from it, as after a jump. */
  restart(): void;
}

/** Cutoff frequency of the low-pass filter of the speed; the value is that of the authors. */
const SPEED_CUTOFF_HZ = 1;

/**
 * Creates a filter of poses; the first pose passes unchanged.
 *
 * @example
 * const filter = createPoseFilter();
 * // Every frame:
 * if (pose.jumps !== jumps) filter.restart();
 * filter.apply(matrix, ctx.clock.deltaS, 1, 5);
 */
export function createPoseFilter(): PoseFilter {
  const position = new Float64Array(3);
  const rotation = new Float64Array(4);
  const next = new Float64Array(4);
  /** The filtered speed: m/s along each axis, and rad/s. */
  const speed = new Float64Array(3);
  let turnSpeed = 0;
  let isRunning = false;

  function start(pose: Float32Array): void {
    for (let i = 0; i < 3; i++) position[i] = pose[12 + i] ?? 0;
    setQuaternion(rotation, pose);
    speed.fill(0);
    turnSpeed = 0;
    isRunning = true;
  }

  return {
    apply: (pose, deltaS, minCutoffHz, beta) => {
      if (!isRunning) {
        start(pose);
        return;
      }
      if (deltaS > 0) {
        const speedPart = partOf(SPEED_CUTOFF_HZ, deltaS);
        let squared = 0;
        for (let i = 0; i < 3; i++) {
          const now = ((pose[12 + i] ?? 0) - (position[i] ?? 0)) / deltaS;
          speed[i] = (speed[i] ?? 0) + speedPart * (now - (speed[i] ?? 0));
          squared += (speed[i] ?? 0) ** 2;
        }
        const part = partOf(minCutoffHz + beta * Math.sqrt(squared), deltaS);
        for (let i = 0; i < 3; i++) position[i] = (position[i] ?? 0) + part * ((pose[12 + i] ?? 0) - (position[i] ?? 0));
        setQuaternion(next, pose);
        turnSpeed += speedPart * (angleBetween(rotation, next) / deltaS - turnSpeed);
        turnToward(rotation, next, partOf(minCutoffHz + beta * turnSpeed, deltaS));
      }
      setRigid(pose, position, rotation);
    },
    restart: () => {
      isRunning = false;
    },
  };
}

/** The weight of a new value in a first-order low-pass filter: 1 / (1 + τ / Δt) with τ = 1 / (2 π f). */
function partOf(cutoffHz: number, deltaS: number): number {
  return 1 / (1 + 1 / (2 * Math.PI * Math.max(cutoffHz, 1e-6) * deltaS));
}

function angleBetween(a: Float64Array, b: Float64Array): number {
  let cosine = 0;
  for (let i = 0; i < 4; i++) cosine += (a[i] ?? 0) * (b[i] ?? 0);
  return 2 * Math.acos(Math.min(1, Math.abs(cosine)));
}
