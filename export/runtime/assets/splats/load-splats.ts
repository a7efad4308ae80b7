import type { Diagnostic } from '../../../../nodes/kit/diagnostics.ts';
import type { SplatAsset } from '../../../../nodes/kit/splat-asset.ts';
import { reduceSplats } from '../../../../nodes/kit/splats/reduce-splats.ts';
import { splatSize } from '../../../../nodes/kit/splats/splat-size.ts';
import { HARMONICS_WORDS, SPLATS_PER_ROW, type Splats, WORDS } from '../../../../nodes/kit/splats/splats.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { limitHere } from '../on-phone.ts';
import { readSplatBytes } from './read-splat-bytes.ts';

export interface LoadedSplats extends SplatAsset {
  readonly findings: readonly Omit<Diagnostic, 'nodeId'>[];
  dispose(): void;
}

/**
 * Loads splats: PLY, SOG, or the form of pages.
 *
 * @param path Path of the file, whose ending tells the format.
 * @param phoneGpuBytes What they may take on phones and headsets: fewer harmonics are uploaded there, and then fewer splats.
 * @throws SplatError
 */
export async function loadSplats(objects: GlObjects, bytes: ArrayBuffer, path: string, phoneGpuBytes?: number): Promise<LoadedSplats> {
  const all = await readSplatBytes(objects, path, new Uint8Array(bytes));
  const splats = reduceSplats(all, splatSize(all.count, all.degree, limitHere(phoneGpuBytes)));
  const { count, degree, antialiased, words, harmonics, ranges, invalid } = splats;
  const positions = new Float32Array(3 * count);
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  for (let i = 0; i < count; i++) for (let axis = 0; axis < 3; axis++) positions[3 * i + axis] = floats[i * WORDS + axis] ?? 0;
  const data = upload(objects, words, WORDS, count);
  const others = degree === 0 ? null : upload(objects, harmonics, HARMONICS_WORDS[degree], count);
  return {
    count,
    degree,
    antialiased,
    ranges,
    positions,
    data,
    harmonics: others,
    findings: invalid === 0 ? [] : [leftOut(path, splats)],
    dispose: () => {
      objects.deleteTexture(data);
      if (others) objects.deleteTexture(others);
    },
  };
}

/** Creates a texture of `stride` words per splat, in rows of `SPLATS_PER_ROW` splats. */
function upload({ gl, createTexture }: GlObjects, words: Uint32Array<ArrayBuffer>, stride: number, count: number): WebGLTexture {
  const texture = createTexture();
  const widthPx = (SPLATS_PER_ROW * stride) / 4;
  const rows = Math.floor(count / SPLATS_PER_ROW);
  const rest = count - rows * SPLATS_PER_ROW;
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, widthPx, Math.ceil(count / SPLATS_PER_ROW));
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  prepareUpload(gl, 4);
  const write = (row: number, width: number, height: number): void => {
    const from = words.subarray(row * SPLATS_PER_ROW * stride);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, from);
  };
  if (rows > 0) write(0, widthPx, rows);
  if (rest > 0) write(rows, (rest * stride) / 4, 1);
  return texture;
}

function leftOut(path: string, { count, invalid }: Splats): Omit<Diagnostic, 'nodeId'> {
  const message = `"${path}" has ${invalid} splats whose values are not finite; they are left out, and ${count} are shown.`;
  return { code: 'SCR032', severity: 'warning', message, fix: 'Remove them in an editor for splats if others are missing, too.' };
}
