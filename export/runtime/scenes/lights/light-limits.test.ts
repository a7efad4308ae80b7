import { expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../../nodes/kit/diagnostics.ts';
import type { DirectionalLightItem } from '../../../../nodes/kit/scene-lists.ts';
import { createLightLimits, createTextureLimits, MAX_SHADOWS } from './light-limits.ts';
import { mapSizeOf } from './light-map.ts';

const DEVICE = { maxSizePx: 4096, floats: true };

function sun(shadow: Partial<NonNullable<DirectionalLightItem['shadow']>> | null): DirectionalLightItem {
  return {
    key: 'sun',
    kind: 'directional',
    radiance: new Float32Array(3),
    towardsLightWorld: Float32Array.of(0, 1, 0),
    shadow: shadow && { areaM: 5, mapSizePx: 2048, bias: 0, normalBiasM: 0, ...shadow },
  };
}

function told(items: readonly DirectionalLightItem[], device = DEVICE): string[] {
  const codes: Omit<Diagnostic, 'nodeId'>[] = [];
  createLightLimits((diagnostic) => codes.push(diagnostic), 'shadows', device)([{ version: 1, items: [...items] }]);
  return codes.map(({ code, message }) => `${code} ${message}`);
}

test('as many lights as can be cast shadows without a word; one more is told', () => {
  const most = Array.from({ length: MAX_SHADOWS }, () => sun({}));
  expect(told([...most, sun(null)])).toEqual([]);
  expect(told([...most, sun({})])).toEqual([expect.stringMatching(/^SCR023 7 lights .* The first 6 cast shadows/)]);
});

test('a map larger than the device makes is told with the size that it has instead', () => {
  expect(told([sun({ mapSizePx: 4096 })])).toEqual([]);
  expect(told([sun({ mapSizePx: 8192 })])).toEqual([expect.stringMatching(/^SCR025 .* shadow maps to 4096 pixels/)]);
});

test('a map for variance is at most 4096 pixels a side, or what the device makes, and told once', () => {
  const large = { maxSizePx: 16384, floats: true };
  expect(told([sun({ mapSizePx: 8192, filter: 'pcss' }), sun({ mapSizePx: 4096, filter: 'vsm' })], large)).toEqual([]);
  const vsm = { areaM: 5, mapSizePx: 8192, bias: 0, normalBiasM: 0, filter: 'vsm' } as const;
  expect(told([sun(vsm), sun(vsm)], large)).toEqual([expect.stringMatching(/^SCR025 .*“Variance”.* 4096 pixels/)]);
  expect([large, DEVICE, { maxSizePx: 2048, floats: true }].map((device) => mapSizeOf(vsm, device))).toEqual([4096, 4096, 2048]);
  // Such a device has soft edges instead, whose maps may be as large as any.
  expect(mapSizeOf(vsm, { maxSizePx: 8192, floats: false })).toBe(8192);
  expect(told([sun(vsm)], { maxSizePx: 2048, floats: true })).toEqual([expect.stringMatching(/^SCR025 .* shadow maps to 2048 pixels/)]);
});

test('what shadows lose for want of texture units is told in one message', () => {
  const messages: string[] = [];
  const limits = createTextureLimits(({ code, message }) => messages.push(`${code} ${message}`));
  limits.tell(0, 0);
  expect(messages).toEqual([]);
  limits.tell(2, 1);
  limits.tell(0, 4);
  expect(messages).toEqual([
    expect.stringMatching(/^SCR025 .*: 2 of them use “Soft” shadow edges, and transparent .* of 1 of them\.$/),
    expect.stringMatching(/^SCR025 .*: transparent objects cast no shadow in the light of 4 of them\.$/),
  ]);
});

test('filters that the device lacks are told once for all, and only where they are chosen', () => {
  const device = { ...DEVICE, floats: false };
  expect(told([sun({ filter: 'soft' }), sun({ filter: 'basic' }), sun({})], device)).toEqual([]);
  expect(told([sun({ filter: 'vsm' }), sun({ filter: 'pcss' })], device)).toEqual([expect.stringMatching(/^SCR025 .* use “Soft” instead/)]);
});
