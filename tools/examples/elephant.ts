import { Logger, NodeIO } from '@gltf-transform/core';
import { KHRMeshQuantization } from '@gltf-transform/extensions';
import { quantize } from '@gltf-transform/functions';
import { SphereGeometry } from 'three';
import { writeModel } from './play/write-model.ts';
import { blend, carve, type Distance, ellipsoid, limb, mirrored, turned, type Vector } from './sculpt/distance.ts';
import { meshOf } from './sculpt/mesh-of.ts';

/** Width of triangles in meters: some 32,000 triangles; the ears need them. */
const CELL_M = 0.019;
/** The box around the elephant, in meters. */
const LOW: Vector = [-0.5, -0.03, -0.75];
const HIGH: Vector = [0.5, 1.15, 0.95];

/** Where the head turns, and how far, in radians: toward the side of the viewer, with the forehead up. */
const NECK: Vector = [0, 0.74, 0.3];
const HEAD_TURN = { yawRad: 0.3, pitchRad: -0.06 } as const;

const HIDE = { name: 'hide', color: [0.3, 0.31, 0.34], roughness: 0.75 } as const;
const IVORY = { name: 'ivory', color: [0.83, 0.77, 0.64], roughness: 0.4 } as const;
const EYE = { name: 'eye', color: [0.015, 0.012, 0.01], roughness: 0.15 } as const;

/**
 * An elephant calf, about 1.05 m tall, that stands at the origin and faces +z. A smooth body with folds, thin ears and a curved trunk: what
 * boxes of a robot do not have. Sculpted of signed distances.
 */
export async function makeElephant(): Promise<Uint8Array> {
  const bytes = await writeModel([
    { name: 'body', geometry: meshOf(elephant(), LOW, HIGH, CELL_M), paint: HIDE },
    ...[1, -1].flatMap((side) => [
      { name: `tusk.${side > 0 ? 'left' : 'right'}`, geometry: meshOf(placed(tusk(side)), LOW, HIGH, 0.011), paint: IVORY },
      { name: `eye.${side > 0 ? 'left' : 'right'}`, geometry: eyeball(side), paint: EYE },
    ]),
  ]);
  const io = new NodeIO().registerExtensions([KHRMeshQuantization]);
  const doc = (await io.readBinary(bytes)).setLogger(new Logger(Logger.Verbosity.SILENT));
  // Each example has its own copy, and a hundredth of a millimeter is enough.
  await doc.transform(quantize({ quantizePosition: 14, quantizeNormal: 8 }));
  return io.writeBinary(doc);
}

function elephant(): Distance {
  const body = blend(
    0.12,
    ellipsoid([0, 0.66, -0.18], [0.25, 0.25, 0.36]),
    ellipsoid([0, 0.66, 0.1], [0.23, 0.25, 0.24]),
    ellipsoid([0, 0.78, -0.02], [0.14, 0.16, 0.36]),
    ellipsoid([0, 0.62, -0.36], [0.22, 0.24, 0.19]),
  );
  const legs = mirrored(
    blend(
      0.05,
      limb([
        [0.135, 0.55, 0.16, 0.105],
        [0.135, 0.28, 0.17, 0.08],
        [0.135, 0.09, 0.18, 0.085],
        [0.135, 0.075, 0.18, 0.088],
      ]),
      limb([
        [0.13, 0.55, -0.4, 0.12],
        [0.135, 0.3, -0.36, 0.083],
        [0.135, 0.09, -0.4, 0.083],
        [0.135, 0.075, -0.4, 0.088],
      ]),
      ...toes(0.135, 0.18),
      ...toes(0.135, -0.4),
    ),
  );
  const tail = limb([
    [0, 0.72, -0.52, 0.035],
    [0.01, 0.62, -0.6, 0.022],
    [0.03, 0.48, -0.62, 0.016],
    [0.035, 0.4, -0.62, 0.022],
    [0.035, 0.33, -0.62, 0.012],
  ]);
  const neck = limb([
    [0, 0.72, 0.18, 0.2],
    [0, 0.8, 0.4, 0.17],
  ]);
  const standing = blend(0.06, blend(0.09, body, legs, neck), placed(head()), tail);
  // Flat soles.
  const hide: Distance = (x, y, z) => Math.max(standing(x, y, z) - folds(x, y, z), -y);
  return hide;
}

function placed(part: Distance): Distance {
  return turned(NECK, HEAD_TURN.yawRad, HEAD_TURN.pitchRad, part);
}

function toes(x: number, z: number): Distance[] {
  return [-0.055, 0, 0.055].map((dx) => ellipsoid([x + dx, 0.022, z + 0.075 - Math.abs(dx) * 0.45], [0.026, 0.028, 0.018]));
}

