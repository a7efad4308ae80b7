import { afterEach, describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../../export/runtime/sessions/session-frame.ts';
import { definition as motionDefinition } from '../../nodes/input/device-motion/definition.ts';
import { create as createMotion } from '../../nodes/input/device-motion/runtime.ts';
import { setFromAngles } from '../../nodes/kit/rigid.ts';
import { definition as geoDefinition } from '../../nodes/pose/geo/definition.ts';
import { create as createGeo } from '../../nodes/pose/geo/runtime.ts';
import { type FakeSensors, fakeSensors } from '../../tests/support/fake-sensors.ts';
import { fakeContext, pulseNumbers } from '../../tests/support/node-context.ts';
import { createSimulatedSensors } from './simulated-sensors.ts';

let page: FakeSensors | null = null;

afterEach(() => {
  page?.restore();
  page = null;
});

const programOf = (...capabilities: string[]) => ({ needs: capabilities.map((capability) => ({ capability })) }) as never;

/** A preview in which both nodes play, in AR. */
async function start() {
  const fake = fakeSensors();
  page = fake;
  const hint = { textContent: '', hidden: true };
  const sensors = createSimulatedSensors(window, hint as HTMLElement);
  sensors.follow(programOf('motion', 'location'));
  const motion = fakeContext(motionDefinition, { params: { smoothingS: 0 } });
  const geo = fakeContext(geoDefinition, { params: { smoothingS: 0 }, services: { session: { sessions: 1 } as never } });
  const nodes = [createMotion(motion.ctx), createGeo(geo.ctx)];
  await fake.touch();
  const frame = createSessionFrame();
  Object.assign(frame, { xr: {}, viewCount: 1, deltaS: 0.5 });
  const step = (at: readonly number[], yawRad = 0, pitchRad = 0) => {
    frame.timeS += 0.5;
    const view = frame.views[0];
    if (view) setFromAngles(view.worldFromView, at, [pitchRad, yawRad, 0]);
    sensors.beforeFrame(frame);
    for (const context of [motion, geo]) context.tick(0.5);
    for (const node of nodes) node.update(frame);
    const { pose } = geo.ctx.outputs;
    return pose.valid ? Array.from(pose.worldFromPose.slice(12, 15), (x) => Math.round(x * 10) / 10 + 0) : null;
  };
  const press = (code: string) => {
    const event = Object.assign(new Event('keydown', { cancelable: true }), { code });
    window.dispatchEvent(event);
    return event.defaultPrevented;
  };
  return { sensors, hint, step, press, geo: geo.ctx.outputs, motion: motion.ctx.outputs };
}

describe('the sensors of the preview', () => {
  test('put the default place 20 m ahead, and it stays while the viewer walks and looks around', async () => {
    const { step, geo } = await start();
    expect(step([0, 1.6, 0])).toEqual([0, 0, -20]);
    for (let i = 1; i <= 20; i++) step([0, 1.6, -i / 4], 0.1 * i);
    expect(step([0, 1.6, -5], 2)).toEqual([0, 0, -20]);
    expect(geo.distanceM.value).toBeCloseTo(15, 1);
    expect((geo.headingRad.value * 180) / Math.PI).toBeCloseTo(360 - 2 * (180 / Math.PI), 0);
  });

  test('tilt the phone as the view is', async () => {
    const { step, motion } = await start();
    step([0, 1.6, 0], 0.3, -0.5);
    // Who looks down by 0.5 leans the phone back by as much: its screen turns up.
    expect([...motion.tilt.value]).toEqual([expect.closeTo(0, 5), expect.closeTo(0.5, 5)]);
  });

  test('follow the keys: shake, inaccurate, denied', async () => {
    const { step, press, geo, motion } = await start();
    step([0, 1.6, 0]);
    expect([press('KeyX'), press('KeyZ')]).toEqual([true, false]);
    const shaken: number[] = [];
    for (let i = 0; i < 4; i++) {
      step([0, 1.6, 0]);
      shaken.push(...pulseNumbers(motion.shaken));
    }
    expect(shaken).toEqual([20]);
    press('KeyB');
    press('KeyB');
    expect([step([0, 1.6, 0]), geo.state.value]).toEqual([null, 'denied']);
    press('KeyB');
    expect([step([0, 1.6, 0]), geo.state.value]).toEqual([[0, 0, -20], 'found']);
  });

  test('are there only for programs that need them, with a hint', async () => {
    const { sensors, hint, press } = await start();
    expect([hint.hidden, hint.textContent]).toEqual([false, expect.stringContaining('shake')]);
    sensors.follow(programOf('depth'));
    expect([hint.hidden, press('KeyX')]).toEqual([true, false]);
  });
});
