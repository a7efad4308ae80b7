import { editor } from 'monaco-editor/editor';
import { GLSL_LANGUAGE } from './glsl-language.ts';
import { optionsFor, readOnlyOptions } from './view-options.ts';

export interface Comparison {
  /** `null` where the text can be typed in, else why not. */
  setReadOnly(reason: string | null): void;
  focus(): void;
  dispose(): void;
}

/** Shows a text over the editor, beside the one that it was copied from. The text itself can still be typed in. */
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
  // What is the same is nothing to look at first.
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
