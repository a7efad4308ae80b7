import { BufferGeometry, Float32BufferAttribute, Uint16BufferAttribute } from 'three';

/**
 * The surface of a hand: a closed capsule around each bone, and closed plates between the bones of the palm. Each vertex belongs to one
 * `HandFrame`, whose matrix is scaled by the radius of its joint, so vertices are in units of that radius (`hand-model.ts` sets the
 * matrices). Capsules stay round at any bend, which one skin over all joints would not without a sculpted model.
 */

/** A coordinate frame that moves vertices. */
export interface HandFrame {
  /** Index of the joint at whose position the frame is; the joint's radius is the unit of its vertices. */
  readonly joint: number;
  /** Indices of two joints: z points from the first to the second. */
  readonly from: number;
  readonly to: number;
}

const FINGER_STARTS = [1, 5, 10, 15, 20] as const;
const FINGER_ENDS = [4, 9, 14, 19, 24] as const;
const MIDDLE_METACARPAL = 10;
const MIDDLE_PROXIMAL = 11;
const WRIST = 0;

/**
 * For each plate of the palm, the joints at its corners, from the thumb's side: metacarpal and knuckle of a finger, knuckle and metacarpal
 * of the next.
 */
const PLATES = [
  [1, 2, 6, 5],
  [5, 6, 11, 10],
  [10, 11, 16, 15],
  [15, 16, 21, 20],
] as const;

/** Half the thickness of a plate, in radii of its joints. */
const PLATE = 0.8;
/** The number of vertices around a capsule, and of rings in each of its ends. */
const AROUND = 12;
const RINGS = 4;

/** Pairs of joints that a bone connects, as indices of `HAND_JOINTS`. */
export const BONES: readonly (readonly [from: number, to: number])[] = FINGER_STARTS.flatMap((start, finger) => [
  [WRIST, start] as const,
  ...Array.from({ length: (FINGER_ENDS[finger] ?? start) - start }, (_, i) => [start + i, start + i + 1] as const),
]);

const PALM_JOINTS: readonly number[] = [...new Set(PLATES.flat())];

/** All coordinate frames that move vertices: two per bone, then one per joint of the palm. */
export const HAND_FRAMES: readonly HandFrame[] = [
  ...BONES.flatMap(([from, to]) => [
    { joint: from, from, to },
    { joint: to, from, to },
  ]),
  ...PALM_JOINTS.map((joint) => ({ joint, from: MIDDLE_METACARPAL, to: MIDDLE_PROXIMAL })),
];

interface Builder {
  readonly positions: number[];
  readonly normals: number[];
  readonly frames: number[];
  readonly indices: number[];
}

/**
 * Creates the surface of a hand.
 *
 * @param isLeft Whether the thumb is on the +x side of a palm that faces down.
 */
export function createHandGeometry(isLeft: boolean): BufferGeometry {
  const builder: Builder = { positions: [], normals: [], frames: [], indices: [] };
  BONES.forEach((_, bone) => {
    addCapsule(builder, 2 * bone);
  });
  for (const plate of PLATES) addPlate(builder, plate, isLeft);
  const { positions, normals, frames, indices } = builder;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  geometry.setAttribute(
    'skinIndex',
    new Uint16BufferAttribute(
      frames.flatMap((frame) => [frame, 0, 0, 0]),
      4,
    ),
  );
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      frames.flatMap(() => [1, 0, 0, 0]),
      4,
    ),
  );
  geometry.setIndex(indices);
  return geometry;
}

/**
 * Adds a vertex.
 *
 * @returns Its index.
 */
function addVertex({ positions, normals, frames }: Builder, frame: number, p: readonly number[], n: readonly number[]): number {
  positions.push(...p);
  normals.push(...n);
  return frames.push(frame) - 1;
}

/**
 * Adds the capsule of a bone, from the pole behind its first joint over the rings of both ends to the pole beyond its second joint. `frame`
 * is the index of the first joint's frame.
 */
function addCapsule(builder: Builder, frame: number): void {
  const { indices } = builder;
  const rings: number[][] = [];
  for (let ring = 0; ring < 2 * RINGS; ring++) {
    const isEnd = ring >= RINGS;
    // Each end has a ring of its own on its equator; the tube is between the two.
    const step = isEnd ? ring - RINGS : ring - RINGS + 1;
    const latitude = (step / RINGS) * (Math.PI / 2);
    rings.push(
      Array.from({ length: AROUND }, (_, i) => {
        const angle = (2 * Math.PI * i) / AROUND;
        const p = [Math.cos(latitude) * Math.cos(angle), Math.cos(latitude) * Math.sin(angle), Math.sin(latitude)];
        return addVertex(builder, isEnd ? frame + 1 : frame, p, p);
      }),
    );
  }
  const behind = addVertex(builder, frame, [0, 0, -1], [0, 0, -1]);
  const beyond = addVertex(builder, frame + 1, [0, 0, 1], [0, 0, 1]);
  const at = (ring: number, i: number): number => rings[ring]?.[i % AROUND] ?? 0;
  for (let i = 0; i < AROUND; i++) {
    indices.push(behind, at(0, i + 1), at(0, i));
    for (let ring = 0; ring + 1 < rings.length; ring++) {
      indices.push(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
    indices.push(beyond, at(rings.length - 1, i), at(rings.length - 1, i + 1));
  }
}

/**
 * Adds the plate between four joints, as a prism. Its side walls are hidden within capsules, but are needed to close it for shadow volumes.
 */
function addPlate(builder: Builder, joints: readonly number[], isLeft: boolean): void {
  const frames = joints.map((joint) => 2 * BONES.length + PALM_JOINTS.indexOf(joint));
  const corners = (y: number) => frames.map((frame) => addVertex(builder, frame, [0, y * PLATE, 0], [0, y, 0]));
  const top = corners(1);
  const bottom = corners(-1);
  const face = (a = 0, b = 0, c = 0): void => {
    builder.indices.push(...(isLeft ? [a, b, c] : [a, c, b]));
  };
  face(top[0], top[1], top[2]);
  face(top[0], top[2], top[3]);
  face(bottom[0], bottom[2], bottom[1]);
  face(bottom[0], bottom[3], bottom[2]);
  for (let i = 0; i < 4; i++) {
    const next = (i + 1) % 4;
    face(top[i], bottom[i], bottom[next]);
    face(top[i], bottom[next], top[next]);
  }
}
