import type { editor } from 'monaco-editor/editor';
import { uiScale } from '../ui/appearance.ts';

/** Its letters are as large as the person wants text. */
export function sizesFor(scale: number): editor.IEditorOptions {
  return { fontSize: 12.5 * scale, lineHeight: Math.round(19 * scale) };
}

/** What every view of a shader's text looks like. */
export function optionsFor(parent: HTMLElement): editor.IEditorOptions & editor.IGlobalEditorOptions {
  return {
    automaticLayout: true,
    fontFamily: getComputedStyle(parent).getPropertyValue('--mono'),
    ...sizesFor(uiScale()),
    minimap: { enabled: false },
    scrollBeyondLastLine: false,
    renderLineHighlight: 'line',
    padding: { top: 8, bottom: 8 },
    tabSize: 2,
    fixedOverflowWidgets: true,
    overviewRulerLanes: 1,
    stickyScroll: { enabled: false },
    // Mistakes are to be seen in a text that is to be read, too.
    renderValidationDecorations: 'on',
    wordBasedSuggestions: 'off',
    suggest: { showWords: false, preview: false },
    // The text's own square before a colour is the one that opens sliders.
    colorDecorators: false,
  };
}

/** Whether the text can be typed in; where it cannot, what is said to someone who tries. */
export function readOnlyOptions(reason: string | null): editor.IEditorOptions {
  return { readOnly: reason !== null, readOnlyMessage: { value: reason ?? '' } };
}
