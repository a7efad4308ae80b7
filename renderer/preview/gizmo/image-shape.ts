import { type ImageBox, onPage, type PagePoint } from './page-point.ts';

/**
 * A shape in an image. Lengths are fractions of the height of the image; `width` and `height` are along its axes, which the angle rotates
 * counterclockwise. `feather`: the width of its soft edge, half of it outside; null without handle.
 */
export interface ImageShape {
  /** UV from the bottom left. */
  readonly center: PagePoint;
  readonly angleRad: number;
  readonly width: number;
  readonly height: number;
  readonly feather: number | null;
}

/** The side or corner of a shape that is dragged: -1 is left or bottom, 1 right or top, 0 neither. */
export interface ShapeSide {
  readonly x: number;
  readonly y: number;
}

/** Least width and height that a drag leaves. */
const LEAST_SIZE = 0.01;

/** Where a point is on the page that lies at these distances from the center along the axes of the shape. */
export function alongShape({ center, angleRad }: Pick<ImageShape, 'center' | 'angleRad'>, x: number, y: number, box: ImageBox): PagePoint {
  const middle = onPage(center, box);
  const [c, s] = [Math.cos(angleRad) * box.height, Math.sin(angleRad) * box.height];
  return { x: middle.x + c * x - s * y, y: middle.y - s * x - c * y };
}

/** A side or corner on the page. */
export function sidePoint(shape: ImageShape, { x, y }: ShapeSide, box: ImageBox): PagePoint {
  return alongShape(shape, (x * shape.width) / 2, (y * shape.height) / 2, box);
}

/** The part of the feather: at the outer end of the soft edge, below the shape, beside the part of its lower side. */
export function featherPoint(shape: ImageShape, box: ImageBox): PagePoint {
  return alongShape(shape, shape.width / 4, -(shape.height + (shape.feather ?? 0)) / 2, box);
}

/** A movement on the page along the axes of the shape. */
export function alongAxes({ angleRad }: ImageShape, from: PagePoint, to: PagePoint, box: ImageBox): PagePoint {
  const [c, s] = [Math.cos(angleRad) / box.height, Math.sin(angleRad) / box.height];
  const [x, y] = [to.x - from.x, to.y - from.y];
  return { x: c * x - s * y, y: -s * x - c * y };
}

/**
 * The shape after a side or corner is dragged. The opposite side stays where it is; if the center is fixed, both sides move alike.
 *
 * @param by The movement along the axes of the shape.
 */
export function resized(
  shape: ImageShape,
  side: ShapeSide,
  by: PagePoint,
  isCenterFixed: boolean,
  snapped: (size: number) => number,
  box: ImageBox,
): ImageShape {
  const grown = (size: number, toward: number, moved: number) =>
    toward === 0 ? size : Math.max(snapped(size + toward * moved * (isCenterFixed ? 2 : 1)), LEAST_SIZE);
  const [width, height] = [grown(shape.width, side.x, by.x), grown(shape.height, side.y, by.y)];
  if (isCenterFixed) return { ...shape, width, height };
  const [x, y] = [(side.x * (width - shape.width)) / 2, (side.y * (height - shape.height)) / 2];
  const [c, s] = [Math.cos(shape.angleRad), Math.sin(shape.angleRad)];
  const center = { x: shape.center.x + ((c * x - s * y) * box.height) / box.width, y: shape.center.y + s * x + c * y };
  return { ...shape, center, width, height };
}
