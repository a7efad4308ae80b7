import { TABLE_WIDTH_PX } from '../../program/texture-sizes.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareUpload } from '../gl/upload.ts';
import type { Slots } from '../values/slots.ts';

/** A param as a texture of one row, updated when the param changes. */
export interface LiveTable {
  /** One row of half floats, filtered linearly. */
  readonly texture: WebGLTexture;
  /** Connects the table to its slot in a new program, before the program is drawn. */
  point(slots: Slots, slot: number): void;
  /** Updates the texture if the param changed. Call it outside of a pass. */
  update(): void;
  dispose(): void;
}

/** How a table is made of the numbers of its param. */
export interface TableSource {
  /** How many numbers the slot has. */
  readonly numbers: number;
  /** Channels of the texture. */
  readonly channels: 1 | 4;
  /** Fills the row. */
  readonly sample: (numbers: ArrayLike<number>, row: Float32Array) => void;
}

export function createLiveTable(objects: GlObjects, { numbers, channels, sample }: TableSource): LiveTable {
  const { gl } = objects;
  // Half floats can be filtered on all devices and distinguish 2,048 values near 1.
  const [stored, format] = channels === 1 ? ([gl.R16F, gl.RED] as const) : ([gl.RGBA16F, gl.RGBA] as const);
  const texture = allocateTexture(gl, objects.createTexture(), stored, gl.LINEAR, TABLE_WIDTH_PX, 1);
  const row = new Float32Array(TABLE_WIDTH_PX * channels);
  const shown = new Float64Array(numbers).fill(Number.NaN);
  let points: Float64Array = shown;

  function hasChanged(): boolean {
    for (let i = 0; i < numbers; i++) if (points[i] !== shown[i]) return true;
    return false;
  }

  return {
    texture,
    point: (slots, slot) => {
      const first = slots.offset(slot);
      points = slots.numbers.subarray(first, first + numbers);
    },
    update: () => {
      if (!hasChanged()) return;
      shown.set(points);
      sample(points, row);
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH_PX, 1, format, gl.FLOAT, row);
    },
    dispose: () => objects.deleteTexture(texture),
  };
}
