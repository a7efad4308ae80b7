import 'monaco-editor/features/codeEditor/register';
import 'monaco-editor/features/bracketMatching/register';
import 'monaco-editor/features/caretOperations/register';
import 'monaco-editor/features/clipboard/register';
import 'monaco-editor/features/codicon/register';
import 'monaco-editor/features/comment/register';
import 'monaco-editor/features/contextmenu/register';
import 'monaco-editor/features/cursorUndo/register';
import 'monaco-editor/features/diffEditor/register';
import 'monaco-editor/features/find/register';
import 'monaco-editor/features/folding/register';
import 'monaco-editor/features/format/register';
import 'monaco-editor/features/gotoError/register';
import 'monaco-editor/features/gotoSymbol/register';
import 'monaco-editor/features/hover/register';
import 'monaco-editor/features/indentation/register';
import 'monaco-editor/features/linesOperations/register';
import 'monaco-editor/features/multicursor/register';
import 'monaco-editor/features/parameterHints/register';
import 'monaco-editor/features/readOnlyMessage/register';
import 'monaco-editor/features/referenceSearch/register';
import 'monaco-editor/features/rename/register';
import 'monaco-editor/features/snippet/register';
import 'monaco-editor/features/suggest/register';
import 'monaco-editor/features/wordHighlighter/register';
import 'monaco-editor/features/wordOperations/register';
import 'monaco-editor/editor/contrib/gotoSymbol/browser/goToCommands';
import 'monaco-editor/editor/contrib/suggest/browser/suggestController';
import { editor, KeyCode, KeyMod, MarkerSeverity } from 'monaco-editor/editor';
import type { NeighborFile } from '../../export/glsl/language/shader-document.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { createColorMarks } from './color-marks.ts';
import { type Comparison, compareWith } from './compare.ts';
import { registerGlslLanguage } from './glsl-language.ts';
import { followTheme } from './monaco-theme.ts';
import { registerProviders } from './providers.ts';
import { forgetModels, neighborFileOf, type ShaderTexts, shaderModel } from './shader-models.ts';
import { createTuning } from './tune-literals.ts';
import { optionsFor, readOnlyOptions, sizesFor } from './view-options.ts';

const OWNER = 'scrim';

const SEVERITIES = { error: MarkerSeverity.Error, warning: MarkerSeverity.Warning, info: MarkerSeverity.Info } as const;

export interface ShownText {
  /** Key of the model, which keeps its caret and undo history. */
  readonly name: string;
  /** File name in the library or project. */
  readonly file: string;
  readonly text: string;
  /** Why the text is read-only; null if it is editable. */
  readonly readOnly: string | null;
}

/** Text editor for shaders. Only this folder imports Monaco; it loads when the panel first opens. */
export interface ShaderEditor {
  /** Shows a text. A text that was shown before keeps its caret and undo history. */
  show(shown: ShownText): void;
  /** Shows a diff against `original`; null shows the text alone. */
  compare(original: string | null): void;
  /** Marks problems in the shown text. */
  mark(diagnostics: readonly Diagnostic[]): void;
  goTo(line: number, column: number): void;
  focus(): void;
  /** Sets the text size as a factor; 1 is the default. */
  setScale(scale: number): void;
  /** Disposes models, which outlive their view, except those that `keep` accepts. */
  forget(keep: (name: string) => boolean): void;
  dispose(): void;
}

export interface ShaderEditorOptions {
  readonly texts: ShaderTexts;
  /** Called on each user edit, not for `show`. `live`: recompile at once, without waiting for a pause. */
  readonly onType: (name: string, text: string, live: boolean) => void;
  /** Called when typing ends: the editor lost focus, or another action begins. */
  readonly onLeave: () => void;
  /** Called before the edits of a rename, which form one undo step with the new text of the neighboring file. */
  readonly onRename: (beside: NeighborFile) => void;
  /** Called to open a place in a chunk (`chunks/NAME.glsl`) or in the ISF file beside a vertex shader. */
  readonly onOther: (file: string, line: number, column: number) => void;
}

/** Caret and scroll position of models that are not shown. Survives the view. */
const viewStates = new WeakMap<editor.ITextModel, editor.ICodeEditorViewState>();

