import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import { CAPTURE_GLSL, type CaptureUsed, createCaptureUse } from '../../../../nodes/kit/capture-glsl.ts';
import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import type { PartedWork } from '../../gl/spread-work.ts';

const VERTEX = /* glsl */ `#version 300 es
precision highp float;
precision highp sampler2DArray;
${CAPTURE_GLSL}
layout(location = 0) in vec3 position;
uniform int view;
out float depthM;
void main() {
  vec3 p = projectInto(view, position);
  float nearM = farM * 0.001;
  depthM = p.z;
  gl_Position = vec4(2.0 * p.xy - p.z, (p.z * (farM + nearM) - 2.0 * farM * nearM) / (farM - nearM), p.z);
}`;

const FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
uniform float farM;
in float depthM;
void main() { gl_FragDepth = depthM / farM; }`;

/** Triangles of a part: about 30 ms without a GPU. */
export const TRIANGLES_PER_PART = 100_000;

/** The mesh whose depth maps are drawn, with what their shaders read. */
export type DrawnMesh = CaptureUsed & Pick<CaptureAsset, 'vertexArray' | 'indexCount'>;

/** Draws depth maps of single views. */
export interface DepthDrawing {
  /** Draws the depth of a mesh from the camera of a view, over `farM`, which is even over all distances. */
  draw(mesh: DrawnMesh, view: number): PartedWork;
  dispose(): void;
}

/** Creates the drawing of depth maps of pinhole cameras. */
export function createDepthDrawing(objects: GlObjects, [widthPx, heightPx]: readonly [number, number]): DepthDrawing {
  const { gl } = objects;
  const program = linkProgram(gl, VERTEX, FRAGMENT);
  const use = createCaptureUse(gl, program);
  const index = gl.getUniformLocation(program, 'view');
  const framebuffer = objects.createFramebuffer();
  return {
    draw: function* (mesh, view) {
      const { indexCount } = mesh;
      for (let first = 0; first < indexCount; first += 3 * TRIANGLES_PER_PART) {
        const count = Math.min(3 * TRIANGLES_PER_PART, indexCount - first);
        beginDepth(gl, framebuffer, mesh.vertexArray, widthPx, heightPx);
        gl.drawBuffers([gl.NONE]);
        gl.readBuffer(gl.NONE);
        gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, mesh.depths, 0, view);
        if (first === 0) gl.clear(gl.DEPTH_BUFFER_BIT);
        use(mesh);
        drawDepthPart(gl, index, view, first, count);
        yield count / (3 * TRIANGLES_PER_PART);
      }
    },
    dispose: () => {
      objects.deleteFramebuffer(framebuffer);
      gl.deleteProgram(program);
    },
  };
}

/** Sets what drawing nearest depths to a framebuffer depends on. */
export function beginDepth(
  gl: WebGL2RenderingContext,
  framebuffer: WebGLFramebuffer,
  vertexArray: WebGLVertexArrayObject,
  widthPx: number,
  heightPx: number,
): void {
  setPassState(gl, framebuffer, vertexArray, 0, 0, widthPx, heightPx);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LESS);
  gl.depthMask(true);
  gl.depthRange(0, 1);
  gl.clearDepth(1);
}

/** Draws indices by the active program, then leaves the state as other drawings expect it. The depth maps are written, not read. */
export function drawDepthPart(
  gl: WebGL2RenderingContext,
  viewIndex: WebGLUniformLocation | null,
  view: number,
  first: number,
  count: number,
): void {
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
  gl.uniform1i(viewIndex, view);
  gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
  gl.disable(gl.DEPTH_TEST);
  gl.bindVertexArray(null);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
}
