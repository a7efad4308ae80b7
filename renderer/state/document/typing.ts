import type { NeighborFile } from '../../../export/glsl/language/shader-document.ts';
import { debounce } from '../../clock.ts';
import type { Editor } from '../editor/editor.ts';
import { endGesture } from './apply.ts';
import { editShader, editSource, projectFileOf, shaderOf } from './edit-shader.ts';

/** Pause in typing after which new problems are marked. */
const REST_MS = 300;

/**
 * Limit for the duration of the last compile. If it took less, each key press compiles at once; else typing waits for a pause as long as
 * that compile.
 */
const AT_ONCE_MS = 30;

/** Longest wait for a pause during continuous typing. A crash loses at most five seconds of work, of which autosave takes four. */
const TYPING_AT_MOST_MS = 900;

/** Buffers typed shader text until it is applied to the document. */
export interface Typing {
  /** Buffers a text. `shader`: the id of its node, or the file of a chunk or vertex shader. */
  type(shader: string, text: string): void;
  /** Applies an edit of a slider at once. Edits form one undo step until `end`. */
  tune(shader: string, text: string): void;
  /** Adds the new text of the neighboring file to the undo step of the next edit. */
  pairWith(beside: NeighborFile): void;
  /** Whether buffered text of this shader is not in the document yet. */
  isAhead(shader: string): boolean;
  /** Applies buffered text of other shaders at once. */
  flush(shader: string): void;
  /** Applies buffered text and ends its undo step. */
  end(): void;
  dispose(): void;
}

export function createTyping(editor: Editor): Typing {
  let beside: NeighborFile | null = null;
  let waiting: { readonly shader: string; readonly text: string } | null = null;
  const applyText = () => {
    const typed = waiting;
    waiting = null;
    if (typed === null) return;
    const isFile = /\.(glsl|vs)$/.test(typed.shader);
    const file = isFile ? projectFileOf(typed.shader) : shaderOf(editor.document.getState(), typed.shader)?.file;
    if (isFile) editSource(editor, projectFileOf(typed.shader), typed.text);
    else editShader(editor, typed.shader, typed.text);
    if (beside !== null && file) editSource(editor, projectFileOf(beside.file), beside.source, file);
    beside = null;
  };
  const codePause = debounce(editor.clock, () => editor.compile.getState().tookMs, applyText, TYPING_AT_MOST_MS);
  // Has no limit: an unfinished name in the header would remove ports, with their wires and params.
  const headerPause = debounce(editor.clock, REST_MS, applyText);
  const flush = () => {
    codePause.flush();
    headerPause.flush();
  };
  const applyNow = () => {
    codePause.cancel();
    headerPause.cancel();
    applyText();
  };
  const rest = debounce(editor.clock, REST_MS, () => editor.ui.setState({ typing: false }));
  let tuning = false;
  const end = () => {
    tuning = false;
    flush();
    endGesture(editor);
  };
  /** A drag of a slider stays one undo step, even if the project is saved during it. */
  const finish = () => {
    if (!tuning) end();
  };
  editor.unfinished.add(finish);
  return {
    type: (shader, text) => {
      if (waiting !== null && waiting.shader !== shader) end();
      waiting = { shader, text };
      editor.ui.setState({ typing: true });
      rest.trigger();
      if (changesHeader(editor, shader, text)) {
        codePause.cancel();
        headerPause.trigger();
      } else if (compilesFast(editor)) applyNow();
      else codePause.trigger();
    },
    tune: (shader, text) => {
      if (waiting !== null && waiting.shader !== shader) end();
      tuning = true;
      waiting = { shader, text };
      applyNow();
    },
    pairWith: (changed) => {
      beside = changed;
    },
    isAhead: (shader) => waiting?.shader === shader,
    flush: (shader) => {
      if (waiting !== null && waiting.shader !== shader) end();
    },
    end,
    dispose: () => {
      end();
      rest.flush();
      editor.unfinished.delete(finish);
    },
  };
}

function compilesFast(editor: Editor): boolean {
  const { revision, tookMs } = editor.compile.getState();
  return revision !== null && tookMs < AT_ONCE_MS;
}

function changesHeader(editor: Editor, shader: string, text: string): boolean {
  const state = editor.document.getState();
  const known = shaderOf(state, shader)?.text ?? state.library.shader(shader) ?? '';
  return headerOf(known) !== headerOf(text);
}

function headerOf(text: string): string {
  return text.slice(0, text.indexOf('*/') + 1);
}
