import { afterEach, describe, expect, test } from '@jest/globals';
import type { SensorOptions } from '../../../export/emulator/sensors/emulated-sensors.ts';
import { type FakeSensors, fakeSensors } from '../../../tests/support/fake-sensors.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { createShakeDetector } from './shake.ts';

const RAD = Math.PI / 180;
const UPRIGHT = [0, 1, 0] as const;
let page: FakeSensors | null = null;

afterEach(() => {
  page?.restore();
  page = null;
});

function start(options: SensorOptions = {}, params: object = { smoothingS: 0 }, lacks: readonly string[] = []) {
  const fake = fakeSensors(options, lacks);
  page = fake;
  const context = fakeContext(definition, { params });
  const node = create(context.ctx);
  const { outputs } = context.ctx;
  const step = (deltaS = 1 / 60) => {
    context.tick(deltaS);
    node.update({} as never);
    const list = (values: ArrayLike<number>) => Array.from(values, (x) => Math.round(x * 1e4) / 1e4 + 0);
    return {
      acceleration: list(outputs.acceleration.value),
      rotationRate: list(outputs.rotationRate.value),
      tilt: list(outputs.tilt.value),
      up: list(outputs.up.value),
      available: outputs.available.value,
      shaken: pulseNumbers(outputs.shaken),
    };
  };
  return { ...context, ...fake, node, step };
}

const NEUTRAL = { acceleration: [0, 0, 0], rotationRate: [0, 0, 0], tilt: [0, 0], up: [0, 1, 0], available: false, shaken: [] };

describe('input/device-motion', () => {
  test.each([
    ['Android', {}],
    ['iPhone, whose accelerations have the opposite sign', { safari: true }],
  ])('tells how the device is moved: %s', async (_name, options) => {
    const { sensors, step, touch } = start(options);
    await touch();
    sensors.orient(0, 90, 0);
    sensors.move([1, 2, 3], [0.1, 0.2, 0.3], UPRIGHT);
    expect(step()).toEqual({
      ...NEUTRAL,
      acceleration: [1, 2, 3],
      rotationRate: [0.1, 0.2, 0.3],
      available: true,
    });
  });

  test.each([
    // W3C Device Orientation, §4.1: beta about x, gamma about y.
    ['upright', [90, 0], 0, [0, 0]],
    ['on a table', [0, 0], 0, [0, Math.PI / 2]],
    ['leaning back by 30°', [60, 0], 0, [0, 30 * RAD]],
    ['leaning forward by 20°', [110, 0], 0, [0, -20 * RAD]],
    // Flat, then its right edge lowered.
    ['the right edge lowered by 25°', [0, 25], 0, [25 * RAD, Math.PI / 2]],
    // The top to the left: the left edge of the device is the lower edge of the page.
    ['held across', [0, -90], 90, [0, 0]],
  ])('tells the tilt of the page: %s', async (_name, [betaDeg = 0, gammaDeg = 0], pageDeg, tilt) => {
    const { sensors, step, touch, turnPage } = start();
    await touch();
    turnPage(pageDeg);
    sensors.orient(0, betaDeg, gammaDeg);
    expect(step().tilt).toEqual(tilt.map((x) => expect.closeTo(x, 3)));
  });

  test('tilt comes from gravity where the device tells no orientation', async () => {
    const { sensors, step, touch } = start();
    await touch();
    sensors.move([0, 0, 0], [0, 0, 0], [0, Math.SQRT1_2, Math.SQRT1_2]);
    expect(step().tilt).toEqual([0, expect.closeTo(Math.PI / 4, 3)]);
  });

  test('smooths exponentially at any frame rate', async () => {
    const at = async (deltaS: number) => {
      const { sensors, step, touch } = start({}, { smoothingS: 0.2 });
      await touch();
      sensors.orient(0, 90, 0);
      sensors.move([0, 0, 0], [0, 0, 0], UPRIGHT);
      step(deltaS);
      sensors.move([8, 0, 0], [0, 0, 0], UPRIGHT);
      let last = 0;
      for (let i = 0; i < Math.round(0.2 / deltaS); i++) last = step(deltaS).acceleration[0] ?? 0;
      page?.restore();
      return last;
    };
    // 1 − 1/e after the time constant.
    expect(await at(0.01)).toBeCloseTo(8 * (1 - 1 / Math.E), 3);
    expect(await at(0.05)).toBeCloseTo(8 * (1 - 1 / Math.E), 3);
  });

  test('a shake gives one pulse with its strength', async () => {
    const { sensors, step, touch } = start();
    await touch();
    const shaken: number[] = [];
    for (const x of [15, -18, 14, -15, 15]) {
      sensors.move([x, 0, 0], [0, 0, 0], UPRIGHT);
      shaken.push(...step().shaken);
    }
    expect(shaken).toEqual([18]);
  });

  test('asks iPhones’ visitors at a touch, others not at all', async () => {
    const iphone = start({ safari: true });
    iphone.sensors.orient(0, 60, 0);
    expect(iphone.step().available).toBe(false);
    await iphone.touch();
    iphone.sensors.orient(0, 60, 0);
    expect(iphone.step().available).toBe(true);
    iphone.restore();
    const android = start();
    android.sensors.orient(0, 60, 0);
    expect(android.step().available).toBe(true);
    android.node.dispose();
    expect(android.listening()).toBe(0);
  });

  test.each([
    ['refused', { safari: true }, [], 'The motion sensor was not allowed.'],
    ['no sensor', {}, [], 'This device has no motion sensor.'],
    ['no interface', {}, ['DeviceMotionEvent', 'DeviceOrientationEvent'], 'This browser gives pages no motion sensor.'],
  ])('without a sensor it says so once and is still: %s', async (_name, options, lacks, message) => {
    const { sensors, step, touch, reports } = start(options, {}, lacks);
    sensors.setSensors('denied');
    await touch();
    for (let i = 0; i < 30; i++) expect(step(0.1)).toEqual(NEUTRAL);
    expect(reports.map((report) => [report.code, report.message])).toEqual([['SCR055', expect.stringContaining(message)]]);
  });
});

describe('a shake', () => {
  const feel = (readings: readonly (readonly [timeS: number, x: number])[]) => {
    const detector = createShakeDetector(12);
    return readings.map(([timeS, x]) => {
      detector.feel([x, 0, 0], timeS);
      return detector.take();
    });
  };

  test('goes one way and back: pushes to one side, slow or weak ones are none', () => {
    expect(
      feel([
        [0, 20],
        [0.1, 20],
        [0.2, 20],
        [0.3, 20],
      ]),
    ).toEqual([0, 0, 0, 0]);
    expect(
      feel([
        [0, 20],
        [0.7, -20],
        [1.4, 20],
      ]),
    ).toEqual([0, 0, 0]);
    expect(
      feel([
        [0, 11],
        [0.1, -11],
        [0.2, 11],
      ]),
    ).toEqual([0, 0, 0]);
    expect(
      feel([
        [0, Number.NaN],
        [0.1, 20],
        [0.2, -30],
        [0.3, 20],
      ]),
    ).toEqual([0, 0, 0, 30]);
  });

  test('that goes on is told again after a rest', () => {
    const readings = Array.from({ length: 24 }, (_, i) => [i / 20, i % 2 ? 20 : -20] as const);
    expect(feel(readings).filter((strength) => strength > 0)).toHaveLength(2);
  });
});
