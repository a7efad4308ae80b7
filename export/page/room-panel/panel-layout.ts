import type { Control } from '../../program/program.ts';

/** Resolution of the panel, pixels per meter: finer than headsets display at its distance. */
export const PX_PER_M = 2000;

/** Sizes in pixels of the panel. Buttons are at least 4 cm high, which is 2.5° at 0.9 m, so that a shaking hand can hit them. */
export const SIZES = {
  /** Transparent margin around the card, for antialiased edges. */
  margin: 8,
  padding: 40,
  columnWidth: 760,
  columnGap: 56,
  /** Maximum height of a column. */
  columnHeight: 900,
  rowGap: 24,
  title: 68,
  titleText: 34,
  text: 38,
  labelHeight: 60,
  press: 92,
  sliderTrack: 84,
  /** Distance between the ends of a slider and of its track: half a knob. */
  trackInset: 28,
  option: 84,
  optionGap: 14,
  optionPadding: 34,
  switchWidth: 104,
} as const;

/** A region of the panel that can be pressed: a control or one option of a choice. In pixels, origin at the top left. */
export interface Part {
  readonly control: number;
  /** Index of the option of a choice; otherwise 0. */
  readonly option: number;
  readonly kind: Control['kind'];
  readonly text: string;
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The label above a slider or a choice. */
export interface Heading {
  readonly control: number;
  readonly text: string;
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface PanelLayout {
  readonly title: string;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly headings: readonly Heading[];
  readonly parts: readonly Part[];
}

/** Measures the width of a text at a font size, both in pixels. */
export type Measure = (text: string, sizePx: number) => number;

/** Places the controls from top to bottom in as many columns as needed. */
export function layOutPanel(title: string, controls: readonly Control[], measure: Measure): PanelLayout {
  const { margin, padding, columnWidth, columnGap, columnHeight, rowGap } = SIZES;
  const headings: Heading[] = [];
  const parts: Part[] = [];
  const left = margin + padding;
  const top = margin + padding + SIZES.title;
  let x = left;
  let y = top;
  let bottom = top;
  for (const [index, control] of controls.entries()) {
    const block = layOutControl(index, control, measure);
    if (y > top && y + block.height > top + columnHeight) {
      x += columnWidth + columnGap;
      y = top;
    }
    const moved = <T extends Heading | Part>(item: T): T => ({ ...item, x: item.x + x, y: item.y + y });
    headings.push(...block.headings.map(moved));
    parts.push(...block.parts.map(moved));
    bottom = Math.max(bottom, y + block.height);
    y += block.height + rowGap;
  }
  const widthPx = x + columnWidth + padding + margin;
  return {
    title: fitText(title, SIZES.titleText, widthPx - 2 * left, measure),
    widthPx,
    heightPx: bottom + padding + margin,
    headings,
    parts,
  };
}

interface Block {
  readonly height: number;
  readonly headings: readonly Heading[];
  readonly parts: readonly Part[];
}

function layOutControl(index: number, control: Control, measure: Measure): Block {
  const { columnWidth: width, labelHeight, text: sizePx } = SIZES;
  const short = (text: string, widthPx: number) => fitText(text, sizePx, widthPx, measure);
  const part = { control: index, option: 0, kind: control.kind, x: 0, y: 0, width } as const;
  const heading = { control: index, x: 0, y: 0, width, height: labelHeight } as const;
  switch (control.kind) {
    case 'slider': {
      const height = labelHeight + SIZES.sliderTrack;
      // The value is at the right of the label.
      return {
        height,
        headings: [{ ...heading, text: short(control.label, width * 0.7) }],
        parts: [{ ...part, text: '', y: labelHeight, height: SIZES.sliderTrack }],
      };
    }
    case 'toggle': {
      const text = short(control.label, width - SIZES.switchWidth - 2 * SIZES.optionPadding);
      return { height: SIZES.press, headings: [], parts: [{ ...part, text, height: SIZES.press }] };
    }
    case 'button':
      return {
        height: SIZES.press,
        headings: [],
        parts: [{ ...part, text: short(control.label, width - 2 * SIZES.optionPadding), height: SIZES.press }],
      };
    case 'choice': {
      const parts = layOutOptions(index, control.options, measure);
      return {
        height: Math.max(labelHeight, ...parts.map(({ y, height }) => y + height)),
        headings: [{ ...heading, text: short(control.label, width) }],
        parts,
      };
    }
  }
}

/** Places options in lines, as words in a text. */
function layOutOptions(control: number, options: readonly string[], measure: Measure): Part[] {
  const { columnWidth, option: height, optionGap, optionPadding, text: sizePx } = SIZES;
  let x = 0;
  let y: number = SIZES.labelHeight;
  return options.map((option, i) => {
    const text = fitText(option, sizePx, columnWidth - 2 * optionPadding, measure);
    const width = Math.min(columnWidth, Math.max(height * 1.4, measure(text, sizePx) + 2 * optionPadding));
    if (x > 0 && x + width > columnWidth) {
      x = 0;
      y += height + optionGap;
    }
    const part: Part = { control, option: i, kind: 'choice', text, x, y, width, height };
    x += width + optionGap;
    return part;
  });
}

/** Shortens a text that is too wide with an ellipsis. */
export function fitText(text: string, sizePx: number, widthPx: number, measure: Measure): string {
  if (measure(text, sizePx) <= widthPx) return text;
  const letters = [...text];
  while (letters.length > 0 && measure(`${letters.join('').trimEnd()}…`, sizePx) > widthPx) letters.pop();
  return `${letters.join('').trimEnd()}…`;
}

/** Returns the index of the part at a point, or −1. */
export function partAt({ parts }: PanelLayout, x: number, y: number): number {
  for (let i = 0; i < parts.length; i++) {
    const part = parts[i];
    if (part && x >= part.x && x < part.x + part.width && y >= part.y && y < part.y + part.height) return i;
  }
  return -1;
}

/** Whether the point is on the card; its round corners count as filled. */
export function isOnPanel({ widthPx, heightPx }: PanelLayout, x: number, y: number): boolean {
  const { margin } = SIZES;
  return x >= margin && x < widthPx - margin && y >= margin && y < heightPx - margin;
}

/** Returns the value of a slider for a point over its track, rounded to a multiple of its step as on the page. */
export function sliderValueAt({ min, max, step }: { min: number; max: number; step: number }, part: Part, x: number): number {
  const { trackInset } = SIZES;
  const along = Math.min(1, Math.max(0, (x - part.x - trackInset) / (part.width - 2 * trackInset)));
  if (!(step > 0)) return min + along * (max - min);
  const steps = Math.min(Math.round((along * (max - min)) / step), Math.floor((max - min) / step + 1e-9));
  // Rounds 0.1 + 0.2 to 0.3.
  return Number((min + steps * step).toPrecision(12));
}
