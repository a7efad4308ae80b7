import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

const open = (): Promise<PageModule> => openModule(chromium.browser, 'tests/browser/runtime-webxr.page.ts');

beforeAll(async () => {
  page = await open();
});

afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

/** For what leaves the globals of its page changed. */
async function inOwnPage<T>(name: string, ...args: readonly unknown[]): Promise<T> {
  const own = await open();
  const result = await own.call<T>(name, ...args);
  await own.close();
  expect(own.errors).toEqual([]);
  return result;
}

const NO_ERROR = 0;

interface Views {
  readonly world: string;
  readonly blend: string;
  readonly views: { readonly eye: string; readonly viewport: unknown; readonly position: number[]; readonly viewFromWorld: number[] }[];
  readonly times: number[][];
  readonly corners: number[][];
  readonly error: number;
}

describe('views of a WebXR session', () => {
  test('one covers the framebuffer', async () => {
    const { views, times, corners, world, blend, error } = await page.call<Views>('views', 'phone');
    expect([world, blend, error]).toEqual(['device', 'alpha', NO_ERROR]);
    expect(views).toEqual([
      {
        eye: 'none',
        viewport: { x: 0, y: 0, widthPx: 128, heightPx: 64 },
        position: [1, 1.5, 2],
        viewFromWorld: [-1, -1.5, -2],
      },
    ]);
    expect(times).toEqual([0, 1, 2].map((i) => [i, expect.closeTo(i / 60, 6), i === 0 ? 0 : expect.closeTo(1 / 60, 6)]));
    // Red grows to the right, green upwards, over all 128 × 64 pixels.
    expect(corners).toEqual([
      [1, 2, 0, 255],
      [127, 2, 0, 255],
      [128, 2, 0, 255],
      [254, 253, 0, 255],
    ]);
  });

  test('two stand side by side, an eye distance apart', async () => {
    const { views, corners, error } = await page.call<Views>('views', 'headset');
    expect(error).toBe(NO_ERROR);
    expect(views.map(({ eye, viewport, position }) => ({ eye, viewport, x: position[0] }))).toEqual([
      { eye: 'left', viewport: { x: 0, y: 0, widthPx: 64, heightPx: 64 }, x: expect.closeTo(0.97, 6) },
      { eye: 'right', viewport: { x: 64, y: 0, widthPx: 64, heightPx: 64 }, x: expect.closeTo(1.03, 6) },
    ]);
    expect(corners).toEqual([
      [2, 2, 0, 255],
      [253, 2, 0, 255],
      [2, 2, 0, 255],
      [253, 253, 0, 255],
    ]);
  });

  test('additive displays report that they add light', async () => {
    const { world, blend } = await page.call<Views>('views', 'glasses');
    expect([world, blend]).toEqual(['device', 'additive']);
  });
});

/** Lower left, lower right, upper left, upper right: the blocks of the page's room. */
const QUARTERS_MM = [1500, 2250, 3000, 4125];

const TURNS: readonly (readonly [string, EmulatorOptions['depth']])[] = [
  ['upright', {}],
  ['turned a quarter', { transform: { turnDeg: 90 } }],
  ['turned half', { transform: { turnDeg: 180 } }],
  ['turned three quarters and mirrored', { transform: { turnDeg: 270, flipX: true } }],
  ['upside down', { transform: { flipY: true } }],
  ['wider than the view', { transform: { covers: { x: -0.2, y: -0.1, width: 1.5, height: 1.3 } } }],
];

interface Depths {
  readonly found: number[][];
  readonly diagnostics: unknown[];
  readonly leaks: string[];
  readonly error: number;
}

const depth = (options: EmulatorOptions): Promise<Depths> => page.call<Depths>('depth', options);

describe('room depth is meters where the view sees them', () => {
  test.each(TURNS)('from a buffer that lies %s', async (_name, options) => {
    const { found, leaks, error } = await depth({ device: 'phone', depth: { ...options } });
    expect(found).toEqual([QUARTERS_MM]);
    expect(leaks).toEqual([]);
    expect(error).toBe(NO_ERROR);
  });

  test.each([
    ['cpu-optimized', 'luminance-alpha'],
    ['cpu-optimized', 'unsigned-short'],
    ['cpu-optimized', 'float32'],
    ['gpu-optimized', 'luminance-alpha'],
    ['gpu-optimized', 'unsigned-short'],
    ['gpu-optimized', 'float32'],
  ] as const)('%s as %s, for one view and two', async (usage, format) => {
    const options = { usages: [usage], formats: [format], transform: { turnDeg: 90 } } as const;
    const phone = await depth({ device: 'phone', depth: options });
    expect(phone).toEqual({ found: [QUARTERS_MM], diagnostics: [], leaks: [], error: NO_ERROR });
    const headset = await depth({ device: 'headset', depth: options });
    expect(headset).toEqual({ found: [QUARTERS_MM, QUARTERS_MM], diagnostics: [], leaks: [], error: NO_ERROR });
  });

  const QUEST = { device: 'headset', depth: { usages: ['gpu-optimized'] } } as const;

  test('from an array of a layer per view, where the browser says neither that it is one nor which layer', async () => {
    const whole = await inOwnPage<Depths>('depth', QUEST, 'whole');
    const { found, error } = await inOwnPage<Depths>('depth', QUEST, 'without textureType and imageIndex');
    expect(error).toBe(NO_ERROR);
    expect(found).toEqual(whole.found);
  });

  test('and unknown where the browser says that it is not valid', async () => {
    const { found, error } = await inOwnPage<Depths>('depth', QUEST, 'not valid');
    expect(error).toBe(NO_ERROR);
    expect(found.flat()).toEqual(Array.from({ length: 8 }, () => null));
  });

  test('as window depth in an array, which Quest Browser and iwer give', async () => {
    const { found, error } = await inOwnPage<Depths>('depth', QUEST, 'whole');
    expect(error).toBe(NO_ERROR);
    const offMm = found.flatMap((view) => view.map((mm, i) => Math.abs(mm - (QUARTERS_MM[i] ?? 0))));
    expect(offMm).toHaveLength(8);
    expect(Math.max(...offMm)).toBeLessThanOrEqual(1);
  });

  test('to a few millimeters where the GPU draws no more than half floats', async () => {
    const options = { device: 'phone', depth: { usages: ['gpu-optimized'] } } as const;
    const { found, error } = await page.call<Depths>('depth', options, null, ['EXT_color_buffer_float']);
    expect(error).toBe(NO_ERROR);
    // 11 bits of mantissa: 2 mm between 2 m and 4 m, 4 mm beyond.
    found[0]?.forEach((mm, i) => {
      expect(Math.abs(mm - (QUARTERS_MM[i] ?? 0))).toBeLessThanOrEqual(2);
    });
    expect(found[0]).toHaveLength(4);
  });

  test('and none where the device has none, which is said', async () => {
    const { found, diagnostics } = await depth({ device: 'glasses' });
    expect(found).toEqual([
      [null, null, null, null],
      [null, null, null, null],
    ]);
    expect(diagnostics).toEqual([
      expect.objectContaining({ code: 'SCR055', severity: 'warning', message: expect.stringContaining('There is no depth.') }),
    ]);
  });
});

