/** What the poster of a page shows: a part of a view, as a person framed it. */
export interface PosterFraming {
  /** Center of the poster: tangents of the angles to the right of and above the viewing direction. */
  readonly center: readonly [number, number];
  /** Height of the poster: difference of the tangents of its upper and lower edge. Its width follows from the shape of posters. */
  readonly height: number;
  /** Where the head stood in an emulated room; absent for other sources. */
  readonly room?: {
    /** Name of the room, as in `scrim render --session room:NAME`. */
    readonly name: string;
    /** Position of the eye and a point that it looks at, in meters in world space. The head is upright. */
    readonly eye: readonly [number, number, number];
    readonly target: readonly [number, number, number];
  };
}

/** A part of a view, as fractions of its size from the top left. */
export interface ViewCrop {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The whole view. */
export const WHOLE_VIEW: ViewCrop = { x: 0, y: 0, width: 1, height: 1 };

/** Edges of a view, as tangents of the angles to its viewing direction. */
export interface ViewTangents {
  readonly left: number;
  readonly right: number;
  readonly bottom: number;
  readonly top: number;
}

/** The edges of a perspective projection, a column-major 4×4 matrix. */
export function tangentsOf(clipFromView: ArrayLike<number>): ViewTangents {
  const [perX, perY, atX, atY] = [clipFromView[0] ?? 1, clipFromView[5] ?? 1, clipFromView[8] ?? 0, clipFromView[9] ?? 0];
  return { left: (atX - 1) / perX, right: (atX + 1) / perX, bottom: (atY - 1) / perY, top: (atY + 1) / perY };
}

/**
 * The largest part of a view of this shape around a center, no taller than `height`; moved where it would leave the view.
 *
 * @param center Fractions of the view from the top left.
 * @param height Fraction of the view.
 * @param shape Width of the part divided by its height, over the same of the view.
 */
export function cropAt(center: readonly [number, number], height: number, shape: number): ViewCrop {
  const fitting = Math.min(height, 1, 1 / shape);
  const width = fitting * shape;
  const inside = (middle: number, size: number) => Math.min(Math.max(middle - size / 2, 0), 1 - size);
  return { x: inside(center[0], width), y: inside(center[1], fitting), width, height: fitting };
}

/** The part of a view that a framing shows. `shape` is that of the poster, width divided by height. */
export function cropOf({ center, height }: PosterFraming, { left, right, bottom, top }: ViewTangents, shape: number): ViewCrop {
  const [width, tall] = [right - left, top - bottom];
  return cropAt([(center[0] - left) / width, (top - center[1]) / tall], height / tall, (shape * tall) / width);
}

/** The inverse of `cropOf`, without a room. */
export function framingOf({ x, y, width, height }: ViewCrop, { left, right, bottom, top }: ViewTangents): PosterFraming {
  return {
    center: [left + (x + width / 2) * (right - left), top - (y + height / 2) * (top - bottom)],
    height: height * (top - bottom),
  };
}
