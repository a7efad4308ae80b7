import type { RgbaImage } from './image.ts';

/** Smallest difference of a red channel that counts as a change. */
const CHANGED = 12;

export interface ChangedBox {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** Number of changed pixels. */
  readonly count: number;
}

/** Bounds of the pixels that differ between two images of one size, in pixels. */
export function changedBox(after: RgbaImage, before: RgbaImage): ChangedBox {
  const box = { left: after.width, right: 0, top: after.height, bottom: 0, count: 0 };
  for (let i = 0; i < after.data.length; i += 4) {
    if (Math.abs((after.data[i] ?? 0) - (before.data[i] ?? 0)) < CHANGED) continue;
    const [x, y] = [(i / 4) % after.width, Math.floor(i / 4 / after.width)];
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.top = Math.min(box.top, y);
    box.bottom = Math.max(box.bottom, y);
    box.count++;
  }
  return box;
}
