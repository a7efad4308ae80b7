import type { DepthMap } from './depth-map.ts';
import type { DepthRays } from './depth-rays.ts';
import { type Block, createTriangleTests, type TriangleTests } from './triangle-tests.ts';

/**
 * The mesh of a depth map, whose vertices are pixels. A quadtree divides the map until two or four triangles show each block of pixels with
 * a small relative error of depth (Lee et al. 2017; Dupont de Dinechin and Paljic 2020, §3.2). Every pixel of a block is compared, not only
 * middles of edges. A block whose neighbor is finer takes the neighbor's corners into its own edges, so there are no cracks.
 *
 * Rejected: a right-triangulated mesh needs sides of 2ⁿ + 1 pixels, and no cracks only by splitting far beyond the place of an error.
 */
export interface DepthMesh {
  /** Column and row of each vertex in half pixels from the top left corner of the map. The center of the first pixel is (1, 1). */
  readonly places: Uint16Array;
  /** The depth of each vertex. */
  readonly depths: Float32Array;
  /** Three vertices per triangle, clockwise as the camera sees them. */
  readonly indices: Uint32Array;
  /** Relative error of depth that triangles have at most. */
  readonly tolerance: number;
}

/** Relative error of depth that triangles may have. */
export const DEPTH_TOLERANCE = 0.005;
/** The tolerance grows by this factor until a mesh has few enough triangles. */
const COARSER = 2;

/**
 * Makes the mesh of a depth map.
 *
 * @param mostTriangles A map that needs more is shown with a larger error.
 */
export function makeDepthMesh(map: DepthMap, rays: DepthRays, mostTriangles: number, tolerance = DEPTH_TOLERANCE): DepthMesh {
  for (let allowed = tolerance; ; allowed *= COARSER) {
    const mesh = meshWithin(map, rays, allowed);
    if (mesh.indices.length / 3 <= mostTriangles || allowed > 1) return mesh;
  }
}

function meshWithin(map: DepthMap, rays: DepthRays, tolerance: number): DepthMesh {
  const tests = createTriangleTests(map, rays, tolerance);
  const { widthPx, heightPx } = map;
  const blocks: Block[] = [];
  const pending: Block[] = [{ left: 0, top: 0, right: rays.wraps ? widthPx : widthPx - 1, bottom: heightPx - 1 }];
  for (let block = pending.pop(); block; block = pending.pop()) {
    const { left, top, right, bottom } = block;
    const isPixel = right - left === 1 && bottom - top === 1;
    if (isPixel || (Math.min(right - left, bottom - top) > 1 && holds(block, widthPx, tests))) blocks.push(block);
    else pending.push(...divided(block));
  }
  const builder = createBuilder(map);
  const cells = blocks.filter(({ left, right }) => right - left === 1);
  for (const cell of cells) addCell(cell, widthPx, map, tests, builder);
  const large = blocks.filter(({ left, right }) => right - left > 1);
  for (const { left, top, right, bottom } of large) {
    for (const row of [top, bottom]) for (const column of [left, right]) builder.use(row * widthPx + (column % widthPx));
  }
  for (const block of large) addBlock(block, widthPx, builder, tests);
  if (rays.wraps) for (const row of [0, heightPx - 1]) closePole(row, map, tests, builder);
  return { ...builder.build(), tolerance };
}

/** Halves both sides of a block, or the longer one of a block that is one pixel wide. */
function divided({ left, top, right, bottom }: Block): readonly Block[] {
  const column = right - left > 1 ? (left + right) >> 1 : right;
  const row = bottom - top > 1 ? (top + bottom) >> 1 : bottom;
  const parts: Block[] = [{ left, top, right: column, bottom: row }];
  if (column < right) parts.push({ left: column, top, right, bottom: row });
  if (row < bottom) parts.push({ left, top: row, right: column, bottom });
  if (column < right && row < bottom) parts.push({ left: column, top: row, right, bottom });
  return parts.filter((part) => part.right > part.left && part.bottom > part.top);
}

/** Whether four triangles around the middle of a block show all its pixels well, and none is stretched. */
function holds(block: Block, widthPx: number, tests: TriangleTests): boolean {
  const corners = cornersOf(block, widthPx);
  const middle = middleOf(block, widthPx);
  if (!tests.isKnown(middle.at) || !corners.every((corner) => tests.isKnown(corner.at))) return false;
  return corners.every((from, i) => {
    const to = corners[(i + 1) % 4] ?? from;
    return fits(middle, from, to, tests) && !tests.isTorn(middle.at, from.at, to.at);
  });
}

function fits(a: Corner, b: Corner, c: Corner, tests: TriangleTests): boolean {
  return tests.fits(a.column, a.row, b.column, b.row, c.column, c.row);
}

interface Corner {
  readonly column: number;
  readonly row: number;
  /** Index of the pixel. */
  readonly at: number;
}

function cornerAt(column: number, row: number, widthPx: number): Corner {
  return { column, row, at: row * widthPx + (column % widthPx) };
}

/** The corners of a block, clockwise from the top left one. */
function cornersOf({ left, top, right, bottom }: Block, widthPx: number): readonly [Corner, Corner, Corner, Corner] {
  return [cornerAt(left, top, widthPx), cornerAt(right, top, widthPx), cornerAt(right, bottom, widthPx), cornerAt(left, bottom, widthPx)];
}

function middleOf({ left, top, right, bottom }: Block, widthPx: number): Corner {
  return cornerAt((left + right) >> 1, (top + bottom) >> 1, widthPx);
}

