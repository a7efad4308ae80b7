import type { SpotState } from './spot.ts';

/** The changes to placed objects that the visitor can undo. */
export interface History {
  /** Stores the states of all spots that a change is about to alter. */
  remember(states: readonly SpotState[]): void;
  /** Removes the last change from the history and returns the states before it; null if there is none. */
  undo(): readonly SpotState[] | null;
  /** Forgets all changes, because world space has moved or the room is another, so that the stored states have no meaning. */
  clear(): void;
}

/** The most changes that can be undone; more than anybody undoes step by step. */
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
