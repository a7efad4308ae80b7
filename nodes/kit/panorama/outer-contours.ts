/** The border pixels of a region in order, `[x, y, x, y, …]`; pixel centers are at integers. */
export type Contour = readonly number[];

/** Offsets to the eight neighbors, counterclockwise on screen from the right. */
const DX = [1, 1, 0, -1, -1, -1, 0, 1] as const;
const DY = [0, -1, -1, -1, 0, 1, 1, 1] as const;

/** Labels of border pixels. `RIGHT_EDGE` marks a border pixel whose right neighbor is outside the region. */
const BORDER = 2;
const RIGHT_EDGE = -2;

/**
 * The outer contours of the regions of an image: those that `cv::findContours` returns with `RETR_EXTERNAL` and `CHAIN_APPROX_NONE`, in
 * the order of their first pixels from the top left. Regions are connected over eight neighbors; those in holes of others are left out.
 * Border following of Suzuki and Abe 1985, “Topological structural analysis of digitized binary images by border following”, algorithm 2.
 *
 * @param image Zero is outside.
 *
 * @example
 * const contours = outerContours(mask, 1024, 512);
 */
export function outerContours(image: Uint8Array, widthPx: number, heightPx: number): Contour[] {
  const stride = widthPx + 2;
  // With a border of zeros, no neighbor is outside the array.
  const labels = new Int8Array(stride * (heightPx + 2));
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) if (image[y * widthPx + x] !== 0) labels[(y + 1) * stride + x + 1] = 1;
  }
  const steps = DX.map((dx, i) => (DY[i] ?? 0) * stride + dx);
  const contours: Contour[] = [];
  for (let y = 1; y <= heightPx; y++) {
    // The last border that was crossed in this row: within a region if the border is not at the right edge.
    let crossed = 0;
    for (let x = 1; x <= widthPx; x++) {
      const at = y * stride + x;
      const label = labels[at] ?? 0;
      if (label === 1 && labels[at - 1] === 0 && crossed <= 0) {
        contours.push(follow(labels, at, stride, steps));
        crossed = labels[at] ?? 0;
      } else if (label !== 0 && label !== 1) crossed = label;
    }
  }
  return contours;
}

/** Follows an outer border from its top left pixel, labels its pixels and returns them. */
function follow(labels: Int8Array, start: number, stride: number, steps: readonly number[]): Contour {
  const points: number[] = [];
  const add = (at: number): void => void points.push((at % stride) - 1, Math.floor(at / stride) - 1);
  // The pixel to the left is outside: search clockwise from there.
  let direction = 4;
  for (let i = 1; i < 8; i++) {
    direction = (4 - i + 8) % 8;
    if (labels[start + (steps[direction] ?? 0)] !== 0) break;
    if (i === 7) {
      labels[start] = RIGHT_EDGE;
      add(start);
      return points;
    }
  }
  const last = start + (steps[direction] ?? 0);
  for (let at = start; ; ) {
    let seenRight = false;
    let next = at;
    // Counter-clockwise from the previous pixel.
    for (let i = 1; i <= 8; i++) {
      const turned = (direction + i) % 8;
      next = at + (steps[turned] ?? 0);
      if (labels[next] !== 0) {
        direction = turned;
        break;
      }
      seenRight ||= turned === 0;
    }
    if (seenRight) labels[at] = RIGHT_EDGE;
    else if (labels[at] === 1) labels[at] = BORDER;
    add(at);
    if (next === start && at === last) return points;
    at = next;
    // From the new pixel, the direction back to the old one.
    direction = (direction + 4) % 8;
  }
}

/** The area and the center of the polygon through the pixels of a contour. */
export interface ContourMoments {
  /** Square pixels. */
  readonly areaPx: number;
  /** Center of area, pixels; centers of pixels are at integers. */
  readonly centerPx: readonly [x: number, y: number];
}

/**
 * The moments m00, m10 / m00 and m01 / m00 of a contour by Green's theorem, as `cv::moments` computes them.
 *
 * @returns Null for a contour without area, such as a line.
 *
 * @example
 * momentsOf([0, 0, 0, 2, 2, 2, 2, 0]); // { areaPx: 4, centerPx: [1, 1] }
 */
export function momentsOf(contour: Contour): ContourMoments | null {
  let [m00, m10, m01] = [0, 0, 0];
  let x0 = contour[contour.length - 2] ?? 0;
  let y0 = contour[contour.length - 1] ?? 0;
  for (let i = 0; i < contour.length; i += 2) {
    const x1 = contour[i] ?? 0;
    const y1 = contour[i + 1] ?? 0;
    const cross = x0 * y1 - x1 * y0;
    m00 += cross;
    m10 += cross * (x0 + x1);
    m01 += cross * (y0 + y1);
    x0 = x1;
    y0 = y1;
  }
  if (m00 === 0) return null;
  return { areaPx: Math.abs(m00) / 2, centerPx: [m10 / (3 * m00), m01 / (3 * m00)] };
}
