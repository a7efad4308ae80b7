import type { PassOperation, Program, ResourceId } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import type { SessionTraits } from '../present/background.ts';
import { type Change, changesOf, type PassInputs } from './changes.ts';

/** Finds out what a frame would only draw again. */
export interface ChangeWatch {
  /**
   * Compares what the passes read with what they read at the last call. Call it once per frame, after nodes are updated and targets of the
   * image domain have their size.
   *
   * @returns Whether the screen may differ from the last frame. Always true with more than one view, and in programs that draw objects or
   * compute images on the CPU, which `RestWatch` looks at.
   */
  look(state: PlayState, session: SessionTraits | null): boolean;
  /**
   * Whether a pass has to be drawn in the frame for which `look` was called. A pass of each view always has to. Call it only if the pass is drawn
   * then: a change that a frame leaves out is drawn later.
   */
  takeNeeded(pass: PassOperation): boolean;
  /** Makes the next frame draw everything. */
  forget(): void;
}

interface Watched {
  /** Null: it may change in every frame. */
  readonly changes: readonly Change[] | null;
  /** Passes that draw what it reads. */
  readonly producers: Watched[];
  /** Passes once per frame that read its image. */
  readonly readers: Watched[];
  /** Whether other operations read its image, too. */
  hasOtherReaders: boolean;
  /** Whether its target keeps its image for the next frame: no other operation draws to it. */
  readonly keepsImage: boolean;
  changed: boolean;
  /** Whether it has changed since it was last drawn. */
  outdated: boolean;
  needed: boolean;
}

export function createChangeWatch(program: Program, inputs: Omit<PassInputs, 'tableSlots'>): ChangeWatch {
  const tableSlots = new Map(program.resources.flatMap((resource) => (resource.kind === 'table' ? [[resource.id, resource.slot]] : [])));
  const watched = watchPasses(program, { ...inputs, tableSlots });
  const inOrder = [...watched.values()];
  const isOnlyPasses = program.operations.every(
    ({ kind }) => kind !== 'draw' && kind !== 'cpu' && kind !== 'shadow-maps' && kind !== 'readback',
  );
  const showsWorld = program.presentation.background === 'world';
  const viewport = { x: -1, y: -1, widthPx: -1, heightPx: -1 };
  let lastSession: SessionTraits | null = null;
  let lastVersion: number | undefined;
  let forgotten = true;

  const screenChanged = ({ view, frame }: PlayState, session: SessionTraits | null): boolean => {
    if (!view || frame.viewCount !== 1) return true;
    const { x, y, widthPx, heightPx } = view.viewport;
    const moved = x !== viewport.x || y !== viewport.y || widthPx !== viewport.widthPx || heightPx !== viewport.heightPx;
    viewport.x = x;
    viewport.y = y;
    viewport.widthPx = widthPx;
    viewport.heightPx = heightPx;
    const showsCamera = showsWorld && session?.world === 'image' && view.cameraImage !== null;
    const isSameImage = frame.version !== undefined && frame.version === lastVersion;
    const changed = moved || (showsCamera && !isSameImage) || session !== lastSession;
    lastSession = session;
    lastVersion = frame.version;
    return changed;
  };
  return {
    look: (state, session) => {
      let changed = screenChanged(state, session) || forgotten || !isOnlyPasses;
      for (let i = 0; i < inOrder.length; i++) {
        const one = inOrder[i];
        if (!one) continue;
        one.changed = hasChanged(one, state) || forgotten;
        if (!one.changed) continue;
        changed = true;
        one.outdated = true;
      }
      forgotten = false;
      for (let i = inOrder.length - 1; i >= 0; i--) {
        const one = inOrder[i];
        if (one) one.needed = one.outdated || (!one.keepsImage && isRead(one));
      }
      return changed;
    },
    takeNeeded: (pass) => {
      const one = watched.get(pass);
      if (!one) return true;
      if (one.needed) one.outdated = false;
      return one.needed;
    },
    forget: () => {
      forgotten = true;
    },
  };
}

/** Makes every comparison, so that each remembers this frame. */
function hasChanged({ changes, producers }: Watched, state: PlayState): boolean {
  let changed = changes === null;
  for (let i = 0; i < (changes?.length ?? 0); i++) if (changes?.[i]?.(state)) changed = true;
  for (let i = 0; i < producers.length; i++) if (producers[i]?.changed) changed = true;
  return changed;
}

/** Whether the image of a pass is read by what is drawn. An image without readers may be viewed. */
function isRead({ readers, hasOtherReaders }: Watched): boolean {
  if (hasOtherReaders || readers.length === 0) return true;
  for (let i = 0; i < readers.length; i++) if (readers[i]?.needed) return true;
  return false;
}

function watchPasses(program: Program, inputs: PassInputs): ReadonlyMap<PassOperation, Watched> {
  const shared = new Set(
    program.resources.flatMap((resource) => (resource.kind === 'target' && resource.shares ? [resource.id, resource.shares] : [])),
  );
  const writerCounts = new Map<ResourceId, number>();
  for (const id of program.operations.flatMap(({ writes }) => writes)) writerCounts.set(id, (writerCounts.get(id) ?? 0) + 1);
  const watched = new Map<PassOperation, Watched>();
  const drawnBy = new Map<ResourceId, Watched>();
  /** Targets that nodes draw. */
  const restless = new Set<ResourceId>();
  for (const operation of program.operations) {
    const producers = operation.reads.flatMap((id) => drawnBy.get(id) ?? []);
    const isPassOnce = operation.kind === 'pass' && operation.view === 'once';
    if (!isPassOnce) for (const producer of producers) producer.hasOtherReaders = true;
    if (operation.kind !== 'pass') {
      if (operation.kind === 'draw' || operation.kind === 'cpu') for (const id of operation.writes) restless.add(id);
      continue;
    }
    const readsRestless = operation.reads.some((id) => restless.has(id));
    const one: Watched = {
      changes: readsRestless ? null : changesOf(operation, inputs),
      producers,
      readers: [],
      hasOtherReaders: false,
      keepsImage: operation.writes.every((id) => !shared.has(id) && writerCounts.get(id) === 1),
      changed: true,
      outdated: true,
      needed: true,
    };
    if (isPassOnce) for (const producer of producers) producer.readers.push(one);
    watched.set(operation, one);
    for (const id of operation.writes) drawnBy.set(id, one);
  }
  return watched;
}
