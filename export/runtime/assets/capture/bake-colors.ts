import type { CaptureMesh } from '../../../../nodes/kit/capture.ts';
import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import { CAPTURE_GLSL, type CaptureUsed, createCaptureUse } from '../../../../nodes/kit/capture-glsl.ts';
import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { PartedWork } from '../../gl/spread-work.ts';
import { fillUnseen } from './fill-unseen.ts';

const VERTEX = /* glsl */ `#version 300 es
precision highp float;
precision highp sampler2DArray;
${CAPTURE_GLSL}
layout(location = 0) in vec3 position;
uniform int viewCount;
uniform int excluded;
flat out highp uint color;
void main() {
  vec4 sum = vec4(0.0);
  for (int view = 0; view < viewCount; view++) {
    if (view == excluded || !isLoaded(view)) continue;
    vec3 p = projectInto(view, position);
    if (p.z <= 0.0) continue;
    vec2 uv = p.xy / p.z;
    float weight = edgeOf(view, uv);
    if (weight <= 0.0) continue;
    weight *= seenBy(view, uv, p.z) / p.z;
    sum += weight * vec4(textureLod(photos, vec3(uv, view), 0.0).rgb, 1.0);
  }
  uvec4 bytes = uvec4(sum.a > 0.0 ? round(vec4(sum.rgb / sum.a, 1.0) * 255.0) : vec4(0.0));
  color = bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;
  gl_Position = vec4(0.0);
}`;

const FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
void main() {}`;

/** Vertices times views of a part: about 50 ms without a GPU. */
const VERTEX_VIEWS_PER_PART = 1_000_000;

/** What the colors of a mesh are computed from: its form on the GPU, and its photographs and depth maps. */
type Baked = CaptureUsed & Pick<CaptureAsset, 'vertexArray' | 'viewCount'>;

/**
 * The color of each vertex: the mean of the photographs that see it, the nearer ones more. A vertex that none sees has the mean of its
 * neighbors. The colors are read back after a part of their own, so that nothing waits for the GPU if the parts wait for it.
 *
 * @param excluded View whose photograph is left out; -1: none.
 * @returns RGBA, 8 bits.
 */
export function* bakeColors(
  gl: WebGL2RenderingContext,
  capture: Baked,
  { positions, indices }: CaptureMesh,
  excluded = -1,
): PartedWork<Uint8Array<ArrayBuffer>> {
  const { vertexArray, viewCount } = capture;
  const count = positions.length / 3;
  const most = Math.ceil(VERTEX_VIEWS_PER_PART / viewCount);
  const program = linkProgram(gl, VERTEX, FRAGMENT, ['color']);
  const use = createCaptureUse(gl, program);
  const [views, without] = ['viewCount', 'excluded'].map((name) => gl.getUniformLocation(program, name));
  const feedback = gl.createTransformFeedback();
  const buffer = gl.createBuffer();
  try {
    gl.bindBuffer(gl.COPY_READ_BUFFER, buffer);
    gl.bufferData(gl.COPY_READ_BUFFER, 4 * count, gl.STREAM_READ);
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    for (let first = 0; first < count; first += most) {
      const part = Math.min(most, count - first);
      setPassState(gl, null, vertexArray, 0, 0, 1, 1);
      use(capture);
      gl.uniform1i(views ?? null, viewCount);
      gl.uniform1i(without ?? null, excluded);
      gl.bindBuffer(gl.ARRAY_BUFFER, null);
      gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
      gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, buffer, 4 * first, 4 * part);
      gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
      gl.enable(gl.RASTERIZER_DISCARD);
      gl.beginTransformFeedback(gl.POINTS);
      gl.drawArrays(gl.POINTS, first, part);
      gl.endTransformFeedback();
      gl.disable(gl.RASTERIZER_DISCARD);
      gl.bindVertexArray(null);
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
      gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
      yield 1;
    }
    const colors = new Uint8Array(4 * count);
    gl.bindBuffer(gl.COPY_READ_BUFFER, buffer);
    gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, colors);
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    yield* fillUnseen(colors, indices);
    return colors;
  } finally {
    gl.deleteTransformFeedback(feedback);
    gl.deleteBuffer(buffer);
    gl.deleteProgram(program);
  }
}
