import type { CaptureMesh } from '../../capture.ts';
import type { CaptureAsset } from '../../capture-asset.ts';
import { createCaptureUse } from '../../capture-glsl.ts';
import { linkProgram } from '../../link-program.ts';
import type { Clock } from '../../runtime.ts';
import { type CaptureDrawing, drawTriangles } from '../capture-drawing.ts';
import { createNearestViews } from '../nearest-views.ts';
import { vertexNormals } from './vertex-normals.ts';
import { createVertexWindow, type VertexWindow } from './vertex-window.ts';
import { LIST_BYTES, MOST_KEPT_VIEWS, UPDATE_FRAGMENT, updateVertex, WINDOWED_FRAGMENT, WINDOWED_VERTEX } from './windowed-shaders.ts';

export interface WindowedDrawing extends CaptureDrawing {
  /** How many vertices got their weights in the last `draw`. */
  readonly updated: number;
}

/** The weights that one view of the session keeps. */
interface KeptWeights {
  readonly lists: WebGLBuffer;
  readonly vertexArray: WebGLVertexArrayObject;
  readonly eye: Float32Array;
  readonly views: Int32Array;
  viewCount: number;
  window: VertexWindow;
}

/**
 * Draws a capture as a lumigraph with weights per vertex, which are kept from frame to frame. Each frame computes those of a window that
 * slides over the vertices; all are computed within `frames` frames. Nothing is computed if the eye and the photographs stay. While the
 * clock is held, all are computed at once, which gives the image of a still eye after `frames` frames.
 *
 * @param blended Number of photographs per vertex, 1 to 4.
 *
 * @example
 * const drawing = createWindowedDrawing(gl, capture, 2, 30, ctx.clock);
 * drawing.draw(clipFromCapture, eye, forward, view);
 */
export function createWindowedDrawing(
  gl: WebGL2RenderingContext,
  capture: CaptureAsset,
  blended: number,
  frames: number,
  clock: Pick<Clock, 'deltaS' | 'held'>,
): WindowedDrawing {
  const program = linkProgram(gl, WINDOWED_VERTEX, WINDOWED_FRAGMENT);
  const updating = linkProgram(gl, updateVertex(blended), UPDATE_FRAGMENT, ['list']);
  const beginDraw = createCaptureUse(gl, program);
  const beginUpdate = createCaptureUse(gl, updating);
  const matrix = gl.getUniformLocation(program, 'clipFromCapture');
  const [drawn, updated] = [program, updating].map((one) => ({
    eye: gl.getUniformLocation(one, 'eye'),
    views: gl.getUniformLocation(one, 'views'),
    viewCount: gl.getUniformLocation(one, 'viewCount'),
  }));
  const nearest = createNearestViews(capture, MOST_KEPT_VIEWS);
  const feedback = gl.createTransformFeedback();
  const normals = gl.createBuffer();
  const vertices = gl.createVertexArray();
  const kept: KeptWeights[] = [];
  let mesh: CaptureMesh | null = null;
  let updatedCount = 0;

  const setViews = (at: typeof drawn, eye: Float32Array): void => {
    gl.uniform3fv(at?.eye ?? null, eye);
    gl.uniform1iv(at?.views ?? null, nearest.views);
    gl.uniform1i(at?.viewCount ?? null, nearest.count);
  };
  const countOf = (of: CaptureMesh): number => of.positions.length / 3;
  /** Gives weights the attributes of a mesh, and makes room for those of its vertices, which must be computed then. */
  const attach = (weights: KeptWeights, of: CaptureMesh): void => {
    const { positions, colors, indices } = capture.buffers;
    gl.bindVertexArray(weights.vertexArray);
    for (const place of [0, 1, 2]) gl.enableVertexAttribArray(place);
    gl.bindBuffer(gl.ARRAY_BUFFER, positions);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, colors);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, weights.lists);
    gl.bufferData(gl.ARRAY_BUFFER, LIST_BYTES * countOf(of), gl.DYNAMIC_COPY);
    gl.vertexAttribIPointer(2, 4, gl.UNSIGNED_INT, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bindVertexArray(null);
    weights.window = createVertexWindow(countOf(of), frames);
  };
  const add = (of: CaptureMesh): KeptWeights => {
    const weights: KeptWeights = {
      lists: gl.createBuffer(),
      vertexArray: gl.createVertexArray(),
      window: createVertexWindow(1, 1),
      eye: new Float32Array(3).fill(Number.NaN),
      views: new Int32Array(MOST_KEPT_VIEWS),
      viewCount: 0,
    };
    attach(weights, of);
    kept.push(weights);
    return weights;
  };
  const setMesh = (of: CaptureMesh): void => {
    mesh = of;
    gl.bindVertexArray(vertices);
    for (const place of [0, 1]) gl.enableVertexAttribArray(place);
    gl.bindBuffer(gl.ARRAY_BUFFER, capture.buffers.positions);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, normals);
    gl.bufferData(gl.ARRAY_BUFFER, vertexNormals(of), gl.STATIC_DRAW);
    gl.vertexAttribPointer(1, 3, gl.BYTE, true, 4, 0);
    gl.bindVertexArray(null);
    for (const weights of kept) attach(weights, of);
  };
  /** Computes the weights of the vertices in the window, if any. */
  const update = (weights: KeptWeights, eye: Float32Array): void => {
    if (isChanged(weights, eye, nearest)) {
      weights.eye.set(eye);
      weights.views.set(nearest.views);
      weights.viewCount = nearest.count;
      weights.window.restart();
    }
    const { window } = weights;
    updatedCount = 0;
    if (!window.advance(clock.deltaS, clock.held)) return;
    updatedCount = window.count;
    beginUpdate(capture);
    setViews(updated, eye);
    gl.bindVertexArray(vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
    gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, weights.lists, LIST_BYTES * window.first, LIST_BYTES * window.count);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, window.first, window.count);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.bindVertexArray(null);
  };
  return {
    get updated() {
      return updatedCount;
    },
    draw: (clipFromCapture, eye, forward, { viewIndex = 0 }, excluded) => {
      const of = capture.mesh;
      if (!of) return;
      nearest.choose(eye, forward, excluded);
      if (of !== mesh) setMesh(of);
      while (kept.length <= viewIndex) add(of);
      const weights = kept[viewIndex];
      if (!weights) return;
      update(weights, eye);
      beginDraw(capture);
      gl.uniformMatrix4fv(matrix, false, clipFromCapture);
      setViews(drawn, eye);
      drawTriangles(gl, weights.vertexArray, capture.indexCount);
    },
    dispose: () => {
      for (const { lists, vertexArray } of kept.splice(0)) {
        gl.deleteBuffer(lists);
        gl.deleteVertexArray(vertexArray);
      }
      gl.deleteVertexArray(vertices);
      gl.deleteBuffer(normals);
      gl.deleteTransformFeedback(feedback);
      for (const one of [program, updating]) gl.deleteProgram(one);
    },
  };
}

function isChanged(
  kept: KeptWeights,
  eye: Float32Array,
  { views, count }: { readonly views: Int32Array; readonly count: number },
): boolean {
  if (kept.viewCount !== count) return true;
  for (let axis = 0; axis < 3; axis++) if (kept.eye[axis] !== eye[axis]) return true;
  for (let i = 0; i < count; i++) if (kept.views[i] !== views[i]) return true;
  return false;
}
