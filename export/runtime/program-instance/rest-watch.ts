import { MAY_CHANGE } from '../../../nodes/kit/runtime.ts';
import type { ObjectList } from '../../../nodes/kit/scene-lists.ts';
import { mayRest } from '../../program/may-rest.ts';
import type { Operation, Program } from '../../program/program.ts';
import type { CpuFilter } from '../cpu/run-cpu-filter.ts';
import type { NodeInstance } from '../operations/node-instance.ts';
import type { PlayState } from '../play-state.ts';
import type { SessionTraits } from '../present/background.ts';
import type { LiveResources } from '../resources/resources.ts';
import type { Slots } from '../values/slots.ts';

/** Finds out which frames of a program with objects, or with images that the CPU computes, would draw the last image again. */
export interface RestWatch {
  /** Compares a frame with that of the last call. Call it once per frame, after nodes are updated. Always true with more than one view. */
  look(state: PlayState, session: SessionTraits | null): boolean;
  /** Makes the next frame draw everything. */
  forget(): void;
}

interface RestParts {
  readonly resources: LiveResources;
  readonly slots: Slots;
  readonly nodes: ReadonlyMap<string, NodeInstance>;
}

/** The number of answers of the CPU so far, and the number with which a change of the frame has arrived everywhere. */
interface Answers {
  readonly count: () => number;
  enough: number;
}

/** Operations that `ChangeWatch` does not compare. */
const COMPARED: ReadonlySet<Operation['kind']> = new Set(['draw', 'cpu', 'shadow-maps', 'readback']);

/** Returns null for programs of passes alone, which `ChangeWatch` looks at, and for those of which every frame has to be drawn. */
export function createRestWatch(program: Program, { resources, slots, nodes }: RestParts): RestWatch | null {
  if (!mayRest(program) || program.operations.every(({ kind }) => !COMPARED.has(kind))) return null;
  const { numbers, texts } = slots;
  const lastNumbers = numbers.slice();
  const view = new Float32Array(36);
  const lastView = view.slice();
  /** Whole numbers and objects. */
  const facts: (() => unknown)[] = texts.map((_, i) => () => texts[i]);
  const answers: Answers[] = [];
  /** Whether it may differ from the last frame without a sign. */
  const restless: (() => boolean)[] = [];
  /** Comparisons of numbers, which remember what they compared. */
  const moves: (() => boolean)[] = [];
  for (const operation of program.operations) {
    const runtime = nodes.get(operation.id)?.runtime;
    if (runtime === undefined) continue;
    facts.push(() => runtime.version);
    if ('shown' in runtime) answers.push({ count: () => (runtime as CpuFilter).shown, enough: 0 });
    if (runtime.version !== undefined) continue;
    for (const id of operation.writes) {
      const written = resources.get(id);
      if (written?.kind === 'objects') moves.push(listMove(written.list));
    }
  }
  for (const [id, resource] of resources) {
    if (resource.kind === 'room-depth') {
      const writer = program.operations.find(({ writes }) => writes.includes(id));
      const node = writer && nodes.get(writer.id);
      facts.push(() => resource.depth.views[0] ?? null);
      restless.push(() => !!resource.depth.views[0] && node?.runtime.version === undefined);
    }
    if (resource.kind === 'pixels') answers.push({ count: () => resource.pixels.taken, enough: 0 });
    if (resource.kind === 'pulses') {
      facts.push(() => resource.queue.count > 0);
      restless.push(() => resource.queue.count > 0);
    }
    if (resource.kind === 'pose') {
      const { pose } = resource;
      const last = new Float32Array(16);
      facts.push(
        () => pose.valid,
        () => pose.jumps,
      );
      moves.push(() => copyChanges(pose.worldFromPose, last));
    }
    if (resource.kind === 'external') {
      const [shown] = resource.layer.views;
      facts.push(
        () => shown?.texture,
        () => shown?.version,
      );
      restless.push(() => shown?.version === MAY_CHANGE);
    }
  }
  const lastFacts: unknown[] = [];
  const showsWorld = program.presentation.background === 'world';
  let lastSession: SessionTraits | null = null;
  let lastVersion: number | undefined;
  let forgotten = true;

  return {
    look: (state, session) => {
      const { view: seen, frame } = state;
      let changed = forgotten || session !== lastSession || !seen || frame.viewCount !== 1;
      forgotten = false;
      lastSession = session;
      if (!seen) return true;
      const { x, y, widthPx, heightPx } = seen.viewport;
      view.set(seen.clipFromView);
      view.set(seen.worldFromView, 16);
      view[32] = x;
      view[33] = y;
      view[34] = widthPx;
      view[35] = heightPx;
      if (copyChanges(view, lastView)) changed = true;
      if (copyChanges(numbers, lastNumbers)) changed = true;
      for (let i = 0; i < facts.length; i++) {
        const fact = facts[i]?.();
        if (fact !== lastFacts[i]) changed = true;
        lastFacts[i] = fact;
      }
      for (let i = 0; i < moves.length; i++) if (moves[i]?.()) changed = true;
      // Those of devices change without a sign.
      const measures = frame.surfaces || frame.light || (showsWorld && session?.world === 'image' && seen.cameraImage);
      if (measures && (frame.version === undefined || frame.version !== lastVersion)) changed = true;
      lastVersion = frame.version;
      for (let i = 0; i < restless.length; i++) if (restless[i]?.()) changed = true;
      let waits = false;
      for (let i = 0; i < answers.length; i++) {
        const each = answers[i];
        if (!each) continue;
        // The first answer may have been asked for before the change. Pixels are read when the frame is drawn.
        if (changed) each.enough = each.count() + 2;
        if (each.count() < each.enough) waits = true;
      }
      return changed || waits;
    },
    forget: () => {
      forgotten = true;
    },
  };
}

/** Numbers per listed object: its matrix and its flags. */
const ITEM_NUMBERS = 17;

/** Compares the places and flags of listed objects, and the version of their list. */
function listMove(list: ObjectList): () => boolean {
  let last = new Float64Array();
  let version = -1;
  return () => {
    const { items } = list;
    let changed = version !== list.version;
    version = list.version;
    if (last.length !== items.length * ITEM_NUMBERS) last = new Float64Array(items.length * ITEM_NUMBERS).fill(Number.NaN);
    for (let i = 0, at = 0; i < items.length; i++) {
      const item = items[i];
      if (!item) continue;
      const { elements } = item.worldFromObject;
      const flags = (item.hidden ? 1 : 0) + (item.castsShadow ? 2 : 0) + (item.receivesShadow ? 4 : 0);
      for (let n = 0; n < ITEM_NUMBERS; n++, at++) {
        const number = elements[n] ?? flags;
        if (number !== last[at]) changed = true;
        last[at] = number;
      }
    }
    return changed;
  };
}

/** Copies numbers. Returns whether one of them was another. */
function copyChanges(now: Readonly<Float32Array | Float64Array>, last: Float32Array | Float64Array): boolean {
  let changed = false;
  for (let i = 0; i < now.length; i++) if (now[i] !== last[i]) changed = true;
  last.set(now);
  return changed;
}
