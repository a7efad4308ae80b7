import { alongAxes, alongShape, featherPoint, type ImageShape, resized, sidePoint } from './image-shape.ts';
import { type ImageBox, onPage, type PagePoint } from './page-point.ts';
import type { HandleNames, ReadParam } from './place.ts';
import type { GizmoValues } from './tool.ts';

/** The values of a gizmo in an image; null for handles that the node does not have. */
export interface ImagePlace {
  /** UV from the bottom left. Without a `center` handle it is that of the rectangle, or of the image. */
  readonly center: PagePoint;
  readonly extentPx: number | null;
  readonly angleRad: number | null;
  readonly rectangle: { readonly low: PagePoint; readonly high: PagePoint } | null;
  readonly shape: ImageShape | null;
}

/**
 * A part that can be dragged. Of a rectangle and of the size of a shape, `x` and `y` are -1 for the left or bottom side, 1 for the right or
 * top one and 0 for neither; with both 0 all of a rectangle moves.
 */
export type ImagePart =
  | { readonly kind: 'center' | 'extent' | 'angle' | 'feather' }
  | { readonly kind: 'rectangle' | 'size'; readonly x: number; readonly y: number };

/** Distance of the angle's part from the center, or from the side of a shape if it is in the image there, in CSS pixels. */
export const ARM_PX = 44;
/** How near the pointer has to be to a part, in CSS pixels. */
const REACH_PX = 9;
const SNAP_UV = 0.05;
const SNAP_PX = 10;
const SNAP_RAD = Math.PI / 12;
const SNAP_FEATHER = 0.01;
/** Least side of a rectangle, in UV. */
const LEAST_SIDE = 0.01;

const SIDES = [-1, 0, 1] as const;

export function readImagePlace(handles: HandleNames, read: ReadParam): ImagePlace {
  const values = (param: string | undefined) => (param === undefined ? null : read(param));
  const point = (param: string | undefined) => {
    const found = values(param);
    return found && { x: found[0] ?? 0, y: found[1] ?? 0 };
  };
  const [low, high] = [point(handles.low), point(handles.high)];
  const rectangle = low && high && { low, high };
  const center =
    point(handles.center) ??
    (rectangle ? { x: (rectangle.low.x + rectangle.high.x) / 2, y: (rectangle.low.y + rectangle.high.y) / 2 } : MIDDLE);
  const angleRad = values(handles.angle)?.[0] ?? null;
  const size = point(handles.size);
  const feather = values(handles.feather)?.[0] ?? null;
  const shape = size && { center, angleRad: angleRad ?? 0, width: size.x, height: size.y, feather };
  return { center, extentPx: values(handles.extent)?.[0] ?? null, angleRad, rectangle, shape };
}

const MIDDLE: PagePoint = { x: 0.5, y: 0.5 };

/** The parts with a point of their own, and where that is on the page. The first one is nearest to the user. */
export function partsOf(handles: HandleNames, place: ImagePlace, box: ImageBox): { readonly part: ImagePart; readonly at: PagePoint }[] {
  const center = onPage(place.center, box);
  const parts: { part: ImagePart; at: PagePoint }[] = [];
  if (place.angleRad !== null) {
    parts.push({ part: { kind: 'angle' }, at: armPoint(place, place.angleRad, box) });
  }
  if (handles.center !== undefined) parts.push({ part: { kind: 'center' }, at: center });
  // Below the center, because the angle begins at the right.
  if (place.extentPx !== null) parts.push({ part: { kind: 'extent' }, at: { x: center.x, y: center.y + place.extentPx / box.scale } });
  if (place.shape) {
    const { shape } = place;
    for (const y of SIDES) {
      for (const x of SIDES) if (x !== 0 || y !== 0) parts.push({ part: { kind: 'size', x, y }, at: sidePoint(shape, { x, y }, box) });
    }
    if (shape.feather !== null) parts.push({ part: { kind: 'feather' }, at: featherPoint(shape, box) });
  }
  if (place.rectangle) {
    const { low, high } = place.rectangle;
    const along = (from: number, to: number, side: number) => from + ((side + 1) / 2) * (to - from);
    for (const y of SIDES) {
      for (const x of SIDES) {
        parts.push({ part: { kind: 'rectangle', x, y }, at: onPage({ x: along(low.x, high.x, x), y: along(low.y, high.y, y) }, box) });
      }
    }
  }
  return parts;
}

/** Right of the shape before it is rotated, if that is in the image; else near the center. */
function armPoint({ center, shape }: ImagePlace, angleRad: number, box: ImageBox): PagePoint {
  const at = (distance: number) => alongShape({ center, angleRad }, distance, 0, box);
  const beside = at((shape?.width ?? 0) / 2 + ARM_PX / box.height);
  const { left, top, width, height } = box;
  const isInside = beside.x >= left && beside.x <= left + width && beside.y >= top && beside.y <= top + height;
  return isInside ? beside : at(ARM_PX / box.height);
}

