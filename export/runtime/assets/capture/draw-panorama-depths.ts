import { CAPTURE_GLSL, createCaptureUse } from '../../../../nodes/kit/capture-glsl.ts';
import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { beginDepth, type DepthDrawing, drawDepthPart, TRIANGLES_PER_PART } from './draw-depths.ts';

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

/** Creates the drawing of depth maps of 360° cameras, which are distances, by the faces of a cube. */
export function createPanoramaDepthDrawing(objects: GlObjects, [widthPx, heightPx]: readonly [number, number]): DepthDrawing {
  const { gl } = objects;
  const sidePx = Math.ceil(widthPx / 3);
  const face = objects.createTexture();
  const faceTarget = objects.createFramebuffer();
  const target = objects.createFramebuffer();
  const drawing = linkProgram(gl, FACE_VERTEX, FACE_FRAGMENT);
  const use = createCaptureUse(gl, drawing);
  const index = gl.getUniformLocation(drawing, 'view');
  const faceAxes = gl.getUniformLocation(drawing, 'faceFromCamera');
  const copying = createCopying(gl, face);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, face);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, sidePx, sidePx);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  attach(gl, faceTarget, () => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, face, 0));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return {
    draw: function* (mesh, view) {
      const { indexCount } = mesh;
      for (const axes of FACES) {
        for (let first = 0; first < indexCount; first += 3 * TRIANGLES_PER_PART) {
          const count = Math.min(3 * TRIANGLES_PER_PART, indexCount - first);
          beginDepth(gl, faceTarget, mesh.vertexArray, sidePx, sidePx);
          if (first === 0) gl.clear(gl.DEPTH_BUFFER_BIT);
          use(mesh);
          gl.uniformMatrix3fv(faceAxes, false, axes);
          drawDepthPart(gl, index, view, first, count);
          yield count / (3 * TRIANGLES_PER_PART);
        }
        attach(gl, target, () => gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, mesh.depths, 0, view));
        setPassState(gl, target, null, 0, 0, widthPx, heightPx);
        gl.enable(gl.DEPTH_TEST);
        gl.depthMask(true);
        gl.depthFunc(gl.ALWAYS);
        copying.copy(axes);
        gl.depthFunc(gl.LESS);
        gl.disable(gl.DEPTH_TEST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      }
    },
    dispose: () => {
      for (const framebuffer of [faceTarget, target]) objects.deleteFramebuffer(framebuffer);
      objects.deleteTexture(face);
      for (const program of [drawing, copying.program]) gl.deleteProgram(program);
    },
  };
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
