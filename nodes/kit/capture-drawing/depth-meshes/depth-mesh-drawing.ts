import type { CaptureAsset, CaptureViewMeshes } from '../../capture-asset.ts';
import { createCaptureUse } from '../../capture-glsl.ts';
import { linkProgram } from '../../link-program.ts';
import { setPassState } from '../../pass-state.ts';
import { type CaptureDrawing, createCaptureDrawing } from '../capture-drawing.ts';
import { createNearestViews } from '../nearest-views.ts';
import {
  DEPTH_FRAGMENT,
  HIDDEN_FRAGMENT,
  HIDDEN_VERTEX,
  PLACE_VERTEX,
  RESOLVE_FRAGMENT,
  SCREEN_VERTEX,
  VIEW_FRAGMENT,
  VIEW_VERTEX,
} from './depth-mesh-shaders.ts';
import { createSumBuffer } from './sum-buffer.ts';

/** Number of photographs whose depth meshes are drawn: the nearest ones to the eye. */
const MOST_MESHES = 8;
/** Photographs per pixel of a lumigraph where no depth mesh is. */
const BLENDED = 2;
/** Surfaces whose distances differ by at most this share are one surface, and their colors are added. */
const SOFTNESS = 0.02;

/**
 * Draws the depth meshes of the nearest photographs (Dupont de Dinechin and Paljic 2020, §3.2; Overbeck et al. 2018). The depth of all is
 * drawn first. Then each mesh is drawn a little nearer, so that whatever is close behind the nearest surface passes the depth test, and adds
 * its color with a weight. At the end the sum is divided by the weights, and gets the depth of the nearest surface. What none of these
 * meshes shows is drawn as a lumigraph, from more photographs. What no photograph shows has the hidden meshes.
 *
 * @example
 * const drawing = createDepthMeshDrawing(gl, capture);
 * drawing.draw(clipFromCapture, eye, forward, { framebuffer, viewport });
 */
