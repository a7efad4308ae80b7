import { linearFromSrgb } from '../../../nodes/kit/color-math.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { LinkedShader } from '../../program/program.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import { COPY_SAMPLER, COPY_SHADER, COPY_UV } from '../gl/copy-shader.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import { prepareReadback } from '../gl/upload.ts';

/** Measures the mean color of the camera image. */
export interface CameraMean {
  /**
   * Returns the mean color, linear sRGB; null before the first measurement and for frames without a camera image. A second call in the same
   * frame returns the same result.
   */
  read(frame: SessionFrame): Readonly<Float32Array> | null;
  dispose(): void;
}

/** Size of the reduced image: 8 × 8 pixels, each the mean of 8 × 8 samples of the camera image. */
const SIDE_PX = 8;
const BYTES = SIDE_PX ** 2 * 4;

const MEAN_SHADER: LinkedShader = {
  id: 'scrim:camera-mean',
  vertex: COPY_SHADER.vertex,
  fragment: /* glsl */ `#version 300 es
precision highp float;
uniform highp sampler2D ${COPY_SAMPLER};
uniform mat3 ${COPY_UV};
out vec4 color;
vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c)); }
vec3 encodedOf(vec3 c) { return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c)); }
void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 64; i++) {
    vec2 at = (floor(gl_FragCoord.xy) + (vec2(i % 8, i / 8) + 0.5) / 8.0) / ${SIDE_PX}.0;
    vec3 uv = ${COPY_UV} * vec3(at, 1.0);
    sum += linearOf(textureLod(${COPY_SAMPLER}, uv.xy / uv.z, 0.0).rgb);
  }
  color = vec4(encodedOf(sum / 64.0), 1.0);
}
`,
};

/** Linear value of each encoded byte. */
const LINEAR = Float32Array.from({ length: 256 }, (_, i) => linearFromSrgb(i / 255));

/** The parts of the engine that the measurement uses. */
export interface CameraMeanTools {
  readonly objects: GlObjects;
  readonly drawer: PassDrawer;
  tool(shader: LinkedShader): GlProgram;
}

/** Creates the measurement. If `held`, each frame waits for its own result, so that renders repeat; otherwise nothing waits for the GPU. */
export function createCameraMean(tools: CameraMeanTools, held: boolean): CameraMean {
  const { objects, drawer } = tools;
  const { gl } = objects;
  const program = tools.tool(MEAN_SHADER);
  const texture = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.NEAREST, SIDE_PX, SIDE_PX);
  const framebuffer = objects.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, BYTES, gl.STREAM_READ);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  const bytes = new Uint8Array(BYTES);
  const mean = new Float32Array(3);
  let measured = false;
  let fence: WebGLSync | null = null;
  let askedIndex = -1;
  let askedS = -1;

  /** Draws the reduced image. Returns false if the frame has no camera image. */
  function draw(frame: SessionFrame): boolean {
    const image = frame.viewCount > 0 ? (frame.views[0]?.cameraImage ?? null) : null;
    const location = program.uniform(COPY_SAMPLER);
    if (image === null || location === null) return false;
    drawer.begin(framebuffer, 0, 0, SIDE_PX, SIDE_PX, 'replace');
    drawer.use(program);
    drawer.texture(0, location, image.texture, 'linear');
    gl.uniformMatrix3fv(program.uniform(COPY_UV), false, image.uvFromViewUv);
    drawer.draw();
    drawer.end();
    return true;
  }

  function takeOver(): void {
    mean.fill(0);
    for (let i = 0; i < BYTES; i += 4) {
      for (let c = 0; c < 3; c++) mean[c] = (mean[c] ?? 0) + (LINEAR[bytes[i + c] ?? 0] ?? 0) / SIDE_PX ** 2;
    }
    measured = true;
  }

  function startReading(): void {
    prepareReadback(gl);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.readPixels(0, 0, SIDE_PX, SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  function finishReading(): void {
    if (fence === null || gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return;
    gl.deleteSync(fence);
    fence = null;
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bytes);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    takeOver();
  }

  return {
    read: (frame) => {
      if (frame.index === askedIndex && frame.timeS === askedS) return measured ? mean : null;
      askedIndex = frame.index;
      askedS = frame.timeS;
      finishReading();
      if (fence === null) {
        if (!draw(frame)) {
          measured = false;
        } else if (held) {
          prepareReadback(gl);
          gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
          gl.readPixels(0, 0, SIDE_PX, SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          takeOver();
        } else {
          startReading();
        }
      }
      return measured ? mean : null;
    },
    dispose: () => {
      if (fence !== null) gl.deleteSync(fence);
      gl.deleteBuffer(buffer);
      objects.deleteFramebuffer(framebuffer);
      objects.deleteTexture(texture);
    },
  };
}
