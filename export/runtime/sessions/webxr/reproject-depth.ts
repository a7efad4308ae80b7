import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { multiplyMatrices, setInverse3 } from '../../../../nodes/kit/matrices.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import { allocateTexture } from '../../gl/allocate-texture.ts';
import type { MutableRoomDepth } from '../session-frame.ts';

/** Pose and projection of the depth camera, column-major 4×4. */
export interface DepthGeometry {
  readonly worldFromDepth: Float32Array;
  readonly clipFromDepth: Float32Array;
}

/** The view to reproject depth to. */
export interface TargetView {
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  readonly viewFromWorld: Float32Array;
}

/** Reprojects depth from a depth camera with another pose or lens to the view (Depth Sensing, `matchDepthView: false`). */
export interface DepthReprojector {
  /** `depth` is indexed by UV of the depth camera's view. Returns the same object in each call, aligned with the view. */
  reproject(depth: MutableRoomDepth, from: DepthGeometry, view: TargetView): MutableRoomDepth;
  dispose(): void;
}

/** Maximum quads per side. Larger depth images are sampled at a lower resolution; a grid of this size has 393,216 vertices. */
const MAX_QUADS = 256;

/**
 * Draws the depth samples as a grid of quads from the view, with a depth test. Quads with an unknown corner are left out. A quad that spans
 * a foreground and a background surface would be a wall that does not exist, so it takes the depth of its farthest corner: areas hidden
 * from the depth camera count as background. Returns null if the GPU cannot render to float textures.
 */
export function createDepthReprojector(gl: WebGL2RenderingContext): DepthReprojector | null {
  const format = gl.getExtension('EXT_color_buffer_float') ? gl.R32F : gl.getExtension('EXT_color_buffer_half_float') ? gl.R16F : null;
  if (format === null) return null;
  const program = linkProgram(gl, VERTEX, FRAGMENT);
  const uniforms = {
    step: gl.getUniformLocation(program, 'sampleStep'),
    depthFromUv: gl.getUniformLocation(program, 'depthFromUv'),
    lens: gl.getUniformLocation(program, 'lens'),
    viewFromDepth: gl.getUniformLocation(program, 'viewFromDepth'),
    clipFromView: gl.getUniformLocation(program, 'clipFromView'),
  };
  const framebuffer = gl.createFramebuffer();
  const vertexArray = gl.createVertexArray();
  const nearness = gl.createRenderbuffer();
  const depthFromUv = new Float32Array(9);
  const viewFromDepth = new Float32Array(16);
  let seen: MutableRoomDepth | null = null;

  const resize = (widthPx: number, heightPx: number): MutableRoomDepth => {
    gl.deleteTexture(seen?.texture ?? null);
    const texture = allocateTexture(gl, gl.createTexture(), format, gl.NEAREST, widthPx, heightPx);
    gl.bindRenderbuffer(gl.RENDERBUFFER, nearness);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, widthPx, heightPx);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, nearness);
    return { texture, widthPx, heightPx, uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1), worldFromDepth: new Float32Array(16) };
  };
  return {
    reproject: (depth, from, view) => {
      const { widthPx, heightPx } = depth;
      if (seen?.widthPx !== widthPx || seen.heightPx !== heightPx) seen = resize(widthPx, heightPx);
      setInverse3(depthFromUv, depth.uvFromViewUv);
      multiplyMatrices(viewFromDepth, view.viewFromWorld, from.worldFromDepth);
      setPassState(gl, framebuffer, vertexArray, 0, 0, widthPx, heightPx);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.LEQUAL);
      gl.depthMask(true);
      gl.clearColor(0, 0, 0, 0);
      gl.clearDepth(1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.useProgram(program);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, depth.texture);
      gl.bindSampler(0, null);
      const step = Math.ceil(Math.max(widthPx, heightPx) / MAX_QUADS);
      const p = from.clipFromDepth;
      gl.uniform1i(uniforms.step, step);
      gl.uniformMatrix3fv(uniforms.depthFromUv, false, depthFromUv);
      gl.uniform4f(uniforms.lens, p[0] ?? 1, p[5] ?? 1, p[8] ?? 0, p[9] ?? 0);
      gl.uniformMatrix4fv(uniforms.viewFromDepth, false, viewFromDepth);
      gl.uniformMatrix4fv(uniforms.clipFromView, false, view.clipFromView);
      gl.drawArrays(gl.TRIANGLES, 0, 6 * Math.ceil((widthPx - 1) / step) * Math.ceil((heightPx - 1) / step));
      gl.disable(gl.DEPTH_TEST);
      gl.bindVertexArray(null);
      seen.worldFromDepth.set(view.worldFromView);
      return seen;
    },
    dispose: () => {
      gl.deleteTexture(seen?.texture ?? null);
      gl.deleteRenderbuffer(nearness);
      gl.deleteFramebuffer(framebuffer);
      gl.deleteVertexArray(vertexArray);
      gl.deleteProgram(program);
    },
  };
}

