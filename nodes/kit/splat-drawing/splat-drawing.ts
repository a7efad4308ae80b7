import type { OcclusionView } from '../early-occlusion.ts';
import { setPassState, setSampler } from '../pass-state.ts';
import type { DrawView } from '../runtime.ts';
import type { SplatAsset } from '../splat-asset.ts';
import { SPLATS_PER_ROW } from '../splats/splats.ts';
import { createColorTarget } from './color-target.ts';
import { createDepthTargets, type DepthTargets } from './depth-targets.ts';
import { createSplatProgram, SPLAT_UNITS, type SplatProgram } from './splat-program.ts';
import { SPLATS_PER_INSTANCE, type SplatOutput } from './splat-shaders.ts';

/** Draws splats in an order that it is given. */
export interface SplatDrawing {
  /** Sets the order: the indices of the splats, the farthest first. Nothing is drawn before. */
  setOrder(order: Uint32Array): void;
  /**
   * Draws color to the framebuffer of a view, and depth if something reads it.
   *
   * @param viewFromSplats Column-major 4×4, rigid with a uniform scale.
   * @param eye Position in the space of the splats.
   */
  draw(view: DrawView, viewFromSplats: Float32Array, eye: Float32Array): void;
  dispose(): void;
}

/**
 * Creates the programs for some splats.
 *
 * @param antialiased Whether opacity compensates for the low-pass filter, as for splats that were trained so.
 * @param occlusion The occlusion that is applied while drawing; null: none.
 *
 * @example
 * const drawing = createSplatDrawing(gl, splats, false, ctx.occlusion);
 */
export function createSplatDrawing(
  gl: WebGL2RenderingContext,
  splats: SplatAsset,
  antialiased: boolean,
  occlusion: OcclusionView | null,
): SplatDrawing {
  const vertexArray = gl.createVertexArray();
  const corners = gl.createBuffer();
  const order = gl.createTexture();
  const sampler = gl.createSampler();
  const empty = gl.createTexture();
  setSampler(gl, sampler, gl.NEAREST);
  gl.bindVertexArray(vertexArray);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, cornersOfQuads(SPLATS_PER_INSTANCE), gl.STATIC_DRAW);
  gl.bindVertexArray(null);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, order);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.R32UI, SPLATS_PER_ROW, Math.ceil(splats.count / SPLATS_PER_ROW));
  const programFor = (output: SplatOutput) => createSplatProgram(gl, splats, { output, antialiased, occlusion, empty });
  const color = programFor('color');
  const colorTarget = createColorTarget(gl);
  let depth: { readonly mean: SplatProgram; readonly front: SplatProgram; readonly targets: DepthTargets } | null = null;
  let hasOrder = false;

  const bindTexture = (unit: number, texture: WebGLTexture | null): void => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    // Other code leaves samplers, which take precedence over the filters of a texture.
    gl.bindSampler(unit, sampler);
  };
  const bindSplats = (meanDepth: WebGLTexture | null): void => {
    bindTexture(SPLAT_UNITS.order, order);
    bindTexture(SPLAT_UNITS.data, splats.data);
    bindTexture(SPLAT_UNITS.harmonics, splats.harmonics);
    bindTexture(SPLAT_UNITS.meanDepth, meanDepth);
    gl.bindSampler(SPLAT_UNITS.room, sampler);
  };
  const drawQuads = (): void => {
    gl.bindVertexArray(vertexArray);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.drawElementsInstanced(gl.TRIANGLES, 6 * SPLATS_PER_INSTANCE, gl.UNSIGNED_SHORT, 0, Math.ceil(splats.count / SPLATS_PER_INSTANCE));
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  };
  const drawDepth = (view: DrawView, viewFromSplats: Float32Array, eye: Float32Array): void => {
    depth ??= { mean: programFor('depth'), front: programFor('front'), targets: createDepthTargets(gl) };
    const { mean, front, targets } = depth;
    if (!targets.grow(view)) return;
    targets.begin('mean', view);
    bindSplats(null);
    mean.use(view, viewFromSplats, eye, 0, 0);
    drawQuads();
    targets.begin('front', view);
    bindSplats(targets.mean);
    front.use(view, viewFromSplats, eye, 0, 0);
    drawQuads();
    bindTexture(0, targets.mean);
    bindTexture(1, targets.front);
    targets.write(view);
  };
  return {
    setOrder: (indices) => {
      const rows = Math.floor(splats.count / SPLATS_PER_ROW);
      const rest = splats.count - rows * SPLATS_PER_ROW;
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, order);
      setUploadState(gl);
      if (rows > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, SPLATS_PER_ROW, rows, gl.RED_INTEGER, gl.UNSIGNED_INT, indices, 0);
      if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, rows, rest, 1, gl.RED_INTEGER, gl.UNSIGNED_INT, indices, rows * SPLATS_PER_ROW);
      hasOrder = true;
    },
    draw: (view, viewFromSplats, eye) => {
      if (!hasOrder) return;
      const { framebuffer, viewport } = view;
      const isBlendedApart = colorTarget.begin(view);
      if (!isBlendedApart) setPassState(gl, framebuffer, null, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
      bindSplats(null);
      color.use(view, viewFromSplats, eye, isBlendedApart ? 0 : viewport.x, isBlendedApart ? 0 : viewport.y);
      drawQuads();
      if (isBlendedApart) colorTarget.write(view);
      if (view.readsDepth !== false) drawDepth(view, viewFromSplats, eye);
      for (let unit = 0; unit <= SPLAT_UNITS.order; unit++) gl.bindSampler(unit, null);
    },
    dispose: () => {
      color.dispose();
      colorTarget.dispose();
      depth?.mean.dispose();
      depth?.front.dispose();
      depth?.targets.dispose();
      gl.deleteVertexArray(vertexArray);
      gl.deleteBuffer(corners);
      gl.deleteTexture(order);
      gl.deleteSampler(sampler);
      gl.deleteTexture(empty);
    },
  };
}

/** Sets what uploads from memory depend on to the defaults of GL, because other code on the context may have changed it. */
function setUploadState(gl: WebGL2RenderingContext): void {
  gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
  for (const name of [gl.UNPACK_ROW_LENGTH, gl.UNPACK_SKIP_PIXELS, gl.UNPACK_SKIP_ROWS]) gl.pixelStorei(name, 0);
}

/** Two triangles per quad of four vertices. */
function cornersOfQuads(count: number): Uint16Array<ArrayBuffer> {
  return Uint16Array.from({ length: 6 * count }, (_, i) => 4 * Math.floor(i / 6) + ([0, 1, 2, 2, 1, 3][i % 6] ?? 0));
}
