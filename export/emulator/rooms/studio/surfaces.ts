import {
  imageOfDiscs,
  imageOfHills,
  leaf,
  oakBoards,
  outdoors,
  type Painter,
  plain,
  plaster,
  rug,
  stripes,
  triangles,
  wallpaper,
  walnut,
  weave,
} from './paint.ts';

/** Appearance of a surface. */
export interface SurfaceStyle {
  readonly paint: Painter;
  /** Size of the texture. */
  readonly sizePx: readonly [width: number, height: number];
  /** Area that one texture covers. `pictureOf…` textures cover their object exactly; the others repeat. */
  readonly tileM: readonly [width: number, height: number];
  /** Strength of the window's reflection at grazing angles. */
  readonly gloss?: number;
  /** Linear-sRGB radiance per unit of color, for surfaces that emit light. */
  readonly glow?: number;
}

export const SURFACES = {
  oak: { paint: oakBoards, sizePx: [256, 512], tileM: [1.12, 2.24], gloss: 0.55 },
  plaster: { paint: plaster, sizePx: [128, 128], tileM: [1.6, 1.6] },
  wallpaper: { paint: wallpaper, sizePx: [256, 256], tileM: [0.62, 0.62] },
  walnut: { paint: walnut, sizePx: [128, 256], tileM: [0.5, 1], gloss: 0.3 },
  ceiling: { paint: plain, sizePx: [4, 4], tileM: [1, 1], gloss: 0.08 },
  white: { paint: plain, sizePx: [4, 4], tileM: [1, 1], gloss: 0.08 },
  rug: { paint: rug, sizePx: [384, 256], tileM: [2.3, 1.6] },
  sofa: { paint: weave([0.38, 0.46, 0.55], 0.3, 81), sizePx: [128, 128], tileM: [0.2, 0.2] },
  mustard: { paint: stripes([0.82, 0.62, 0.22], [0.92, 0.86, 0.72], 6, 82), sizePx: [128, 128], tileM: [0.46, 0.46] },
  clay: { paint: triangles([0.72, 0.4, 0.3], [0.9, 0.84, 0.74], 5, 83), sizePx: [128, 128], tileM: [0.46, 0.46] },
  linen: { paint: weave([0.93, 0.91, 0.86], 0.16, 84), sizePx: [96, 96], tileM: [0.12, 0.12] },
  knit: { paint: weave([0.74, 0.66, 0.54], 0.42, 85), sizePx: [96, 96], tileM: [0.36, 0.36] },
  ceramic: { paint: plain, sizePx: [4, 4], tileM: [1, 1], gloss: 0.4 },
  leaf: { paint: leaf, sizePx: [64, 128], tileM: [1, 1], gloss: 0.1 },
  hills: { paint: imageOfHills, sizePx: [160, 200], tileM: [0.56, 0.7] },
  discs: { paint: imageOfDiscs, sizePx: [160, 200], tileM: [0.56, 0.7] },
  outdoors: { paint: outdoors, sizePx: [128, 96], tileM: [1.9, 1.4], glow: 1 },
} as const satisfies Record<string, SurfaceStyle>;

export type SurfaceName = keyof typeof SURFACES;
