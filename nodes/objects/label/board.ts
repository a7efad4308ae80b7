import type { SessionService } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';

/** A rectangle on the screen in heights of the view, from its center, y up. */
export interface ScreenBox {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** A label among the others. */
export interface BoardLabel {
  /** What the label does where a nearer one is in its place. */
  readonly overlap: 'hide' | 'move' | 'allow';
  /** Whether it looks for what hides it, at `mayLook`. */
  readonly looks: boolean;
  /** Finds out where the label is in this frame: writes the fields below. */
  prepare(frame: SessionFrame): void;
  /** False while it has no pose or text, or is out of view. */
  wants: boolean;
  distanceM: number;
  /** The label is hidden while this many nearer ones are shown. */
  atMost: number;
  readonly box: ScreenBox;
  /** The result: whether it is shown, and how far up it is moved, in heights of the view. */
  shown: boolean;
  moved: number;
  /** Whether it may look for what hides it in this frame. Rays through depth images are dear, so labels take turns. */
  mayLook: boolean;
  /** Frames since it last looked; infinite for a label that has just appeared. */
  unseenFrames: number;
}

/** All labels of a player. */
export interface Board {
  add(label: BoardLabel): void;
  remove(label: BoardLabel): void;
  /** Called by each label in its update; the first call of a frame arranges all. */
  arrange(label: BoardLabel, frame: SessionFrame): void;
}

/** Farther than this a label is not moved; it is hidden. Heights of the view. */
const MAX_MOVE = 0.25;
const GAP = 0.006;
/** Labels that look in a frame: with twenty of them, each looks twelve times a second. */
const LOOKS_PER_FRAME = 4;

const boards = new WeakMap<SessionService, Board>();

/** The board of a player, of which there is one session service. */
export function boardOf(session: SessionService): Board {
  const board = boards.get(session) ?? createBoard();
  boards.set(session, board);
  return board;
}

/** Nearest first: a label keeps its place from all that are farther. Values and poses have been computed when the first label updates. */
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

/** Lets the labels look that have waited longest; of several, the nearest. */
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

/** Moves the label up over nearer ones that are in its place; false if there is no room. */
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

/** Insertion sort: from frame to frame the order hardly changes, and nothing is allocated. */
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
