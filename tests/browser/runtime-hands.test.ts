import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-hands.page.ts');

describe('hands and controllers in a headset', () => {
  test('joints are where the browser says, one by one, for both hands', async () => {
    const { differences, lost, ...rest } = await page.call<{ differences: number[]; lost: object }>('joints');
    for (const difference of differences) expect(difference).toBeLessThan(1e-6);
    expect(rest).toEqual({ tracked: [true, true], by: ['right-hand hold', 'left-hand hover'], granted: true });
    expect(lost).toEqual({ tracked: [true, false], by: ['right-hand cancel', 'left-hand hover'] });
  });

  test('are recorded, and replayed as they came: pointers, taps, joints, grips', async () => {
    const { live, again, diagnostics } = await page.call<{ live: { tapCount: number }[]; again: object[]; diagnostics: object[] }>(
      'replayed',
    );
    expect(diagnostics).toEqual([]);
    expect(live.map(({ tapCount }) => tapCount).reduce((sum, count) => sum + count)).toBe(1);
    expect(again).toEqual(live);
  });

  test('hands are not asked for where no node needs them', async () => {
    expect(await page.call('unasked')).toEqual([false, false]);
  });

  test('missing hands are told on a headset, not on a phone, which is touched', async () => {
    expect([await page.call('missingOn', 'headset'), await page.call('missingOn', 'phone')]).toEqual([1, 0]);
  });

  test('a controller has its grip, and vibrates', async () => {
    const { grip, own, bare, played } = await page.call<{ grip: number[]; own: number[]; bare: boolean; played: number[] }>('haptics');
    expect(grip).toHaveLength(16);
    expect([grip, bare, played]).toEqual([own, false, [0.6, 250]]);
  });
});
