import type { NeighborFile } from '../../../export/glsl/language/shader-document.ts';
import { debounce } from '../../clock.ts';
import type { Editor } from '../editor/editor.ts';
import { endGesture } from './apply.ts';
import { editShader, editSource, projectFileOf, shaderOf } from './edit-shader.ts';

/** After this long without a key, typing rests: mistakes are marked. */
const REST_MS = 300;

/** Where the last compile took less, each key compiles at once; else typing waits for a pause as long as that compile. */
const AT_ONCE_MS = 30;

/** Typing without a pause is taken over after this long: a crash may cost five seconds of work, of which autosave uses four. */
const TYPING_AT_MOST_MS = 900;

/** Text on its way from the keyboard into the document. */
export interface Typing {
  /** `shader`: the node whose shader it is, or the file of a chunk or of a vertex shader. */
  type(shader: string, text: string): void;
  /** Takes over at once what a slider in the text makes of it; with what follows it is one step until `end`. */
  tune(shader: string, text: string): void;
  /** What is typed next is one step with this new text of the file beside it. */
  along(beside: NeighborFile): void;
  /** Whether text of the shader's has been typed that the document does not have yet. */
  isAhead(shader: string): boolean;
  /** Takes over at once what was typed for other shaders than this. */
  flush(shader: string): void;
  /** Takes over what was typed, as a step of its own. */
  end(): void;
  dispose(): void;
}

export function createTyping(editor: Editor): Typing {
  let beside: NeighborFile | null = null;
  let waiting: { readonly shader: string; readonly text: string } | null = null;
  const take = () => {
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
  const codePause = debounce(editor.clock, () => editor.compile.getState().tookMs, take, TYPING_AT_MOST_MS);
  // Without a limit: each word of a header is a port or a parameter, and half a name would remove wires and values.
  const headerPause = debounce(editor.clock, REST_MS, take);
  const flush = () => {
    codePause.flush();
    headerPause.flush();
  };
  const takeNow = () => {
    codePause.cancel();
    headerPause.cancel();
    take();
  };
  const rest = debounce(editor.clock, REST_MS, () => editor.ui.setState({ typing: false }));
  let tuning = false;
  const end = () => {
    tuning = false;
    flush();
    endGesture(editor);
  };
  /** A slider that is held for long is one step, whatever is saved meanwhile. */
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
      } else if (compilesFast(editor)) takeNow();
      else codePause.trigger();
    },
    tune: (shader, text) => {
      if (waiting !== null && waiting.shader !== shader) end();
      tuning = true;
      waiting = { shader, text };
      takeNow();
    },
    along: (changed) => {
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
