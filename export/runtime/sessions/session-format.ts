/**
 * The file `session.json` of a recorded session, which `docs/SESSION-FORMAT.md` describes. The session folder contains it, color images
 * (JPEG or PNG) and optional depth (16-bit PNG with one channel).
 *
 * World space is right-handed with y up (gravity-aligned), in meters, with the floor at y = 0 if it was detected. Camera space looks along
 * −z with y up, as in WebXR. Matrices are column-major, 16 numbers.
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
    /** How depth is measured. `z`: along the camera's axis. `range`: along the ray of the pixel. */
    readonly kind: 'z' | 'range';
  };
  readonly frameRateHz: number;
  readonly frames: readonly SessionFileFrame[];
  /** Light of all frames without `light`. */
  readonly light?: SessionFileLight;
  readonly surfaces?: readonly SessionFileSurface[];
  /** Path of the voxels of the room at the start, relative to the folder (`nodes/kit/voxel-file.ts`). */
  readonly room?: string;
}

/**
 * Focal lengths and principal point of a camera, in pixels, y down. (0, 0) is the outer corner of the top left pixel, whose center is (0.5,
 * 0.5).
 */
export interface Intrinsics {
  readonly fxPx: number;
  readonly fyPx: number;
  readonly cxPx: number;
  readonly cyPx: number;
}

export interface SessionFileFrame {
  readonly timeS: number;
  /** Path of the color image, relative to the folder. */
  readonly color: string;
  readonly depth?: string;
  readonly worldFromCamera: readonly number[];
  readonly light?: SessionFileLight;
  readonly input?: SessionFileInput;
}

/** What the visitor did in a frame; as `SessionInput` in `nodes/kit/session.ts`. */
export interface SessionFileInput {
  readonly pointers?: readonly SessionFilePointer[];
  readonly left?: SessionFileController;
  readonly right?: SessionFileController;
  readonly leftHand?: SessionFileHand;
  readonly rightHand?: SessionFileHand;
}

export interface SessionFilePointer {
  /** Number of the pointer, from 1, the same in all frames. */
  readonly id: number;
  readonly by: 'screen' | 'mouse' | 'left' | 'right' | 'left-hand' | 'right-hand' | 'gaze';
  readonly phase: 'hover' | 'start' | 'hold' | 'end' | 'cancel';
  readonly worldFromRay: readonly number[];
  readonly worldFromGrip?: readonly number[];
  readonly pinch: number;
  /** Only with the phase `end`: whether the press was a tap. */
  readonly tapped?: boolean;
}

export interface SessionFileController {
  readonly stick: readonly [number, number];
  readonly trigger: number;
  readonly squeeze: number;
  readonly primary?: boolean;
  readonly secondary?: boolean;
  readonly stickPressed?: boolean;
  readonly bare?: boolean;
  readonly worldFromRay?: readonly number[];
  readonly worldFromGrip?: readonly number[];
}

/** 25 joints in the order of `nodes/kit/hand-joints.ts`. */
export interface SessionFileHand {
  readonly worldFromJoints: readonly number[];
  readonly radiiM: readonly number[];
}

/**
 * A light estimate, as `LightEstimate` in `nodes/kit/session.ts`. `sphericalHarmonics` has 27 numbers: RGB of the first coefficient, then
 * of the second, and so on.
 */
export interface SessionFileLight {
  readonly sphericalHarmonics: readonly number[];
  readonly primaryDirectionWorld: readonly [number, number, number];
  readonly primaryIntensity: readonly [number, number, number];
}

/** A plane whose y axis is the normal; the polygon is in its x–z plane. */
export interface SessionFileSurface {
  readonly id: string;
  readonly kind: 'plane';
  readonly orientation: 'horizontal' | 'vertical';
  readonly label?: string;
  readonly worldFromPlane: readonly number[];
  readonly polygonXZ: readonly (readonly [number, number])[];
}
