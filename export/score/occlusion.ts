/** Counts of pixels of one or more frames, for the intersection over union (IoU) of what is drawn and what is true. */
export interface OcclusionCounts {
  /** Pixels drawn and truly visible, pixels of which at least one holds. */
  readonly visibleBoth: number;
  readonly visibleEither: number;
  /** The same for pixels that are not drawn and truly hidden. */
  readonly hiddenBoth: number;
  readonly hiddenEither: number;
  /** Pixels that are truly hidden, and all pixels that count. */
  readonly hidden: number;
  readonly all: number;
}

/** A layer with objects: before real surfaces hide it, and after. Row-major, rows from the top. */
export interface OccludedLayer {
  /** Depth of the layer before occlusion, meters along the axis of the camera, 0 where there is nothing. */
  readonly layerM: ArrayLike<number>;
  /** RGBA of the layer, before and after occlusion. Only alpha is read. */
  readonly whole: ArrayLike<number>;
  readonly shown: ArrayLike<number>;
}

/**
 * Compares the pixels that a layer shows with those that the measured depth of the room says are visible: the ones where the layer is not
 * behind the room. Pixels that the layer covers by less than half, and pixels whose depth is unknown, do not count. A pixel is drawn
 * if more than half of the layer's alpha is left.
 *
 * @param roomM Measured depth of the room, meters along the axis of the camera, 0 where unknown.
 */
export function countOcclusion({ layerM, whole, shown }: OccludedLayer, roomM: ArrayLike<number>): OcclusionCounts {
  let [visibleBoth, visibleEither, hiddenBoth, hiddenEither, hidden, all] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < roomM.length; i++) {
    const alpha = whole[4 * i + 3] ?? 0;
    const [layer, room] = [layerM[i] ?? 0, roomM[i] ?? 0];
    if (layer === 0 || room === 0 || alpha < 128) continue;
    const drawn = 2 * (shown[4 * i + 3] ?? 0) > alpha;
    const visible = layer <= room;
    all++;
    if (!visible) hidden++;
    if (drawn && visible) visibleBoth++;
    if (drawn || visible) visibleEither++;
    if (!(drawn || visible)) hiddenBoth++;
    if (!(drawn && visible)) hiddenEither++;
  }
  return { visibleBoth, visibleEither, hiddenBoth, hiddenEither, hidden, all };
}

export interface OcclusionIou {
  readonly visible: number;
  readonly hidden: number;
  /** The part of the pixels that is truly hidden. An occlusion that has nothing to hide is not tested. */
  readonly hiddenShare: number;
}

/** The intersection over union of what is visible and of what is hidden, over all counts; 1 where there is nothing of the kind. */
export function occlusionIou(counts: readonly OcclusionCounts[]): OcclusionIou {
  const total = (key: keyof OcclusionCounts): number => counts.reduce((sum, one) => sum + one[key], 0);
  const ratio = (both: number, either: number): number => (either === 0 ? 1 : both / either);
  return {
    visible: ratio(total('visibleBoth'), total('visibleEither')),
    hidden: ratio(total('hiddenBoth'), total('hiddenEither')),
    hiddenShare: total('all') === 0 ? 0 : total('hidden') / total('all'),
  };
}
