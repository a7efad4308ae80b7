import type { RoomDepth, ViewFrame } from '../../kit/session.ts';
import { type ConfidenceMeter, createConfidenceMeter } from './confidence.ts';
import type { DepthDrawing, DepthImage } from './drawing.ts';
import { createHoleFiller, type HoleFiller } from './fill-holes.ts';
import { createEdgeFollower, type EdgeFollower } from './follow-edges.ts';
import { createSteadier, type Steadier } from './steady.ts';

export type DepthFilter = 'by-sensor' | 'nearest' | 'linear' | 'edge-aware';

/**
 * A sensor with at most this many samples per side is coarse, so that its depth is interpolated. Phones measure 160 × 90 to 256 × 192
 * samples, headsets 320 × 320; recordings and painted images have more, and interpolation would only cost time.
 */
const COARSE_SIDE = 320;

/** Processes the depth of one view, in this order: smoothing, hole filling, interpolation along edges. */
export interface DepthRefiner {
  /** Returns the processed depth, always as the same object. */
  refine(depth: RoomDepth, view: ViewFrame, wishes: RefineWishes): RoomDepth;
  /** The confidence of the depth that was refined last, at the resolution of the sensor; null if it was not requested. */
  readonly confidence: WebGLTexture | null;
  /** How well the camera image matches the depth, as `RegistrationMeter` draws it; null if no camera image guides the interpolation. */
  readonly registration: DepthImage | null;
  forget(): void;
  dispose(): void;
}

export interface RefineWishes {
  smoothingS: number;
  deltaS: number;
  fillHoles: boolean;
  /** Whether to compute the confidence of the depth too. */
  confidence: boolean;
  /** Whether a device measured the depth. */
  isSensor: boolean;
}

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** Creates a refiner. `drawing` is null if the GPU does not support float render targets; the depth is then not processed. */
export function createDepthRefiner(gl: WebGL2RenderingContext, drawing: DepthDrawing | null, filter: DepthFilter): DepthRefiner {
  let steadier: Steadier | null = null;
  let filler: HoleFiller | null = null;
  let follower: EdgeFollower | null = null;
  let meter: ConfidenceMeter | null = null;
  let confidence: WebGLTexture | null = null;
  let refined: Mutable<RoomDepth> | null = null;
  return {
    get registration() {
      return follower?.registration ?? null;
    },
    get confidence() {
      return confidence;
    },
    refine: (depth, view, { smoothingS, deltaS, fillHoles, confidence: isRated, isSensor }) => {
      refined ??= { ...depth };
      let { texture } = depth;
      refined.widthPx = depth.widthPx;
      refined.heightPx = depth.heightPx;
      refined.uvFromViewUv = depth.uvFromViewUv;
      refined.worldFromDepth = depth.worldFromDepth;
      refined.interpolate = filter !== 'nearest';
      if (drawing && smoothingS > 0) {
        steadier ??= createSteadier(gl, drawing);
        texture = steadier.steady(depth, view, smoothingS, deltaS);
      } else steadier?.forget();
      const measured = texture;
      if (drawing && fillHoles) {
        filler ??= createHoleFiller(drawing);
        texture = filler.fill(texture, depth.widthPx, depth.heightPx);
      }
      if (drawing && isRated) {
        meter ??= createConfidenceMeter(drawing);
        confidence = meter.rate(measured, texture, depth.widthPx, depth.heightPx);
      }
      if (drawing && isEdgeAware(filter, depth, isSensor)) {
        follower ??= createEdgeFollower(gl, drawing);
        const image = follower.follow(texture, depth, view);
        texture = image.texture;
        refined.widthPx = image.widthPx;
        refined.heightPx = image.heightPx;
        refined.uvFromViewUv = UPRIGHT;
      }
      refined.texture = texture;
      return refined;
    },
    forget: () => steadier?.forget(),
    dispose: () => {
      for (const part of [steadier, filler, follower, meter]) part?.dispose();
    },
  };
}

function isEdgeAware(filter: DepthFilter, { widthPx, heightPx }: RoomDepth, isSensor: boolean): boolean {
  if (filter === 'by-sensor') return isSensor && Math.max(widthPx, heightPx) <= COARSE_SIDE;
  return filter === 'edge-aware';
}

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
