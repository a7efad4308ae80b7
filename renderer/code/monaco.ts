import { editor, MarkerSeverity, Uri } from 'monaco-editor/editor';
import 'monaco-editor/features/codeEditor/register';
import 'monaco-editor/features/bracketMatching/register';
import 'monaco-editor/features/caretOperations/register';
import 'monaco-editor/features/clipboard/register';
import 'monaco-editor/features/comment/register';
import 'monaco-editor/features/contextmenu/register';
import 'monaco-editor/features/cursorUndo/register';
import 'monaco-editor/features/find/register';
import 'monaco-editor/features/folding/register';
import 'monaco-editor/features/gotoError/register';
import 'monaco-editor/features/hover/register';
import 'monaco-editor/features/indentation/register';
import 'monaco-editor/features/linesOperations/register';
import 'monaco-editor/features/multicursor/register';
import 'monaco-editor/features/suggest/register';
import 'monaco-editor/features/wordHighlighter/register';
import 'monaco-editor/features/wordOperations/register';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { ISF_LANGUAGE, registerIsfLanguage } from './glsl-language.ts';

/** One text editor for shaders. Everything of Monaco is behind this file, which is loaded when the panel is first opened. */
export interface ShaderEditor {
  /** Shows a text under a name; one shown before comes back with its caret and its own undo. */
  show(name: string, text: string): void;
  /** Marks the text shown. */
  mark(diagnostics: readonly Diagnostic[]): void;
  goTo(line: number, column: number): void;
  /** Texts outlive their view, with their undo; this ends those whose names are not to be kept. */
  forget(keep: (name: string) => boolean): void;
  dispose(): void;
}

export interface ShaderEditorOptions {
  /** Each change by the person; not what `show` put in. */
  readonly onType: (name: string, text: string) => void;
  /** The focus left the text. */
  readonly onLeave: () => void;
}

/** Caret and scroll of texts that are not shown, also while no view is there at all. */
const viewStates = new WeakMap<editor.ITextModel, editor.ICodeEditorViewState>();

const MARKER_OWNER = 'scrim';
const SCHEME = 'scrim-shader';
const SEVERITIES = { error: MarkerSeverity.Error, warning: MarkerSeverity.Warning, info: MarkerSeverity.Info } as const;

export function createShaderEditor(parent: HTMLElement, { onType, onLeave }: ShaderEditorOptions): ShaderEditor {
  (globalThis as { MonacoEnvironment?: unknown }).MonacoEnvironment = {
    getWorker: () => new Worker(new URL('./monaco.worker.ts', import.meta.url), { type: 'module' }),
  };
  const unregister = registerIsfLanguage();
  const dark = window.matchMedia('(prefers-color-scheme: light)');
  const applyTheme = () => {
    defineTheme(dark.matches);
    editor.setTheme('scrim');
  };
  applyTheme();
  dark.addEventListener('change', applyTheme);

  const view = editor.create(parent, {
    automaticLayout: true,
    fontFamily: getComputedStyle(parent).getPropertyValue('--mono'),
    fontSize: 12.5,
    lineHeight: 19,
    minimap: { enabled: false },
    scrollBeyondLastLine: false,
    renderLineHighlight: 'line',
    padding: { top: 8, bottom: 8 },
    tabSize: 2,
    fixedOverflowWidgets: true,
    overviewRulerLanes: 1,
    stickyScroll: { enabled: false },
    ariaLabel: 'Shader source',
    model: null,
  });
  view.onDidBlurEditorText(onLeave);
  let shown: string | null = null;
  let ours = false;
  const keepPlace = () => {
    const model = view.getModel();
    const state = view.saveViewState();
    if (model && state) viewStates.set(model, state);
  };
  view.onDidChangeModelContent(() => {
    const model = view.getModel();
    if (!ours && model && shown !== null) onType(shown, model.getValue());
  });

  return {
    show: (name, text) => {
      const uri = Uri.from({ scheme: SCHEME, path: `/${name}` });
      const model = editor.getModel(uri) ?? editor.createModel(text, ISF_LANGUAGE, uri);
      ours = true;
      if (shown !== name) {
        keepPlace();
        view.setModel(model);
        const state = viewStates.get(model);
        if (state) view.restoreViewState(state);
        shown = name;
      }
      // An edit, not a new value, so that the text's own undo goes back over what came from outside.
      if (model.getValue() !== text) model.pushEditOperations([], [{ range: model.getFullModelRange(), text }], () => null);
      ours = false;
    },
    mark: (diagnostics) => {
      const model = view.getModel();
      if (!model) return;
      editor.setModelMarkers(
        model,
        MARKER_OWNER,
        diagnostics.map((diagnostic) => markerOf(model, diagnostic)),
      );
    },
    goTo: (line, column) => {
      view.setPosition({ lineNumber: line, column });
      view.revealLineInCenterIfOutsideViewport(line);
      view.focus();
    },
    forget: (keep) => {
      for (const model of editor.getModels()) if (model.uri.scheme === SCHEME && !keep(model.uri.path.slice(1))) model.dispose();
    },
    dispose: () => {
      dark.removeEventListener('change', applyTheme);
      keepPlace();
      view.dispose();
      unregister();
    },
  };
}

/** From the column to the end of the word there; the whole line where no column is known. */
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

function defineTheme(light: boolean): void {
  const style = getComputedStyle(document.documentElement);
  const color = (name: string) => style.getPropertyValue(name).trim();
  const ink = (name: string) => color(name).replace('#', '');
  editor.defineTheme('scrim', {
    base: light ? 'vs' : 'vs-dark',
    inherit: true,
    rules: [
      { token: 'keyword', foreground: ink('--code-keyword') },
      { token: 'type', foreground: ink('--code-type') },
      { token: 'support.function', foreground: ink('--code-function') },
      { token: 'variable.predefined', foreground: ink('--code-builtin') },
      { token: 'number', foreground: ink('--code-number') },
      { token: 'comment', foreground: ink('--code-comment') },
      { token: 'header.key', foreground: ink('--code-builtin') },
      { token: 'header.string', foreground: ink('--code-string') },
      { token: 'delimiter', foreground: ink('--text-2') },
    ],
    colors: {
      'editor.background': color('--surface-0'),
      'editor.foreground': color('--text'),
      'editorLineNumber.foreground': color('--text-3'),
      'editorLineNumber.activeForeground': color('--text'),
      'editor.lineHighlightBackground': color('--surface-1'),
      'editor.lineHighlightBorder': '#00000000',
      'editorCursor.foreground': color('--accent'),
      'editorWidget.background': color('--surface-2'),
      'editorWidget.border': color('--line-strong'),
      'editorSuggestWidget.selectedBackground': color('--surface-4'),
      'editorError.foreground': color('--danger'),
      'editorWarning.foreground': color('--warning'),
      focusBorder: color('--accent'),
    },
  });
}
