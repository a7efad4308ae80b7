/**
 * The file `session.json` of a recorded session; `docs/SESSION-FORMAT.md` tells it in words. A session folder holds it, color
 * pictures (JPEG or PNG) and, where there is depth, 16-bit PNG of one channel.
 *
 * World space is right-handed, y up against gravity, meters, floor at y = 0 where one was seen. Camera space looks down -z
 * with y up, as WebXR has it. Matrices are column-major, 16 numbers.
 */
export interface SessionFile {
  readonly format: 'scrim-session';
  readonly version: 1;
  readonly title: string;
  readonly credit?: string;
  readonly licence?: string;
  readonly color: {
    readonly widthPx: number;
    readonly heightPx: number;
    readonly intrinsics: Intrinsics;
  };
  readonly depth?: {
    readonly widthPx: number;
    readonly heightPx: number;
    readonly intrinsics: Intrinsics;
    /** Meters per stored unit: 0.001 for millimeters. A stored 0 is unknown. */
    readonly metresPerUnit: number;
    /** `z`: along the camera's axis. `range`: along the ray. */
    readonly kind: 'z' | 'range';
  };
  readonly frameRateHz: number;
  readonly frames: readonly SessionFileFrame[];
  /** For all frames that bring none of their own. */
  readonly light?: SessionFileLight;
  readonly surfaces?: readonly SessionFileSurface[];
}

/** Pixels; (0, 0) is the outer corner of the top left pixel, whose center is (0.5, 0.5); y down, as pictures have it. */
export interface Intrinsics {
  readonly fxPx: number;
  readonly fyPx: number;
  readonly cxPx: number;
  readonly cyPx: number;
}

export interface SessionFileFrame {
  readonly timeS: number;
  /** Relative to the folder. */
  readonly color: string;
  readonly depth?: string;
  readonly worldFromCamera: readonly number[];
  readonly light?: SessionFileLight;
}

/** As `LightEstimate` in `nodes/kit/session.ts`: 27 numbers, coefficient by coefficient, RGB within. */
export interface SessionFileLight {
  readonly sphericalHarmonics: readonly number[];
  readonly primaryDirectionWorld: readonly [number, number, number];
  readonly primaryIntensity: readonly [number, number, number];
}

/** A plane: its y axis is the normal; the polygon lies in its x–z plane. */
export interface SessionFileSurface {
  readonly id: string;
  readonly kind: 'plane';
  readonly orientation: 'horizontal' | 'vertical';
  readonly label?: string;
  readonly worldFromPlane: readonly number[];
  readonly polygonXZ: readonly (readonly [number, number])[];
}
