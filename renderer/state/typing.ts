import type { NeighbourFile } from '../../export/glsl/language/shader-document.ts';
import { debounce } from '../clock.ts';
import { endGesture } from './apply.ts';
import { editShader, editSource, projectFileOf, shaderOf } from './edit-shader.ts';
import type { Editor } from './editor.ts';

/** A pause this long takes the text over: long enough not to compile every letter, short enough to feel live. */
const PAUSE_MS = 300;

/** Text on its way from the keyboard into the document. */
export interface Typing {
  /** `shader`: the node whose shader it is, or the file of a chunk or of a vertex shader. */
  type(shader: string, text: string): void;
  /** Takes over at once what a slider in the text makes of it; with what follows it is one step until `end`. */
  tune(shader: string, text: string): void;
  /** What is typed next is one step with this new text of the file beside it. */
  along(beside: NeighbourFile): void;
  /** Whether text of the shader's has been typed that the document does not have yet. */
  isAhead(shader: string): boolean;
  /** Takes over at once what was typed for other shaders than this. */
  flush(shader: string): void;
  /** Takes over what was typed, as a step of its own. */
  end(): void;
  dispose(): void;
}

export function createTyping(editor: Editor): Typing {
  let beside: NeighbourFile | null = null;
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
  const pause = debounce(editor.clock, PAUSE_MS, take);
  let tuning = false;
  const end = () => {
    tuning = false;
    pause.flush();
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
      pause.trigger();
    },
    tune: (shader, text) => {
      if (waiting !== null && waiting.shader !== shader) end();
      tuning = true;
      waiting = { shader, text };
      pause.cancel();
      take();
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
      editor.unfinished.delete(finish);
    },
  };
}
