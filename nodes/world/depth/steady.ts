import { multiplyMatrices, setInverse3 } from '../../kit/matrices.ts';
import type { RoomDepth, ViewFrame } from '../../kit/session.ts';
import type { DepthDrawing, DepthImage } from './drawing.ts';

/** Smooths the measurements of a sensor over time, for one view. */
export interface Steadier {
  /**
   * Returns the measured depth, blended with earlier measurements, whose weight falls to 1/e after `smoothingS`. The texture is valid until
   * the call after the next.
   */
  steady(depth: RoomDepth, view: ViewFrame, smoothingS: number, deltaS: number): WebGLTexture;
  forget(): void;
  dispose(): void;
}

/**
 * Creates a temporal filter. Only noise is smoothed: a change of more than 3 cm plus 1.5 % of the distance is a movement and applies at
 * once, so that moving objects leave no trail. Earlier measurements are reprojected from the earlier pose of the view.
 */
export function createSteadier(gl: WebGL2RenderingContext, drawing: DepthDrawing): Steadier {
  const pass = drawing.link(STEADY, ['now', 'past']);
  const uniforms = {
    viewUvFromUv: pass.uniform('viewUvFromUv'),
    pastUvFromViewUv: pass.uniform('pastUvFromViewUv'),
    lens: pass.uniform('lens'),
    pastLens: pass.uniform('pastLens'),
    pastFromView: pass.uniform('pastFromView'),
    keep: pass.uniform('keep'),
  };
  const viewUvFromUv = new Float32Array(9);
  const pastFromView = new Float32Array(16);
  const past = { uvFromViewUv: new Float32Array(9), clipFromView: new Float32Array(16), viewFromWorld: new Float32Array(16) };
  let front: DepthImage | null = null;
  let back: DepthImage | null = null;
  let isKnown = false;

  const resize = (widthPx: number, heightPx: number): void => {
    for (const image of [front, back]) if (image) drawing.free(image);
    front = drawing.createImage(widthPx, heightPx);
    back = drawing.createImage(widthPx, heightPx);
    isKnown = false;
  };
  return {
    steady: (depth, view, smoothingS, deltaS) => {
      if (front?.widthPx !== depth.widthPx || front.heightPx !== depth.heightPx) resize(depth.widthPx, depth.heightPx);
      const target = back;
      if (!target || !front) return depth.texture;
      setInverse3(viewUvFromUv, depth.uvFromViewUv);
      multiplyMatrices(pastFromView, past.viewFromWorld, view.worldFromView);
      drawing.begin(target, pass);
      drawing.texture(0, depth.texture, 'nearest');
      drawing.texture(1, front.texture, 'nearest');
      gl.uniformMatrix3fv(uniforms.viewUvFromUv, false, viewUvFromUv);
      gl.uniformMatrix3fv(uniforms.pastUvFromViewUv, false, past.uvFromViewUv);
      setLens(gl, uniforms.lens, view.clipFromView);
      setLens(gl, uniforms.pastLens, past.clipFromView);
      gl.uniformMatrix4fv(uniforms.pastFromView, false, pastFromView);
      gl.uniform1f(uniforms.keep, isKnown ? Math.exp(-deltaS / smoothingS) : 0);
      drawing.draw();
      past.uvFromViewUv.set(depth.uvFromViewUv);
      past.clipFromView.set(view.clipFromView);
      past.viewFromWorld.set(view.viewFromWorld);
      back = front;
      front = target;
      isKnown = true;
      return target.texture;
    },
    forget: () => {
      isKnown = false;
    },
    dispose: () => {
      for (const image of [front, back]) if (image) drawing.free(image);
    },
  };
}

/** Sets a uniform to the scale and offset of x and y of a projection. */
function setLens(gl: WebGL2RenderingContext, location: WebGLUniformLocation | null, p: Float32Array): void {
  gl.uniform4f(location, p[0] ?? 1, p[5] ?? 1, p[8] ?? 0, p[9] ?? 0);
}

const STEADY = /* glsl */ `
uniform sampler2D now;
uniform sampler2D past;
uniform mat3 viewUvFromUv;
uniform mat3 pastUvFromViewUv;
uniform vec4 lens;
uniform vec4 pastLens;
uniform mat4 pastFromView;
uniform float keep;
float meters() {
  float m = texelFetch(now, ivec2(gl_FragCoord.xy), 0).r;
  if (m <= 0.0 || keep <= 0.0) return m;
  vec2 ndc = place(viewUvFromUv, uv) * 2.0 - 1.0;
  vec3 then = (pastFromView * vec4((ndc + lens.zw) / lens.xy * m, -m, 1.0)).xyz;
  if (then.z >= 0.0) return m;
  vec2 thenNdc = pastLens.xy * then.xy / -then.z - pastLens.zw;
  vec2 at = place(pastUvFromViewUv, thenNdc * 0.5 + 0.5);
  if (!isInside(at)) return m;
  // Interpolated, because the nearest sample would drag slopes along as the view rotates; samples of other surfaces are ignored.
  float noiseM = 0.03 + 0.015 * m;
  ivec2 last = textureSize(past, 0) - 1;
  vec2 texel = at * vec2(last + 1) - 0.5;
  ivec2 low = ivec2(floor(texel));
  vec2 part = texel - vec2(low);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 4; i++) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    float measured = texelFetch(past, clamp(low + corner, ivec2(0), last), 0).r;
    vec2 near = mix(1.0 - part, part, vec2(corner));
    if (measured > 0.0 && abs(measured + then.z) < 2.0 * noiseM) sum += vec2(measured, 1.0) * near.x * near.y;
  }
  if (sum.y <= 0.0) return m;
  float change = sum.x / sum.y + then.z;
  return abs(change) < noiseM ? m + keep * change : m;
}`;