/** Whether two rigid matrices are equal within the browser’s rounding, which moves a point by about a tenth of a millimeter. */
export function isSameMatrix(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  for (let i = 0; i < 16; i++) if (Math.abs((a[i] ?? 0) - (b[i] ?? 0)) > 1e-4) return false;
  return true;
}

/** Whether two projections have the same scale and shift. Near and far planes do not matter. */
export function isSameLens(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  return LENS.every((i) => Math.abs((a[i] ?? 0) - (b[i] ?? 0)) <= 1e-4);
}

/** Indices of scale and shift of x and y in a column-major projection. */
const LENS: readonly number[] = [0, 5, 8, 9];

/**
 * Vertex shader that places the depth samples in the view, as quads. The outermost samples are moved to the edge of the image. A quad whose
 * corners differ by more than `GAP` times the distance spans two surfaces. A quad with an unknown corner, or one behind the eye, is moved
 * outside the clip volume. Comments stand here because pages ship the text of a shader as it is.
 */
const VERTEX = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D room;
uniform int sampleStep;
uniform mat3 depthFromUv;
uniform vec4 lens;
uniform mat4 viewFromDepth;
uniform mat4 clipFromView;
out float viewM;
flat out float farthestM;
const float GAP = 0.1;
ivec2 last;

vec3 inView(ivec2 at) {
  float m = texelFetch(room, at, 0).r;
  vec2 size = vec2(last + 1);
  vec2 uv = mix(mix((vec2(at) + 0.5) / size, vec2(0.0), equal(at, ivec2(0))), vec2(1.0), equal(at, last));
  vec3 placed = depthFromUv * vec3(uv, 1.0);
  vec2 ndc = placed.xy / placed.z * 2.0 - 1.0;
  return m > 0.0 ? (viewFromDepth * vec4((ndc + lens.zw) / lens.xy * m, -m, 1.0)).xyz : vec3(0.0);
}

void main() {
  last = textureSize(room, 0) - 1;
  int columns = (last.x + sampleStep - 1) / sampleStep;
  int mesh = gl_VertexID / 6;
  ivec2 a = ivec2(mesh % columns, mesh / columns) * sampleStep;
  ivec2 d = min(a + sampleStep, last);
  bool isUpper = gl_VertexID % 6 >= 3;
  vec3 p = inView(isUpper ? d : a);
  vec3 q = inView(ivec2(d.x, a.y));
  vec3 r = inView(ivec2(a.x, d.y));
  vec3 depths = -vec3(p.z, q.z, r.z);
  float nearestM = min(min(depths.x, depths.y), depths.z);
  farthestM = max(max(depths.x, depths.y), depths.z);
  int corner = gl_VertexID % 3;
  vec3 own = corner == 0 ? p : corner == 1 ? q : r;
  viewM = -own.z;
  gl_Position = clipFromView * vec4(own, 1.0);
  if (nearestM <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  } else if (farthestM - nearestM > GAP * nearestM) {
    vec4 behind = clipFromView * vec4(own.xy, -farthestM, 1.0);
    gl_Position.z = behind.z / behind.w * gl_Position.w;
  } else {
    farthestM = 0.0;
  }
}
`;

const FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
in float viewM;
flat in float farthestM;
out vec4 color;
void main() { color = vec4(farthestM > 0.0 ? farthestM : viewM, 0.0, 0.0, 1.0); }
`;
