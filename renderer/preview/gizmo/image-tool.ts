import { imageBox } from './image-box.ts';
import {
  draggedValues,
  type ImageDrag,
  type ImagePart,
  type ImagePlace,
  partAt,
  partsOf,
  readImagePlace,
  turnBetween,
} from './image-place.ts';
import { type ImageBox, onPage } from './page-point.ts';
import type { HandleNames } from './place.ts';
import type { GizmoTool } from './tool.ts';

const MAX_PIXEL_RATIO = 2;
const RADIUS_PX = 6;
/** Radius of the parts of a rectangle or shape. */
const CORNER_PX = 4.5;
/** Colors of the parts, and of the one under the pointer: those of the axes in the room. */
const COLORS = {
  center: '#4c8dff',
  extent: '#7ac74f',
  angle: '#f2495c',
  rectangle: '#4c8dff',
  size: '#4c8dff',
  feather: '#7ac74f',
} as const;
const ACTIVE = '#ffd23f';
const OUTLINE = 'rgb(0 0 0 / 65%)';

/** The gizmo of what has a place in an image: center, radius and angle of a filter, a rectangle, or a shape with a soft edge. */
export function createImageTool(parentElement: HTMLElement): GizmoTool {
  const canvas = parentElement.ownerDocument.createElement('canvas');
  canvas.id = 'image-gizmo';
  parentElement.append(canvas);
  const context = canvas.getContext('2d');
  let handles: HandleNames = {};
  let place: ImagePlace | null = null;
  let box: ImageBox | null = null;
  let active: ImagePart | null = null;
  let drag: ImageDrag | null = null;

  return {
    canvas,
    isActive: () => active !== null,
    hover: (x, y) => {
      const before = active;
      active = place && box ? partAt(handles, place, box, { x, y }) : null;
      return !isSame(active, before);
    },
    leave: () => {
      active = null;
    },
    begin: (x, y) => {
      if (active && place) drag = { part: active, from: place, start: { x, y }, to: { x, y }, turnedRad: 0, snaps: false };
    },
    move: (x, y, snaps) => {
      if (!drag || !box) return;
      const turnedRad = drag.turnedRad + turnBetween(onPage(drag.from.center, box), drag.to, { x, y });
      drag = { ...drag, to: { x, y }, turnedRad, snaps };
    },
    values: () => (drag && box ? draggedValues(handles, drag, box) : {}),
    end: () => {
      drag = null;
      active = null;
    },
    follow: ({ gizmo, inspected, view, box: viewBox, read }) => {
      handles = gizmo.handles;
      canvas.dataset.node = gizmo.node;
      box = imageBox(inspected, gizmo.node, view, viewBox);
      // Also during a drag: the parts show what the params allow.
      place = readImagePlace(handles, read);
      // A node that nothing reads is not in the program.
      return box !== null && Object.values(handles).some((param) => read(param) !== null);
    },
    draw: () => {
      if (!context || !place || !box) return;
      const ratio = Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO);
      const [width, height] = [Math.floor(window.innerWidth * ratio), Math.floor(window.innerHeight * ratio)];
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, window.innerWidth, window.innerHeight);
      drawPlace(context, handles, place, box, drag?.part ?? active);
    },
    setShown: (mode) => {
      canvas.hidden = mode === null;
      canvas.dataset.mode = mode ?? '';
    },
    dispose: () => canvas.remove(),
  };
}

function isSame(a: ImagePart | null, b: ImagePart | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

function drawPlace(
  context: CanvasRenderingContext2D,
  handles: HandleNames,
  place: ImagePlace,
  box: ImageBox,
  active: ImagePart | null,
): void {
  const center = onPage(place.center, box);
  const parts = partsOf(handles, place, box);
  const colorOf = (part: ImagePart) => (isSame(part, active) ? ACTIVE : COLORS[part.kind]);
  const stroke = (color: string, trace: () => void) => {
    for (const [style, lineWidth] of [
      [OUTLINE, 4],
      [color, 2],
    ] as const) {
      context.beginPath();
      trace();
      Object.assign(context, { strokeStyle: style, lineWidth });
      context.stroke();
    }
  };
  const radius = place.extentPx === null ? 0 : place.extentPx / box.scale;
  if (place.extentPx !== null) stroke(colorOf({ kind: 'extent' }), () => context.arc(center.x, center.y, radius, 0, 2 * Math.PI));
  if (place.rectangle) {
    const [low, high] = [onPage(place.rectangle.low, box), onPage(place.rectangle.high, box)];
    stroke(COLORS.rectangle, () => context.rect(low.x, high.y, high.x - low.x, low.y - high.y));
  }
  if (place.shape) {
    const { angleRad, width, height, feather } = place.shape;
    const outline = (beyond: number) => {
      const [across, up] = [(width + beyond) * box.height, (height + beyond) * box.height];
      context.save();
      context.translate(center.x, center.y);
      context.rotate(-angleRad);
      context.roundRect(-across / 2, -up / 2, across, up, (beyond / 2) * box.height);
      context.restore();
    };
    if (feather) stroke(colorOf({ kind: 'feather' }), () => outline(feather));
    stroke(COLORS.size, () => outline(0));
  }
  for (const { part, at } of parts) {
    if (part.kind !== 'angle') continue;
    stroke(colorOf(part), () => {
      context.moveTo(center.x, center.y);
      context.lineTo(at.x, at.y);
    });
  }
  // The first part is drawn last, over the others.
  for (const { part, at } of [...parts].reverse()) {
    context.beginPath();
    context.arc(at.x, at.y, part.kind === 'rectangle' || part.kind === 'size' ? CORNER_PX : RADIUS_PX, 0, 2 * Math.PI);
    Object.assign(context, { strokeStyle: OUTLINE, lineWidth: 3, fillStyle: colorOf(part) });
    context.stroke();
    context.fill();
  }
}
