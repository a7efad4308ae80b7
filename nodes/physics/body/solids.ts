import type { BodyShape, Triple } from '../../kit/physics.ts';

/** Sides of a cylinder: an even number, so that it is symmetric, and enough to roll. */
const SIDES = 16;

const BOX_FACES: readonly (readonly number[])[] = [
  [0, 2, 6, 4],
  [1, 5, 7, 3],
  [0, 4, 5, 1],
  [2, 3, 7, 6],
  [0, 1, 3, 2],
  [4, 6, 7, 5],
];

/**
 * Creates a box.
 *
 * @param sizeM Size along x, y and z.
 */
export function boxShape(sizeM: Triple, centerM: Triple = [0, 0, 0]): BodyShape {
  const verticesM = Array.from({ length: 8 }, (_, i): Triple => {
    const side = (axis: 0 | 1 | 2, bit: number) => centerM[axis] + (i & bit ? 0.5 : -0.5) * sizeM[axis];
    return [side(0, 4), side(1, 2), side(2, 1)];
  });
  return { kind: 'hull', verticesM, faces: BOX_FACES };
}

/**
 * Creates a prism along y that stands for an elliptic cylinder. Its sides lie partly inside and partly outside, so that the volume is that
 * of the cylinder.
 */
export function cylinderShape(sizeM: Triple, centerM: Triple = [0, 0, 0]): BodyShape {
  const grow = Math.sqrt((2 * Math.PI) / (SIDES * Math.sin((2 * Math.PI) / SIDES)));
  const ring = (y: number) =>
    Array.from({ length: SIDES }, (_, i): Triple => {
      const angleRad = (2 * Math.PI * i) / SIDES;
      return [
        centerM[0] + 0.5 * grow * sizeM[0] * Math.cos(angleRad),
        centerM[1] + y,
        centerM[2] + 0.5 * grow * sizeM[2] * Math.sin(angleRad),
      ];
    });
  const sides = Array.from({ length: SIDES }, (_, i) => [i, i + SIDES, ((i + 1) % SIDES) + SIDES, (i + 1) % SIDES]);
  const bottom = Array.from({ length: SIDES }, (_, i) => i);
  const top = Array.from({ length: SIDES }, (_, i) => 2 * SIDES - 1 - i);
  return { kind: 'hull', verticesM: [...ring(-0.5 * sizeM[1]), ...ring(0.5 * sizeM[1])], faces: [bottom, top, ...sides] };
}

export function sphereShape(radiusM: number, centerM: Triple = [0, 0, 0]): BodyShape {
  return { kind: 'sphere', centerM, radiusM };
}

/** Creates a capsule along y: a cylinder between two half spheres. `sizeM` is the size of the whole. */
export function capsuleShapes(sizeM: Triple, centerM: Triple = [0, 0, 0]): BodyShape[] {
  const radiusM = 0.5 * Math.max(sizeM[0], sizeM[2]);
  const straightM = sizeM[1] - 2 * radiusM;
  if (straightM <= 0.1 * radiusM) return [sphereShape(radiusM, centerM)];
  const end = (y: number): Triple => [centerM[0], centerM[1] + y, centerM[2]];
  return [
    sphereShape(radiusM, end(-0.5 * straightM)),
    sphereShape(radiusM, end(0.5 * straightM)),
    cylinderShape([2 * radiusM, straightM, 2 * radiusM], centerM),
  ];
}
