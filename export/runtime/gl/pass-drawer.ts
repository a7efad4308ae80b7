import { setPassState, setSampler } from '../../../nodes/kit/pass-state.ts';
import type { GlObjects } from './gl-objects.ts';
import type { GlProgram } from './program-cache.ts';

/** Number of vertices of a draw, by `LinkedShader.geometry`. */
const TRIANGLE_VERTICES = 3;
const QUAD_VERTICES = 6;

export type PassBlend = 'replace' | 'over';

/** Draws full-screen triangles and quads, independent of the current GL state. */
export interface PassDrawer {
  /** Sets the target of draws until `end`. */
  begin(framebuffer: WebGLFramebuffer | null, x: number, y: number, widthPx: number, heightPx: number, blend: PassBlend): void;
  use(program: GlProgram): void;
  /** Binds a texture; null binds a transparent one, which means unknown depth. Use `nearest` for anything but color. */
  texture(unit: number, location: WebGLUniformLocation, texture: WebGLTexture | null, filter: 'linear' | 'nearest'): void;
  /** Binds a cube map; null binds a transparent one. */
  cube(unit: number, location: WebGLUniformLocation, texture: WebGLTexture | null): void;
  draw(): void;
  /** Ends the pass: unbinds the sampler objects, because they would override the texture parameters that three.js sets. */
  end(): void;
  dispose(): void;
}

export function createPassDrawer(objects: GlObjects): PassDrawer {
  const { gl } = objects;
  // The vertex shader computes the triangle from gl_VertexID. A separate vertex array excludes other attributes.
  const vertexArray = objects.createVertexArray();
  const linear = objects.createSampler();
  const nearest = objects.createSampler();
  setSampler(gl, linear, gl.LINEAR);
  setSampler(gl, nearest, gl.NEAREST);
  const empty = createEmptyTexture(objects, gl.TEXTURE_2D);
  let emptyCube: WebGLTexture | null = null;
  let vertices = TRIANGLE_VERTICES;
  let unitsUsed = 0;
  return {
    begin: (framebuffer, x, y, widthPx, heightPx, blend) => {
      setPassState(gl, framebuffer, vertexArray, x, y, widthPx, heightPx);
      if (blend === 'replace') return;
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    },
    use: ({ program, shader }) => {
      gl.useProgram(program);
      vertices = shader.geometry === undefined ? TRIANGLE_VERTICES : QUAD_VERTICES;
    },
    texture: (unit, location, texture, filter) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture ?? empty);
      gl.bindSampler(unit, filter === 'linear' ? linear : nearest);
      gl.uniform1i(location, unit);
      if (unit >= unitsUsed) unitsUsed = unit + 1;
    },
    cube: (unit, location, texture) => {
      emptyCube ??= texture === null ? createEmptyTexture(objects, gl.TEXTURE_CUBE_MAP) : null;
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture ?? emptyCube);
      gl.bindSampler(unit, linear);
      gl.uniform1i(location, unit);
      if (unit >= unitsUsed) unitsUsed = unit + 1;
    },
    draw: () => gl.drawArrays(gl.TRIANGLES, 0, vertices),
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
      if (emptyCube) objects.deleteTexture(emptyCube);
    },
  };
}

/** Creates a texture of one texel that is all zero: transparent as color, unknown as depth. */
function createEmptyTexture(objects: GlObjects, target: GLenum): WebGLTexture {
  const { gl } = objects;
  const texture = objects.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(target, texture);
  gl.texStorage2D(target, 1, gl.RGBA8, 1, 1);
  return texture;
}
