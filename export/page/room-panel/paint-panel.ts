import type { Control } from '../../program/program.ts';
import { sliderText } from '../control-elements.ts';
import type { ControlValues } from '../control-values.ts';
import { type Heading, type Measure, type PanelLayout, type Part, SIZES } from './panel-layout.ts';

/** Colors of the panel, as in the page's style sheet. */
const CARD = 'rgb(28 31 37 / 92%)';
const EDGE = 'rgb(255 255 255 / 16%)';
const TEXT = '#f4f2ec';
const QUIET = '#c3c5cb';
const ACCENT = '#ffcf5c';
const ON_ACCENT = '#221a00';
const FILL = 'rgb(255 255 255 / 10%)';
const FILL_HOVER = 'rgb(255 255 255 / 22%)';
const FILL_HELD = 'rgb(255 255 255 / 34%)';
const TRACK = 'rgb(255 255 255 / 24%)';

const FAMILY = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif';
const RADIUS = 44;
const PART_RADIUS = 22;

/** State of a part: idle, hit by a ray, or held. */
export type Touch = 'none' | 'hover' | 'held';

export function createMeasure(context: CanvasRenderingContext2D): Measure {
  return (text, sizePx) => {
    context.font = fontOf(sizePx);
    return context.measureText(text).width;
  };
}

/** How far the outline of a part reaches beyond it, pixels. */
const OUTLINE_PX = 3;

/**
 * Paints a part or a heading of the panel anew. Returns its pixels and where they are in the image of the canvas, whose context is scaled by
 * `scale`.
 */
export function repaintArea(
  context: CanvasRenderingContext2D,
  layout: PanelLayout,
  values: ControlValues,
  touchOf: (part: number) => Touch,
  { x, y, width, height }: Part | Heading,
  scale: number,
): { readonly pixels: ImageData; readonly x: number; readonly y: number } {
  const left = Math.max(0, Math.floor((x - OUTLINE_PX) * scale));
  const top = Math.max(0, Math.floor((y - OUTLINE_PX) * scale));
  const widthPx = Math.min(context.canvas.width, Math.ceil((x + width + OUTLINE_PX) * scale)) - left;
  const heightPx = Math.min(context.canvas.height, Math.ceil((y + height + OUTLINE_PX) * scale)) - top;
  context.save();
  context.beginPath();
  context.rect(left / scale, top / scale, widthPx / scale, heightPx / scale);
  context.clip();
  paintPanel(context, layout, values, touchOf);
  context.restore();
  return { pixels: context.getImageData(left, top, widthPx, heightPx), x: left, y: top };
}

/** Paints the whole panel from the current values. */
export function paintPanel(
  context: CanvasRenderingContext2D,
  layout: PanelLayout,
  values: ControlValues,
  touchOf: (part: number) => Touch,
): void {
  const { margin, padding, titleText, text } = SIZES;
  const { widthPx, heightPx } = layout;
  context.clearRect(0, 0, widthPx, heightPx);
  context.textBaseline = 'middle';
  round(context, margin, margin, widthPx - 2 * margin, heightPx - 2 * margin, RADIUS);
  context.fillStyle = CARD;
  context.fill();
  context.lineWidth = 3;
  context.strokeStyle = EDGE;
  context.stroke();
  context.fillStyle = QUIET;
  context.font = fontOf(titleText);
  context.textAlign = 'left';
  context.fillText(layout.title, margin + padding, margin + padding + titleText / 2);
  context.font = fontOf(text);
  for (const heading of layout.headings) {
    const control = values.controls[heading.control];
    context.fillStyle = TEXT;
    context.textAlign = 'left';
    context.fillText(heading.text, heading.x, heading.y + heading.height / 2);
    if (control?.kind !== 'slider') continue;
    context.fillStyle = ACCENT;
    context.textAlign = 'right';
    context.fillText(sliderText(control, values.get(heading.control)), heading.x + heading.width, heading.y + heading.height / 2);
  }
  for (const [i, part] of layout.parts.entries()) {
    const control = values.controls[part.control];
    if (control) paintPart(context, part, control, values.get(part.control), touchOf(i));
  }
}

function paintPart(context: CanvasRenderingContext2D, part: Part, control: Control, value: number, touch: Touch): void {
  const chosen = control.kind === 'choice' && part.option === value;
  const ink = chosen ? ON_ACCENT : TEXT;
  switch (control.kind) {
    case 'slider':
      paintSlider(context, part, (value - control.min) / Math.max(1e-12, control.max - control.min), touch);
      break;
    case 'toggle':
      fillPart(context, part, fillOf(touch));
      write(context, part.text, part.x + SIZES.optionPadding, part, ink, 'left');
      paintSwitch(context, part, value !== 0);
      break;
    case 'button':
    case 'choice':
      fillPart(context, part, chosen ? ACCENT : fillOf(touch));
      if (chosen && touch !== 'none') outline(context, part);
      write(context, part.text, part.x + part.width / 2, part, ink, 'center');
      break;
    default:
      control satisfies never;
  }
}

function paintSlider(context: CanvasRenderingContext2D, part: Part, along: number, touch: Touch): void {
  if (touch !== 'none') fillPart(context, part, FILL);
  const { trackInset } = SIZES;
  const thickness = 14;
  const from = part.x + trackInset;
  const length = part.width - 2 * trackInset;
  const y = part.y + part.height / 2;
  const at = from + Math.min(1, Math.max(0, along)) * length;
  round(context, from, y - thickness / 2, length, thickness, thickness / 2);
  context.fillStyle = TRACK;
  context.fill();
  round(context, from, y - thickness / 2, at - from, thickness, thickness / 2);
  context.fillStyle = ACCENT;
  context.fill();
  disc(context, at, y, touch === 'none' ? 22 : 27, touch === 'held' ? '#ffffff' : ACCENT);
}

function paintSwitch(context: CanvasRenderingContext2D, part: Part, on: boolean): void {
  const width = SIZES.switchWidth;
  const height = 56;
  const x = part.x + part.width - SIZES.optionPadding - width;
  const y = part.y + (part.height - height) / 2;
  round(context, x, y, width, height, height / 2);
  context.fillStyle = on ? ACCENT : TRACK;
  context.fill();
  disc(context, on ? x + width - height / 2 : x + height / 2, y + height / 2, 21, on ? ON_ACCENT : TEXT);
}

function fillOf(touch: Touch): string {
  return touch === 'held' ? FILL_HELD : touch === 'hover' ? FILL_HOVER : FILL;
}

function fillPart(context: CanvasRenderingContext2D, { x, y, width, height }: Part, fill: string): void {
  round(context, x, y, width, height, PART_RADIUS);
  context.fillStyle = fill;
  context.fill();
}

function outline(context: CanvasRenderingContext2D, { x, y, width, height }: Part): void {
  round(context, x, y, width, height, PART_RADIUS);
  context.lineWidth = 5;
  context.strokeStyle = TEXT;
  context.stroke();
}

function write(context: CanvasRenderingContext2D, text: string, x: number, part: Part, fill: string, align: CanvasTextAlign): void {
  context.fillStyle = fill;
  context.textAlign = align;
  context.fillText(text, x, part.y + part.height / 2 + 1);
}

function disc(context: CanvasRenderingContext2D, x: number, y: number, radius: number, fill: string): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
}

function round(context: CanvasRenderingContext2D, x: number, y: number, width: number, height: number, radius: number): void {
  context.beginPath();
  context.roundRect(x, y, width, height, radius);
}

function fontOf(sizePx: number): string {
  return `500 ${sizePx}px ${FAMILY}`;
}
