import type { CameraPlaces } from './camera-places.ts';

/** What an acquisition takes unless it is told otherwise; lengths in meters, sizes in pixels. */
export const ACQUISITION_DEFAULTS = {
  shape: 'outside-in',
  /** Cameras on a sphere. */
  sphere: 24,
  /** Cameras along x, y and z of a grid. */
  grid: [3, 3, 1],
  extentM: 2,
  centerM: [0, 1, 0],
  fovDeg: 60,
  size: { widthPx: 1024, heightPx: 768 },
  /** Size of 360° photographs. */
  aroundSize: { widthPx: 2048, heightPx: 1024 },
} as const satisfies { readonly shape: CameraPlaces['shape'] } & Record<string, unknown>;

/** The vertical fields of view that photographs may have. */
export const FOV_DEG = { least: 1, most: 150 } as const;