/** Collects triangles; vertices are pixels, or poles behind them. */
interface Builder {
  /** Marks a pixel as a corner of triangles, before they are added. */
  use(corner: number): void;
  isUsed(corner: number): boolean;
  add(a: number, b: number, c: number): void;
  build(): Omit<DepthMesh, 'tolerance'>;
}

function createBuilder({ widthPx, heightPx, values }: DepthMap): Builder {
  const pixels = widthPx * heightPx;
  const used = new Uint8Array(pixels);
  /** Number of each vertex, plus 1; the last two are the poles. */
  const numbers = new Int32Array(pixels + 2);
  const places: number[] = [];
  const depths: number[] = [];
  const indices: number[] = [];
  const vertex = (corner: number): number => {
    if (numbers[corner] === 0) {
      numbers[corner] = depths.length + 1;
      if (corner < pixels) places.push(2 * (corner % widthPx) + 1, 2 * Math.floor(corner / widthPx) + 1);
      else places.push(1, corner === pixels ? 0 : 2 * heightPx);
      depths.push(corner < pixels ? (values[corner] ?? 0) : meanOfRow(corner === pixels ? 0 : heightPx - 1));
    }
    return (numbers[corner] ?? 1) - 1;
  };
  const meanOfRow = (row: number): number => {
    const known = values.subarray(row * widthPx, (row + 1) * widthPx).filter((depth) => depth > 0 && Number.isFinite(depth));
    return known.length / known.reduce((sum, depth) => sum + 1 / depth, 0);
  };
  return {
    use: (corner) => {
      used[corner] = 1;
    },
    isUsed: (corner) => used[corner] === 1,
    add: (a, b, c) => {
      indices.push(vertex(a), vertex(b), vertex(c));
    },
    build: () => ({ places: Uint16Array.from(places), depths: Float32Array.from(depths), indices: Uint32Array.from(indices) }),
  };
}

/** Adds the triangles of a block of one pixel by the diagonal along which depth changes less; none that is stretched. */
function addCell({ left, top, right, bottom }: Block, widthPx: number, { values }: DepthMap, tests: TriangleTests, builder: Builder): void {
  const a = top * widthPx + left;
  const b = top * widthPx + (right % widthPx);
  const c = bottom * widthPx + (right % widthPx);
  const d = bottom * widthPx + left;
  if (!tests.isKnown(a)) addTriangle(b, c, d, tests, builder);
  else if (!tests.isKnown(b)) addTriangle(a, c, d, tests, builder);
  else if (!tests.isKnown(c)) addTriangle(a, b, d, tests, builder);
  else if (!tests.isKnown(d)) addTriangle(a, b, c, tests, builder);
  else if (Math.abs((values[a] ?? 0) - (values[c] ?? 0)) <= Math.abs((values[b] ?? 0) - (values[d] ?? 0))) {
    addTriangle(a, b, c, tests, builder);
    addTriangle(a, c, d, tests, builder);
  } else {
    addTriangle(a, b, d, tests, builder);
    addTriangle(b, c, d, tests, builder);
  }
}

function addTriangle(a: number, b: number, c: number, tests: TriangleTests, builder: Builder): void {
  if (!tests.isKnown(a) || !tests.isKnown(b) || !tests.isKnown(c) || tests.isTorn(a, b, c)) return;
  builder.use(a);
  builder.use(b);
  builder.use(c);
  builder.add(a, b, c);
}

/** Adds a larger block: two triangles if they suffice, else a fan from its middle to the corners on its edges. */
function addBlock(block: Block, widthPx: number, builder: Builder, tests: TriangleTests): void {
  const { left, top, right, bottom } = block;
  const around: number[] = [];
  const visit = (column: number, row: number): void => {
    const corner = row * widthPx + (column % widthPx);
    if (builder.isUsed(corner)) around.push(corner);
  };
  for (let column = left; column < right; column++) visit(column, top);
  for (let row = top; row < bottom; row++) visit(right, row);
  for (let column = right; column > left; column--) visit(column, bottom);
  for (let row = bottom; row > top; row--) visit(left, row);
  if (around.length === 4) {
    const [a, b, c, d] = cornersOf(block, widthPx);
    if (fits(a, b, c, tests) && fits(a, c, d, tests)) {
      builder.add(a.at, b.at, c.at);
      builder.add(a.at, c.at, d.at);
      return;
    }
    if (fits(a, b, d, tests) && fits(b, c, d, tests)) {
      builder.add(a.at, b.at, d.at);
      builder.add(b.at, c.at, d.at);
      return;
    }
  }
  const middle = middleOf(block, widthPx).at;
  around.forEach((corner, i) => {
    builder.add(corner, around[(i + 1) % around.length] ?? corner, middle);
  });
}

/** Closes the hole around a pole, between the first or last row and the direction straight up or down. */
function closePole(row: number, { widthPx, heightPx }: DepthMap, tests: TriangleTests, builder: Builder): void {
  const pole = widthPx * heightPx + (row === 0 ? 0 : 1);
  const ring: number[] = [];
  for (let column = 0; column < widthPx; column++) {
    const corner = row * widthPx + column;
    if (builder.isUsed(corner) && tests.isKnown(corner)) ring.push(corner);
  }
  if (ring.length < 3) return;
  ring.forEach((corner, i) => {
    builder.add(corner, ring[(i + 1) % ring.length] ?? corner, pole);
  });
}