interface Camera {
  readonly largest: number;
  readonly alphas: number[];
  readonly colors: number;
  readonly capabilities: string[];
  readonly diagnostics: { readonly code: string }[];
  readonly leaks: string[];
}

describe('the camera picture', () => {
  test('is what the view shows of the world', async () => {
    const { largest, alphas, colors, capabilities, leaks } = await page.call<Camera>('camera', []);
    expect(largest).toBeLessThanOrEqual(1);
    expect(alphas).toEqual([255]);
    // The room is furnished: a picture upside down or of one color would not do.
    expect(colors).toBeGreaterThan(100);
    expect(capabilities).toEqual(['camera-image']);
    expect(leaks).toEqual([]);
  });

  test('leaves the real world visible when it is refused', async () => {
    const { alphas, capabilities, diagnostics } = await page.call<Camera>('camera', ['camera-access']);
    expect(alphas).toEqual([0]);
    expect(capabilities).toEqual([]);
    expect(diagnostics.map((d) => d.code)).toEqual(['SCR055']);
  });
});

test('light comes as the device estimates it', async () => {
  const light = await page.call('light');
  // The emulated room's lamp.
  expect(light).toEqual({
    direction: [0.36, 0.8, 0.48].map((value) => expect.closeTo(value, 5)),
    intensity: [1.9, 1.8, 1.65].map((value) => expect.closeTo(value, 5)),
    coefficients: 27,
  });
});

test('a context that is lost takes the session nowhere: it draws on when the graphics are back, and time takes no leap', async () => {
  expect(await page.call('contextLoss')).toEqual({
    same: true,
    blank: false,
    whileLost: [0, 0],
    heard: ['ended by page'],
    longest: expect.closeTo(0.5, 6),
    error: 0,
  });
});

describe('a session tells the page', () => {
  const HEARD = ['tracked false', 'tracked true', 'visible false', 'visible true', 'recentered'];

  test('of tracking, visibility and re-centering, and ends when the page wants', async () => {
    const { heard, whileLost, leaks } = await page.call<{ heard: string[]; whileLost: number; leaks: string[] }>('events', 'page');
    expect(heard).toEqual([...HEARD, 'ended by page']);
    expect(whileLost).toBe(0);
    expect(leaks).toEqual([]);
  });

  test('or when the device does', async () => {
    const { heard, leaks } = await page.call<{ heard: string[]; leaks: string[] }>('events', 'device');
    expect(heard).toEqual([...HEARD, 'ended by user']);
    expect(leaks).toEqual([]);
  });
});

test('a refusal says why, and what to do', async () => {
  expect(await page.call('refusals')).toEqual({
    none: [false, false, 'SCR050 This browser cannot show AR: it has no WebXR.'],
    lacking: [true, false, 'SCR051 This device has no AR, or lacks what the page needs: surfaces you point at.'],
    optional: [true, true, 'SCR055 Not available here: the depth of the room. There is no depth.'],
    complete: [true, true],
  });
});

test.each([
  ['NotSupportedError', 'This device has no AR.'],
  ['NotAllowedError', 'AR was not allowed.'],
  ['SecurityError', 'The browser starts AR only after a click or tap'],
  ['InvalidStateError', 'Another AR session is running.'],
  ['UnknownError', 'AR could not be started: The device is busy.'],
])('a browser that answers %s is understood', async (name, words) => {
  expect(await page.call('refusedBy', name)).toEqual([null, expect.stringMatching(new RegExp(`^SCR051 ${words}.* .+`))]);
});

describe('iwer as it comes', () => {
  test('with one eye: its second view of no width is left out', async () => {
    expect(await inOwnPage('plainIwer', false)).toEqual({
      viewports: [{ x: 0, y: 0, widthPx: 640, heightPx: 360 }],
      eyes: ['left'],
      corner: [255, 255, 0, 255],
    });
  });

  test('with two eyes', async () => {
    expect(await inOwnPage('plainIwer', true)).toEqual({
      viewports: [
        { x: 0, y: 0, widthPx: 320, heightPx: 360 },
        { x: 320, y: 0, widthPx: 320, heightPx: 360 },
      ],
      eyes: ['left', 'right'],
      corner: [255, 255, 0, 255],
    });
  });
});
