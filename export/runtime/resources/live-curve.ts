import { CURVE_NUMBERS, sampleCurve } from '../../../nodes/kit/curve.ts';
import { CURVE_WIDTH_PX } from '../../program/texture-sizes.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareUpload } from '../gl/upload.ts';
import type { Slots } from '../values/slots.ts';

/** The curve of a param as a texture of heights, updated when the curve changes. */
export interface LiveCurve {
  /** One row of half floats, filtered linearly. */
  readonly texture: WebGLTexture;
  /** Connects the curve to its slot in a new program, before the program is drawn. */
  point(slots: Slots, slot: number): void;
  /** Updates the texture if the curve changed. Call it outside of a pass. */
  update(): void;
  dispose(): void;
}

/** Heights of the curve, valid within one update; updates do not nest. */
const scratchHeights = new Float32Array(CURVE_WIDTH_PX);

export function createLiveCurve(objects: GlObjects): LiveCurve {
  const { gl } = objects;
  // Half floats can be filtered on all devices and distinguish 2,048 heights near 1.
  const texture = allocateTexture(gl, objects.createTexture(), gl.R16F, gl.LINEAR, CURVE_WIDTH_PX, 1);
  const shown = new Float64Array(CURVE_NUMBERS).fill(Number.NaN);
  let points: Float64Array = shown;

  function hasChanged(): boolean {
    for (let i = 0; i < CURVE_NUMBERS; i++) if (points[i] !== shown[i]) return true;
    return false;
  }

  return {
    texture,
    point: (slots, slot) => {
      const first = slots.offset(slot);
      points = slots.numbers.subarray(first, first + CURVE_NUMBERS);
    },
    update: () => {
      if (!hasChanged()) return;
      shown.set(points);
      sampleCurve(points, scratchHeights);
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, CURVE_WIDTH_PX, 1, gl.RED, gl.FLOAT, scratchHeights);
    },
    dispose: () => objects.deleteTexture(texture),
  };
}
