import { ICON_LINE, ICON_SIDE, ICONS, type IconName } from './icons.ts';
import { FONT_PX, type LabelLayout, LINE_HEIGHT_PX, type MeasureText } from './layout.ts';

/** The fonts of labels, in the page and in the texture. They show every script that the device has a font for. */
export const FONT_FAMILY = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif';
export const TEXT_WEIGHT = 500;
export const TITLE_WEIGHT = 700;
export const CORNER_PX = 14;

/** Painted pixels per label pixel: enough to be sharp at arm's length in a headset. */
const DENSITY = 2;

type Context2d = OffscreenCanvasRenderingContext2D;

export interface LabelColors {
  /** The color of the text, as a CSS color; `background` likewise. */
  readonly text: string;
  readonly background: string;
}

/** A canvas that measures and paints labels. */
export interface LabelPainter {
  readonly canvas: OffscreenCanvas;
  readonly measure: MeasureText;
  /** Paints the whole label, and gives the canvas the size of the layout. */
  paint(layout: LabelLayout, icon: IconName | null, colors: LabelColors): void;
}

export function createLabelPainter(): LabelPainter {
  const canvas = new OffscreenCanvas(1, 1);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no 2D canvas.');
  return {
    canvas,
    measure: (text, isTitle) => {
      setFont(context, isTitle);
      return context.measureText(text).width;
    },
    paint: (layout, icon, colors) => {
      canvas.width = Math.ceil(layout.widthPx * DENSITY);
      canvas.height = Math.ceil(layout.heightPx * DENSITY);
      context.setTransform(canvas.width / layout.widthPx, 0, 0, canvas.height / layout.heightPx, 0, 0);
      context.beginPath();
      context.roundRect(0, 0, layout.widthPx, layout.heightPx, CORNER_PX);
      context.fillStyle = colors.background;
      context.fill();
      context.fillStyle = colors.text;
      context.strokeStyle = colors.text;
      for (const line of layout.lines) paintLine(context, line);
      if (icon !== null && layout.icon) paintIcon(context, icon, layout.icon);
    },
  };
}

function paintLine(context: Context2d, { text, isTitle, xPx, topPx, widthPx, direction }: LabelLayout['lines'][number]): void {
  setFont(context, isTitle);
  context.direction = direction;
  context.textAlign = 'start';
  context.textBaseline = 'alphabetic';
  const { fontBoundingBoxAscent: ascent, fontBoundingBoxDescent: descent } = context.measureText(text);
  // CSS 2.1 §10.8.1: half of what the line is higher than its font is above the ascent.
  const baseline = topPx + (LINE_HEIGHT_PX - ascent - descent) / 2 + ascent;
  context.fillText(text, direction === 'rtl' ? xPx + widthPx : xPx, baseline);
}

function paintIcon(context: Context2d, icon: IconName, { xPx, yPx, sizePx }: NonNullable<LabelLayout['icon']>): void {
  context.save();
  context.translate(xPx, yPx);
  context.scale(sizePx / ICON_SIDE, sizePx / ICON_SIDE);
  context.lineWidth = ICON_LINE;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  context.stroke(new Path2D(ICONS[icon]));
  context.restore();
}

/** Sets the font again, because a canvas loses it when its size is set. */
function setFont(context: Context2d, isTitle: boolean): void {
  context.font = `${isTitle ? TITLE_WEIGHT : TEXT_WEIGHT} ${FONT_PX}px ${FONT_FAMILY}`;
  // Without rounding of advances, which would make lines wider in the page than here.
  context.textRendering = 'geometricPrecision';
}
