import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

/** Pages of the WebXR samples (https://github.com/immersive-web/webxr-samples) make the same calls on the emulated device. */

const page = useModule('tests/browser/webxr-samples.page.ts');

const near = (numbers: readonly number[], digits = 3) => numbers.map((x) => expect.closeTo(x, digits));

test('hit-test.html and hit-test-anchors.html: the reticle lies on the table, and a tap anchors what stays there', async () => {
  const result = await page.call<Record<string, unknown>>('hitTestAnchors');
  // The table's top is 0.8 m high, seen from (0, 1.6, 0), which is the origin of `local`.
  const onTable = near([0, -0.8, -1.8]);
  expect(result).toEqual({ onTable, first: [onTable], atCeiling: null, deleted: [], errors: [], ended: true });
});

test('anchors.html: a free anchor stays where the reticle was 1 m ahead', async () => {
  const { shown, at, moved } = await page.call<Record<string, number[]>>('anchors');
  // From (0, 1.6, 0) towards (0, 0.8, -1.8).
  const length = Math.hypot(0.8, 1.8);
  const ahead = [0, 1.6 - 0.8 / length, -1.8 / length];
  expect(shown).toEqual(near(ahead));
  expect(at).toEqual(near(ahead));
  expect(moved).toEqual(near([1, 1.6, -1]));
});

test('immersive-hands.html: 25 radii and poses are filled from the hand’s iterator, and agree with the joints', async () => {
  type Hand = Readonly<Record<'tip' | 'filled' | 'radii' | 'modes', number[]>> & { readonly size: number };
  const { seen, ...rest } = await page.call<{ seen: Record<string, Hand> }>('hands');
  expect(rest).toEqual({ views: 2, states: ['visible-blurred'], hasClass: true, error: 0 });
  expect(Object.keys(seen).sort()).toEqual(['left', 'right']);
  for (const { tip, filled, radii, modes, size } of Object.values(seen)) {
    expect(size).toBe(25);
    expect(modes).toEqual(['tracked-pointer']);
    expect(filled).toEqual(near(tip));
    for (const radiusM of radii) {
      expect(radiusM).toBeGreaterThan(0.003);
      expect(radiusM).toBeLessThan(0.04);
    }
  }
});

test('input-selection.html and controller-state.html: select and squeeze come in order with their rays, buttons and sticks', async () => {
  const { events, origins, held, released, hasInlineViewer } = await page.call<Record<string, unknown>>('input');
  expect(hasInlineViewer).toBe(true);
  const of = (hand: string) => (events as string[]).filter((name) => name.endsWith(hand)).map((name) => name.split(' ')[0]);
  expect(of('left')).toEqual(['selectstart', 'select', 'selectend']);
  expect(of('right')).toEqual(['squeezestart', 'squeeze', 'squeezeend']);
  expect(new Set((origins as number[][]).map(([x = 0]) => Math.sign(x)))).toEqual(new Set([-1, 1]));
  // The standard mapping: button 0 is the trigger, button 1 the squeeze; axes 2 and 3 are the thumbstick.
  expect(held).toEqual(
    expect.arrayContaining([
      { hand: 'left', mapping: 'xr-standard', pressed: [0], axes: [0, 0, 0, 0] },
      { hand: 'right', mapping: 'xr-standard', pressed: [1], axes: [0, 0, 0.5, -1] },
    ]),
  );
  expect(released).toEqual([0, 0]);
  expect(page.errors).toEqual([]);
});
