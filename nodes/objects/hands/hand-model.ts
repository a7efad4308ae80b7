import { Bone, type Material, Matrix4, Skeleton, SkinnedMesh, Sphere, Vector3 } from 'three';
import { HAND_JOINTS } from '../../kit/hand-joints.ts';
import type { Hand } from '../../kit/session.ts';
import { createHandGeometry, HAND_FRAMES } from './hand-geometry.ts';

/** A hand whose skin follows the joints. */
export interface HandModel {
  /** The skinned mesh. Its origin is the wrist. */
  readonly root: SkinnedMesh;
  /** Sets the bones of the mesh and the pose of its wrist from a tracked hand. */
  follow(hand: Hand, worldFromObject: Matrix4): void;
  dispose(): void;
}

/** Radius of the bounding sphere around the wrist: no part of a hand is farther away, meters. */
const REACH_M = 0.35;
/** A shorter bone counts as having no direction, meters. */
const LEAST_M = 1e-5;

// Filled and read within one call.
const scratchInverse = new Matrix4();
const scratchMatrix = new Matrix4();
const scratchX = new Vector3();
const scratchY = new Vector3();
const scratchZ = new Vector3();
const scratchAt = new Vector3();

export function createHandModel(isLeft: boolean, material: Material): HandModel {
  const geometry = createHandGeometry(isLeft);
  const bones = HAND_FRAMES.map(() => new Bone());
  // Vertices are in the frames already, so no bone has a rest pose.
  const skeleton = new Skeleton(
    bones,
    bones.map(() => new Matrix4()),
  );
  const root = new SkinnedMesh(geometry, material);
  root.bind(skeleton, new Matrix4());
  root.matrixAutoUpdate = false;
  root.matrixWorldAutoUpdate = false;
  root.boundingSphere = new Sphere(new Vector3(), REACH_M);
  const positions = HAND_JOINTS.map(() => new Vector3());
  return {
    root,
    follow: ({ worldFromJoints, radiiM }, worldFromObject) => {
      worldFromObject.fromArray(worldFromJoints);
      scratchInverse.copy(worldFromObject).invert();
      for (let i = 0; i < positions.length; i++) positions[i]?.fromArray(worldFromJoints, 16 * i + 12).applyMatrix4(scratchInverse);
      for (let i = 0; i < HAND_FRAMES.length; i++) {
        const frame = HAND_FRAMES[i];
        const bone = bones[i];
        const from = frame && positions[frame.from];
        const to = frame && positions[frame.to];
        const at = frame && positions[frame.joint];
        if (!frame || !bone || !from || !to || !at) continue;
        // Up as the first joint has it, out of the back of the hand.
        scratchMatrix.fromArray(worldFromJoints, 16 * frame.from).premultiply(scratchInverse);
        scratchMatrix.extractBasis(scratchX, scratchY, scratchAt);
        scratchZ.subVectors(to, from);
        if (scratchZ.lengthSq() < LEAST_M ** 2) scratchZ.copy(scratchAt).negate();
        scratchZ.normalize();
        setBasis(bone.matrixWorld, at, radiiM[frame.joint] ?? 0);
      }
    },
    dispose: () => {
      geometry.dispose();
      skeleton.dispose();
    },
  };
}

/**
 * Writes a matrix with position, scale and axes: z is `scratchZ`; y is `scratchY` made perpendicular to z, or any perpendicular axis if the
 * two are parallel.
 */
function setBasis(out: Matrix4, at: Vector3, radiusM: number): void {
  scratchX.crossVectors(scratchY, scratchZ);
  // If the bone lies along y of its joint, any perpendicular is right, because capsules are round.
  if (scratchX.lengthSq() < 1e-6) scratchX.set(Math.abs(scratchZ.x) < 0.9 ? 1 : 0, Math.abs(scratchZ.x) < 0.9 ? 0 : 1, 0);
  scratchY.crossVectors(scratchZ, scratchX).normalize();
  scratchX.crossVectors(scratchY, scratchZ);
  out.makeBasis(scratchX.multiplyScalar(radiusM), scratchY.multiplyScalar(radiusM), scratchZ.multiplyScalar(radiusM)).setPosition(at);
}
