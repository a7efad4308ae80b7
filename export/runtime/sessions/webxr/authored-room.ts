import { linkProgram } from '../../../../nodes/kit/link-program.ts';
import { setPassState } from '../../../../nodes/kit/pass-state.ts';
import type { CameraImage } from '../../../../nodes/kit/session.ts';
import { allocateTexture } from '../../gl/allocate-texture.ts';
import { COPY_SHADER } from '../../gl/copy-shader.ts';
import { MAX_VIEWS } from '../../targets/target.ts';
import type { MutableCameraImage, MutableView } from '../session-frame.ts';

/**
 * Replaces the visitor's room in VR: a floor with a line per meter, a bright horizon and a softer sky, which show scale and orientation. It
 * is the camera image of each view, so filters apply to it.
 */
export interface AuthoredRoom {
  /** Draws the room for the current pose and projection of the view. */
  image(view: MutableView, index: number): CameraImage;
  dispose(): void;
}

/** Resolution relative to the view: only the nearby lines are sharp. */
const SCALE = 0.5;
const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** Creates a room whose floor is at y = 0 in world space. */
export function createAuthoredRoom(gl: WebGL2RenderingContext): AuthoredRoom {
  const program = linkProgram(gl, COPY_SHADER.vertex, FRAGMENT);
  const lens = gl.getUniformLocation(program, 'lens');
  const worldFromView = gl.getUniformLocation(program, 'worldFromView');
  const framebuffer = gl.createFramebuffer();
  const vertexArray = gl.createVertexArray();
  const images: (MutableCameraImage | null)[] = Array.from({ length: MAX_VIEWS }, () => null);

  const fitted = (index: number, widthPx: number, heightPx: number): MutableCameraImage => {
    const known = images[index];
    if (known?.widthPx === widthPx && known.heightPx === heightPx) return known;
    if (known) gl.deleteTexture(known.texture);
    const texture = allocateTexture(gl, gl.createTexture(), gl.RGBA8, gl.LINEAR, widthPx, heightPx);
    const image = { texture, widthPx, heightPx, uvFromViewUv: UPRIGHT };
    images[index] = image;
    return image;
  };
  return {
    image: (view, index) => {
      const { viewport, clipFromView: p } = view;
      const image = fitted(index, Math.max(1, Math.ceil(viewport.widthPx * SCALE)), Math.max(1, Math.ceil(viewport.heightPx * SCALE)));
      setPassState(gl, framebuffer, vertexArray, 0, 0, image.widthPx, image.heightPx);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, image.texture, 0);
      gl.useProgram(program);
      gl.uniform4f(lens, p[0] ?? 1, p[5] ?? 1, p[8] ?? 0, p[9] ?? 0);
      gl.uniformMatrix4fv(worldFromView, false, view.worldFromView);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.bindVertexArray(null);
      return image;
    },
    dispose: () => {
      for (const image of images) gl.deleteTexture(image?.texture ?? null);
      gl.deleteFramebuffer(framebuffer);
      gl.deleteVertexArray(vertexArray);
      gl.deleteProgram(program);
    },
  };
}

/**
 * Draws the room. `lens` has the scale and shift of x and y in the projection, which may be off-axis. Colors are display-referred sRGB.
 * Lines are 16 mm wide and at least one pixel.
 */
const FRAGMENT = /* glsl */ `#version 300 es
precision highp float;
uniform vec4 lens;
uniform mat4 worldFromView;
in vec2 viewUv;
out vec4 color;
const vec3 HORIZON = vec3(0.86, 0.87, 0.88);
const vec3 SKY = vec3(0.56, 0.62, 0.70);
const vec3 FLOOR = vec3(0.64, 0.64, 0.65);
const vec3 LINE = vec3(0.50, 0.51, 0.53);
float lines(vec2 at, vec2 footprint) {
  vec2 width = max(vec2(0.008), footprint);
  vec2 away = abs(fract(at - 0.5) - 0.5);
  vec2 hit = (1.0 - smoothstep(vec2(0.0), width, away)) * min(vec2(1.0), vec2(0.008) / width + 0.25);
  return max(hit.x, hit.y);
}
void main() {
  vec3 inView = vec3((viewUv * 2.0 - 1.0 + lens.zw) / lens.xy, -1.0);
  vec3 ray = normalize(mat3(worldFromView) * inView);
  vec3 eye = worldFromView[3].xyz;
  float above = eye.y;
  float down = max(-ray.y, 1e-4);
  vec2 at = eye.xz + ray.xz * (above / down);
  vec2 footprint = fwidth(at);
  float distance = length(at - eye.xz);
  float near = exp(-0.09 * distance);
  vec3 ground = mix(HORIZON, mix(FLOOR, LINE, lines(at, footprint) * near), near);
  vec3 sky = mix(HORIZON, SKY, smoothstep(0.0, 0.8, ray.y));
  color = vec4(ray.y < 0.0 && above > 0.0 ? ground : sky, 1.0);
}
`;
