import type { GlObjects } from './gl-objects.ts';
import type { GlProgram } from './program-cache.ts';

export type PassBlend = 'replace' | 'over';

/**
 * Draws full-screen triangles. It sets all GL state that such a draw depends on and assumes nothing about what others left:
 * three.js, the browser's XR code and nodes use the same context.
 */
export interface PassDrawer {
  /** Everything drawn until `end` goes here. */
  begin(framebuffer: WebGLFramebuffer | null, x: number, y: number, widthPx: number, heightPx: number, blend: PassBlend): void;
  use(program: GlProgram): void;
  /** A null texture stands for transparent, or for unknown depth. `nearest` for anything that is not colour. */
  texture(unit: number, location: WebGLUniformLocation, texture: WebGLTexture | null, filter: 'linear' | 'nearest'): void;
  draw(): void;
  /** Takes its samplers off the units again: three.js sets texture parameters and knows no samplers. */
  end(): void;
  dispose(): void;
}

export function createPassDrawer(objects: GlObjects): PassDrawer {
  const { gl } = objects;
  // The vertex shader makes the triangle from gl_VertexID; an array of its own keeps attributes of others out of the draw.
  const vertexArray = objects.createVertexArray();
  const linear = createSampler(objects, gl.LINEAR);
  const nearest = createSampler(objects, gl.NEAREST);
  const empty = createEmptyTexture(objects);
  let unitsUsed = 0;
  return {
    begin: (framebuffer, x, y, widthPx, heightPx, blend) => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.viewport(x, y, widthPx, heightPx);
      gl.disable(gl.SCISSOR_TEST);
      gl.disable(gl.DEPTH_TEST);
      gl.disable(gl.STENCIL_TEST);
      gl.disable(gl.CULL_FACE);
      gl.disable(gl.RASTERIZER_DISCARD);
      gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
      gl.disable(gl.SAMPLE_COVERAGE);
      gl.colorMask(true, true, true, true);
      if (blend === 'over') {
        gl.enable(gl.BLEND);
        gl.blendEquation(gl.FUNC_ADD);
        gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      } else {
        gl.disable(gl.BLEND);
      }
      gl.bindVertexArray(vertexArray);
    },
    use: (program) => gl.useProgram(program.program),
    texture: (unit, location, texture, filter) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture ?? empty);
      gl.bindSampler(unit, filter === 'linear' ? linear : nearest);
      gl.uniform1i(location, unit);
      if (unit >= unitsUsed) unitsUsed = unit + 1;
    },
    draw: () => gl.drawArrays(gl.TRIANGLES, 0, 3),
    end: () => {
      for (let unit = 0; unit < unitsUsed; unit++) gl.bindSampler(unit, null);
      unitsUsed = 0;
      gl.bindVertexArray(null);
    },
    dispose: () => {
      objects.deleteVertexArray(vertexArray);
      objects.deleteSampler(linear);
      objects.deleteSampler(nearest);
      objects.deleteTexture(empty);
    },
  };
}

/** Samplers rather than texture parameters: textures come from browsers and nodes too, and may be read-only or have mips. */
function createSampler(objects: GlObjects, filter: GLenum): WebGLSampler {
  const { gl } = objects;
  const sampler = objects.createSampler();
  gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return sampler;
}

/** All zero: transparent as colour, unknown as depth. */
function createEmptyTexture(objects: GlObjects): WebGLTexture {
  const { gl } = objects;
  const texture = objects.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 1, 1);
  return texture;
}
