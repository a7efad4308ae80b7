import { hash } from './noise.ts';
import { curtain, lathe, leafBlade, panel, roundedBox, type Shape } from './shapes.ts';
import type { SurfaceName } from './surfaces.ts';

/** An object in the room: its shape at `at`, rotated about the y axis. */
export interface Part {
  readonly surface: SurfaceName;
  readonly shape: Shape;
  readonly at: readonly [number, number, number];
  readonly yawRad?: number;
  /** Rotation about the x axis, before the yaw. */
  readonly pitchRad?: number;
  /** Multiplies the surface's color; linear-sRGB. */
  readonly tint?: readonly [number, number, number];
  /** The box that approximates the part while light is baked; none for parts that hardly cast shadows. */
  readonly blocker?: Blocker;
}

/** A box that stands for a part while light is baked; rotated with the part. */
export interface Blocker {
  readonly center: readonly [number, number, number];
  readonly size: readonly [number, number, number];
}

type Triple = readonly [number, number, number];

export const ROOM = { widthM: 5.2, heightM: 2.6, depthM: 4.6 } as const;
/** Opening in the left wall, meters. */
export const WINDOW = { centerY: 1.5, centerZ: -0.35, heightM: 1.4, widthM: 1.9 } as const;

/** Creates a box-shaped part without a blocker, because the part is too thin to cast shadows while light is baked. */
function trim(surface: SurfaceName, at: Triple, size: Triple, radiusM = 0, more: Partial<Part> = {}): Part {
  return { surface, at, shape: roundedBox(size, radiusM), ...more };
}

function box(surface: SurfaceName, at: Triple, size: Triple, radiusM = 0, more: Partial<Part> = {}): Part {
  return { surface, at, shape: roundedBox(size, radiusM), blocker: { center: at, size }, ...more };
}

export function furnish(): readonly Part[] {
  return [
    ...walls(),
    ...windowParts(),
    ...sofa(),
    ...coffeeTable(),
    ...bookcase(),
    ...sideboard(),
    ...movableLight(),
    ...plant(),
    ...pictures(),
  ];
}

const HALF_W = ROOM.widthM / 2;
const HALF_D = ROOM.depthM / 2;
/** Thickness of the walls, in meters: enough to block light. */
const WALL_M = 0.1;

function walls(): Part[] {
  const { widthM, heightM, depthM } = ROOM;
  const inner = (surface: SurfaceName, axis: 0 | 1 | 2, side: 1 | -1, at: Triple): Part => ({
    surface,
    at,
    shape: panel([widthM, heightM, depthM], axis, side),
  });
  const left = -HALF_W - WALL_M / 2;
  const side = (z0: number, z1: number, y0: number, y1: number): Part =>
    trim('plaster', [left, (y0 + y1) / 2, (z0 + z1) / 2], [WALL_M, y1 - y0, z1 - z0]);
  const [w0, w1] = [WINDOW.centerZ - WINDOW.widthM / 2, WINDOW.centerZ + WINDOW.widthM / 2];
  const [h0, h1] = [WINDOW.centerY - WINDOW.heightM / 2, WINDOW.centerY + WINDOW.heightM / 2];
  return [
    inner('oak', 1, 1, [0, 0, 0]),
    inner('ceiling', 1, -1, [0, heightM, 0]),
    inner('wallpaper', 2, 1, [0, heightM / 2, -HALF_D]),
    inner('plaster', 2, -1, [0, heightM / 2, HALF_D]),
    inner('plaster', 0, -1, [HALF_W, heightM / 2, 0]),
    side(-HALF_D, w0, 0, heightM),
    side(w1, HALF_D, 0, heightM),
    side(w0, w1, 0, h0),
    side(w0, w1, h1, heightM),
    trim('white', [0, 0.05, -HALF_D + 0.008], [widthM, 0.1, 0.016]),
    trim('white', [0, 0.05, HALF_D - 0.008], [widthM, 0.1, 0.016]),
    trim('white', [-HALF_W + 0.008, 0.05, 0], [0.016, 0.1, depthM]),
    trim('white', [HALF_W - 0.008, 0.05, 0], [0.016, 0.1, depthM]),
    trim('white', [1.2, 1.02, HALF_D - 0.02], [0.86, 2.04, 0.04], 0.006, { tint: [0.86, 0.84, 0.8] }),
    trim('walnut', [0.84, 1.02, HALF_D - 0.07], [0.12, 0.02, 0.025], 0.01),
    trim('rug', [-0.15, 0.006, -0.35], [2.3, 0.012, 1.6]),
  ];
}

