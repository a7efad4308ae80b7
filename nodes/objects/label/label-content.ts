import type { NodeContext } from '../../kit/runtime.ts';
import { createTextWriter, type TextWriter } from '../../kit/text-template.ts';
import type { definition } from './definition.ts';
import type { IconName } from './icons.ts';
import { FONT_PX, type LabelLayout, layOutLabel, MAX_CHARACTERS, shorten } from './layout.ts';
import { createLabelPainter, type LabelColors, type LabelPainter } from './paint-label.ts';

const NAMES = ['a', 'b'] as const;
const DECIMALS = 2;

/** The content of a label, which the page and the texture show. */
export interface LabelContentView {
  /** A number that is raised when anything of the content changes. */
  readonly version: number;
  readonly layout: LabelLayout;
  readonly icon: IconName | null;
  readonly colors: LabelColors;
  readonly canvas: OffscreenCanvas;
  /** Paints the content on `canvas`. */
  paint(): void;
}

export interface LabelContentSource extends LabelContentView {
  /** Reads the params; returns false if there is nothing to show. Allocates only when the content changes. */
  update(): boolean;
}

export function createLabelContent({ params, config, report }: NodeContext<typeof definition>): LabelContentSource {
  const icon = config.icon === 'none' ? null : config.icon;
  const title = createTemplateText();
  const text = createTemplateText();
  const colorsNow = new Float64Array(8).fill(Number.NaN);
  let width = Number.NaN;
  let painter: LabelPainter | null = null;
  let layout: LabelLayout = { widthPx: 0, heightPx: 0, lines: [], icon: null };
  let colors: LabelColors = { text: '', background: '' };
  let version = 0;
  let isEmpty = true;

  function numberOf(name: string): number {
    return params[name as (typeof NAMES)[number]].value;
  }

  function readColors(): boolean {
    let changed = false;
    for (let i = 0; i < 8; i++) {
      const value = (i < 4 ? params.color.value[i] : params.background.value[i - 4]) ?? 0;
      changed ||= value !== colorsNow[i];
      colorsNow[i] = value;
    }
    if (changed) colors = { text: cssColor(params.color.value), background: cssColor(params.background.value) };
    return changed;
  }

  function layOut(): void {
    painter ??= createLabelPainter();
    const words = shorten(text.words);
    const heading = shorten(title.words);
    if (text.words.length > MAX_CHARACTERS || title.words.length > MAX_CHARACTERS) {
      report({
        code: 'SCR059',
        severity: 'warning',
        port: text.words.length > MAX_CHARACTERS ? 'text' : 'title',
        message: `The text has more than ${MAX_CHARACTERS} characters. The rest is not shown.`,
        fix: 'Shorten it.',
      });
    }
    layout = layOutLabel({ title: heading, text: words, hasIcon: icon !== null, maxWidthPx: width * FONT_PX }, painter.measure);
    isEmpty = layout.lines.length === 0 && icon === null;
  }

  const content: LabelContentSource = {
    get version() {
      return version;
    },
    get layout() {
      return layout;
    },
    icon,
    get colors() {
      return colors;
    },
    get canvas() {
      painter ??= createLabelPainter();
      return painter.canvas;
    },
    paint: () => {
      painter ??= createLabelPainter();
      painter.paint(layout, icon, colors);
    },
    update: () => {
      // Each is read, so that each knows its last value.
      const titleChanged = title.read(params.title.value, numberOf);
      const textChanged = text.read(params.text.value, numberOf);
      const widthChanged = width !== params.width.value;
      const colorsChanged = readColors();
      width = params.width.value;
      if (titleChanged || textChanged || widthChanged) layOut();
      if (titleChanged || textChanged || widthChanged || colorsChanged) version++;
      return !isEmpty;
    },
  };
  return content;
}

/** Creates a function that fills numbers into a text. The text is written anew only if the template or a digit has changed. */
function createTemplateText() {
  let template: string | null = null;
  let writer: TextWriter | null = null;
  const self = {
    words: '',
    read: (next: string, numberOf: (name: string) => number): boolean => {
      const isNew = next !== template || writer === null;
      if (isNew) writer = createTextWriter(next, NAMES, DECIMALS, 'en');
      template = next;
      const changed = writer?.round(numberOf) === true || isNew;
      if (changed && writer) self.words = writer.write('');
      return changed;
    },
  };
  return self;
}

function cssColor(color: Readonly<Float64Array>): string {
  const [r = 0, g = 0, b = 0, a = 1] = color;
  return `rgb(${r * 255} ${g * 255} ${b * 255} / ${a})`;
}
