import { editor } from 'monaco-editor/editor';
import { type Colour, coloursOf } from '../../export/glsl/language/literals.ts';
import { documentOf, rangeOf, type ShaderTexts } from './shader-models.ts';

/** Class of the small square before each colour of the text. */
export const SWATCH_CLASS = 'tuner-swatch';

export interface ColourMarks {
  dispose(): void;
}

/** Shows the colours that the text holds as numbers. */
export function createColourMarks(view: editor.ICodeEditor, texts: ShaderTexts): ColourMarks {
  const sheet = new CSSStyleSheet();
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  const known = new Set<string>();
  const marks = view.createDecorationsCollection();
  const refresh = () => {
    const model = view.getModel();
    const colours = model ? coloursOf(model.getValue(), documentOf(model, texts).outline) : [];
    marks.set(
      colours.map(({ range, colour }) => ({
        range: { ...rangeOf(range), endLineNumber: range.start.line, endColumn: range.start.column },
        options: {
          description: 'colour',
          showIfCollapsed: true,
          before: {
            content: '\u200b',
            inlineClassName: `${SWATCH_CLASS} ${classOf(colour)}`,
            inlineClassNameAffectsLetterSpacing: true,
            cursorStops: editor.InjectedTextCursorStops.None,
          },
        },
      })),
    );
  };
  const classOf = (colour: Colour): string => {
    const bytes = colour.map((value) => Math.round(value * 255));
    const name = `tuner-is-${bytes.join('-')}`;
    if (!known.has(name)) {
      known.add(name);
      const [red, green, blue, alpha = 255] = bytes;
      sheet.insertRule(`.${name} { background: rgb(${red} ${green} ${blue} / ${alpha / 255}); }`, sheet.cssRules.length);
    }
    return name;
  };
  const parts = [view.onDidChangeModel(refresh), view.onDidChangeModelContent(refresh)];
  refresh();
  return {
    dispose: () => {
      for (const part of parts) part.dispose();
      marks.clear();
      document.adoptedStyleSheets = document.adoptedStyleSheets.filter((other) => other !== sheet);
    },
  };
}
