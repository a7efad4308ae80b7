import { DataUtils } from 'three';
import { srgbFromLinear } from '../../../nodes/kit/color-math.ts';
import type { ReflectionFormat } from './light-probe.ts';
import type { ReflectionFaces } from './session-light.ts';

/** Uploads the probe's cube map as a texture of the page's context. */
export function createReflectionCube(gl: WebGL2RenderingContext, light: ReflectionFaces, format: ReflectionFormat): WebGLTexture {
  const texture = gl.createTexture();
  const size = light.cubeSizePx;
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  light.cubeFaces.forEach((face, index) => {
    const target = gl.TEXTURE_CUBE_MAP_POSITIVE_X + index;
    if (format === 'rgba16f') gl.texImage2D(target, 0, gl.RGBA16F, size, size, 0, gl.RGBA, gl.HALF_FLOAT, toHalf(face));
    else gl.texImage2D(target, 0, gl.SRGB8_ALPHA8, size, size, 0, gl.RGBA, gl.UNSIGNED_BYTE, toSrgb(face));
  });
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  return texture;
}

function toHalf(linear: Float32Array): Uint16Array {
  return Uint16Array.from(linear, (value) => DataUtils.toHalfFloat(Math.min(value, 65_504)));
}

function toSrgb(linear: Float32Array): Uint8Array {
  return Uint8Array.from(linear, (value, index) => {
    if (index % 4 === 3) return 255;
    return Math.round(srgbFromLinear(Math.min(Math.max(value, 0), 1)) * 255);
  });
}
