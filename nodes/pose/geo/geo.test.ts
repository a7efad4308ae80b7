import { afterEach, describe, expect, test } from '@jest/globals';
import type { SensorOptions } from '../../../export/emulator/sensors/emulated-sensors.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { type FakeSensors, fakeSensors } from '../../../tests/support/fake-sensors.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { setDeviceAngles } from '../../kit/device-orientation.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { setGeoPlace } from '../../kit/wgs84.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const RAD = Math.PI / 180;
const HERE = { latitudeDeg: 48.137, longitudeDeg: 11.575, altitudeM: 560 };
let page: FakeSensors | null = null;

afterEach(() => {
  page?.restore();
  page = null;
});

interface Scene {
  readonly params?: object;
  readonly options?: SensorOptions;
  readonly lacks?: readonly string[];
  /** Azimuth of the -z axis of world space. */
  readonly northRad?: number;
}

/** A place 40 m east and 30 m north of where the visitor begins. */
function start({ params = {}, options = {}, lacks = [], northRad = 0 }: Scene = {}) {
  const fake = fakeSensors(options, lacks);
  page = fake;
  const target = { latitudeDeg: 0, longitudeDeg: 0, altitudeM: 0 };
  setGeoPlace(target, { ...HERE, altitudeM: 0 }, { eastM: 40, northM: 30, upM: 0 });
  const { latitudeDeg, longitudeDeg } = target;
  const session = { sessions: 1 };
  const context = fakeContext(definition, {
    params: { latitudeDeg, longitudeDeg, smoothingS: 0, ...params },
    services: { session: session as never },
  });
  const node = create(context.ctx);
  const frame = createSessionFrame();
  frame.viewCount = 1;
  Object.assign(frame, { xr: {} });
  const view = frame.views[0]?.worldFromView ?? new Float32Array(16);
  const earthFromView = new Float32Array(16);
  const angles = { alphaRad: 0, betaRad: 0, gammaRad: 0, screenRad: 0 };
  const deg = (rad: number) => (((rad / RAD) % 360) + 360) % 360;
  /** The visitor stands at a point of world space and looks somewhere; the phone's sensors tell of it. */
  const look = (at: readonly number[], yawRad = 0, pitchRad = 0, compassErrorRad = 0) => {
    setFromAngles(view, at, [pitchRad, yawRad, 0]);
    setFromAngles(earthFromView, [0, 0, 0], [pitchRad, yawRad - northRad - compassErrorRad, 0]);
    setDeviceAngles(angles, earthFromView);
    fake.sensors.orient(deg(angles.alphaRad), angles.betaRad / RAD, angles.gammaRad / RAD);
  };
  const { outputs } = context.ctx;
  const step = (deltaS = 0.1) => {
    context.tick(deltaS);
    node.update(frame);
    const { pose } = outputs;
    return pose.valid ? [...pose.worldFromPose.slice(12, 15)] : null;
  };
  const frontRad = () => Math.atan2(outputs.pose.worldFromPose[8] ?? 0, outputs.pose.worldFromPose[10] ?? 0);
  return { ...context, ...fake, node, frame, session, outputs, look, step, frontRad };
}

const near = (values: readonly number[], digits = 2) => values.map((value) => expect.closeTo(value, digits));

