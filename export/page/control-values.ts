import type { Control } from '../program/program.ts';

export type SetControl = (control: Control, value: number | boolean) => void;

/** The values of the controls, shared by the page and the panel in the room. */
export interface ControlValues {
  readonly controls: readonly Control[];
  /** The value of a control as a number: 0 or 1 for a toggle, the index for a choice, the number of presses for a button. */
  get(index: number): number;
  /** Sets the value of a control. An equal value changes nothing and notifies nobody. */
  set(index: number, value: number): void;
  /** Calls `listener` after each change. Returns a function that removes it. */
  listen(listener: (index: number) => void): () => void;
}

export function createControlValues(controls: readonly Control[], set: SetControl): ControlValues {
  const values = controls.map(({ value }) => value);
  const listeners = new Set<(index: number) => void>();
  return {
    controls,
    get: (index) => values[index] ?? 0,
    set: (index, value) => {
      const control = controls[index];
      if (!control || values[index] === value) return;
      values[index] = value;
      set(control, control.kind === 'toggle' ? value !== 0 : value);
      for (const listener of listeners) listener(index);
    },
    listen: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
