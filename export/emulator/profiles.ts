export type DeviceName = 'phone' | 'headset' | 'glasses';

export type DepthUsage = 'cpu-optimized' | 'gpu-optimized';
export type DepthFormat = 'luminance-alpha' | 'unsigned-short' | 'float32';

/** What a kind of device supports, as visible to pages. Sources: export/emulator/README.md. */
export interface DeviceProfile {
  readonly views: 1 | 2;
  readonly blend: 'alpha-blend' | 'additive';
  readonly interaction: 'screen-space' | 'world-space';
  readonly fovYRad: number;
  readonly controllers: boolean;
  /** Hertz; sessions start with the first. */
  readonly frameRates: readonly number[];
  readonly features: readonly string[];
  /** How many anchors it keeps after a session. */
  readonly persistentAnchors: number;
  readonly depth: DepthProfile;
}

export interface DepthProfile {
  /** In the device's order of preference. */
  readonly usages: readonly DepthUsage[];
  readonly formats: readonly DepthFormat[];
  readonly sizePx: readonly [width: number, height: number];
}

export const DEVICE_PROFILES: Readonly<Record<DeviceName, DeviceProfile>> = {
  // Chrome on Android, portrait or landscape.
  phone: {
    views: 1,
    blend: 'alpha-blend',
    interaction: 'screen-space',
    fovYRad: 1.05,
    controllers: false,
    frameRates: [60],
    features: [
      'viewer',
      'local',
      'local-floor',
      'unbounded',
      'hit-test',
      'anchors',
      'plane-detection',
      'light-estimation',
      'depth-sensing',
      'camera-access',
      'dom-overlay',
    ],
    persistentAnchors: 0,
    depth: { usages: ['cpu-optimized', 'gpu-optimized'], formats: ['luminance-alpha'], sizePx: [160, 120] },
  },
  // A standalone passthrough headset.
  headset: {
    views: 2,
    blend: 'alpha-blend',
    interaction: 'world-space',
    fovYRad: 1.4,
    controllers: true,
    frameRates: [90, 72, 80, 120],
    features: [
      'viewer',
      'local',
      'local-floor',
      'bounded-floor',
      'unbounded',
      'hit-test',
      'anchors',
      'plane-detection',
      'mesh-detection',
      'hand-tracking',
      'layers',
      'depth-sensing',
    ],
    // As Quest Browser 31.2.
    persistentAnchors: 8,
    depth: {
      usages: ['gpu-optimized', 'cpu-optimized'],
      formats: ['unsigned-short', 'float32', 'luminance-alpha'],
      sizePx: [160, 160],
    },
  },
  // An additive display: it adds light and cannot darken.
  glasses: {
    views: 2,
    blend: 'additive',
    interaction: 'world-space',
    fovYRad: 0.5,
    controllers: false,
    frameRates: [60],
    features: ['viewer', 'local', 'local-floor', 'unbounded', 'hit-test', 'anchors', 'hand-tracking'],
    persistentAnchors: 0,
    depth: { usages: [], formats: [], sizePx: [1, 1] },
  },
};
