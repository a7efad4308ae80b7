import type { Patch } from 'immer';
import { applyPatches, type Change } from './commands/change.ts';
import type { Project } from './project.ts';

/** Undo and redo, as data. */
export interface History {
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
  /** Names the state that the project is in: equal numbers, equal projects. Keep the one that was saved to know what is not. */
  readonly state: number;
  readonly lastState: number;
  readonly limit: number;
}

export interface HistoryStep {
  /** For the menu: "Undo move". */
  readonly label: string;
  /** Changes with the same key, one right after the other, are one step: a drag, a slider. Null stands alone. */
  readonly key: string | null;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
  /** The state before this step. */
  readonly before: number;
  readonly after: number;
}

export function emptyHistory(limit = 500): History {
  return { past: [], future: [], state: 0, lastState: 0, limit };
}

export interface StepOptions {
  readonly label: string;
  readonly key?: string;
}

/**
 * Adds a change to the history. Refused and empty changes add no step.
 *
 * @param options `label` names the step in the menu; consecutive changes with the same `key` become one step.
 */
export function record(history: History, change: Change, { label, key }: StepOptions): History {
  if (change.patches.length === 0) return history;
  const state = history.lastState + 1;
  const last = history.past.at(-1);
  const goesOn = last !== undefined && key !== undefined && last.key === key && history.future.length === 0;
  const step: HistoryStep = goesOn
    ? { ...last, ...joined(last, change), after: state }
    : { label, key: key ?? null, patches: change.patches, inverse: change.inverse, before: history.state, after: state };
  const past = goesOn ? [...history.past.slice(0, -1), step] : [...history.past, step];
  return { ...history, past: past.slice(-history.limit), future: [], state, lastState: state };
}

/** Ends a drag: the next change starts a new step, even with the same key. */
export function endStep(history: History): History {
  const last = history.past.at(-1);
  if (!last || last.key === null) return history;
  return { ...history, past: [...history.past.slice(0, -1), { ...last, key: null }] };
}

export interface Moved {
  readonly history: History;
  readonly project: Project;
}

/** @returns The history and the project one step back, or null at the first state. */
export function undo(history: History, project: Project): Moved | null {
  const step = history.past.at(-1);
  if (!step) return null;
  return {
    history: { ...history, past: history.past.slice(0, -1), future: [{ ...step, key: null }, ...history.future], state: step.before },
    project: applyPatches(project, step.inverse),
  };
}

/** @returns The history and the project one step forward, or null where nothing was undone. */
export function redo(history: History, project: Project): Moved | null {
  const [step, ...future] = history.future;
  if (!step) return null;
  return {
    history: { ...history, past: [...history.past, step], future, state: step.after },
    project: applyPatches(project, step.patches),
  };
}

/** A drag makes hundreds of changes to the same places: of those only the first way back and the last way forward count. */
function joined({ patches, inverse }: HistoryStep, next: Change): Pick<HistoryStep, 'patches' | 'inverse'> {
  const start = patches.length - next.patches.length;
  const again = next.patches.every((patch, i) => patch.op === 'replace' && overwrites(patch, patches[start + i]));
  if (!again) return { patches: [...patches, ...next.patches], inverse: [...next.inverse, ...inverse] };
  const kept = patches.slice(start).map((patch, i): Patch => ({ ...patch, value: next.patches[i]?.value }));
  return { patches: [...patches.slice(0, start), ...kept], inverse };
}

function overwrites(patch: Patch, before: Patch | undefined): boolean {
  return before !== undefined && before.op !== 'remove' && samePath(patch, before);
}

function samePath(a: Patch, b: Patch): boolean {
  return a.path.length === b.path.length && a.path.every((part, i) => part === b.path[i]);
}