function head(): Distance {
  const skull = blend(
    0.09,
    ellipsoid([0, 0.86, 0.47], [0.165, 0.18, 0.15]),
    mirrored(ellipsoid([0.07, 0.96, 0.46], [0.09, 0.08, 0.1])),
    ellipsoid([0, 0.78, 0.57], [0.105, 0.13, 0.1]),
    mirrored(ellipsoid([0.085, 0.74, 0.55], [0.055, 0.075, 0.07])),
  );
  const trunk = limb([
    [0, 0.83, 0.6, 0.095],
    [0, 0.72, 0.67, 0.082],
    [0, 0.6, 0.705, 0.07],
    [0, 0.48, 0.71, 0.06],
    [0.01, 0.37, 0.7, 0.052],
    [0.02, 0.28, 0.715, 0.046],
    [0.03, 0.215, 0.75, 0.042],
    [0.035, 0.185, 0.8, 0.038],
    [0.035, 0.19, 0.85, 0.036],
  ]);
  const jaw = limb([
    [0, 0.7, 0.52, 0.065],
    [0, 0.62, 0.61, 0.035],
  ]);
  const lids = mirrored(ellipsoid([0.132, 0.868, 0.57], [0.036, 0.034, 0.038]));
  const skullAndTrunk = blend(0.07, skull, ringed(trunk), jaw);
  const nostrils = mirrored(
    limb([
      [0.035 + 0.012, 0.19, 0.89, 0.01],
      [0.035 + 0.012, 0.19, 0.86, 0.008],
    ]),
  );
  return blend(0.03, blend(0.03, carve(0.012, skullAndTrunk, nostrils), lids), mirrored(ear()));
}

/** Rings of skin around the trunk, which follow its height. */
function ringed(trunk: Distance): Distance {
  return (x, y, z) => {
    const from = Math.min(Math.max((0.8 - y) / 0.2, 0), 1);
    return trunk(x, y, z) - 0.004 * from * Math.sin((y - 0.4 * Math.max(z - 0.7, 0)) * 105);
  };
}

/** A thin, slightly hollow plate behind the cheek, wavy at its rim. */
function ear(): Distance {
  const outline = ellipsoid([0.3, 0.8, 0], [0.16, 0.21, 1]);
  const lobe = ellipsoid([0.235, 0.66, 0], [0.09, 0.13, 1]);
  const shape = blend(0.08, outline, lobe);
  return (x, y, z) => {
    const out = x - 0.15;
    const middle = 0.4 - 0.55 * out + 1.1 * out * out + 0.018 * Math.sin(y * 22 + 1) * Math.min(Math.max(out / 0.2, 0), 1);
    // Thicker toward the head; rounded at the rim.
    const thick = 0.015 + 0.03 * Math.min(Math.max((0.22 - x) / 0.1, 0), 1);
    return Math.hypot(Math.max(shape(x, y, 0) + thick, 0), (z - middle) * 0.85) - thick;
  };
}

function tusk(side: number): Distance {
  return limb(
    [
      [0.085, 0.72, 0.56, 0.026],
      [0.105, 0.62, 0.66, 0.022],
      [0.115, 0.57, 0.74, 0.015],
      [0.115, 0.565, 0.8, 0.007],
    ].map(([x = 0, ...rest]) => [side * x, ...rest] as unknown as readonly [number, number, number, number]),
  );
}

function eyeball(side: number): SphereGeometry {
  const [x, y, z] = unturned([side * 0.15, 0.86, 0.584]);
  return new SphereGeometry(0.022, 24, 16).translate(x, y, z);
}

/** Where a point of the head is after the turn of `placed`. */
function unturned([x, y, z]: Vector): Vector {
  const { yawRad, pitchRad } = HEAD_TURN;
  const [dx, dy, dz] = [x - NECK[0], y - NECK[1], z - NECK[2]];
  const [uy, uz] = [Math.cos(pitchRad) * dy - Math.sin(pitchRad) * dz, Math.sin(pitchRad) * dy + Math.cos(pitchRad) * dz];
  return [NECK[0] + Math.cos(yawRad) * dx + Math.sin(yawRad) * uz, NECK[1] + uy, NECK[2] - Math.sin(yawRad) * dx + Math.cos(yawRad) * uz];
}

/** Height of the folds of the hide in meters: around the knees, and over the flanks. */
function folds(x: number, y: number, z: number): number {
  const knee = Math.exp(-(((y - 0.3) / 0.07) ** 2)) * Math.sin(y * 110 + z * 15);
  const flank = Math.exp(-(((y - 0.62) / 0.12) ** 2)) * Math.exp(-(((z + 0.24) / 0.1) ** 2)) * Math.sin(z * 70 + y * 45 + Math.abs(x) * 10);
  return 0.003 * knee + 0.002 * flank;
}
