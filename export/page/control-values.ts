import type { Control } from '../program/program.ts';

export type SetControl = (control: Control, value: number | boolean) => void;

/** What the controls are set to, wherever they are shown: on the page, or on a panel in the room. */
export interface ControlValues {
  readonly controls: readonly Control[];
  /** As the control's `value`: 0 or 1 of a toggle, the place of a choice, the presses of a button. */
  get(index: number): number;
  /** Does nothing where it is set to that already. */
  set(index: number, value: number): void;
  /** Calls `listener` after each change. Returns the function that stops it. */
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
