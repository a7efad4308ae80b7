import type { DepthFormat } from '../profiles.ts';
import type { EncodedDepth } from './depth-encoding.ts';

/** Depth as a texture in the page's context: a plain texture for one view, a texture array with a layer per eye for two. */
export interface DepthTexture {
  readonly texture: WebGLTexture;
  /** Uploads a depth buffer to a layer. Row 0 of the texture is the buffer's top row. */
  upload(depth: EncodedDepth, layer: number): void;
  dispose(): void;
}

/** The texture format for a depth format (WebXR Depth Sensing §2.2). */
function glFormat(gl: WebGL2RenderingContext, format: DepthFormat): readonly [internal: GLenum, format: GLenum, type: GLenum] {
  switch (format) {
    case 'luminance-alpha':
      return [gl.LUMINANCE_ALPHA, gl.LUMINANCE_ALPHA, gl.UNSIGNED_BYTE];
    case 'unsigned-short':
      return [gl.R16UI, gl.RED_INTEGER, gl.UNSIGNED_SHORT];
    case 'float32':
      return [gl.R32F, gl.RED, gl.FLOAT];
  }
}

export function createDepthTexture(
  gl: WebGL2RenderingContext,
  widthPx: number,
  heightPx: number,
  layers: 1 | 2,
  depthFormat: DepthFormat,
): DepthTexture {
  const [internal, format, type] = glFormat(gl, depthFormat);
  const target = layers === 1 ? gl.TEXTURE_2D : gl.TEXTURE_2D_ARRAY;
  const texture = gl.createTexture();
  gl.bindTexture(target, texture);
  if (layers === 1) gl.texImage2D(target, 0, internal, widthPx, heightPx, 0, format, type, null);
  else gl.texImage3D(target, 0, internal, widthPx, heightPx, layers, 0, format, type, null);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(target, name, gl.CLAMP_TO_EDGE);
  return {
    texture,
    upload: ({ data }, layer) => {
      gl.bindTexture(target, texture);
      const texels = asTexels(data, depthFormat);
      if (layers === 1) gl.texSubImage2D(target, 0, 0, 0, widthPx, heightPx, format, type, texels);
      else gl.texSubImage3D(target, 0, 0, 0, layer, widthPx, heightPx, 1, format, type, texels);
    },
    dispose: () => gl.deleteTexture(texture),
  };
}

function asTexels(data: ArrayBuffer, format: DepthFormat): ArrayBufferView {
  if (format === 'float32') return new Float32Array(data);
  return format === 'unsigned-short' ? new Uint16Array(data) : new Uint8Array(data);
}
