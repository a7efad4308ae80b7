import { describe, expect, test } from '@jest/globals';
import type { Capability } from '../../../nodes/kit/definition.ts';
import type { ProgramNeed, Tier } from '../needs.ts';
import { DEVICE_FACTS } from './device-facts.ts';
import { deviceTable, deviceWarnings, refusedFeatures } from './device-table.ts';

const need = (capability: Capability, more: Partial<ProgramNeed> = {}): ProgramNeed => ({
  capability,
  required: false,
  nodes: [`${capability}-a`],
  why: 'to test',
  without: `No ${capability}.`,
  ...more,
});
const tiers = (...ids: Tier['id'][]): Tier[] => ids.map((id) => ({ id, without: [] }));
const ALL = tiers('ar-camera', 'ar', 'camera', 'authored-vr', 'orbit');

const row = (kind: string, needs: ProgramNeed[], of = ALL) =>
  deviceTable({ needs, tiers: of, operations: [] }).find((each) => each.kind === kind);
const effects = (kind: string, needs: ProgramNeed[]) => row(kind, needs)?.lost.map(({ effect }) => effect);

describe('the table of devices', () => {
  test('has a row for every kind of device, whose page needs nothing', () => {
    const rows = deviceTable({ needs: [], tiers: ALL, operations: [] });
    expect(rows.map(({ kind, tier }) => [kind, tier])).toEqual([
      ['android-phone', 'ar-camera'],
      ['quest', 'ar'],
      ['android-xr', 'ar'],
      ['vision-pro', 'authored-vr'],
      ['see-through', 'ar'],
      ['iphone', 'camera'],
      ['laptop', 'camera'],
    ]);
    expect(rows.flatMap(({ lost }) => lost)).toEqual([]);
  });

  test('says what visitors see instead where a feature is missing', () => {
    const needs = [need('light-estimation'), need('meshes'), need('hands')];
    expect(effects('quest', needs)).toEqual(['No light-estimation.']);
    expect(effects('android-phone', needs)).toEqual(['No meshes.', 'No hands.']);
    expect(effects('vision-pro', needs)).toEqual(['No light-estimation.', 'No meshes.']);
    expect(effects('iphone', needs)).toEqual(['No light-estimation.', 'No meshes.', 'No hands.']);
  });

  test('says it of each node in its own words', () => {
    const shared = need('hit-test', { nodes: ['place-a', 'reticle-a'], withoutByNode: { 'reticle-a': 'No reticle.' } });
    expect(row('laptop', [shared])?.lost).toMatchObject([
      { node: 'place-a', effect: 'No hit-test.' },
      { node: 'reticle-a', effect: 'No reticle.' },
    ]);
  });

  test('marks what no source tells', () => {
    expect(row('see-through', [need('anchors')])?.lost).toMatchObject([{ fact: { has: 'unknown' } }]);
    expect(row('see-through', [need('anchors', { required: true })])?.worthless).toBe(false);
  });

  test('a required feature that is missing makes the page worthless', () => {
    expect(row('laptop', [need('depth', { required: true })], tiers('ar', 'orbit'))).toMatchObject({ tier: 'orbit', worthless: true });
    expect(row('quest', [need('depth', { required: true })], tiers('ar', 'orbit'))).toMatchObject({ tier: 'ar', worthless: false });
  });

  test('a node that makes pages worthless warns once, with all those devices', () => {
    const shown = tiers('ar', 'orbit');
    const warningsOf = (needs: ProgramNeed[]) => deviceWarnings(deviceTable({ needs, tiers: shown, operations: [] }));
    expect(warningsOf([need('depth'), need('hit-test')])).toEqual([]);
    const [warning, ...others] = warningsOf([need('depth', { required: true }), need('meshes')]);
    expect(warning).toMatchObject({ code: 'SCR076', severity: 'warning', nodeId: 'depth-a' });
    expect(warning?.message).toMatch(/depth-a requires: .*iPhone.*; Laptop/);
    expect(warning?.message).not.toMatch(/Quest/);
    expect(others).toEqual([]);
  });

  test('the room of VR takes the place of the camera image', () => {
    expect(effects('vision-pro', [need('camera-image', { required: true })])).toEqual([]);
  });
});

test('an emulated device refuses what the real one lacks', () => {
  expect(refusedFeatures('quest')).toEqual(['camera-access', 'light-estimation', 'dom-overlay']);
  expect(refusedFeatures('android-phone')).toEqual(['mesh-detection', 'hand-tracking']);
});

test('every fact has a source and a date', () => {
  for (const { sessionFact, features } of DEVICE_FACTS) {
    for (const { source, date } of [sessionFact, ...Object.values(features)]) {
      expect(source).not.toBe('');
      expect(date).toMatch(/^\d{4}-\d{2}(-\d{2})?$/);
    }
  }
});

test('shadows that only darken are unseen on additive displays, and nowhere else', () => {
  const operations = ['layer/shadow', 'layer/negative-shadow'].map((type, i) => ({ kind: 'draw', type, node: `shadow-${i}` })) as never;
  const unseen = deviceTable({ needs: [], tiers: ALL, operations }).map(({ display, unseen }) => [display, unseen]);
  expect(unseen.filter(([, nodes]) => nodes?.length !== 0)).toEqual([['additive', ['shadow-0']]]);
});
