import { linkProgram } from '../../../../nodes/kit/link-program.ts';

/** Draws the smaller levels of a texture from the larger ones, by rows. */
export interface MipDrawer {
  /** Draws rows of a level from the level before. The texture has to be bound at unit 0. */
  draw(level: number, widthPx: number, heightPx: number, row: number, rows: number): void;
  dispose(): void;
}

const VERTEX = /* glsl */ `#version 300 es
void main() {
  gl_Position = vec4(float((gl_VertexID << 1) & 2) * 2.0 - 1.0, float(gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
`;

/** Linear filtering at the center of the pixel gives the mean of the four pixels that it covers. */
const FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
uniform highp sampler2D larger;
uniform vec2 sizePx;
out vec4 color;
void main() {
  color = textureLod(larger, gl_FragCoord.xy / sizePx, 0.0);
}
`;

/**
 * Creates what draws the levels of `texture`, whose storage has them all. Without it, `generateMipmap` makes all levels at once.
 *
 * @throws Error if the GPU cannot draw to the format of the texture; it can draw to all formats of panoramas that it can light by.
 */
export function createMipDrawer(gl: WebGL2RenderingContext, texture: WebGLTexture): MipDrawer {
  const program = linkProgram(gl, VERTEX, FRAGMENT);
  const sizePx = gl.getUniformLocation(program, 'sizePx');
  const framebuffer = gl.createFramebuffer();
  const vertexArray = gl.createVertexArray();
  const setLevels = (first: number, last: number): void => {
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_BASE_LEVEL, first);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAX_LEVEL, last);
  };
  return {
    draw: (level, widthPx, heightPx, row, rows) => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, level);
      // Only the larger level can be read, so that no pixel is read and written in one draw.
      setLevels(level - 1, level - 1);
      for (const state of [gl.BLEND, gl.CULL_FACE, gl.DEPTH_TEST, gl.STENCIL_TEST, gl.RASTERIZER_DISCARD, gl.SAMPLE_COVERAGE])
        gl.disable(state);
      gl.colorMask(true, true, true, true);
      gl.viewport(0, 0, widthPx, heightPx);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, row, widthPx, rows);
      gl.useProgram(program);
      gl.uniform2f(sizePx, widthPx, heightPx);
      gl.bindSampler(0, null);
      gl.bindVertexArray(vertexArray);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.bindVertexArray(null);
      gl.disable(gl.SCISSOR_TEST);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      // The defaults.
      setLevels(0, 1000);
    },
    dispose: () => {
      gl.deleteProgram(program);
      gl.deleteFramebuffer(framebuffer);
      gl.deleteVertexArray(vertexArray);
    },
  };
}
