import { describe, expect, test } from '@jest/globals';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import type { LayerPixels } from '../../kit/layer-pixels.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** A picture of letters, the top row first: `#` is white, `+` is gray of 40 %, `o` is opaque black, a dot is transparent. */
function picture(...rows: readonly string[]): LayerPixels {
  const colors: Readonly<Record<string, readonly number[]>> = {
    '#': [255, 255, 255, 255],
    '+': [102, 102, 102, 255],
    o: [0, 0, 0, 255],
    '.': [0, 0, 0, 0],
  };
  const [first = ''] = rows;
  const data = Uint8Array.from([...rows].reverse().flatMap((row) => [...row].flatMap((letter) => colors[letter] ?? [])));
  return { data, widthPx: first.length, heightPx: rows.length };
}

// 7 white pixels of 10 × 5. By hand: x = 2, 3, 4, 2, 3, 4, 6 from the left, y = 3, 3, 3, 2, 2, 2, 1 from the bottom.
const BLOB = picture(
  'oooooooooo', //
  'oo###ooooo',
  'oo###ooooo',
  'oooooo#+oo',
  'oooooooooo',
);
const EMPTY = picture('oooo', 'oooo');

function start(params: Parameters<typeof fakeContext<typeof definition>>[1] = {}) {
  let shown: LayerPixels | null = null;
  const { ctx, tick, set } = fakeContext(definition, { ...params, inputs: { mask: { read: () => shown } } });
  const node = create(ctx);
  const step = (next: LayerPixels | null) => {
    shown = next;
    tick(1 / 30);
    node.update({} as never);
    return ctx.outputs;
  };
  return { node, step, set };
}

/** What happens in a frame: `+` for an entry, `-` for a leave. */
function events({ entered, left, inside }: ReturnType<ReturnType<typeof start>['step']>): string {
  return `${'+'.repeat(entered.count)}${'-'.repeat(left.count)} ${inside.value}`;
}

describe('layer/measure-mask', () => {
  test('gives area, center and box of a mask that was measured by hand', () => {
    const { area, center, boxMin, boxMax } = start().step(BLOB);
    expect(area.value).toBeCloseTo(7 / 50, 9);
    expect(center.value[0]).toBeCloseTo((24 / 7 + 0.5) / 10, 9);
    expect(center.value[1]).toBeCloseTo((16 / 7 + 0.5) / 5, 9);
    expect([...boxMin.value]).toEqual([0.2, 0.2]);
    expect([...boxMax.value]).toEqual([0.7, 0.8]);
  });

  test('counts gray from the threshold on, and by alpha whatever is opaque', () => {
    expect(start({ params: { threshold: 0.4 } }).step(BLOB).area.value).toBeCloseTo(8 / 50, 9);
    expect(start({ params: { source: 1 } }).step(BLOB).area.value).toBe(1);
    expect(start({ params: { source: 1 } }).step(picture('#o..', '....')).area.value).toBe(0.25);
  });

  test('measures only its region, and relates the area to it', () => {
    const { area, boxMax } = start({ params: { regionMin: [0.2, 0.6], regionMax: [0.5, 1] } }).step(BLOB);
    // 3 × 2 pixels, of which the upper row of the blob is one half.
    expect(area.value).toBeCloseTo(0.5, 9);
    expect([...boxMax.value]).toEqual([0.5, 0.8]);
  });

  test('is empty in a region without pixels', () => {
    expect(start({ params: { regionMin: [0.6, 0.6], regionMax: [0.4, 0.4] } }).step(BLOB).area.value).toBe(0);
  });

  test('pulses when the mask enters and leaves, with the area, and not between the two limits', () => {
    const half = picture('#o');
    const quarter = picture('#ooo');
    const { step } = start({ params: { enterArea: 0.4, leaveArea: 0.2 } });
    expect(events(step(null))).toBe(' false');
    expect(events(step(quarter))).toBe(' false');
    const entered = step(half);
    expect([events(entered), pulseNumbers(entered.entered)]).toEqual(['+ true', [0.5]]);
    expect([events(step(quarter)), events(step(half))]).toEqual([' true', ' true']);
    const left = step(EMPTY);
    expect([events(left), pulseNumbers(left.left)]).toEqual(['- false', [0]]);
  });

  test('keeps the last center while there is no mask, and forgets it at a reset', () => {
    const { node, step } = start();
    step(picture('ooo#'));
    const { center, boxMin, boxMax } = step(EMPTY);
    expect([...center.value]).toEqual([0.875, 0.5]);
    expect([...boxMin.value, ...boxMax.value]).toEqual([0, 0, 0, 0]);
    node.reset?.();
    expect([...step(null).center.value]).toEqual([0.5, 0.5]);
    expect(events(step(picture('#')))).toBe('+ true');
  });
});
