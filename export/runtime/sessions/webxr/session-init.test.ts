import { describe, expect, test } from '@jest/globals';
import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../../program/needs.ts';
import { grantedCapabilities, sessionInit } from './session-init.ts';

function need(capability: Capability, required = false): ProgramNeed {
  return { capability, required, nodes: [], why: 'to test', without: 'nothing happens' };
}

describe('a session is asked', () => {
  test('for nothing but the floor when nothing is needed', () => {
    expect(sessionInit([], null)).toEqual({ requiredFeatures: [], optionalFeatures: ['local-floor'] });
  });

  test('for what is needed, required and optional apart', () => {
    const init = sessionInit([need('hit-test', true), need('camera-image'), need('depth')], null);
    expect(init.requiredFeatures).toEqual(['hit-test']);
    expect(init.optionalFeatures).toEqual(['local-floor', 'camera-access', 'depth-sensing']);
    expect(init.depthSensing?.usagePreference).toEqual(['cpu-optimized', 'gpu-optimized']);
  });

  test('to show page elements where there are some', () => {
    const root = {} as Element;
    expect(sessionInit([], root)).toMatchObject({ optionalFeatures: ['local-floor', 'dom-overlay'], domOverlay: { root } });
  });
});

test('capabilities are what was enabled, or all where the browser does not say', () => {
  const needs = [need('depth'), need('planes')];
  expect([...grantedCapabilities({ enabledFeatures: ['local', 'plane-detection'] } as XRSession, needs)]).toEqual(['planes']);
  expect([...grantedCapabilities({} as XRSession, needs)]).toEqual(['depth', 'planes']);
});
