import { BoxGeometry, type BufferGeometry, CylinderGeometry, LatheGeometry, SphereGeometry, Vector2 } from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import { type Color, drawTexture, mix, wood } from './draw-texture.ts';
import { type ModelPart, type Paint, writeModel } from './write-model.ts';

/** Dimensions of a chute in meters, and its slope. The chutes cross the stand from side to side, each below the last. */
const CHUTE = { lengthM: 0.5, innerM: 0.066, floorM: 0.015, railM: 0.044, thickM: 0.011, slopeRad: 0.13 } as const;
const COUNT = 4;
/** Height of the center of the top chute, and the distance down to the next one. */
const TOP_M = 0.62;
const PITCH_M = 0.138;
/**
 * How far each chute is moved from the center toward its upper end. The upper end thus reaches past the lower end of the chute above by
 * twice as much.
 */
const SHIFT_M = 0.046;
const CAP_M = 0.11;

export const MARBLE_RADIUS_M = 0.024;
/** Where marbles leave the funnel, above the upper end of the top chute. */
export const FUNNEL_M = [-0.225, 0.755, 0] as const;

const BEECH = drawTexture(256, 128, wood([0.93, 0.78, 0.58], [0.78, 0.57, 0.36], 1.3));
const WALNUT = drawTexture(256, 128, wood([0.5, 0.33, 0.22], [0.3, 0.18, 0.11], 4.1));
const PAINTS = {
  beech: { name: 'beech', color: [1, 1, 1], roughness: 0.55, texture: BEECH },
  walnut: { name: 'walnut', color: [1, 1, 1], roughness: 0.5, texture: WALNUT },
  brass: { name: 'brass', color: [0.8, 0.55, 0.2], metalness: 0.9, roughness: 0.28 },
} as const satisfies Record<string, Paint>;
/** Paints of the rails, from the top chute down. */
const RAILS: readonly Paint[] = [
  { name: 'coral', color: [0.72, 0.13, 0.08], roughness: 0.4 },
  { name: 'mustard', color: [0.82, 0.44, 0.04], roughness: 0.4 },
  { name: 'sea', color: [0.03, 0.28, 0.3], roughness: 0.4 },
  { name: 'night', color: [0.03, 0.07, 0.2], roughness: 0.4 },
];

/** Makes the model of the chutes. It has 16 parts, as many as a compound body may have. */
export function makeChutes(): Promise<Uint8Array> {
  return writeModel(Array.from({ length: COUNT }, (_, i) => chute(i)).flat());
}

function chute(index: number): ModelPart[] {
  const { lengthM, innerM, floorM, railM, thickM, slopeRad } = CHUTE;
  // Marbles roll to the right in the first chute, to the left in the second, and so on.
  const toRight = index % 2 === 0 ? 1 : -1;
  const isLast = index === COUNT - 1;
  const extraM = isLast ? 0.08 : 0;
  const place = (geometry: BufferGeometry) =>
    geometry
      .translate((extraM / 2) * toRight, 0, 0)
      .rotateZ(-slopeRad * toRight)
      .translate(-SHIFT_M * toRight, TOP_M - PITCH_M * index, 0);
  const paint = RAILS[index] ?? PAINTS.beech;
  const long = lengthM + extraM;
  const widthM = innerM + 2 * thickM;
  const rail = (side: number) =>
    place(new RoundedBoxGeometry(long, railM, thickM, 2, 0.004).translate(0, railM / 2 - floorM / 2, (side * (innerM + thickM)) / 2));
  const capX = (-toRight * (long + thickM)) / 2;
  return [
    { name: `floor ${index}`, geometry: place(new BoxGeometry(long, floorM, innerM).toNonIndexed()), paint: PAINTS.beech },
    { name: `front ${index}`, geometry: rail(1), paint },
    { name: `back ${index}`, geometry: rail(-1), paint },
    {
      name: `cap ${index}`,
      geometry: place(new RoundedBoxGeometry(thickM, CAP_M, widthM, 2, 0.004).translate(capX, CAP_M / 2 - floorM / 2, 0)),
      paint,
    },
  ];
}

/** The board that the run stands on. */
export function makeBase(): Promise<Uint8Array> {
  return writeModel([
    { name: 'base', geometry: new RoundedBoxGeometry(0.62, 0.024, 0.2, 3, 0.007).translate(0, 0.012, 0), paint: PAINTS.walnut },
  ]);
}

/** Makes the model of the stand that carries the chutes: two posts with knobs, and the funnel. */
export function makeStand(): Promise<Uint8Array> {
  const parts: ModelPart[] = [];
  const backM = -(CHUTE.innerM / 2 + CHUTE.thickM + 0.017);
  for (const x of [-0.165, 0.165]) {
    parts.push(
      { name: `post ${x}`, geometry: new CylinderGeometry(0.014, 0.014, 0.69, 24).translate(x, 0.37, backM), paint: PAINTS.beech },
      { name: `knob ${x}`, geometry: new SphereGeometry(0.021, 24, 16).translate(x, 0.73, backM), paint: PAINTS.brass },
    );
  }
  const [x, y] = FUNNEL_M;
  const profile = [
    [0.029, 0],
    [0.032, 0.024],
    [0.077, 0.082],
    [0.08, 0.087],
    [0.074, 0.087],
    [0.028, 0.026],
    [0.027, 0],
  ].map(([r = 0, h = 0]) => new Vector2(r, h));
  parts.push(
    { name: 'funnel', geometry: new LatheGeometry(profile, 40).translate(x, y - 0.03, 0), paint: PAINTS.brass },
    {
      name: 'arm',
      geometry: new CylinderGeometry(0.007, 0.007, 0.06, 12).rotateZ(Math.PI / 2).translate(-0.19, y - 0.022, backM / 2),
      paint: PAINTS.brass,
    },
  );
  return writeModel(parts);
}

/** Colors of the swirl in a marble: the light and the dark one. */
export const MARBLES: Readonly<Record<'ruby' | 'sea' | 'amber', readonly [Color, Color]>> = {
  ruby: [
    [0.97, 0.9, 0.86],
    [0.83, 0.09, 0.12],
  ],
  sea: [
    [0.55, 0.85, 0.9],
    [0.05, 0.25, 0.62],
  ],
  amber: [
    [1, 0.86, 0.4],
    [0.12, 0.45, 0.25],
  ],
};

/** A marble of swirled glass. */
export function makeMarble([light, dark]: readonly [Color, Color]): Promise<Uint8Array> {
  const texture = drawTexture(128, 64, (u, v) => {
    const swirl = Math.sin(2 * Math.PI * (2 * u + 1.1 * v) + 1.2 * Math.sin(2 * Math.PI * v));
    const thread = Math.sin(2 * Math.PI * (6 * u - 2 * v) + 2 * Math.sin(2 * Math.PI * (u + v)));
    return mix(mix(light, dark, 1 / (1 + Math.exp(-14 * swirl))), [1, 1, 1], thread > 0.93 ? 0.7 : 0);
  });
  return writeModel([
    {
      name: 'marble',
      geometry: new SphereGeometry(MARBLE_RADIUS_M, 28, 18),
      paint: { name: 'glass', color: [1, 1, 1], roughness: 0.06, texture },
    },
  ]);
}
