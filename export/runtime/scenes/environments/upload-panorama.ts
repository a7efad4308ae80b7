import { HalfFloatType, RedFormat, type Texture } from 'three';
import type { PartedWork } from '../../gl/spread-work.ts';
import { prepareUpload } from '../../gl/upload.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createMipDrawer, type MipDrawer } from './mip-drawer.ts';

/** Pixels that one turn uploads, or draws of the smaller levels: 128 rows of the largest panorama, 8 MB in half floats. */
export const UPLOADED_PX = 2 ** 20;

interface Rows {
  readonly widthPx: number;
  readonly heightPx: number;
  upload(gl: WebGL2RenderingContext, row: number, rows: number): void;
}

/**
 * Uploads the texture of a panorama by rows and draws its smaller levels by rows, which three.js does at once: 32 million pixels stop the
 * page for seconds without a GPU. The texture has what three.js' own upload would give, within the rounding of its format.
 */
export function* uploadPanorama(renderer: SceneRenderer, texture: Texture): PartedWork {
  const source = rowsOf(texture);
  const { widthPx, heightPx } = source;
  renderer.work((three) => allocate(three, texture, widthPx, heightPx));
  const glTexture = (renderer.three.properties.get(texture) as { __webglTexture: WebGLTexture }).__webglTexture;
  const gl = renderer.three.getContext() as WebGL2RenderingContext;
  const drawOn = (draw: (gl: WebGL2RenderingContext) => void): void => {
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, glTexture);
    draw(gl);
  };
  for (const [row, rows] of slices(widthPx, heightPx)) {
    drawOn((gl) => {
      prepareUpload(gl, 1);
      source.upload(gl, row, rows);
    });
    yield (rows * widthPx) / UPLOADED_PX;
  }
  let mips: MipDrawer | null = null;
  try {
    let size: Size = source;
    for (let level = 1; size.widthPx > 1 || size.heightPx > 1; level++) {
      const { widthPx: width, heightPx: height } = halved(size);
      size = { widthPx: width, heightPx: height };
      for (const [row, rows] of slices(width, height)) {
        drawOn((gl) => {
          mips ??= createMipDrawer(gl, glTexture);
          mips.draw(level, width, height, row, rows);
        });
        yield (rows * width) / UPLOADED_PX;
      }
    }
  } finally {
    (mips as MipDrawer | null)?.dispose();
  }
}

/** Rows of an image, as many at a time as one turn takes. */
function* slices(widthPx: number, heightPx: number): Generator<readonly [row: number, rows: number]> {
  const most = Math.max(1, Math.floor(UPLOADED_PX / widthPx));
  for (let row = 0; row < heightPx; row += most) yield [row, Math.min(most, heightPx - row)];
}

type Size = Pick<Rows, 'widthPx' | 'heightPx'>;

function halved({ widthPx, heightPx }: Size): Size {
  return { widthPx: Math.max(1, widthPx >> 1), heightPx: Math.max(1, heightPx >> 1) };
}

/** Makes three.js create the texture with all levels, without pixels: given levels are not generated, and a source that is not ready is not uploaded. */
function allocate(three: SceneRenderer['three'], texture: Texture, widthPx: number, heightPx: number): void {
  const levels = Math.floor(Math.log2(Math.max(widthPx, heightPx))) + 1;
  texture.mipmaps = Array.from({ length: levels }, () => ({ width: widthPx, height: heightPx })) as unknown as Texture['mipmaps'];
  texture.generateMipmaps = false;
  texture.source.dataReady = false;
  three.initTexture(texture);
  texture.source.dataReady = true;
  texture.mipmaps = [];
}

function rowsOf(texture: Texture): Rows {
  const image = texture.image as ImageBitmap | { readonly data: Uint16Array | Uint8Array; readonly width: number; readonly height: number };
  const { width: widthPx, height: heightPx } = image;
  if (image instanceof ImageBitmap) {
    return {
      widthPx,
      heightPx,
      upload: (gl, row, rows) => {
        gl.pixelStorei(gl.UNPACK_SKIP_ROWS, row);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, widthPx, rows, gl.RGBA, gl.UNSIGNED_BYTE, image);
        // three.js does not know this state.
        gl.pixelStorei(gl.UNPACK_SKIP_ROWS, 0);
      },
    };
  }
  const channels = texture.format === RedFormat ? 1 : 4;
  return {
    widthPx,
    heightPx,
    upload: (gl, row, rows) => {
      gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, texture.flipY);
      const format = channels === 1 ? gl.RED : gl.RGBA;
      const type = texture.type === HalfFloatType ? gl.HALF_FLOAT : gl.UNSIGNED_BYTE;
      const data = image.data.subarray(row * widthPx * channels, (row + rows) * widthPx * channels);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, texture.flipY ? heightPx - row - rows : row, widthPx, rows, format, type, data);
    },
  };
}
