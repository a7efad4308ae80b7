import { editor } from 'monaco-editor/editor';
import { GLSL_LANGUAGE } from './glsl-language.ts';
import { optionsFor } from './view-options.ts';

/** Shows a text over the editor, beside the one that it was copied from. The text itself can still be typed in. */
export function compareWith(
  parent: HTMLElement,
  original: string,
  model: editor.ITextModel,
  readOnly: boolean,
  onLeave: () => void,
): { dispose(): void } {
  const place = document.createElement('div');
  place.className = 'code-view code-compare';
  parent.append(place);
  const before = editor.createModel(original, GLSL_LANGUAGE);
  const view = editor.createDiffEditor(place, {
    ...optionsFor(parent),
    originalEditable: false,
    readOnly,
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