/** The part at a point of the page; null if there is none. All of the circle is the part of the extent. */
export function partAt(handles: HandleNames, place: ImagePlace, box: ImageBox, { x, y }: PagePoint): ImagePart | null {
  let nearest = REACH_PX;
  let found: ImagePart | null = null;
  for (const { part, at } of partsOf(handles, place, box)) {
    const distance = Math.hypot(at.x - x, at.y - y);
    if (distance >= nearest) continue;
    nearest = distance;
    found = part;
  }
  if (found || place.extentPx === null) return found;
  const center = onPage(place.center, box);
  return Math.abs(Math.hypot(x - center.x, y - center.y) - place.extentPx / box.scale) < REACH_PX ? { kind: 'extent' } : null;
}

/** A drag of a part, in CSS pixels of the page. `turnedRad`: the angle around the center, which may exceed a full turn. */
export interface ImageDrag {
  readonly part: ImagePart;
  readonly from: ImagePlace;
  readonly start: PagePoint;
  readonly to: PagePoint;
  readonly turnedRad: number;
  readonly snaps: boolean;
}

/** The values of the params after a drag. Centers and rectangles stay in the image. */
export function draggedValues(handles: HandleNames, { part, from, start, to, turnedRad, snaps }: ImageDrag, box: ImageBox): GizmoValues {
  const snapped = (value: number, step: number) => (snaps ? Math.round(value / step) * step : value);
  const moved = { x: (to.x - start.x) / box.width, y: -(to.y - start.y) / box.height };
  switch (part.kind) {
    case 'center':
      if (handles.center === undefined) return {};
      return { [handles.center]: [snapped(from.center.x + moved.x, SNAP_UV), snapped(from.center.y + moved.y, SNAP_UV)].map(inImage) };
    case 'extent': {
      if (handles.extent === undefined || from.extentPx === null) return {};
      const center = onPage(from.center, box);
      const away = (point: PagePoint) => Math.hypot(point.x - center.x, point.y - center.y);
      return { [handles.extent]: snapped(from.extentPx + (away(to) - away(start)) * box.scale, SNAP_PX) };
    }
    case 'angle':
      if (handles.angle === undefined || from.angleRad === null) return {};
      return { [handles.angle]: snapped(from.angleRad + turnedRad, SNAP_RAD) };
    case 'size': {
      const { size, center } = handles;
      if (size === undefined || from.shape === null) return {};
      const by = alongAxes(from.shape, start, to, box);
      const shape = resized(from.shape, part, by, center === undefined, (value) => snapped(value, SNAP_UV), box);
      return { [size]: [shape.width, shape.height], ...(center === undefined ? {} : { [center]: [shape.center.x, shape.center.y] }) };
    }
    case 'feather': {
      if (handles.feather === undefined || from.shape === null) return {};
      const { y } = alongAxes(from.shape, start, to, box);
      return { [handles.feather]: Math.max(snapped((from.shape.feather ?? 0) - 2 * y, SNAP_FEATHER), 0) };
    }
    case 'rectangle': {
      const { low, high } = handles;
      if (low === undefined || high === undefined || from.rectangle === null) return {};
      const x = span(from.rectangle.low.x, from.rectangle.high.x, part.x, part.y, moved.x, snapped);
      const y = span(from.rectangle.low.y, from.rectangle.high.y, part.y, part.x, moved.y, snapped);
      return { [low]: [x[0], y[0]], [high]: [x[1], y[1]] };
    }
  }
}

/** One axis of a dragged rectangle: the side that moves, or both sides if no side of either axis is dragged. */
function span(
  low: number,
  high: number,
  side: number,
  otherSide: number,
  by: number,
  snapped: (value: number, step: number) => number,
): readonly [number, number] {
  if (side < 0) return [Math.min(inImage(snapped(low + by, SNAP_UV)), high - LEAST_SIDE), high];
  if (side > 0) return [low, Math.max(inImage(snapped(high + by, SNAP_UV)), low + LEAST_SIDE)];
  if (otherSide !== 0) return [low, high];
  const shift = Math.min(Math.max(snapped(low + by, SNAP_UV) - low, -low), 1 - high);
  return [low + shift, high + shift];
}

function inImage(value: number): number {
  return Math.min(Math.max(value, 0), 1);
}

/** The smallest turn from one point to another around a center, counterclockwise on the page. */
export function turnBetween(center: PagePoint, from: PagePoint, to: PagePoint): number {
  const turn = Math.atan2(center.y - to.y, to.x - center.x) - Math.atan2(center.y - from.y, from.x - center.x);
  return Math.atan2(Math.sin(turn), Math.cos(turn));
}