describe('pose/geo', () => {
  test.each([
    ['Android', {}, 0, 0],
    ['Android, looking up', {}, 0.4, 0.5],
    ['iPhone', { safari: true }, 0, 0],
    ['iPhone, leaning back', { safari: true }, 2, -0.6],
  ])('puts a place where it is, whatever direction the session began in: %s', async (_name, options, yawRad, pitchRad) => {
    // -z of world space points to the east.
    const { look, step, touch, sensors, outputs, frontRad } = start({ options, northRad: Math.PI / 2, params: { directionRad: Math.PI } });
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0], yawRad, pitchRad);
    // East is ahead, north is to the left.
    expect(step()).toEqual(near([-30, 0, -40]));
    expect(outputs.distanceM.value).toBeCloseTo(50, 3);
    expect(outputs.state.value).toBe('found');
    // Its front looks south, to the right.
    expect(frontRad()).toBeCloseTo(Math.PI / 2, 3);
    expect(outputs.headingRad.value).toBeCloseTo((Math.PI / 2 - yawRad + 2 * Math.PI) % (2 * Math.PI), 3);
    expect([outputs.latitudeDeg.value, outputs.longitudeDeg.value]).toEqual(near([HERE.latitudeDeg, HERE.longitudeDeg], 6));
  });

  test('stays in world space while the visitor walks and the compass is off for a moment', async () => {
    const { look, step, touch, sensors, outputs } = start({ params: { smoothingS: 2 } });
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    const first = step() ?? [];
    for (let i = 1; i <= 30; i++) {
      look([0, 1.6, -i / 10], 0, 0, 0.6);
      step();
    }
    const last = step() ?? [];
    // Three seconds of a compass that is wrong by 34°, 50 m away: it would be 29 m off, if it were believed.
    expect(Math.hypot((last[0] ?? 0) - (first[0] ?? 0), (last[2] ?? 0) - (first[2] ?? 0))).toBeLessThan(3);
    expect(outputs.distanceM.value).toBeCloseTo(Math.hypot(40, 27), -1);
  });

  test('states its error: of the position, and of the compass over the distance', async () => {
    const { look, step, touch, sensors, outputs } = start();
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    step();
    // 10° of a compass at 50 m, and 95 % of positions within 5 m.
    expect(outputs.errorM.value).toBeCloseTo(2.448 * Math.hypot(5 / 2.448, 50 * 10 * RAD), 1);
    expect(outputs.headingErrorRad.value).toBeCloseTo(1.96 * 10 * RAD, 3);
  });

  test('asks at the first touch alone, and watches once', async () => {
    const { step, look, touch, sensors, outputs, node, listening } = start();
    look([0, 1.6, 0]);
    expect([step(), sensors.watches, outputs.state.value, outputs.errorM.value]).toEqual([null, 0, 'asking', -1]);
    await touch();
    await touch();
    expect([step(), sensors.watches, outputs.state.value]).toEqual([null, 1, 'searching']);
    node.dispose();
    expect([sensors.watches, listening()]).toEqual([0, 0]);
  });

  test.each([
    ['denied', 'denied', 'The location was not allowed. Things at places on Earth are not shown.'],
    ['unavailable', 'unavailable', 'This device does not know its location. Things at places on Earth are not shown.'],
    ['timeout', 'searching', 'The location is not known yet. The search continues.'],
  ] as const)('says so once where the location is refused, and is invalid: %s', async (state, told, message) => {
    const { look, step, touch, sensors, outputs, reports } = start();
    sensors.setLocation(state);
    await touch();
    look([0, 1.6, 0]);
    expect([step(), step(), outputs.state.value]).toEqual([null, null, told]);
    expect(reports.map((report) => [report.code, report.message])).toEqual([['SCR055', message]]);
    // After a timeout the search goes on.
    sensors.setLocation('granted');
    sensors.setPlace(HERE, 5);
    expect(step()).not.toBe(null);
  });

  test('a location that is taken away later hides the place', async () => {
    const { look, step, touch, sensors, outputs } = start();
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    expect(step()).not.toBe(null);
    sensors.setLocation('denied');
    expect([step(), outputs.state.value]).toEqual([null, 'denied']);
  });

  test('is invalid while it is too inaccurate, and says after a while what to do', async () => {
    const { look, step, touch, sensors, outputs, reports } = start();
    await touch();
    sensors.setPlace(HERE, 120);
    look([0, 1.6, 0]);
    expect([step(), outputs.state.value, outputs.errorM.value > 50]).toEqual([null, 'inaccurate', true]);
    for (let i = 0; i < 40; i++) step(0.5);
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR055', fix: expect.stringContaining('outdoors') })]);
    sensors.setPlace(HERE, 4);
    expect([step(), outputs.state.value]).toEqual([expect.anything(), 'found']);
  });

  test.each([
    ['no compass', {}, [], 'This device has no compass.'],
    ['no sensors in the browser', {}, ['DeviceMotionEvent', 'DeviceOrientationEvent'], 'This device has no compass.'],
    ['a visitor who does not allow it', { safari: true }, [], 'The compass was not allowed.'],
  ])('without north it says so and is invalid: %s', async (_name, options, lacks, message) => {
    const { step, frame, touch, sensors, outputs, reports } = start({ options, lacks });
    sensors.setSensors('denied');
    await touch();
    sensors.setPlace(HERE, 5);
    const view = frame.views[0]?.worldFromView;
    if (view) setFromAngles(view, [0, 1.6, 0], [0, 0, 0]);
    for (let i = 0; i < 15; i++) step(0.5);
    expect([step(), outputs.state.value]).toEqual([null, 'searching']);
    expect(reports.map((report) => report.message)).toEqual([expect.stringContaining(message)]);
  });

  test('re-centering moves world space, not the place', async () => {
    const { frame, look, step, touch, sensors } = start();
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    expect(step()).toEqual(near([40, 0, -30]));
    // The same view, 90° to the right of -z in the new world space, 2 m from its origin.
    frame.jumps = 1;
    const view = frame.views[0]?.worldFromView;
    if (view) setFromAngles(view, [2, 1.6, 0], [0, -Math.PI / 2, 0]);
    expect(step()).toEqual(near([32, 0, 40]));
  });

  test('another session begins anew with the last position', async () => {
    const { session, look, step, touch, sensors, outputs } = start();
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    step();
    session.sessions++;
    look([0, 1.6, 0]);
    expect([step(), outputs.state.value]).toEqual([near([40, 0, -30]), 'found']);
  });

  test('a height above the ellipsoid is relative to the altitude that the device states', async () => {
    const { look, step, touch, sensors } = start({ params: { height: 'ellipsoid', heightM: 600 } });
    await touch();
    // The phone is 1.6 m above the floor; 50 m away, the earth has curved by 0.2 mm.
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    expect(step()).toEqual(near([40, 600 - (560 - 1.6), -30]));
  });

  test('the declination turns the place to true north', async () => {
    const { look, step, touch, sensors } = start({ params: { declinationRad: 10 * RAD } });
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.6, 0]);
    // -z is magnetic north, which is 10° east of true north: the place at 53.13° is 43.13° to the right.
    expect(step()).toEqual(near([50 * Math.sin(43.13 * RAD), 0, -50 * Math.cos(43.13 * RAD)], 1));
  });

  test('without tracking it follows the visitor’s location', async () => {
    const { frame, look, step, touch, sensors } = start();
    Object.assign(frame, { xr: null });
    await touch();
    sensors.setPlace(HERE, 5);
    look([0, 1.5, 2]);
    expect(step()).toEqual(near([40, 0, -28]));
    const place = { ...HERE };
    setGeoPlace(place, HERE, { eastM: 30, northM: 0, upM: 0 });
    for (let i = 0; i < 30; i++) {
      look([0, 1.5, 2]);
      step(1);
      sensors.setPlace(place, 5);
    }
    // 30 m further east, by far most of it is seen after half a minute.
    expect(step()?.[0]).toBeCloseTo(10, -1);
  });
});
