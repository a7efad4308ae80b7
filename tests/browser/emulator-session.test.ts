import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/emulator-session.page.ts');
});
afterAll(async () => {
  await page?.close();
});

function ask<T>(name: string, ...args: readonly unknown[]): Promise<T> {
  return page.call<T>(name, ...args);
}

describe('requestSession', () => {
  test('grants what the device has and refuses what it lacks', async () => {
    const { errors, second, granted, supported } = await ask<
      Record<'errors' | 'granted', unknown> & { second: string; supported: boolean }
    >('requests');
    expect(errors).toEqual({
      refusedRequired: 'NotSupportedError',
      unknownRequired: 'NotSupportedError',
      localOnThePage: 'NotSupportedError',
      depthWithoutWishes: 'NotSupportedError',
      depthInAnotherFormat: 'NotSupportedError',
      overlayWithoutRoot: 'NotSupportedError',
      plain: null,
    });
    expect(granted).toEqual({
      features: ['viewer', 'local', 'local-floor', 'depth-sensing', 'hit-test'],
      depth: ['cpu-optimized', 'luminance-alpha'],
    });
    expect(second).toBe('InvalidStateError');
    expect(supported).toBe(true);
  });
});

describe('a page that oversteps hears of it', () => {
  test('after the frame, in the wrong frame, after the end', async () => {
    const { stale, messages, within, ended } = await ask<Record<'stale' | 'messages' | 'within' | 'ended', object>>('trespasses');
    expect(Object.entries(stale).filter(([, name]) => name !== 'InvalidStateError')).toEqual([]);
    expect(Object.keys(stale)).toHaveLength(9);
    // Chromium's message, which authors of pages look up; also where the session has no anchors.
    expect(new Set(Object.values(messages))).toEqual(new Set(['XRFrame access outside the callback that produced it is invalid.']));
    expect(within).toEqual({ viewOfAnotherFrame: 'InvalidStateError', outsideTheView: 'RangeError', depthOfTheGpu: 'InvalidStateError' });
    expect(ended).toEqual({
      renderState: 'InvalidStateError',
      end: 'InvalidStateError',
      layer: 'InvalidStateError',
      space: 'NotSupportedError',
      hitTest: 'InvalidStateError',
    });
  });

  test('without the features', async () => {
    expect(await ask('trespassesWithoutFeatures')).toEqual({
      depth: 'NotSupportedError',
      gpuDepth: 'NotSupportedError',
      usage: 'InvalidStateError',
      format: 'InvalidStateError',
      probe: 'NotSupportedError',
      camera: null,
      plainContext: 'InvalidStateError',
    });
    expect(await ask('contextMadeCompatible')).toBeNull();
  });
});

interface FoundViews {
  readonly size: number[];
  readonly blend: string;
  readonly interaction: string;
  readonly views: readonly { eye: string; viewport: number[]; projection: number[]; position: number[] }[];
}

describe('views', () => {
  test('a phone has one, over all of the framebuffer', async () => {
    const found = await ask<FoundViews>('views', { device: 'phone', sizePx: [300, 600], fovYRad: 1 });
    expect(found).toMatchObject({ size: [300, 600], blend: 'alpha-blend', interaction: 'screen-space' });
    expect(found.views).toHaveLength(1);
    const [view] = found.views;
    expect(view).toMatchObject({ eye: 'none', viewport: [0, 0, 300, 600], position: [0.5, 1.5, 1] });
    // 1 / tan(fov / 2), and half the width of that at half the aspect.
    expect(view?.projection[5]).toBeCloseTo(1 / Math.tan(0.5), 6);
    expect(view?.projection[0]).toBeCloseTo(2 / Math.tan(0.5), 6);
    expect(view?.projection[8]).toBeCloseTo(0, 6);
  });

  test('a headset has two side by side, apart by the distance of the eyes, each seeing further outwards', async () => {
    const { views, size } = await ask<FoundViews>('views', { device: 'headset', sizePx: [640, 320], ipdM: 0.06 });
    expect(size).toEqual([640, 320]);
    expect(views.map(({ eye, viewport, position }) => [eye, viewport, position])).toEqual([
      ['left', [0, 0, 320, 320], [0.47, 1.5, 1]],
      ['right', [320, 0, 320, 320], [0.53, 1.5, 1]],
    ]);
    const [left, right] = views;
    expect(left?.projection[8]).toBeLessThan(-0.05);
    expect(right?.projection[8]).toBe(-(left?.projection[8] ?? 0));
  });

  test('a headset can be asked for one, and glasses add light', async () => {
    expect((await ask<FoundViews>('views', { device: 'headset', views: 1 })).views.map(({ eye }) => eye)).toEqual(['none']);
    expect(await ask<FoundViews>('views', { device: 'glasses' })).toMatchObject({ blend: 'additive', interaction: 'world-space' });
  });
});

test('tracking is lost and found, hidden sessions rest, errors in callbacks reach the page', async () => {
  const found = await ask<Record<string, unknown>>('troubles');
  expect(found).toMatchObject({ lost: null, found: true, hidden: 0, shown: 1, told: ['hidden', 'visible', 'reset'] });
  const [first = 0, second = 0] = found.times as number[];
  expect(first).toBe(0);
  expect(second).toBeCloseTo(1000 / 60, 6);
  expect(String(found.errors)).toMatch(/the page stumbled/);
  expect(found.stumbled).toBe('Error');
});

test('five sessions leave nothing behind, and the device goes without a trace', async () => {
  const { counts, before, during, after } = await ask<Record<'before' | 'during' | 'after', object> & { counts: object[] }>('leavings');
  expect(counts).toHaveLength(5);
  for (const count of counts) expect(count).toEqual({ ...counts[0], page: 0 });
  expect(during).not.toEqual(before);
  expect(after).toEqual(before);
});

test('nothing was complained about', () => {
  expect(page.errors.filter((error) => !error.includes('the page stumbled'))).toEqual([]);
});
