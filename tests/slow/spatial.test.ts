import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/spatial.page.ts');
});

afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

interface Told {
  readonly at: readonly number[];
  readonly normal: readonly number[];
  readonly z: readonly number[];
  readonly source: string;
  readonly distanceM: number;
  readonly anchorable: boolean;
  readonly label: string;
  readonly frame: number;
}

interface Counted {
  readonly before: { readonly hitTests: number; readonly deviceSources: number; readonly anchors: number };
  readonly after: Counted['before'];
  readonly error: number;
}

const NOTHING_OPEN = { hitTests: 0, deviceSources: 0, anchors: 0 };

/** 1 mm. */
const near = (numbers: readonly number[]) => numbers.map((x) => expect.closeTo(x, 3));

/** From (0, 1.5, 1), 1 rad below the horizon: the floor is met 1.5 / tan 1 ahead. */
const AHEAD_M = 1.5 / Math.tan(1);
const FLOOR_HIT = {
  at: near([0, 0, 1 - AHEAD_M]),
  normal: near([0, 1, 0]),
  z: near([0, 0, 1]),
  distanceM: expect.closeTo(1.5 / Math.sin(1), 3),
};

interface Phone extends Counted {
  readonly center: Told | null;
  readonly seen: readonly {
    readonly phases: string[];
    readonly taps: number;
    readonly hit: Told | null;
    readonly ray?: number[];
    readonly pointer: boolean;
  }[];
}

describe('hit tests of a phone', () => {
  let able: Phone;
  beforeAll(async () => {
    able = await page.call<Phone>('phone', ['hit-test', 'anchors']);
  });

  test('meet the floor of the room to a millimeter, by the device itself', () => {
    const { center, before, error } = able;
    expect(center).toMatchObject({ ...FLOOR_HIT, source: 'session', anchorable: true });
    expect([before, error]).toEqual([NOTHING_OPEN, 0]);
  });

  test('follow a finger from its start to its end, with one tap', () => {
    const { seen } = able;
    const pressed = seen.filter(({ phases }) => phases.length > 0);
    expect(pressed.map(({ phases }) => phases)).toEqual(
      [['screen start'], ['screen hold'], ['screen hold'], ['screen end']].slice(-pressed.length),
    );
    expect(seen.map(({ taps }) => taps).reduce((a, b) => a + b)).toBe(1);
    for (const { hit, ray = [], pointer } of pressed) {
      expect([hit?.source, pointer]).toEqual(['session', true]);
      const distanceM = (ray[13] ?? 0) / (ray[9] ?? 0);
      expect(hit?.at).toEqual(near([0, 1, 2].map((row) => (ray[12 + row] ?? 0) - distanceM * (ray[8 + row] ?? 0))));
    }
  });

  test('are answered by planes, and then by an assumed floor, where the device has no hit test', async () => {
    const refuse = ['hit-test'];
    const byPlanes = await page.call<Phone>('phone', ['hit-test', 'planes'], { refuse });
    expect(byPlanes.center).toMatchObject({ ...FLOOR_HIT, source: 'plane', label: 'floor', anchorable: false });
    const byFloor = await page.call<Phone>('phone', ['hit-test'], { refuse });
    expect(byFloor.center).toMatchObject({ ...FLOOR_HIT, source: 'floor' });
  });
});

interface Sources extends Counted {
  readonly by: Readonly<Record<string, Told | null>>;
  readonly first: string;
  readonly waited: number;
  readonly index: number;
  /** To the first solid. */
  readonly solidM: number;
}

describe('a ray that no device follows', () => {
  test.each([
    ['on the CPU', 'cpu-optimized', false],
    ['on the GPU', 'gpu-optimized', false],
    ['on the GPU, while the clock is held', 'gpu-optimized', true],
  ] as const)('is answered by each source to a millimeter, with depth %s', async (_name, usage, held) => {
    const { by, first, waited, index, solidM, error } = await page.call<Sources>(
      'sources',
      { depth: { usages: [usage], formats: ['float32'] } },
      held,
    );
    expect(by).toMatchObject({
      session: null,
      plane: { ...FLOOR_HIT, label: 'floor' },
      mesh: { distanceM: expect.closeTo(solidM, 3), normal: near([0, 1, 0]) },
      depth: { distanceM: expect.closeTo(solidM, 3), normal: [0, 1, 0].map((x) => expect.closeTo(x, 2)) },
      floor: FLOOR_HIT,
    });
    expect([first, error]).toEqual(['plane', 0]);
    if (held || usage === 'cpu-optimized') expect(waited).toBe(0);
    // The frame that was measured, which is not the one that asks.
    else expect(by.depth?.frame).toBeLessThan(index);
  });
});

test('a controller’s ray is followed by the device, with an offset, while the controller is there', async () => {
  const { found, open, gone, left, back, after, error } = await page.call<
    Counted & { found: Told[]; open: number; gone: unknown[]; left: number; back: Told[] }
  >('controllers');
  expect(found).toMatchObject([
    { at: near([0.2, 0, 0.5]), source: 'session' },
    { at: near([0.3, 0, 0.5]), source: 'session' },
  ]);
  expect([open > 0, gone, left < open]).toEqual([true, [null, null], true]);
  expect(back).toMatchObject([{ source: 'session' }, { source: 'session' }]);
  expect([after, error]).toEqual([NOTHING_OPEN, 0]);
});

interface Errors {
  readonly anchored: number[];
  readonly loose: number;
  readonly jumps: number;
}

test('anchors stay at their point of the room while tracking drifts and the visitor re-centers', async () => {
  const { states, steady, drifted, recentered, counted, events, after } = await page.call<
    Counted & { states: string[]; steady: Errors; drifted: Errors; recentered: Errors; counted: number; events: string[] }
  >('anchors');
  expect(states).toEqual(['pending,pending', 'tracked,tracked', 'lost,lost', 'tracked,tracked', 'deleted,deleted']);
  for (const { anchored } of [steady, drifted, recentered]) for (const errorM of anchored) expect(errorM).toBeLessThan(0.001);
  expect(steady.loose).toBeLessThan(0.001);
  expect(drifted.loose).toBeGreaterThan(0.1);
  expect(recentered.loose).toBeGreaterThan(0.1);
  expect([steady.jumps, drifted.jumps, recentered.jumps, counted]).toEqual([0, 0, 1, 0]);
  expect(events).toContain('recentered');
  expect(after).toEqual(NOTHING_OPEN);
});

test('an anchor that the session does not grant holds its pose, and none outlives the session', async () => {
  const { refused, ended } = await page.call<{
    refused: Counted & { found: Told; state: string; wrong: string; deleted: string; left: number };
    ended: Counted & { state: string; afterwards: string; at: number[] };
  }>('refusals');
  expect(refused).toMatchObject({
    found: { source: 'floor', anchorable: false },
    state: 'unsupported',
    wrong: 'RangeError',
    deleted: 'deleted',
    left: 0,
  });
  expect(ended).toMatchObject({ state: 'tracked', afterwards: 'deleted', at: near([0, 0, -1]), before: NOTHING_OPEN });
});