function windowParts(): Part[] {
  const x = -HALF_W - WALL_M / 2;
  const { centerY: y, centerZ: z, heightM, widthM } = WINDOW;
  const bar = (dy: number, dz: number, height: number, width: number): Part =>
    trim('white', [x, y + dy, z + dz], [0.06, height, width], 0.008, { tint: [0.9, 0.9, 0.88] });
  const cloth = (side: number): Part => ({
    surface: 'linen',
    shape: curtain(0.42, 2.15, 5, 0.035),
    at: [-HALF_W + 0.09, 1.22, z + side * (widthM / 2 + 0.14)],
    yawRad: Math.PI / 2,
    blocker: { center: [-HALF_W + 0.09, 1.22, z + side * (widthM / 2 + 0.14)], size: [0.42, 2.15, 0.06] },
  });
  return [
    { surface: 'outdoors', at: [x - 0.04, y, z], shape: panel([0, heightM, widthM], 0, 1) },
    bar(heightM / 2 - 0.025, 0, 0.05, widthM),
    bar(-heightM / 2 + 0.025, 0, 0.05, widthM),
    bar(0, -widthM / 2 + 0.025, heightM, 0.05),
    bar(0, widthM / 2 - 0.025, heightM, 0.05),
    bar(0, 0, heightM, 0.045),
    bar(0.22, 0, 0.035, widthM),
    box('white', [-HALF_W + 0.05, y - heightM / 2 - 0.02, z], [0.16, 0.03, widthM + 0.1], 0.006),
    trim('walnut', [-HALF_W + 0.09, 2.32, z], [0.025, 0.025, widthM + 0.9], 0.01),
    cloth(-1),
    cloth(1),
  ];
}

function sofa(): Part[] {
  const [x, z] = [-0.45, -1.68];
  const cloth = (at: Triple, size: Triple, radius: number): Part => box('sofa', at, size, radius);
  const pillow = (surface: SurfaceName, px: number, yawRad: number): Part =>
    box(surface, [px, 0.62, z - 0.06], [0.42, 0.42, 0.14], 0.065, { yawRad, pitchRad: -0.32 });
  const foot = (dx: number, dz: number): Part => trim('walnut', [x + dx, 0.05, z + dz], [0.05, 0.1, 0.05], 0.01);
  return [
    cloth([x, 0.2, z], [1.9, 0.2, 0.84], 0.04),
    cloth([x - 0.41, 0.37, z + 0.04], [0.8, 0.17, 0.76], 0.05),
    cloth([x + 0.41, 0.37, z + 0.04], [0.8, 0.17, 0.76], 0.05),
    cloth([x, 0.52, z - 0.34], [1.9, 0.62, 0.18], 0.06),
    cloth([x - 0.88, 0.38, z], [0.16, 0.42, 0.84], 0.06),
    cloth([x + 0.88, 0.38, z], [0.16, 0.42, 0.84], 0.06),
    pillow('mustard', x - 0.56, 0.18),
    pillow('clay', x + 0.52, -0.22),
    foot(-0.86, -0.36),
    foot(0.86, -0.36),
    foot(-0.86, 0.36),
    foot(0.86, 0.36),
  ];
}

