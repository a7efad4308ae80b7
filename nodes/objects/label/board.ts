import type { SessionService } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';

/** A rectangle on the screen. Units are heights of the view; the origin is its center, y up. */
export interface ScreenBox {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** A label as the board sees it, which arranges it among the others. */
export interface BoardLabel {
  /** What happens to the label if a nearer one covers it. */
  readonly overlap: 'hide' | 'move' | 'allow';
  /** Whether the label checks if the room hides it, in frames in which `mayLook` is true. */
  readonly looks: boolean;
  /** Computes where the label is in this frame, and writes `wants`, `distanceM`, `atMost` and `box`. */
  prepare(frame: SessionFrame): void;
  /** Whether the label wants to be shown: false while it has no pose or text, or is out of view. */
  wants: boolean;
  distanceM: number;
  /** The label is hidden while this many nearer labels are shown. */
  atMost: number;
  readonly box: ScreenBox;
  /** The result of the board: whether the label is shown, and how far up it is moved, in heights of the view. */
  shown: boolean;
  moved: number;
  /**
   * Whether the label may check in this frame if the room hides it. Casting rays through depth images is expensive, so labels take turns.
   */
  mayLook: boolean;
  /** Number of frames since the label last checked; infinite for a label that has just appeared. */
  unseenFrames: number;
}

/** The board of a player: arranges all labels so that they do not cover each other. */
export interface Board {
  add(label: BoardLabel): void;
  remove(label: BoardLabel): void;
  /** Called by each label in its update. The first call of a frame arranges all labels. */
  arrange(label: BoardLabel, frame: SessionFrame): void;
}

/** The farthest that a label is moved up, in heights of the view; a label that would have to move farther is hidden. */
const MAX_MOVE = 0.25;
const GAP = 0.006;
/** How many labels may check per frame if the room hides them: with twenty labels, each checks twelve times a second. */
const LOOKS_PER_FRAME = 4;

const boards = new WeakMap<SessionService, Board>();

/** Returns the board of a player; the session service, of which each player has one, identifies it. */
export function boardOf(session: SessionService): Board {
  const board = boards.get(session) ?? createBoard();
  boards.set(session, board);
  return board;
}

/**
 * Creates a board. It arranges the nearest label first, so that a label keeps its place whatever is farther. Values and poses have been
 * computed when the first label updates.
 */
export function createBoard(): Board {
  const labels: BoardLabel[] = [];
  const updated = new Set<BoardLabel>();
  return {
    add: (label) => void labels.push(label),
    remove: (label) => {
      const index = labels.indexOf(label);
      if (index >= 0) labels.splice(index, 1);
      updated.delete(label);
    },
    arrange: (label, frame) => {
      // A label that updates again begins the next frame.
      const isFirst = updated.size === 0 || updated.has(label);
      if (isFirst) updated.clear();
      updated.add(label);
      if (!isFirst) return;
      for (let i = 0; i < labels.length; i++) labels[i]?.prepare(frame);
      sortByDistance(labels);
      arrangeSorted(labels);
      takeTurns(labels);
    },
  };
}

function arrangeSorted(labels: readonly BoardLabel[]): void {
  let shownCount = 0;
  for (let i = 0; i < labels.length; i++) {
    const label = labels[i];
    if (!label) continue;
    label.moved = 0;
    label.shown = label.wants && shownCount < label.atMost && findRoom(label, labels, i);
    if (label.shown) shownCount++;
  }
}

/** Chooses the labels that may check if the room hides them: those that have waited longest; of several, the nearest. */
function takeTurns(labels: readonly BoardLabel[]): void {
  for (const label of labels) {
    label.mayLook = false;
    label.unseenFrames = label.shown && label.looks ? label.unseenFrames + 1 : Number.POSITIVE_INFINITY;
  }
  for (let turn = 0; turn < LOOKS_PER_FRAME; turn++) {
    let next: BoardLabel | null = null;
    for (const label of labels) {
      if (label.shown && label.looks && !label.mayLook && label.unseenFrames > (next?.unseenFrames ?? 0)) next = label;
    }
    if (!next) return;
    next.mayLook = true;
    next.unseenFrames = 0;
  }
}

/** Moves the label up until it covers no nearer one; returns false if there is no room. */
function findRoom(label: BoardLabel, labels: readonly BoardLabel[], count: number): boolean {
  if (label.overlap === 'allow') return true;
  let blocking = blockerOf(label, labels, count);
  while (blocking) {
    label.moved = blocking.box.top + blocking.moved + GAP - label.box.bottom;
    if (label.overlap === 'hide' || label.moved > MAX_MOVE) return false;
    blocking = blockerOf(label, labels, count);
  }
  return true;
}

function blockerOf({ box, moved }: BoardLabel, labels: readonly BoardLabel[], count: number): BoardLabel | null {
  for (let i = 0; i < count; i++) {
    const other = labels[i];
    if (!other?.shown || other.overlap === 'allow') continue;
    const beside = other.box.left >= box.right || other.box.right <= box.left;
    const above = other.box.bottom + other.moved >= box.top + moved || other.box.top + other.moved <= box.bottom + moved;
    if (!beside && !above) return other;
  }
  return null;
}

/**
 * Sorts the labels in place, nearest first. Insertion sort, because the order hardly changes from frame to frame and nothing may be
 * allocated.
 */
function sortByDistance(labels: BoardLabel[]): void {
  for (let i = 1; i < labels.length; i++) {
    const label = labels[i];
    if (!label) continue;
    let at = i;
    for (let before = labels[at - 1]; before && before.distanceM > label.distanceM; before = labels[at - 1]) {
      labels[at] = before;
      at--;
    }
    labels[at] = label;
  }
}
