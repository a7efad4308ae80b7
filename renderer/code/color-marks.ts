import { editor } from 'monaco-editor/editor';
import { type Color, colorsOf } from '../../export/glsl/language/literals.ts';
import { debounce, pageClock } from '../clock.ts';
import { rangeOf } from './shader-models.ts';

const REST_MS = 300;

/** Class of the swatch before each color in the text. */
export const SWATCH_CLASS = 'tuner-swatch';

export interface ColorMarks {
  dispose(): void;
}

/** Marks color literals in the text with swatches. */
export function createColorMarks(view: editor.ICodeEditor): ColorMarks {
  const sheet = new CSSStyleSheet();
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  const known = new Set<string>();
  const marks = view.createDecorationsCollection();
  const refresh = () => {
    const model = view.getModel();
    const colors = model ? colorsOf(model.getValue()) : [];
    marks.set(
      colors.map(({ range, color }) => ({
        range: { ...rangeOf(range), endLineNumber: range.start.line, endColumn: range.start.column },
        options: {
          description: 'color',
          showIfCollapsed: true,
          before: {
            content: '\u200b',
            inlineClassName: `${SWATCH_CLASS} ${classOf(color)}`,
            inlineClassNameAffectsLetterSpacing: true,
            cursorStops: editor.InjectedTextCursorStops.None,
          },
        },
      })),
    );
  };
  const classOf = (color: Color): string => {
    const bytes = color.map((value) => Math.round(value * 255));
    const name = `tuner-is-${bytes.join('-')}`;
    if (!known.has(name)) {
      known.add(name);
      const [red, green, blue, alpha = 255] = bytes;
      sheet.insertRule(`.${name} { background: rgb(${red} ${green} ${blue} / ${alpha / 255}); }`, sheet.cssRules.length);
    }
    return name;
  };
  // Monaco moves the marks with the text. The text is read again only after a pause.
  const rest = debounce(pageClock, REST_MS, refresh);
  const parts = [view.onDidChangeModel(refresh), view.onDidChangeModelContent(rest.trigger), { dispose: rest.cancel }];
  refresh();
  return {
    dispose: () => {
      for (const part of parts) part.dispose();
      marks.clear();
      document.adoptedStyleSheets = document.adoptedStyleSheets.filter((other) => other !== sheet);
    },
  };
}
