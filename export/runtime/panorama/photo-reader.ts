import type { PanoramaShot } from '../../../nodes/kit/panorama/shot.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { LinkedShader } from '../../program/program.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import { COPY_SAMPLER, COPY_SHADER, COPY_UV } from '../gl/copy-shader.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { ProgramCache } from '../gl/program-cache.ts';
import { prepareReadback } from '../gl/upload.ts';

/** Reduces the camera image to the size of a photo: each pixel averages up to 6 × 6 pixels of the image, in linear light. */
const PHOTO_SHADER: LinkedShader = {
  id: 'scrim:photo',
  vertex: COPY_SHADER.vertex,
  fragment: /* glsl */ `#version 300 es
precision highp float;
uniform highp sampler2D ${COPY_SAMPLER};
uniform mat3 ${COPY_UV};
uniform ivec2 taps;
uniform vec2 sizePx;
out vec4 color;
vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c)); }
vec3 encodedOf(vec3 c) { return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c)); }
void main() {
  vec3 sum = vec3(0.0);
  for (int y = 0; y < 6; y++) {
    for (int x = 0; x < 6; x++) {
      if (x >= taps.x || y >= taps.y) continue;
      vec2 at = (floor(gl_FragCoord.xy) + (vec2(x, y) + 0.5) / vec2(taps)) / sizePx;
      vec3 uv = ${COPY_UV} * vec3(at, 1.0);
      sum += linearOf(textureLod(${COPY_SAMPLER}, uv.xy / uv.z, 0.0).rgb);
    }
  }
  color = vec4(encodedOf(sum / float(taps.x * taps.y)), 1.0);
}
`,
};

const MOST_TAPS = 6;

/** Reads camera images back in a smaller size. */
export interface PhotoReader {
  /**
   * Reads the camera image of a view in the given size.
   *
   * @throws Error if the view has no camera image.
   */
  read(view: ViewFrame, widthPx: number, heightPx: number): PanoramaShot;
  dispose(): void;
}

export function createPhotoReader(objects: GlObjects, programs: ProgramCache, drawer: PassDrawer): PhotoReader {
  const { gl } = objects;
  const program = programs.acquire(PHOTO_SHADER);
  programs.finish(program);
  const framebuffer = objects.createFramebuffer();
  let texture: WebGLTexture | null = null;
  let size: readonly [number, number] = [0, 0];
  return {
    read: ({ cameraImage, clipFromView, worldFromView }, widthPx, heightPx) => {
      const sampler = program.uniform(COPY_SAMPLER);
      if (!cameraImage || !sampler) throw new Error('The view has no camera image.');
      if (texture === null || size[0] !== widthPx || size[1] !== heightPx) {
        if (texture) objects.deleteTexture(texture);
        texture = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.NEAREST, widthPx, heightPx);
        size = [widthPx, heightPx];
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      }
      drawer.begin(framebuffer, 0, 0, widthPx, heightPx, 'replace');
      drawer.use(program);
      drawer.texture(0, sampler, cameraImage.texture, 'linear');
      gl.uniformMatrix3fv(program.uniform(COPY_UV), false, cameraImage.uvFromViewUv);
      gl.uniform2f(program.uniform('sizePx'), widthPx, heightPx);
      gl.uniform2i(program.uniform('taps'), tapsFor(cameraImage.widthPx, widthPx), tapsFor(cameraImage.heightPx, heightPx));
      drawer.draw();
      drawer.end();
      const data = new Uint8Array(widthPx * heightPx * 4);
      prepareReadback(gl);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return { widthPx, heightPx, data, clipFromView: clipFromView.slice(), worldFromView: worldFromView.slice() };
    },
    dispose: () => {
      if (texture) objects.deleteTexture(texture);
      objects.deleteFramebuffer(framebuffer);
    },
  };
}

function tapsFor(imagePx: number, photoPx: number): number {
  return Math.min(MOST_TAPS, Math.max(1, Math.ceil(imagePx / photoPx)));
}
