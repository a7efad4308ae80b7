import { encode } from 'fast-png';

export type Color = readonly [r: number, g: number, b: number];

/** Draws a texture by a function of u, to the right, and v, up; colors are display-referred, in [0, 1]. Edges are antialiased. */
export function drawTexture(widthPx: number, heightPx: number, colorAt: (u: number, v: number) => Color): Uint8Array {
  const data = new Uint8Array(3 * widthPx * heightPx);
  const steps = 3;
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) {
      const sum = [0, 0, 0];
      for (let s = 0; s < steps * steps; s++) {
        const u = (x + ((s % steps) + 0.5) / steps) / widthPx;
        const v = 1 - (y + (Math.floor(s / steps) + 0.5) / steps) / heightPx;
        colorAt(u, v).forEach((part, i) => {
          sum[i] = (sum[i] ?? 0) + part;
        });
      }
      sum.forEach((part, i) => {
        data[3 * (y * widthPx + x) + i] = Math.round(255 * Math.min(1, Math.max(0, part / (steps * steps))));
      });
    }
  }
  return encode({ width: widthPx, height: heightPx, data, channels: 3 });
}

export function mix(a: Color, b: Color, t: number): Color {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

/** Grain of planed wood: long wavy lines along u. */
export function wood(light: Color, dark: Color, seed: number): (u: number, v: number) => Color {
  return (u, v) => {
    const wave = v * 22 + 0.9 * Math.sin(5 * u + seed) + 0.35 * Math.sin(17 * u + 3 * seed + 9 * v);
    const ring = 0.5 + 0.5 * Math.sin(2 * Math.PI * (wave + 0.3 * Math.sin(31 * v + seed)));
    const fleck = 0.5 + 0.5 * Math.sin(190 * u + 40 * Math.sin(60 * v + seed));
    return mix(light, dark, 0.55 * ring ** 3 + 0.12 * fleck);
  };
}
