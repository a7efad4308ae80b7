import { Matrix4, Quaternion, Vector3 } from 'three';

/** A film of an example: where the visitor stands, and where the screen is touched. */
export interface Film {
  readonly example: string;
  readonly seconds: number;
  readonly touches: readonly Touch[];
  /** The pose of the phone. */
  readonly pose: Pose;
}

/** A touch of the screen. Coordinates are fractions of its size, from the top left. */
interface Touch {
  readonly atS: number;
  readonly x: number;
  readonly y: number;
}

interface Pose {
  readonly position: [number, number, number];
  readonly quaternion: [number, number, number, number];
}

const UP = new Vector3(0, 1, 0);

/**
 * A phone that is held still, at a distance and height from the point that it looks at. An animated image of a moving camera has several
 * times as many bytes.
 */
function lookAt(target: readonly [number, number, number], distanceM: number, heightM: number): Pose {
  const to = new Vector3(...target);
  const eye = new Vector3(0, heightM, distanceM).add(to);
  const turn = new Quaternion().setFromRotationMatrix(new Matrix4().lookAt(eye, to, UP));
  return { position: [eye.x, eye.y, eye.z], quaternion: [turn.x, turn.y, turn.z, turn.w] };
}

export const FILMS: readonly Film[] = [
  {
    example: 'marble-run',
    seconds: 6.5,
    // The first touch puts the run on the table; the others drop marbles.
    touches: [{ atS: 0.7, x: 0.5, y: 0.69 }, ...[1.8, 2.3, 2.8, 3.3].map((atS) => ({ atS, x: 0.82, y: 0.8 }))],
    pose: lookAt([-0.2, 0.72, -0.45], 1.55, 0.3),
  },
  {
    example: 'tin-cans',
    seconds: 6.5,
    // The first touch puts the cans on the table; the others throw balls.
    touches: [
      { atS: 0.7, x: 0.5, y: 0.745 },
      { atS: 2.4, x: 0.46, y: 0.5 },
      { atS: 3.4, x: 0.53, y: 0.47 },
      { atS: 4.4, x: 0.5, y: 0.52 },
    ],
    pose: lookAt([-0.2, 0.8, -0.5], 1.5, 0.35),
  },
];
