import { describe, expect, test } from '@jest/globals';
import { affineToMatrix, depthClipFromView, depthUvFromViewUv } from './depth-transform.ts';

function at(transform: Parameters<typeof depthUvFromViewUv>[0], u: number, v: number): number[] {
  const m = affineToMatrix(depthUvFromViewUv(transform));
  const row = (r: number): number => (m[r] ?? 0) * u + (m[r + 4] ?? 0) * v + (m[r + 12] ?? 0);
  return [row(0), row(1)];
}

const CORNER = [0, 0] as const;
const TOP_RIGHT = [1, 0] as const;

describe('where a corner of the view lies in the buffer, both from the top left', () => {
  test.each([
    [{}, TOP_RIGHT, [1, 0]],
    // Turned clockwise, the view's top right comes to the bottom right.
    [{ turnDeg: 90 }, TOP_RIGHT, [1, 1]],
    [{ turnDeg: 180 }, TOP_RIGHT, [0, 1]],
    [{ turnDeg: 270 }, TOP_RIGHT, [0, 0]],
    [{ flipX: true }, TOP_RIGHT, [0, 0]],
    [{ flipY: true }, TOP_RIGHT, [1, 1]],
    [{ flipX: true, turnDeg: 90 }, TOP_RIGHT, [1, 0]],
    // A buffer that shows the view's middle half: its corner lies outside.
    [{ covers: { x: 0.25, y: 0.25, width: 0.5, height: 0.5 } }, CORNER, [-0.5, -0.5]],
    [{ covers: { x: -0.5, y: 0, width: 2, height: 1 } }, CORNER, [0.25, 0]],
  ] as const)('%j', (transform, [u, v], expected) => {
    expect(at(transform, u, v)).toEqual(expected.map((x) => expect.closeTo(x, 9)));
  });
});

test('the projection draws a point to its texel, the buffer’s first row first', () => {
  // x and y of a 90° projection: clip = (x, y, ·, −z).
  const clipFromView = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0];
  const map = depthUvFromViewUv({ turnDeg: 90, covers: { x: 0, y: 0, width: 0.5, height: 1 } });
  const m = depthClipFromView(clipFromView, map);
  // A quarter from the left, a quarter from the top: device coordinates (−0.5, 0.5), 2 m away.
  const point = [-1, 1, -2, 1];
  const clip = [0, 1, 2, 3].map((r) => point.reduce((sum, p, c) => sum + p * (m[c * 4 + r] ?? 0), 0));
  const [u, v] = [map.a * 0.25 + map.c * 0.25 + map.tx, map.b * 0.25 + map.d * 0.25 + map.ty];
  expect([u, v]).toEqual([0.75, 0.5]);
  // The target's row 0 is at −1 and holds v = 0.
  expect([(clip[0] ?? 0) / (clip[3] ?? 1), (clip[1] ?? 0) / (clip[3] ?? 1)]).toEqual([
    expect.closeTo(2 * u - 1, 6),
    expect.closeTo(2 * v - 1, 6),
  ]);
});
