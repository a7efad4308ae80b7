import { editor } from 'monaco-editor/editor';
import { GLSL_LANGUAGE } from './glsl-language.ts';
import { optionsFor, readOnlyOptions } from './view-options.ts';

export interface Comparison {
  /** Sets why the text is read-only; `null` makes it editable. */
  setReadOnly(reason: string | null): void;
  focus(): void;
  dispose(): void;
}

/** Shows a diff of the text and its original over the editor. The text stays editable. */
export function compareWith(
  parent: HTMLElement,
  original: string,
  model: editor.ITextModel,
  readOnly: string | null,
  onLeave: () => void,
): Comparison {
  const place = document.createElement('div');
  place.className = 'code-view code-compare';
  parent.append(place);
  const before = editor.createModel(original, GLSL_LANGUAGE);
  const view = editor.createDiffEditor(place, {
    ...optionsFor(parent),
    originalEditable: false,
    ...readOnlyOptions(readOnly),
    renderSideBySide: true,
    useInlineViewWhenSpaceIsLimited: true,
    renderSideBySideInlineBreakpoint: 620,
    originalAriaLabel: 'Original',
    modifiedAriaLabel: 'Shader source, compared',
  });
  view.setModel({ original: before, modified: model });
  const blurred = view.getModifiedEditor().onDidBlurEditorText(onLeave);
  view.getModifiedEditor().focus();
  // Scrolls to the first difference.
  const first = view.onDidUpdateDiff(() => {
    first.dispose();
    view.revealFirstDiff();
  });
  return {
    setReadOnly: (reason) => view.updateOptions(readOnlyOptions(reason)),
    focus: () => view.getModifiedEditor().focus(),
    dispose: () => {
      first.dispose();
      blurred.dispose();
      view.setModel(null);
      view.dispose();
      before.dispose();
      place.remove();
    },
  };
}
