/**
 * Glass or another blended surface, to be ordered for drawing and assigned to a batch. Everything before the first glass is batch 0. A new
 * batch begins at each glass that may show a surface of the current batch, because the image of what is behind glass must then be updated.
 */
export interface OrderedItem {
  readonly isGlass: boolean;
  /** Whether it is drawn after all others, in the last batch, because it has no visible color. */
  readonly isLast: boolean;
  /** Lower values are drawn first, whatever their distance. */
  readonly renderOrder: number;
  /** Whether it is drawn in this view. */
  isVisible: boolean;
  /** Distance along the view axis, meters. */
  depthM: number;
  /** Bounds on the screen, in clip units of -1 to 1. */
  readonly box: { left: number; right: number; bottom: number; top: number };
  /** The batch that `arrange` assigns. */
  batch: number;
}

/**
 * Maximum number of batches with glass. Each further batch costs another image of the size of the view, so the farthest glass shares one
 * batch.
 */
export const MAX_BATCHES = 5;

/** How far outside of its own bounds glass shows objects, because it refracts, as a fraction of its size. */
const REACH = 0.25;

/**
 * Sorts `items` by render order, then from far to near, and sets their batches. Returns the number of batches with glass; 0: no glass is
 * visible.
 */
export function arrange<T extends OrderedItem>(items: T[]): number {
  items.sort(farFirst);
  let batch = 0;
  let first = 0;
  for (let i = 0; i < items.length; i++) {
    const item = items[i];
    if (!item) continue;
    if (item.isGlass && item.isVisible && !item.isLast && (batch === 0 || overlapsAny(items, first, i, item))) {
      batch++;
      first = i;
    }
    item.batch = batch;
  }
  const merged = Math.max(batch - MAX_BATCHES, 0);
  for (let i = 0; i < items.length; i++) {
    const item = items[i];
    if (!item) continue;
    if (item.isLast) item.batch = batch;
    if (item.batch > 0) item.batch = Math.max(item.batch - merged, 1);
  }
  return batch - merged;
}

function farFirst(a: OrderedItem, b: OrderedItem): number {
  return a.renderOrder - b.renderOrder || b.depthM - a.depthM;
}

/** Whether a glass with the given bounds may show one of the visible items from index `first` to before `end`. */
function overlapsAny(items: readonly OrderedItem[], first: number, end: number, { box }: OrderedItem): boolean {
  const aside = REACH * (box.right - box.left);
  const above = REACH * (box.top - box.bottom);
  for (let i = first; i < end; i++) {
    const other = items[i];
    if (!other?.isVisible || other.isLast) continue;
    const { left, right, bottom, top } = other.box;
    if (left < box.right + aside && right > box.left - aside && bottom < box.top + above && top > box.bottom - above) return true;
  }
  return false;
}
