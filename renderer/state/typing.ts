import { debounce } from '../clock.ts';
import { endGesture } from './apply.ts';
import { editShader } from './edit-shader.ts';
import type { Editor } from './editor.ts';

/** A pause this long takes the text over: long enough not to compile every letter, short enough to feel live. */
const PAUSE_MS = 300;

/** Text on its way from the keyboard into the document. */
export interface Typing {
  type(node: string, text: string): void;
  /** Takes over at once what a slider in the text makes of it; with what follows it is one step until `end`. */
  tune(node: string, text: string): void;
  /** Whether text of the node's has been typed that the document does not have yet. */
  isAhead(node: string): boolean;
  /** Takes over at once what was typed for other nodes than this. */
  flush(node: string): void;
  /** Takes over what was typed, as a step of its own. */
  end(): void;
  dispose(): void;
}

export function createTyping(editor: Editor): Typing {
  let waiting: { readonly node: string; readonly text: string } | null = null;
  const take = () => {
    const typed = waiting;
    waiting = null;
    if (typed !== null) editShader(editor, typed.node, typed.text);
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
    type: (node, text) => {
      if (waiting !== null && waiting.node !== node) end();
      waiting = { node, text };
      pause.trigger();
    },
    tune: (node, text) => {
      if (waiting !== null && waiting.node !== node) end();
      tuning = true;
      waiting = { node, text };
      pause.cancel();
      take();
    },
    isAhead: (node) => waiting?.node === node,
    flush: (node) => {
      if (waiting !== null && waiting.node !== node) end();
    },
    end,
    dispose: () => {
      end();
      editor.unfinished.delete(finish);
    },
  };
}
