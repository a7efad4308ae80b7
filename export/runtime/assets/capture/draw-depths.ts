import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import { CAPTURE_GLSL, createCaptureUse } from '../../../../nodes/kit/capture-glsl.ts';
import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';

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

/** Draws the depth of the mesh from each pinhole camera, over `farM`, which is even over all distances. */
export function drawDepths(objects: GlObjects, capture: CaptureAsset, [widthPx, heightPx]: readonly [number, number]): void {
  const { gl } = objects;
  const { vertexArray, indexCount, depths, viewCount, panoramas } = capture;
  const program = linkProgram(gl, VERTEX, FRAGMENT);
  const use = createCaptureUse(gl, program);
  const framebuffer = objects.createFramebuffer();
  setPassState(gl, framebuffer, vertexArray, 0, 0, widthPx, heightPx);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LESS);
  gl.depthMask(true);
  gl.depthRange(0, 1);
  gl.clearDepth(1);
  use(capture);
  // The depth maps are written, not read.
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
  const view = gl.getUniformLocation(program, 'view');
  gl.drawBuffers([gl.NONE]);
  gl.readBuffer(gl.NONE);
  for (let layer = 0; layer < viewCount; layer++) {
    if (panoramas.has(layer)) continue;
    gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, depths, 0, layer);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.uniform1i(view, layer);
    gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
  }
  gl.disable(gl.DEPTH_TEST);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  objects.deleteFramebuffer(framebuffer);
  gl.deleteProgram(program);
}
