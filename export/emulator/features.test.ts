import { describe, expect, test } from '@jest/globals';
import { chooseDepth, grantFeatures } from './features.ts';
import { DEVICE_PROFILES } from './profiles.ts';

const { depth: PHONE, features } = DEVICE_PROFILES.phone;
const PHONE_FEATURES = new Set(features);
const HEADSET = DEVICE_PROFILES.headset.depth;

describe('the configuration of depth sensing', () => {
  test('of several wishes the first that the device has', () => {
    expect(
      chooseDepth({ usagePreference: ['gpu-optimized', 'cpu-optimized'], dataFormatPreference: ['float32', 'luminance-alpha'] }, PHONE),
    ).toEqual({
      usage: 'gpu-optimized',
      format: 'luminance-alpha',
      matchView: true,
    });
  });

  test('without wishes the device’s own', () => {
    expect(chooseDepth({ usagePreference: [], dataFormatPreference: [] }, HEADSET)).toEqual({
      usage: 'gpu-optimized',
      format: 'unsigned-short',
      matchView: true,
    });
  });

  test('none when nothing fits', () => {
    expect(chooseDepth({ usagePreference: ['cpu-optimized'], dataFormatPreference: ['float32'] }, PHONE)).toBeNull();
  });
});

describe('features', () => {
  test('optional ones that the device lacks are left out', () => {
    const wishes = { requiredFeatures: ['local-floor'], optionalFeatures: ['mesh-detection', 'hit-test'] };
    expect(grantFeatures(wishes, PHONE_FEATURES, PHONE)).toEqual({ features: ['viewer', 'local', 'local-floor', 'hit-test'], depth: null });
  });

  test('a required one that it lacks is named', () => {
    expect(grantFeatures({ requiredFeatures: ['hit-test', 'mesh-detection'] }, PHONE_FEATURES, PHONE)).toEqual({
      missing: 'mesh-detection',
    });
  });

  test('depth needs its wishes', () => {
    expect(grantFeatures({ optionalFeatures: ['depth-sensing'] }, PHONE_FEATURES, PHONE)).toEqual({
      features: ['viewer', 'local'],
      depth: null,
    });
    expect(grantFeatures({ requiredFeatures: ['depth-sensing'] }, PHONE_FEATURES, PHONE)).toEqual({ missing: 'depth-sensing' });
  });
});
