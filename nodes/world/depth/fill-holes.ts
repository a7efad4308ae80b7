import { createSizedImage, type DepthDrawing } from './drawing.ts';

/** Fills unknown samples from the known samples around them. */
export interface HoleFiller {
  /** Returns the depth without the holes that can be filled. The texture is valid until the next call. */
  fill(texture: WebGLTexture, widthPx: number, heightPx: number): WebGLTexture;
  dispose(): void;
}

/**
 * Creates a hole filler. A hole gets the distance of the farther surface at its border: sensors miss what is far, transparent or hidden
 * from one of their two lenses, and a virtual object in front of a window must not vanish behind the window's frame. Depth cameras fill the
 * same way (Intel RealSense SDK, hole-filling filter, “farthest from around”).
 *
 * Each unknown sample looks left, right, up and down for the border of its hole. Where the four borders lie on one plane, as in a hole in a
 * floor, the sample lies on it too. A sample stays unknown if it is farther than 1/16 of the image from all borders and fewer than three
 * sides have one, as in a sky that the image cuts off: nothing tells its distance.
 *
 * Pull-push (Gortler et al., The Lumigraph, 1996, §3.4) is not used: its mean of near and far hid 95 % of a panel in front of the window of
 * a recorded room. Known samples cost one fetch, unknown ones at most about 400.
 */
export function createHoleFiller(drawing: DepthDrawing): HoleFiller {
  const pass = drawing.link(FILL, ['room']);
  const sized = createSizedImage(drawing);
  return {
    fill: (texture, widthPx, heightPx) => {
      const image = sized.in(widthPx, heightPx);
      drawing.begin(image, pass);
      drawing.texture(0, texture, 'nearest');
      drawing.draw();
      return image.texture;
    },
    dispose: sized.free,
  };
}

const FILL = /* glsl */ `
uniform sampler2D room;

// Meters of the border in a direction, and its distance in samples; 0 meters where there is none. Steps grow with the distance, so a
// border thinner than 1/32 of its distance may be missed.
vec2 borderAt(ivec2 from, ivec2 way) {
  ivec2 size = textureSize(room, 0);
  for (int off = 1; ; off += max(1, off / 32)) {
    ivec2 at = from + way * off;
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) return vec2(0.0);
    float m = texelFetch(room, at, 0).r;
    if (m <= 0.0) continue;
    // The outermost sample is often a mixture of two surfaces, so take the median of three.
    ivec2 last = size - 1;
    float second = texelFetch(room, clamp(at + way, ivec2(0), last), 0).r;
    float third = texelFetch(room, clamp(at + way * 2, ivec2(0), last), 0).r;
    if (second > 0.0 && third > 0.0) m = max(min(m, second), min(max(m, second), third));
    return vec2(m, float(off));
  }
  return vec2(0.0);
}

// The plane through two opposite borders; inverse depth is linear along a line of the image.
float between(vec2 a, vec2 b) { return (a.y + b.y) / (b.y / a.x + a.y / b.x); }

float meters() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  float m = texelFetch(room, here, 0).r;
  if (m > 0.0) return m;
  vec2 sides[4] = vec2[](borderAt(here, ivec2(-1, 0)), borderAt(here, ivec2(1, 0)), borderAt(here, ivec2(0, -1)), borderAt(here, ivec2(0, 1)));
  ivec2 size = textureSize(room, 0);
  float reach = max(4.0, float(max(size.x, size.y)) / 16.0);
  float farthestM = 0.0;
  int count = 0;
  bool isClose = false;
  for (int i = 0; i < 4; i++) {
    if (sides[i].x <= 0.0) continue;
    count++;
    farthestM = max(farthestM, sides[i].x);
    isClose = isClose || sides[i].y <= reach;
  }
  if (count == 0 || (count < 3 && !isClose)) return 0.0;
  float sameM = 4.0 * strayM(farthestM);
  if (count == 4) {
    float acrossM = between(sides[0], sides[1]);
    float uprightM = between(sides[2], sides[3]);
    if (abs(acrossM - uprightM) < sameM) return 0.5 * (acrossM + uprightM);
  }
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 4; i++) {
    if (sides[i].x > 0.0 && sides[i].x >= farthestM - sameM) sum += vec2(sides[i].x, 1.0) / sides[i].y;
  }
  return sum.x / sum.y;
}`;
