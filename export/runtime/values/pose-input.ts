import type { PoseView } from '../../../nodes/kit/pose.ts';

/** The pose at an input of a node. After a recompile it may be connected to another output while the node keeps its state. */
export interface PoseInput extends PoseView {
  /** Connects the input to an output. Connecting another output increases `jumps`. */
  point(pose: PoseView): void;
}

export function createPoseInput(pose: PoseView): PoseInput {
  return new PointedPose(pose);
}

class PointedPose implements PoseInput {
  /** Added to the output's `jumps`, so that the sum never decreases. */
  private offset = 0;

  constructor(private pose: PoseView) {}

  get worldFromPose(): Float32Array {
    return this.pose.worldFromPose;
  }

  get valid(): boolean {
    return this.pose.valid;
  }

  get jumps(): number {
    return this.pose.jumps + this.offset;
  }

  point(pose: PoseView): void {
    if (pose === this.pose) return;
    this.offset = this.jumps + 1 - pose.jumps;
    this.pose = pose;
  }
}
