import { createSizedImage, type DepthDrawing } from './drawing.ts';

/** Rates how far the depth of one view can be trusted. */
export interface ConfidenceMeter {
  /**
   * Draws the confidence of each sample as a shade of gray, at the resolution of the sensor. The texture is valid until the next call.
   *
   * @param measured Depth in meters before holes are filled; `filled`: after.
   */
  rate(measured: WebGLTexture, filled: WebGLTexture, widthPx: number, heightPx: number): WebGLTexture;
  dispose(): void;
}

/**
 * Creates a meter. The confidence of a measured sample is from 0.25, at a border of a surface or in strong noise, to 1, where the three
 * samples on each side lie on one plane within the typical error of depth sensors. A filled sample has 0.25, an unknown one 0.
 *
 * Both the border and the noise are read from pairs of opposite samples: on a plane their mean is the depth between them, whatever the
 * slope, so the floor is as certain as the wall.
 */
export function createConfidenceMeter(drawing: DepthDrawing): ConfidenceMeter {
  const pass = drawing.link(RATE, ['measured', 'filled']);
  const sized = createSizedImage(drawing, 'gray');
  return {
    rate: (measured, filled, widthPx, heightPx) => {
      const image = sized.in(widthPx, heightPx);
      drawing.begin(image, pass);
      drawing.texture(0, measured, 'nearest');
      drawing.texture(1, filled, 'nearest');
      drawing.draw();
      return image.texture;
    },
    dispose: sized.free,
  };
}

const RATE = /* glsl */ `
uniform sampler2D measured;
uniform sampler2D filled;
const int REACH = 3;
const float LEAST = 0.25;

float meters() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  float m = texelFetch(measured, here, 0).r;
  if (m <= 0.0) return texelFetch(filled, here, 0).r > 0.0 ? LEAST : 0.0;
  ivec2 last = textureSize(measured, 0) - 1;
  float borderPx = float(REACH + 1);
  float bends = 0.0;
  float squares = 0.0;
  float pairs = 0.0;
  for (int y = 0; y <= REACH; y++) {
    for (int x = -REACH; x <= REACH; x++) {
      if (y == 0 && x <= 0) continue;
      ivec2 off = ivec2(x, y);
      ivec2 a = here + off;
      ivec2 b = here - off;
      if (any(lessThan(min(a, b), ivec2(0))) || any(greaterThan(max(a, b), last))) continue;
      float away = length(vec2(off));
      if (away > float(REACH)) continue;
      float aM = texelFetch(measured, a, 0).r;
      float bM = texelFetch(measured, b, 0).r;
      float bend = 0.5 * (aM + bM) - m;
      if (aM <= 0.0 || bM <= 0.0 || abs(bend) > 4.0 * strayM(m)) {
        borderPx = min(borderPx, away);
        continue;
      }
      bends += bend;
      squares += bend * bend;
      pairs += 1.0;
    }
  }
  // A mean of two samples has half the variance of one. The error of the sample itself is in all bends alike, so it cancels.
  float variance = pairs > 1.0 ? max(0.0, squares - bends * bends / pairs) / (pairs - 1.0) : 0.0;
  float noiseM = sqrt(2.0 * variance);
  float calm = 1.0 / (1.0 + pow(max(0.0, noiseM / strayM(m) - 1.0), 2.0));
  return LEAST + (1.0 - LEAST) * calm * smoothstep(0.5, float(REACH), borderPx);
}`;
