import type { Patch } from 'immer';
import { applyPatches, type Change } from './commands/change.ts';
import type { Project } from './project.ts';

/** The steps that can be undone and redone, as plain data. */
export interface History {
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
  /**
   * Number of the current state. Equal numbers mean equal projects, so compare it with the number at the last save to detect unsaved
   * changes.
   */
  readonly state: number;
  readonly lastState: number;
  readonly limit: number;
}

export interface HistoryStep {
  /** Label for the menu, as in “Undo move”. */
  readonly label: string;
  /** Consecutive changes with the same key become one step, as in a drag. Null never merges. */
  readonly key: string | null;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
  /** State before this step. */
  readonly before: number;
  readonly after: number;
}

/**
 * @param limit Maximum number of steps to undo.
 *
 * @example
 * let history = emptyHistory();
 * undo(history, project); // null
 */
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
 *
 * @example
 * const moved = moveNodes(project, { graph: 'main', positions });
 * history = record(history, moved, { label: 'Move', key: 'drag-1' });
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

/** Ends a step: the next change starts a new one, even with the same key. */
export function endStep(history: History): History {
  const last = history.past.at(-1);
  if (!last || last.key === null) return history;
  return { ...history, past: [...history.past.slice(0, -1), { ...last, key: null }] };
}

export interface Moved {
  readonly history: History;
  readonly project: Project;
}

/**
 * Undoes one step.
 *
 * @param project The current project.
 * @returns The history and the previous project, or null at the first state.
 *
 * @example
 * const moved = undo(history, project);
 * if (moved) ({ history, project } = moved);
 */
export function undo(history: History, project: Project): Moved | null {
  const step = history.past.at(-1);
  if (!step) return null;
  return {
    history: { ...history, past: history.past.slice(0, -1), future: [{ ...step, key: null }, ...history.future], state: step.before },
    project: applyPatches(project, step.inverse),
  };
}

/**
 * Redoes one step.
 *
 * @param project The current project.
 * @returns The history and the next project, or null if nothing was undone.
 */
export function redo(history: History, project: Project): Moved | null {
  const [step, ...future] = history.future;
  if (!step) return null;
  return {
    history: { ...history, past: [...history.past, step], future, state: step.after },
    project: applyPatches(project, step.patches),
  };
}

/**
 * Merges two steps. A drag makes hundreds of changes to the same places; only the first inverse patch and the last patch of each are
 * needed.
 */
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
