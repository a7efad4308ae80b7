import { expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../../nodes/kit/diagnostics.ts';
import type { DirectionalLightItem } from '../../../../nodes/kit/runtime.ts';
import { createLightLimits, MAX_SHADOWS } from './light-limits.ts';

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
  expect(told([...most, sun({})])).toEqual([expect.stringMatching(/^SCR023 7 lights .* the first 6 do/)]);
});

test('a map larger than the device makes is told with the size that it has instead', () => {
  expect(told([sun({ mapSizePx: 4096 })])).toEqual([]);
  expect(told([sun({ mapSizePx: 8192 })])).toEqual([expect.stringMatching(/^SCR025 .* larger than 4096 pixels/)]);
});

test('filters that the device lacks are told once for all, and only where they are chosen', () => {
  const device = { ...DEVICE, floats: false };
  expect(told([sun({ filter: 'soft' }), sun({ filter: 'basic' }), sun({})], device)).toEqual([]);
  expect(told([sun({ filter: 'vsm' }), sun({ filter: 'pcss' })], device)).toEqual([expect.stringMatching(/^SCR025 .* as of “Soft”/)]);
});
