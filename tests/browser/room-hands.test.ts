import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/room-hands.page.ts');

const near = (numbers: readonly number[]) => numbers.map((x) => expect.closeTo(x, 2));

describe('hands and controllers of a headset in the preview', () => {
  test('controllers point at the mouse, press by keys and tell what they play', async () => {
    const { hints, held, ahead, grip, pulses, up } = await page.call<Record<string, number[]>>('controllers');
    expect(hints).toEqual([expect.stringContaining('trigger'), false]);
    expect(held).toEqual({ phases: ['left hover', 'right start'], trigger: [0, 1], squeeze: [1, 0] });
    // At (300, 200) of 400 × 400 pixels: half the tangent of half the field of view to the right, at 2 m.
    const aim = [1 + Math.tan(0.7), 1.6, 0];
    const from = [1.18, 1.4, 1.65];
    const along = aim.map((x, i) => x - (from[i] ?? 0));
    expect(grip).toEqual(near(from));
    expect(ahead).toEqual(near(along.map((x) => x / Math.hypot(...along))));
    expect(pulses).toEqual([null, { strength: 0.5, durationS: 0.2 }]);
    expect(up).toEqual(['left hover', 'right end']);
  });

  test('two hands pinch; one that is lost in its pinch cancels it, and comes back without pressing', async () => {
    const { seen, shapes, refused, hint } = await page.call<{
      seen: string[][];
      shapes: Record<string, number[]>;
      refused: string;
      hint: string;
    }>('hands');
    expect(seen).toEqual([
      ['left-hand start', 'right-hand start'],
      ['left-hand hold', 'right-hand hold'],
      ['left-hand hold', 'right-hand cancel'],
      ['left-hand hold'],
      ['left-hand hold', 'right-hand hover'],
      ['left-hand end', 'right-hand hover'],
    ]);
    expect(shapes).toEqual({ relaxed: [0, 0], pinch: [1, 0], grab: [0, 1], poke: [0, 0], capture: [0, 0] });
    expect(refused).toContain('“wave”');
    expect(hint).toContain('pinch');
  });
});

test('on a phone in the preview a click taps, Shift and Alt make drags of one finger and of two, and other drags look around', async () => {
  interface Played {
    readonly phases: readonly (readonly string[])[];
    readonly rays: readonly (readonly number[])[];
    readonly taps: number;
  }
  type Drag = Readonly<Record<'down' | 'moved' | 'up', Played>> & { readonly turned: boolean };
  const { click, one, two, look, hint, tan } = await page.call<{
    click: Played;
    one: Drag;
    two: Drag;
    look: Drag;
    hint: string;
    tan: number;
  }>('touches');
  const phases = ({ phases }: Played) => [...new Set(phases.flat())];
  expect([phases(click)[0], phases(click).at(-1), click.taps]).toEqual(['screen start', 'screen end', 1]);
  // At (300, 200) of 400 × 400 pixels, then at (200, 100).
  expect(click.rays).toEqual([[expect.closeTo(tan / 2, 2), expect.closeTo(0, 2)]]);
  expect([phases(one.down)[0], phases(one.moved), phases(one.up)]).toEqual(['screen start', ['screen hold'], ['screen end']]);
  expect([one.down.rays.length, one.moved.rays.length, one.turned]).toEqual([1, 1, false]);
  expect([two.down.rays.length, two.moved.rays.length, two.turned]).toEqual([2, 2, false]);
  const [a, b] = two.moved.rays;
  expect([a?.[0], a?.[1]]).toEqual(near([-(b?.[0] ?? 0), -(b?.[1] ?? 0)]));
  expect([phases(look.down), phases(look.moved), phases(look.up), look.up.taps, look.turned]).toEqual([[], [], [], 0, true]);
  expect(hint).toContain('Shift + drag');
});

test('tracking drifts, is lost and re-centered, and anchors are lost and deleted, by keys that the preview shows', async () => {
  interface Step {
    readonly at: readonly number[] | null;
    readonly views: number;
    readonly jumps: number;
    readonly anchors: number;
  }
  const { steps, hints, hidden } = await page.call<{ steps: Readonly<Record<string, Step | null>>; hints: string[]; hidden: boolean }>(
    'tracking',
  );
  expect(hidden).toBe(false);
  for (const word of ['re-center', 'drift', 'lose tracking', 'lose anchors', 'delete anchors']) expect(hints[0]).toContain(word);
  const at = (name: string) => steps[name]?.at;
  expect(at('start')).toEqual(near([0, 1, -1]));
  // World space moves by 2 cm and turns by 1° about the room's origin; the anchor, whose point stays, moves the other way.
  const drifted = ([x = 0, y = 0, z = 0]: readonly number[]) => {
    const [cos, sin] = [Math.cos(Math.PI / 180), Math.sin(Math.PI / 180)];
    return [(x - 0.02) * cos - z * sin, y, (x - 0.02) * sin + z * cos];
  };
  const exact = (numbers: readonly number[]) => numbers.map((x) => expect.closeTo(x, 4));
  expect(at('minute')).toEqual(exact(drifted([0, 1, -1])));
  // The same once more within a minute, in small steps.
  const after = at('drift') ?? [];
  expect(after.map((x, i) => Math.abs(x - (drifted(drifted([0, 1, -1]))[i] ?? 0)) < 3e-4)).toEqual([true, true, true]);
  expect(at('still')).toEqual(exact(after));
  expect([at('anchorsLost'), at('anchorsFound')]).toEqual([null, exact(after)]);
  expect([steps.trackingLost, steps.trackingFound?.views]).toEqual([null, 1]);
  // World space begins at the head again, at (1, 2) of the floor.
  expect(at('centered')).toEqual(near([-1, 1, -3]));
  expect([steps.trackingFound?.jumps, steps.centered?.jumps]).toEqual([0, 1]);
  expect([steps.centered?.anchors, steps.deleted?.anchors]).toEqual([1, 0]);
  expect(hints[3]).toContain('stop the drift');
  expect(hints[5]).toContain('find anchors again');
});