function coffeeTable(): Part[] {
  const [x, z] = [-0.2, -0.42];
  const leg = (dx: number, dz: number): Part => trim('walnut', [x + dx, 0.195, z + dz], [0.045, 0.39, 0.045], 0.01);
  const book = (y: number, size: Triple, yawRad: number, tint: Triple): Part =>
    trim('white', [x - 0.26, y, z + 0.02], size, 0.004, { yawRad, tint });
  return [
    box('walnut', [x, 0.405, z], [1.05, 0.035, 0.56], 0.012),
    box('walnut', [x, 0.16, z], [0.95, 0.02, 0.46], 0.006),
    leg(-0.47, -0.23),
    leg(0.47, -0.23),
    leg(-0.47, 0.23),
    leg(0.47, 0.23),
    book(0.436, [0.28, 0.028, 0.2], 0.2, [0.16, 0.24, 0.3]),
    book(0.461, [0.24, 0.022, 0.17], -0.1, [0.7, 0.3, 0.18]),
    {
      surface: 'ceramic',
      tint: [0.75, 0.72, 0.66],
      at: [x + 0.25, 0.4225, z - 0.05],
      shape: lathe([
        [0, 0],
        [0.05, 0],
        [0.078, 0.03],
        [0.098, 0.075],
        [0.09, 0.075],
        [0.07, 0.035],
        [0, 0.02],
      ]),
      blocker: { center: [x + 0.25, 0.46, z - 0.05], size: [0.14, 0.07, 0.14] },
    },
    {
      surface: 'knit',
      at: [1.2, 0, -0.55],
      shape: lathe(
        [
          [0, 0],
          [0.24, 0],
          [0.28, 0.05],
          [0.29, 0.18],
          [0.27, 0.33],
          [0.22, 0.38],
          [0, 0.39],
        ],
        28,
      ),
      blocker: { center: [1.2, 0.19, -0.55], size: [0.48, 0.38, 0.48] },
    },
  ];
}

function bookcase(): Part[] {
  const [x, z] = [1.86, -2.1];
  const [width, height, depth] = [1.1, 1.85, 0.34];
  const board = (at: Triple, size: Triple): Part => box('walnut', at, size);
  const shelves = [0.06, 0.5, 0.94, 1.38, height - 0.015];
  return [
    board([x - width / 2, height / 2, z], [0.03, height, depth]),
    board([x + width / 2, height / 2, z], [0.03, height, depth]),
    board([x, height / 2, z - depth / 2 + 0.005], [width, height, 0.01]),
    ...shelves.map((y) => board([x, y, z], [width, 0.03, depth])),
    ...shelves.slice(0, -1).flatMap((y, row) => books(x - width / 2 + 0.03, y + 0.015, z + 0.02, row)),
  ];
}

const CLOTHS: readonly Triple[] = [
  [0.42, 0.12, 0.09],
  [0.1, 0.19, 0.27],
  [0.55, 0.4, 0.14],
  [0.16, 0.26, 0.18],
  [0.6, 0.55, 0.46],
  [0.28, 0.16, 0.22],
  [0.7, 0.66, 0.58],
];

/** A row of standing books with sizes and colors from a seed, and a gap at the end. */
function books(x0: number, y: number, z: number, row: number): Part[] {
  const out: Part[] = [];
  let x = x0;
  for (let i = 0; x < x0 + 0.72 + 0.28 * hash(row, 5, 91); i++) {
    const thick = 0.022 + 0.034 * hash(i, row, 92);
    const tall = 0.22 + 0.13 * hash(i, row, 93);
    const deep = 0.17 + 0.06 * hash(i, row, 94);
    const tint = CLOTHS[Math.floor(hash(i, row, 95) * CLOTHS.length)] ?? [0.5, 0.5, 0.5];
    out.push({ surface: 'white', tint, at: [x + thick / 2, y + tall / 2, z], shape: roundedBox([thick - 0.002, tall, deep]) });
    x += thick;
  }
  const length = x - x0;
  // One box approximates the whole row.
  const blocker: Blocker = { center: [x0 + length / 2, y + 0.14, z], size: [length, 0.28, 0.19] };
  return out.map((part, i) => (i === 0 ? { ...part, blocker } : part));
}

