import type { CaptureFacts } from './capture-asset.ts';
import { setFromAngles } from './rigid.ts';
import type { NumberView, VectorView, Writable } from './value-views.ts';

/**
 * What a `capture` wire carries: a captured place without anything of the GPU. The same object every frame: read it during the frame.
 *
 * A point p of the capture's document is at `worldFromPlace · (scale · p)`.
 */
export interface CapturedPlace {
  /** Id of the asset, for readers that draw it (`AssetService.capture`). Null if no file is chosen. */
  readonly assetId: string | null;
  /** Its cameras, its mesh, and which photographs are there. Null while it loads, if it cannot be loaded, and if no file is chosen. */
  readonly facts: CaptureFacts | null;
  /** Its pose: column-major 4×4, rigid. */
  readonly worldFromPlace: Float32Array;
  /** Uniform factor on the lengths of the document, above 0. */
  readonly scale: number;
}

/** Params that place a capture: `POSITION_PARAM`, `ROTATION_PARAM` and `SCALE_PARAM`. */
export interface PlaceParams {
  readonly positionM: VectorView;
  readonly rotationRad: VectorView;
  readonly scale: NumberView;
}

/** At a scale of 0 a capture would have no inverse. */
const LEAST_SCALE = 1e-6;

/**
 * Creates a place without capture.
 *
 * @example
 * const place = createCapturedPlace();
 * writeCapturedPlace(place, handle.value, ctx.params);
 */
export function createCapturedPlace(): Writable<CapturedPlace> {
  const worldFromPlace = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  return { assetId: null, facts: null, worldFromPlace, scale: 1 };
}

/**
 * Writes a capture and where it is; keeps the id of the asset. Allocates nothing.
 *
 * @param facts Null while there is no capture.
 *
 * @example
 * writeCapturedPlace(ctx.outputs.capture, handle?.value ?? null, ctx.params);
 */
export function writeCapturedPlace(
  out: Writable<CapturedPlace>,
  facts: CaptureFacts | null,
  { positionM, rotationRad, scale }: PlaceParams,
): void {
  out.facts = facts;
  setFromAngles(out.worldFromPlace, positionM.value, rotationRad.value);
  out.scale = Math.max(scale.value, LEAST_SCALE);
}
