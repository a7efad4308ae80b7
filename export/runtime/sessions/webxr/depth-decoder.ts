import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { COPY_SHADER } from '../../gl/copy-shader.ts';
import type { XrGpuDepthInformation } from './webxr-types.ts';

/** Content of the texture: one of WebXR's formats, or window-space depth. */
export type DepthSource = XRDepthDataFormat | 'window';

/** Decodes a depth texture to meters, texel by texel, 0 where unknown. */
export interface DepthDecoder {
  readonly source: DepthSource;
  readonly array: boolean;
  /** Binds program, texture (unit 0) and uniforms. `viewIndex` is the array layer to use if the browser does not report one. */
  use(info: XrGpuDepthInformation, viewIndex: number): void;
  dispose(): void;
}

export function createDecoder(gl: WebGL2RenderingContext, source: DepthSource, array: boolean): DepthDecoder {
  const program = linkProgram(gl, COPY_SHADER.vertex, fragment(source, array));
  const scale = gl.getUniformLocation(program, 'scale');
  const layer = gl.getUniformLocation(program, 'layer');
  const target = array ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
  const scratch = new Float32Array(2);
  return {
    source,
    array,
    use: (info, viewIndex) => {
      gl.useProgram(program);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(target, info.texture);
      // meters = near far / (far − d (far − near)), in a form that also holds for an infinite far plane.
      const near = info.depthNear ?? 0;
      const nearByFar = near / (info.depthFar ?? Number.POSITIVE_INFINITY);
      scratch[0] = source === 'window' ? near : info.rawValueToMeters;
      scratch[1] = source === 'window' ? 1 - nearByFar : 0;
      gl.uniform2fv(scale, scratch);
      gl.uniform1i(layer, info.imageIndex ?? viewIndex);
    },
    dispose: () => gl.deleteProgram(program),
  };
}

function fragment(source: DepthSource, array: boolean): string {
  const type = `${source === 'unsigned-short' ? 'u' : ''}sampler2D${array ? 'Array' : ''}`;
  const at = array ? 'ivec3(gl_FragCoord.xy, layer)' : 'ivec2(gl_FragCoord.xy)';
  return /* glsl */ `#version 300 es
precision highp float;
uniform highp ${type} depth;
uniform vec2 scale;
uniform int layer;
out vec4 color;
float metersFromWindow(float d) { return d > 0.0 && d < 1.0 ? scale.x / (1.0 - d * scale.y) : 0.0; }
void main() {
  color = vec4(${METERS[source].replace('TEXEL', `texelFetch(depth, ${at}, 0)`)}, 0.0, 0.0, 1.0);
}
`;
}

/**
 * GLSL that converts a texel to meters, by the content of the texture. In `luminance-alpha`, luminance is the low byte and alpha the high
 * one (Depth Sensing §2.2).
 */
const METERS: Readonly<Record<DepthSource, string>> = {
  'luminance-alpha': 'dot(TEXEL.ra, vec2(255.0, 65280.0)) * scale.x',
  'unsigned-short': 'float(TEXEL.r) * scale.x',
  float32: 'TEXEL.r * scale.x',
  window: 'metersFromWindow(TEXEL.r)',
};
