import type { DepthDrawing, MetersPicture } from './drawing.ts';

/** Fills unknown samples from the known samples around them. */
export interface HoleFiller {
  /** The depth without holes, unless all samples are unknown; valid until the next call. */
  fill(texture: WebGLTexture, widthPx: number, heightPx: number): WebGLTexture;
  dispose(): void;
}

/**
 * Pull-push (Gortler et al., The Lumigraph, 1996, §3.4): the pull phase halves the resolution down to one sample, each the mean of the
 * known samples below; the push phase fills unknown samples from the level above. The cost does not depend on the holes: 2.7 times the
 * number of samples.
 */
export function createHoleFiller(drawing: DepthDrawing): HoleFiller {
  const pull = drawing.link(PULL, ['finer']);
  const push = drawing.link(PUSH, ['own', 'coarser']);
  /** Level 0 has the resolution of the sensor. */
  const pulled: MetersPicture[] = [];
  const filled: MetersPicture[] = [];

  const clear = (): void => {
    for (const picture of [...pulled, ...filled]) drawing.free(picture);
    pulled.length = 0;
    filled.length = 0;
  };
  const resize = (widthPx: number, heightPx: number): void => {
    clear();
    let width = widthPx;
    let height = heightPx;
    do {
      filled.push(drawing.createPicture(width, height));
      width = Math.ceil(width / 2);
      height = Math.ceil(height / 2);
      pulled.push(drawing.createPicture(width, height));
    } while (width > 1 || height > 1);
  };
  return {
    fill: (texture, widthPx, heightPx) => {
      if (filled[0]?.widthPx !== widthPx || filled[0].heightPx !== heightPx) resize(widthPx, heightPx);
      for (let level = 0; level < pulled.length; level++) {
        const target = pulled[level];
        if (!target) continue;
        drawing.begin(target, pull);
        drawing.texture(0, pulled[level - 1]?.texture ?? texture, 'nearest');
        drawing.draw();
      }
      for (let level = filled.length - 1; level >= 0; level--) {
        const target = filled[level];
        if (!target) continue;
        drawing.begin(target, push);
        drawing.texture(0, pulled[level - 1]?.texture ?? texture, 'nearest');
        drawing.texture(1, (filled[level + 1] ?? pulled[level])?.texture ?? null, 'nearest');
        drawing.draw();
      }
      return filled[0]?.texture ?? texture;
    },
    dispose: clear,
  };
}

const PULL = `
uniform sampler2D finer;
float meters() {
  ivec2 size = textureSize(finer, 0);
  ivec2 first = ivec2(gl_FragCoord.xy) * 2;
  float sum = 0.0;
  float known = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 at = first + ivec2(i & 1, i >> 1);
    if (any(greaterThanEqual(at, size))) continue;
    float m = texelFetch(finer, at, 0).r;
    if (m <= 0.0) continue;
    sum += m;
    known += 1.0;
  }
  return known > 0.0 ? sum / known : 0.0;
}`;

const PUSH = `
uniform sampler2D own;
uniform sampler2D coarser;
float meters() {
  float m = texelFetch(own, ivec2(gl_FragCoord.xy), 0).r;
  if (m > 0.0) return m;
  ivec2 last = textureSize(coarser, 0) - 1;
  vec2 texel = gl_FragCoord.xy * 0.5 - 0.5;
  ivec2 low = ivec2(floor(texel));
  vec2 part = texel - vec2(low);
  float sum = 0.0;
  float total = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    float around = texelFetch(coarser, clamp(low + corner, ivec2(0), last), 0).r;
    vec2 near = mix(1.0 - part, part, vec2(corner));
    float weight = around > 0.0 ? near.x * near.y : 0.0;
    sum += around * weight;
    total += weight;
  }
  return total > 0.0 ? sum / total : 0.0;
}`;
