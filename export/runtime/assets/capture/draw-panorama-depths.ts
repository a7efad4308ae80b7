import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import { CAPTURE_GLSL, createCaptureUse } from '../../../../nodes/kit/capture-glsl.ts';
import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';

const HEAD = `#version 300 es
precision highp float;
precision highp sampler2DArray;
uniform mat3 faceFromCamera;
`;

/** Draws the mesh on a face of a cube around the camera. Triangles may be larger than a face, and a panorama bends their edges. */
const FACE_VERTEX = `${HEAD}${CAPTURE_GLSL}
layout(location = 0) in vec3 position;
uniform int view;
out vec3 along;
void main() {
  along = alongAxes(view, position);
  vec3 p = faceFromCamera * along;
  float nearM = farM * 0.001;
  gl_Position = vec4(p.xy, (p.z * (farM + nearM) - 2.0 * farM * nearM) / (farM - nearM), p.z);
}`;

const FACE_FRAGMENT = `#version 300 es
precision highp float;
uniform float farM;
in vec3 along;
void main() { gl_FragDepth = length(along) / farM; }`;

const SCREEN_VERTEX = `#version 300 es
out vec2 uv;
void main() {
  uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}`;

/** Copies the part of a panorama that a face shows. */
const AROUND_FRAGMENT = `${HEAD}
uniform highp sampler2D face;
in vec2 uv;
void main() {
  vec2 angles = (uv - 0.5) * vec2(6.2831853, 3.14159265);
  vec3 p = faceFromCamera * vec3(sin(angles.x) * cos(angles.y), sin(angles.y), cos(angles.x) * cos(angles.y));
  // A face is a little larger than its part, so that rounding leaves no gap between two of them.
  if (p.z <= 0.0 || max(abs(p.x), abs(p.y)) > p.z * 1.001) discard;
  gl_FragDepth = texture(face, p.xy / p.z * 0.5 + 0.5).r;
}`;

/** Axes of the six faces in those of the camera (right, up, forward), column-major, so that each face has its direction as z. */
const FACES = [
  [1, 0, 0, 0, 1, 0, 0, 0, 1],
  [0, 0, 1, 0, 1, 0, -1, 0, 0],
  [-1, 0, 0, 0, 1, 0, 0, 0, -1],
  [0, 0, -1, 0, 1, 0, 1, 0, 0],
  [1, 0, 0, 0, 0, 1, 0, -1, 0],
  [1, 0, 0, 0, 0, -1, 0, 1, 0],
].map((axes) => Float32Array.from(axes));

/** Draws the distance of the mesh from each 360° camera over `farM`, by the faces of a cube. */
export function drawPanoramaDepths(objects: GlObjects, capture: CaptureAsset, [widthPx, heightPx]: readonly [number, number]): void {
  const { gl } = objects;
  const { vertexArray, indexCount, depths, panoramas } = capture;
  const sidePx = Math.ceil(widthPx / 3);
  const face = objects.createTexture();
  const faceTarget = objects.createFramebuffer();
  const target = objects.createFramebuffer();
  const drawing = linkProgram(gl, FACE_VERTEX, FACE_FRAGMENT);
  const activate = createCaptureUse(gl, drawing);
  const view = gl.getUniformLocation(drawing, 'view');
  const faceAxes = gl.getUniformLocation(drawing, 'faceFromCamera');
  const copying = createCopying(gl, face);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, face);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, sidePx, sidePx);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  attach(gl, faceTarget, () => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, face, 0));
  for (const layer of panoramas) {
    attach(gl, target, () => gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, depths, 0, layer));
    for (const axes of FACES) {
      setPassState(gl, faceTarget, vertexArray, 0, 0, sidePx, sidePx);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.LESS);
      gl.depthMask(true);
      gl.clearDepth(1);
      gl.clear(gl.DEPTH_BUFFER_BIT);
      activate(capture);
      // The depth maps are written, not read.
      gl.activeTexture(gl.TEXTURE2);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
      gl.uniform1i(view, layer);
      gl.uniformMatrix3fv(faceAxes, false, axes);
      gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);

      setPassState(gl, target, null, 0, 0, widthPx, heightPx);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      copying.copy(axes);
    }
  }
  gl.depthFunc(gl.LESS);
  gl.disable(gl.DEPTH_TEST);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  for (const framebuffer of [faceTarget, target]) objects.deleteFramebuffer(framebuffer);
  objects.deleteTexture(face);
  for (const program of [drawing, copying.program]) gl.deleteProgram(program);
}

/** Copies what a face shows to the bound framebuffer. */
function createCopying(gl: WebGL2RenderingContext, face: WebGLTexture) {
  const program = linkProgram(gl, SCREEN_VERTEX, AROUND_FRAGMENT);
  const faceAxes = gl.getUniformLocation(program, 'faceFromCamera');
  return {
    program,
    copy: (axes: Float32Array): void => {
      gl.useProgram(program);
      gl.uniformMatrix3fv(faceAxes, false, axes);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, face);
      gl.bindSampler(0, null);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    },
  };
}

function attach(gl: WebGL2RenderingContext, framebuffer: WebGLFramebuffer, texture: () => void): void {
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  texture();
  gl.drawBuffers([gl.NONE]);
  gl.readBuffer(gl.NONE);
}
