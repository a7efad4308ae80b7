import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { callsOfBoth } from '../../tools/bench/room-calls.bench.ts';
import { useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';

const ROOT = resolve(import.meta.dirname, '../..');

const chromium = useBrowser();

describeWithData('antique cameras with light, shadow and occlusion', 'models/AntiqueCamera.glb', (model) => {
  test('need no more draws, switches of programs and state changes than in plain three.js', async () => {
    const one = await callsOfBoth(chromium.browser, ROOT, model, 1);
    const ten = await callsOfBoth(chromium.browser, ROOT, model, 10);
    for (const { ours, three } of [one, ten]) {
      expect(ours.draws).toBeLessThanOrEqual(three.draws);
      expect(ours.programSwitches).toBeLessThanOrEqual(three.programSwitches);
      expect(ours.stateChanges).toBeLessThanOrEqual(three.stateChanges);
    }
    // Each consists of two meshes, which are drawn to the shadow map too.
    expect(ten.three.draws - one.three.draws).toBe(4 * 9);
    expect(ten.ours.stateChanges).toBeLessThanOrEqual(one.ours.stateChanges);
    // Each mesh has textures of its own, so a count of fewer changes has missed some.
    expect(one.ours.stateChanges).toBeGreaterThan(one.ours.draws);
  });
});
