import type { Operation, Program, ResourceId } from '../../export/program/program.ts';
import type { ToPreview } from '../preview-protocol.ts';

/**
 * Draws what only viewed layers need in the frames that show them. A thumbnail is read a few times per second; without the gate, its passes
 * would be drawn in every frame.
 */
export interface LayerGate {
  /** Takes up a program before it is played. */
  follow(program: Program): void;
  /** Sets the layers that the next frame shows besides the screen output, as `node.port`. */
  show(viewer: ViewerLayers, thumbnails: readonly string[]): void;
  isDrawn(operation: Operation): boolean;
}

type ViewerLayers = Pick<Extract<ToPreview, { kind: 'viewer' }>, 'left' | 'right' | 'probed'>;

const NOTHING: ViewerLayers = { left: null, right: null, probed: null };

export function createLayerGate(): LayerGate {
  /** Operations that the screen output does not need, with the viewed layers that need them. */
  const layersOf = new WeakMap<Operation, ReadonlySet<string>>();
  let viewer = NOTHING;
  let thumbnails: readonly string[] = [];
  return {
    follow: (program) => {
      for (const [operation, layers] of viewedOnly(program)) layersOf.set(operation, layers);
    },
    show: (shownByViewer, shownAsThumbnails) => {
      viewer = shownByViewer;
      thumbnails = shownAsThumbnails;
    },
    isDrawn: (operation) => {
      const layers = layersOf.get(operation);
      if (layers === undefined) return true;
      const { left, right, probed } = viewer;
      return has(layers, left) || has(layers, right) || has(layers, probed) || thumbnails.some((layer) => layers.has(layer));
    },
  };
}

function has(layers: ReadonlySet<string>, layer: string | null): boolean {
  return layer !== null && layers.has(layer);
}

/** The operations that draw, but not for the screen output, each with the viewed layers that need it. */
function viewedOnly({ operations, taps }: Program): Map<Operation, Set<string>> {
  const writers = new Map<ResourceId, Operation[]>();
  for (const operation of operations) {
    for (const id of operation.writes) writers.set(id, [...(writers.get(id) ?? []), operation]);
  }
  // Values run in every frame, so what they read is drawn in every frame.
  const always = behind(
    operations.filter((operation) => !draws(operation) || ('target' in operation && operation.target === 'screen')),
    writers,
  );
  const found = new Map<Operation, Set<string>>();
  for (const [name, { color, depth }] of Object.entries(taps)) {
    const roots = [color, ...(depth ? [depth.resource] : [])].flatMap((id) => writers.get(id) ?? []);
    for (const operation of behind(roots, writers)) {
      if (always.has(operation) || !draws(operation)) continue;
      const layers = found.get(operation) ?? new Set();
      found.set(operation, layers.add(name));
    }
  }
  return found;
}

function draws({ kind }: Operation): boolean {
  return kind === 'pass' || kind === 'draw' || kind === 'shadow-maps' || kind === 'cpu';
}

/** The operations and all that they read from, directly or indirectly. */
function behind(roots: readonly Operation[], writers: ReadonlyMap<ResourceId, readonly Operation[]>): ReadonlySet<Operation> {
  const all = new Set(roots);
  // The set grows during the iteration.
  for (const { reads } of all) for (const id of reads) for (const writer of writers.get(id) ?? []) all.add(writer);
  return all;
}
