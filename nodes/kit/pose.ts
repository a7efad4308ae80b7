/** What a `pose` wire carries: a rigid transform in world space. The same object every frame: read it during the frame. */
export interface PoseView {
  /** The transform: column-major 4×4, rigid, without scale. Without meaning while `valid` is false. */
  readonly worldFromPose: Float32Array;
  /** Whether there is a pose: false if nothing is hit, tracked or connected. Readers then hide what they would place. */
  readonly valid: boolean;
  /**
   * A number that is raised when the pose jumps for another reason than motion: at re-centering (`SessionFrame.jumps`), or when the node
   * turns to something else. Filters and physics that follow the pose restart then.
   */
  readonly jumps: number;
}

/** A pose output, written in `update` by the node that owns it. */
export interface PoseOutput {
  readonly worldFromPose: Float32Array;
  valid: boolean;
  jumps: number;
}

/**
 * Creates an identity pose that is not valid.
 *
 * @example
 * const pose = createPose();
 * writePose(pose, hit.worldFromHit, frame.jumps);
 */
export function createPose(): PoseOutput {
  return { worldFromPose: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1), valid: false, jumps: 0 };
}

/**
 * Writes a pose to an output. A matrix with a number that is not finite is not written: the output becomes invalid and keeps its last
 * matrix.
 *
 * @param worldFromPose Column-major 4×4, rigid; null for no pose.
 *
 * @example
 * writePose(ctx.outputs.pose, pointer?.worldFromRay ?? null, frame.jumps);
 */
export function writePose(out: PoseOutput, worldFromPose: ArrayLike<number> | null, jumps: number): void {
  out.jumps = jumps;
  out.valid = worldFromPose !== null && worldFromPose.length === 16 && isPose(worldFromPose);
  if (out.valid && worldFromPose) out.worldFromPose.set(worldFromPose);
}

/**
 * Whether sixteen numbers are a pose: all are finite, and no axis is near zero. Devices that lose tracking give zeros or NaN.
 *
 * @param matrices Column-major 4×4, possibly several in a row.
 * @param offset Index of the first number of the matrix.
 *
 * @example
 * if (isPose(hand.worldFromJoints, 16 * joint)) show(joint);
 */
export function isPose(matrices: ArrayLike<number>, offset = 0): boolean {
  for (let i = 0; i < 16; i++) if (!Number.isFinite(matrices[offset + i])) return false;
  for (let axis = 0; axis < 12; axis += 4) {
    const at = offset + axis;
    // A zero matrix is finite and has no axes.
    if (Math.hypot(matrices[at] ?? 0, matrices[at + 1] ?? 0, matrices[at + 2] ?? 0) < 0.5) return false;
  }
  return Math.abs((matrices[offset + 15] ?? 0) - 1) < 1e-3;
}