export function createShaderEditor(parent: HTMLElement, { texts, onType, onLeave, onRename, onOther }: ShaderEditorOptions): ShaderEditor {
  (globalThis as { MonacoEnvironment?: unknown }).MonacoEnvironment = {
    getWorker: () => new Worker(new URL('./monaco.worker.ts', import.meta.url), { type: 'module' }),
  };
  const place = document.createElement('div');
  place.className = 'code-view';
  parent.append(place);
  const view = editor.create(place, { ...optionsFor(parent), ariaLabel: 'Shader source', model: null });
  let shown: { readonly name: string; readonly model: editor.ITextModel; readonly readOnly: string | null } | null = null;
  let comparison: Comparison | null = null;
  let ours = false;
  let tuning = false;
  let stepNext = false;

  const keepPlace = () => {
    const model = view.getModel();
    const state = view.saveViewState();
    if (model && state) viewStates.set(model, state);
  };
  const setModel = (model: editor.ITextModel, readOnly: string | null) => {
    if (view.getModel() !== model) {
      keepPlace();
      view.setModel(model);
      const state = viewStates.get(model);
      if (state) view.restoreViewState(state);
    }
    view.updateOptions(readOnlyOptions(readOnly));
  };
  const onChange = (model: editor.ITextModel) => {
    if (ours || !shown || model !== shown.model) return;
    onType(shown.name, model.getValue(), tuning);
    if (stepNext) onLeave();
    stepNext = false;
  };
  const listened = new Map<editor.ITextModel, { dispose(): void }>();
  const listen = (model: editor.ITextModel) => {
    if (listened.has(model)) return;
    const part = model.onDidChangeContent(() => onChange(model));
    listened.set(model, part);
    model.onWillDispose(() => listened.delete(model));
  };

  const parts = [
    registerGlslLanguage(),
    followTheme(),
    registerProviders({
      texts,
      onRename: (beside) => {
        onLeave();
        if (beside) onRename(beside);
        stepNext = true;
      },
    }),
    // Monaco uses another key on Linux; this one works on all systems.
    disposer(editor.addKeybindingRule({ keybinding: KeyMod.Shift | KeyMod.Alt | KeyCode.KeyF, command: 'editor.action.formatDocument' })),
    disposer(view.onDidBlurEditorText(onLeave)),
    disposer(
      editor.registerEditorOpener({
        openCodeEditor: (_, resource, target) => {
          const file = neighborFileOf(resource);
          if (file === null) return false;
          if (!target) onOther(file, 1, 1);
          else if ('lineNumber' in target) onOther(file, target.lineNumber, target.column);
          else onOther(file, target.startLineNumber, target.startColumn);
          return true;
        },
      }),
    ),
    disposer(createColorMarks(view)),
    disposer(
      createTuning(view, {
        onStart: () => {
          onLeave();
          tuning = true;
        },
        onEnd: () => {
          tuning = false;
          onLeave();
        },
      }),
    ),
  ];

  return {
    setScale: (scale) => view.updateOptions(sizesFor(scale)),
    show: ({ name, file, text, readOnly }) => {
      const model = shaderModel(name, file, text);
      listen(model);
      if (shown?.model !== model) {
        comparison?.dispose();
        comparison = null;
      }
      shown = { name, model, readOnly };
      // An edit instead of `setValue` keeps the undo history across external changes.
      ours = true;
      if (model.getValue() !== text) model.pushEditOperations([], [{ range: model.getFullModelRange(), text }], () => null);
      ours = false;
      comparison?.setReadOnly(readOnly);
      setModel(model, readOnly);
    },
    compare: (original) => {
      comparison?.dispose();
      comparison = original === null || !shown ? null : compareWith(parent, original, shown.model, shown.readOnly, onLeave);
    },
    mark: (diagnostics) => {
      if (shown) markDiagnostics(shown.model, diagnostics);
    },
    goTo: (line, column) => {
      view.setPosition({ lineNumber: line, column });
      view.revealLineInCenterIfOutsideViewport(line);
      view.focus();
    },
    focus: () => (comparison ?? view).focus(),
    forget: forgetModels,
    dispose: () => {
      comparison?.dispose();
      keepPlace();
      for (const part of listened.values()) part.dispose();
      for (const part of parts) part();
      view.dispose();
      place.remove();
    },
  };
}

function disposer(part: { dispose(): void }): () => void {
  return () => part.dispose();
}

function markDiagnostics(model: editor.ITextModel, diagnostics: readonly Diagnostic[]): void {
  editor.setModelMarkers(
    model,
    OWNER,
    diagnostics.map((diagnostic) => markerOf(model, diagnostic)),
  );
}

/** Marks from the column to the end of its word, or the whole line if the column is unknown. */
function markerOf(model: editor.ITextModel, { line, column, message, fix, severity, code }: Diagnostic): editor.IMarkerData {
  const startLineNumber = Math.min(Math.max(line ?? 1, 1), model.getLineCount());
  const startColumn = column ?? model.getLineFirstNonWhitespaceColumn(startLineNumber);
  const word = column === undefined ? null : model.getWordAtPosition({ lineNumber: startLineNumber, column: startColumn });
  return {
    severity: SEVERITIES[severity],
    message: fix === undefined ? message : `${message}\n${fix}`,
    code,
    startLineNumber,
    startColumn,
    endLineNumber: startLineNumber,
    endColumn: column === undefined ? model.getLineMaxColumn(startLineNumber) : (word?.endColumn ?? startColumn + 1),
  };
}