function sideboard(): Part[] {
  const [x, z] = [2.36, 0.45];
  const door = (dz: number): Part => trim('white', [x - 0.215, 0.42, z + dz], [0.02, 0.5, 0.68], 0.006, { tint: [0.78, 0.76, 0.7] });
  return [
    box('walnut', [x, 0.43, z], [0.42, 0.6, 1.45], 0.01),
    door(-0.355),
    door(0.355),
    trim('walnut', [x - 0.1, 0.065, z - 0.6], [0.05, 0.13, 0.05], 0.01),
    trim('walnut', [x - 0.1, 0.065, z + 0.6], [0.05, 0.13, 0.05], 0.01),
    {
      surface: 'ceramic',
      tint: [0.2, 0.34, 0.36],
      at: [x, 0.73, z - 0.42],
      shape: lathe([
        [0, 0],
        [0.07, 0],
        [0.11, 0.08],
        [0.1, 0.17],
        [0.045, 0.25],
        [0.055, 0.29],
        [0.04, 0.28],
        [0, 0.2],
      ]),
      blocker: { center: [x, 0.86, z - 0.42], size: [0.16, 0.25, 0.16] },
    },
    trim('white', [x + 0.05, 0.9, z + 0.3], [0.03, 0.34, 0.46], 0.004, { tint: [0.08, 0.08, 0.09] }),
  ];
}

function movableLight(): Part[] {
  const at: Triple = [0.88, 0, -1.95];
  return [
    {
      surface: 'ceramic',
      tint: [0.05, 0.05, 0.055],
      at,
      shape: lathe(
        [
          [0, 0],
          [0.15, 0],
          [0.15, 0.02],
          [0, 0.025],
        ],
        24,
      ),
    },
    {
      surface: 'ceramic',
      tint: [0.05, 0.05, 0.055],
      at,
      shape: lathe(
        [
          [0.011, 0.02],
          [0.011, 0.5],
          [0.011, 1],
          [0.011, 1.42],
        ],
        10,
      ),
    },
    {
      surface: 'linen',
      at,
      tint: [1, 0.95, 0.85],
      shape: lathe(
        [
          [0.19, 1.34],
          [0.18, 1.41],
          [0.165, 1.48],
          [0.15, 1.55],
          [0.14, 1.62],
        ],
        28,
      ),
      blocker: { center: [at[0], 1.48, at[2]], size: [0.28, 0.28, 0.28] },
    },
  ];
}

function plant(): Part[] {
  const at: Triple = [-2.12, 0, -1.82];
  const leaves = Array.from({ length: 17 }, (_, i): Part => {
    const rise = 0.35 + 0.5 * hash(i, 1, 96);
    return {
      surface: 'leaf',
      at: [at[0], 0.42 + 0.012 * i, at[2]],
      yawRad: i * 2.399963,
      tint: [0.85 + 0.3 * hash(i, 2, 96), 0.95 + 0.2 * hash(i, 3, 96), 0.9],
      shape: leafBlade(0.34 + 0.22 * hash(i, 4, 96), 0.12 + 0.05 * hash(i, 5, 96), rise),
    };
  });
  return [
    {
      surface: 'ceramic',
      tint: [0.62, 0.58, 0.52],
      at,
      shape: lathe(
        [
          [0, 0],
          [0.15, 0],
          [0.185, 0.2],
          [0.2, 0.38],
          [0.185, 0.38],
          [0.18, 0.34],
          [0, 0.34],
        ],
        28,
      ),
      blocker: { center: [at[0], 0.19, at[2]], size: [0.34, 0.38, 0.34] },
    },
    ...leaves,
  ];
}

function pictures(): Part[] {
  const picture = (surface: SurfaceName, x: number, y: number): Part[] => [
    trim('white', [x, y, -HALF_D + 0.012], [0.62, 0.76, 0.024], 0.006, { tint: [0.1, 0.09, 0.085] }),
    { surface, at: [x, y, -HALF_D + 0.026], shape: panel([0.56, 0.7, 0], 2, 1) },
  ];
  return [...picture('hills', -0.82, 1.52), ...picture('discs', -0.12, 1.52)];
}
