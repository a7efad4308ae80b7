import type { editor } from 'monaco-editor/editor';
import { uiScale } from '../ui/appearance.ts';

/** Font size and line height for the UI scale. */
export function sizesFor(scale: number): editor.IEditorOptions {
  return { fontSize: 12.5 * scale, lineHeight: Math.round(19 * scale) };
}

/** Options of every shader editor. */
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
    // Dropped files become nodes, as elsewhere in the window.
    dropIntoEditor: { enabled: false },
    fixedOverflowWidgets: true,
    overviewRulerLanes: 1,
    stickyScroll: { enabled: false },
    // Marks problems in read-only texts, too.
    renderValidationDecorations: 'on',
    wordBasedSuggestions: 'off',
    suggest: { showWords: false, preview: false },
    // `color-marks.ts` draws swatches that open sliders.
    colorDecorators: false,
  };
}

/** Makes the text read-only if there is a reason, which Monaco shows on an attempt to type. */
export function readOnlyOptions(reason: string | null): editor.IEditorOptions {
  return { readOnly: reason !== null, readOnlyMessage: { value: reason ?? '' } };
}
