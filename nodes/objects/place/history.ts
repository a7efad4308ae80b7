import type { SpotState } from './spot.ts';

/** What the visitor can undo. */
export interface History {
  /** Before a change: the states of all spots that it changes. */
  remember(states: readonly SpotState[]): void;
  /** The states before the last change that is not undone yet, or null. */
  undo(): readonly SpotState[] | null;
  /** World space has moved or the room is another: the states mean nothing. */
  clear(): void;
}

/** More than anybody undoes step by step. */
const MAX_STEPS = 64;

export function createHistory(): History {
  const steps: (readonly SpotState[])[] = [];
  return {
    remember: (states) => {
      if (states.length === 0) return;
      steps.push(states);
      if (steps.length > MAX_STEPS) steps.shift();
    },
    undo: () => steps.pop() ?? null,
    clear: () => {
      steps.length = 0;
    },
  };
}
