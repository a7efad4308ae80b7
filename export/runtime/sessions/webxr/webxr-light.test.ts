import { expect, test } from '@jest/globals';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { harmonicsBasis } from '../../../../tests/support/spherical-harmonics.ts';
import { rotateHarmonics } from './rotate-harmonics.ts';
import { createWebXrLight } from './webxr-light.ts';
import type { XrBinding, XrSessionWithLight } from './webxr-types.ts';

const COEFFICIENTS = Float32Array.from({ length: 27 }, (_, i) => Math.sin(i * 1.7 + 1));

function poseOf(x: number, y: number, z: number): Matrix4 {
  const turn = new Quaternion()
    .setFromAxisAngle(new Vector3(1, 2, -0.5).normalize(), x)
    .multiply(new Quaternion(y, z, 0.2, 0.9).normalize());
  return new Matrix4().compose(new Vector3(3, -1, 2), turn, new Vector3(1, 1, 1));
}

/** Radiance of one channel from one side. */
function radiance(l: ArrayLike<number>, channel: number, { x, y, z }: Vector3): number {
  return harmonicsBasis(x, y, z).reduce((sum, value, i) => sum + value * (l[i * 3 + channel] ?? 0), 0);
}

test('turned harmonics say of every direction what they said of it before it was turned', () => {
  for (const pose of [poseOf(0.4, 0.3, -0.6), poseOf(2.8, 0, 0.7), new Matrix4().makeRotationY(Math.PI / 2), new Matrix4()]) {
    const turned = new Float32Array(27);
    rotateHarmonics(turned, COEFFICIENTS, Float32Array.from(pose.elements));
    for (let i = 0; i < 60; i++) {
      const inProbe = new Vector3(Math.sin(i * 2.1), Math.cos(i * 1.3), Math.sin(i * 0.7 + 1)).normalize();
      const inWorld = inProbe.clone().transformDirection(pose);
      for (let c = 0; c < 3; c++) expect(radiance(turned, c, inWorld)).toBeCloseTo(radiance(COEFFICIENTS, c, inProbe), 4);
    }
  }
});

test('a space that is re-centered turns all of the light: coefficients, the strongest light and what is mirrored', async () => {
  const probe = Object.assign(new EventTarget(), { probeSpace: {} });
  const session = { requestLightProbe: () => Promise.resolve(probe) } as unknown as XrSessionWithLight;
  const texture = {};
  const binding = { getReflectionCubeMap: () => texture } as unknown as XrBinding;
  const light = createWebXrLight(session);
  await Promise.resolve();
  const said = {
    sphericalHarmonicsCoefficients: COEFFICIENTS,
    primaryLightDirection: { x: 0, y: 0, z: 1 },
    primaryLightIntensity: { x: 1, y: 1, z: 1 },
  };
  const read = (pose: Matrix4) => {
    const frame = { getLightEstimate: () => said, getPose: () => ({ transform: { matrix: Float32Array.from(pose.elements) } }) };
    const found = light.read(frame as unknown as XRFrame, {} as XRReferenceSpace, binding);
    if (!found?.reflection) throw new Error('No light.');
    const { reflection, sphericalHarmonics, primaryDirectionWorld } = found;
    const m = reflection.cubeFromWorld;
    return {
      version: reflection.version,
      toRight: m ? [m[0], m[1], m[2]].map((n) => Math.round((n ?? 0) * 1000) / 1000 + 0) : null,
      harmonics: [...sphericalHarmonics],
      towards: [...primaryDirectionWorld].map((n) => Math.round(n * 1000) / 1000 + 0),
    };
  };
  const before = read(new Matrix4());
  expect(before).toMatchObject({ version: 1, toRight: [1, 0, 0], towards: [0, 0, 1] });
  before.harmonics.forEach((value, i) => {
    expect(value).toBeCloseTo(COEFFICIENTS[i] ?? Number.NaN, 5);
  });
  expect(read(new Matrix4().makeTranslation(1, 2, 3)).version).toBe(1);
  // What was towards +z is towards +x now.
  const after = read(new Matrix4().makeRotationY(Math.PI / 2));
  expect(after).toMatchObject({ version: 2, toRight: [0, 0, 1], towards: [1, 0, 0] });
  // Its x coefficient is what its z coefficient was.
  expect(after.harmonics[9]).toBeCloseTo(COEFFICIENTS[6] ?? Number.NaN, 5);
  expect(read(new Matrix4().makeRotationY(Math.PI / 2)).version).toBe(2);
});