export function createDepthMeshDrawing(gl: WebGL2RenderingContext, capture: CaptureAsset): CaptureDrawing {
  const { depthMeshes } = capture;
  const buffer = createSumBuffer(gl);
  const nearest = createNearestViews(capture, MOST_MESHES);
  const depth = { view: createStage(gl, VIEW_VERTEX, DEPTH_FRAGMENT), place: createStage(gl, PLACE_VERTEX, DEPTH_FRAGMENT) };
  const color = createStage(gl, VIEW_VERTEX, VIEW_FRAGMENT);
  const hidden = depthMeshes?.hidden ? { meshes: depthMeshes.hidden, stage: createStage(gl, HIDDEN_VERTEX, HIDDEN_FRAGMENT) } : null;
  const rest = createCaptureDrawing(gl, capture, 'lumigraph', BLENDED);
  const resolve = linkProgram(gl, SCREEN_VERTEX, RESOLVE_FRAGMENT);
  const origin = gl.getUniformLocation(resolve, 'origin');
  const depthFactor = gl.getUniformLocation(resolve, 'depthFactor');
  const hasHidden = gl.getUniformLocation(resolve, 'hasHidden');
  const sources = ['sum', 'depth'].map((name) => gl.getUniformLocation(resolve, name));

  const drawMeshes = (
    stage: Stage,
    meshes: CaptureViewMeshes | null,
    clipFromCapture: Float32Array,
    eye: Float32Array,
    nearer: number,
  ): void => {
    if (!meshes) return;
    stage.use(capture, clipFromCapture, eye, nearer);
    gl.bindVertexArray(meshes.vertexArray);
    for (let i = 0; i < nearest.count; i++) {
      const index = nearest.views[i] ?? 0;
      const mesh = meshes.views[index];
      if (!mesh) continue;
      gl.uniform1i(stage.view, index);
      gl.uniform2f(stage.mapSize, 2 * mesh.widthPx, 2 * mesh.heightPx);
      gl.drawElements(gl.TRIANGLES, mesh.indexCount, gl.UNSIGNED_INT, 4 * mesh.firstIndex);
    }
  };
  const drawPlace = (clipFromCapture: Float32Array, eye: Float32Array): void => {
    depth.place.use(capture, clipFromCapture, eye, 0);
    gl.bindVertexArray(capture.vertexArray);
    gl.drawElements(gl.TRIANGLES, capture.indexCount, gl.UNSIGNED_INT, 0);
  };
  /** Writes what the depth meshes show, with a factor times its depth. */
  const drawSum = (x: number, y: number, factor: number): void => {
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.ALWAYS);
    gl.depthMask(true);
    gl.useProgram(resolve);
    gl.uniform2i(origin, x, y);
    gl.uniform1f(depthFactor, factor);
    gl.uniform1i(hasHidden, hidden ? 1 : 0);
    bindSource(gl, 0, buffer.sum, sources[0]);
    bindSource(gl, 1, buffer.depth, sources[1]);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
  return {
    draw: (clipFromCapture, eye, forward, target, excluded) => {
      const { framebuffer, viewport } = target;
      const { x, y, widthPx, heightPx } = viewport;
      nearest.choose(eye, forward, excluded);
      buffer.grow(widthPx, heightPx);
      setPassState(gl, buffer.framebuffer, null, 0, 0, widthPx, heightPx);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.LEQUAL);
      gl.depthMask(true);
      gl.clearColor(0, 0, 0, 0);
      gl.clearDepth(1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.colorMask(false, false, false, false);
      if (hidden) gl.depthRange(0, 0.5);
      drawMeshes(depth.view, depthMeshes, clipFromCapture, eye, 0);
      drawPlace(clipFromCapture, eye);
      gl.colorMask(true, true, true, true);
      gl.depthMask(false);
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE);
      drawMeshes(color, depthMeshes, clipFromCapture, eye, SOFTNESS);
      if (hidden) {
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        // Behind all else, so that they show only where nothing is.
        gl.depthRange(0.5, 1);
        drawMeshes(hidden.stage, hidden.meshes, clipFromCapture, eye, 0);
        gl.depthRange(0, 1);
      }

      setPassState(gl, framebuffer, null, x, y, widthPx, heightPx);
      // At first as near as possible, so that the lumigraph costs only what the depth meshes leave.
      drawSum(x, y, 0);
      rest.draw(clipFromCapture, eye, forward, target, excluded);
      gl.colorMask(false, false, false, false);
      drawSum(x, y, 1);
      gl.colorMask(true, true, true, true);
      // The textures are targets again in the next frame.
      bindSource(gl, 0, null, null);
      bindSource(gl, 1, null, null);
      gl.depthFunc(gl.LESS);
      gl.disable(gl.DEPTH_TEST);
    },
    dispose: () => {
      buffer.dispose();
      rest.dispose();
      for (const { program } of [depth.view, depth.place, color, ...(hidden ? [hidden.stage] : [])]) gl.deleteProgram(program);
      gl.deleteProgram(resolve);
    },
  };
}

interface Stage {
  readonly program: WebGLProgram;
  readonly view: WebGLUniformLocation | null;
  readonly mapSize: WebGLUniformLocation | null;
  /** Activates the program. */
  use(capture: CaptureAsset, clipFromCapture: Float32Array, eye: Float32Array, nearer: number): void;
}

function createStage(gl: WebGL2RenderingContext, vertex: string, fragment: string): Stage {
  const program = linkProgram(gl, vertex, fragment);
  const activate = createCaptureUse(gl, program);
  const uniform = (name: string): WebGLUniformLocation | null => gl.getUniformLocation(program, name);
  const [matrix, eyeAt, share] = [uniform('clipFromCapture'), uniform('eye'), uniform('nearer')];
  return {
    program,
    view: uniform('view'),
    mapSize: uniform('mapSize'),
    use: (capture, clipFromCapture, eye, nearer) => {
      activate(capture);
      gl.uniformMatrix4fv(matrix ?? null, false, clipFromCapture);
      gl.uniform3fv(eyeAt ?? null, eye);
      gl.uniform1f(share ?? null, nearer);
    },
  };
}

function bindSource(
  gl: WebGL2RenderingContext,
  unit: number,
  texture: WebGLTexture | null,
  uniform: WebGLUniformLocation | null | undefined,
): void {
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  if (texture === null) return;
  gl.bindSampler(unit, null);
  gl.uniform1i(uniform ?? null, unit);
}
