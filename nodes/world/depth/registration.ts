import { setInverse3 } from '../../kit/matrices.ts';
import type { CameraImage, RoomDepth } from '../../kit/session.ts';
import type { DepthDrawing, DepthImage } from './drawing.ts';

/** Measures whether the borders of the depth are where the camera image has edges. */
export interface RegistrationMeter {
  /**
   * Draws one pixel: how much more the image changes at borders of the depth than beside them, as a difference of colors, or `UNKNOWN`. The
   * result is the same object each time, and stays on the GPU, so nothing waits for it.
   */
  measure(texture: WebGLTexture, depth: RoomDepth, image: CameraImage): DepthImage;
  dispose(): void;
}

/**
 * The range of results in which the weight of the camera image rises from 0 to 1; gradually, so that nothing jumps. A recorded room gives
 * 0.14 to 0.21 where depth and image are registered, and -0.01 to 0.02 where the image is shifted by 6 %
 * (`tests/slow/depth-filters.test.ts`).
 */
export const TRUSTED = [0.03, 0.08] as const;

/** The result if there are too few borders to tell. */
export const UNKNOWN = -1;

/** Samples per side that one pixel of the first pass sums up. */
const BLOCK = 8;

export function createRegistrationMeter(gl: WebGL2RenderingContext, drawing: DepthDrawing): RegistrationMeter {
  const block = drawing.link(SUM_BLOCK, ['room', 'guide']);
  const whole = drawing.link(DIVIDE, ['gains', 'counts']);
  const uniforms = {
    viewUvFromUv: block.uniform('viewUvFromUv'),
    guideUvFromViewUv: block.uniform('guideUvFromViewUv'),
    counting: block.uniform('counting'),
  };
  const viewUvFromUv = new Float32Array(9);
  let sums: { readonly gains: DepthImage; readonly counts: DepthImage } | null = null;
  const result = drawing.createImage(1, 1);
  const free = (): void => {
    if (sums) for (const picture of [sums.gains, sums.counts]) drawing.free(picture);
  };

  const fitted = (depth: RoomDepth): NonNullable<typeof sums> => {
    const [width, height] = [Math.ceil(depth.widthPx / BLOCK), Math.ceil(depth.heightPx / BLOCK)];
    if (sums?.gains.widthPx === width && sums.gains.heightPx === height) return sums;
    free();
    sums = { gains: drawing.createImage(width, height), counts: drawing.createImage(width, height) };
    return sums;
  };
  const sum = (target: DepthImage, counting: 0 | 1, texture: WebGLTexture, image: CameraImage): void => {
    drawing.begin(target, block);
    drawing.texture(0, texture, 'nearest');
    drawing.texture(1, image.texture, 'linear');
    gl.uniformMatrix3fv(uniforms.viewUvFromUv, false, viewUvFromUv);
    gl.uniformMatrix3fv(uniforms.guideUvFromViewUv, false, image.uvFromViewUv);
    gl.uniform1i(uniforms.counting, counting);
    drawing.draw();
  };
  return {
    measure: (texture, depth, image) => {
      const { gains, counts } = fitted(depth);
      setInverse3(viewUvFromUv, depth.uvFromViewUv);
      sum(gains, 0, texture, image);
      sum(counts, 1, texture, image);
      drawing.begin(result, whole);
      drawing.texture(0, gains.texture, 'nearest');
      drawing.texture(1, counts.texture, 'nearest');
      drawing.draw();
      return result;
    },
    dispose: () => {
      free();
      drawing.free(result);
    },
  };
}

const SUM_BLOCK = /* glsl */ `
uniform sampler2D room;
uniform sampler2D guide;
uniform mat3 viewUvFromUv;
uniform mat3 guideUvFromViewUv;
uniform bool counting;

vec3 guideAt(vec2 texel, vec2 size) { return textureLod(guide, place(guideUvFromViewUv, place(viewUvFromUv, texel / size)), 0.0).rgb; }

// Color difference between two neighboring samples.
float change(vec2 texel, vec2 toNext, vec2 size) { return length(guideAt(texel + toNext, size) - guideAt(texel, size)); }

// At a border between a sample and the next: how much more the image changes there than a few samples beside it.
float gainAt(ivec2 from, ivec2 toNext, ivec2 last) {
  if (any(greaterThan(from + toNext, last))) return 0.0;
  float a = texelFetch(room, from, 0).r;
  float b = texelFetch(room, from + toNext, 0).r;
  if (a <= 0.0 || b <= 0.0 || abs(a - b) < 8.0 * strayM(min(a, b))) return 0.0;
  if (counting) return 1.0;
  vec2 size = vec2(last + 1);
  vec2 texel = vec2(from) + 0.5;
  vec2 way = vec2(toNext);
  float beside = change(texel - 6.0 * way, way, size) + change(texel - 4.0 * way, way, size);
  beside += change(texel + 4.0 * way, way, size) + change(texel + 6.0 * way, way, size);
  return change(texel, way, size) - 0.25 * beside;
}

float meters() {
  ivec2 last = textureSize(room, 0) - 1;
  ivec2 first = ivec2(gl_FragCoord.xy) * ${BLOCK};
  float sum = 0.0;
  for (int i = 0; i < ${BLOCK * BLOCK}; i++) {
    ivec2 from = first + ivec2(i % ${BLOCK}, i / ${BLOCK});
    if (any(greaterThan(from, last))) continue;
    sum += gainAt(from, ivec2(1, 0), last) + gainAt(from, ivec2(0, 1), last);
  }
  return sum;
}`;

const DIVIDE = /* glsl */ `
uniform sampler2D gains;
uniform sampler2D counts;
// With fewer borders, chance decides.
const float LEAST = 8.0;

float meters() {
  ivec2 size = textureSize(gains, 0);
  float gain = 0.0;
  float count = 0.0;
  for (int y = 0; y < size.y; y++) {
    for (int x = 0; x < size.x; x++) {
      gain += texelFetch(gains, ivec2(x, y), 0).r;
      count += texelFetch(counts, ivec2(x, y), 0).r;
    }
  }
  return count < LEAST ? ${UNKNOWN}.0 : gain / count;
}`;
