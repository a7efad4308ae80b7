import type { Matrix4, Object3D } from 'three';
import type { ObjectItem, ObjectList } from './scene-lists.ts';
import type { DetectedSurface } from './session.ts';

/** Detected surfaces as objects of an output list. */
export interface SurfaceObjects<S extends DetectedSurface> {
  /** Once per frame: surfaces that came, went, moved or changed their shape. */
  update(surfaces: readonly S[]): void;
  dispose(): void;
}

export interface SurfaceBuilder<S extends DetectedSurface> {
  /** Built anew when the surface's shape has changed. Null for one without any area. */
  build(surface: S): BuiltSurface | null;
  /** Which surfaces are wanted; always the same answer for the same surface and shape. */
  wants(surface: S): boolean;
  /** Called for every item and frame, to set what the node's params say. */
  adjust(item: ObjectItem): void;
}

export interface BuiltSurface {
  readonly root: Object3D;
  readonly worldFromObject: Matrix4;
  dispose(): void;
}

interface Entry<S> {
  readonly surface: S;
  readonly version: number;
  readonly built: BuiltSurface | null;
  readonly item: ObjectItem | null;
  seen: number;
}

/** Keeps an output list in step with surfaces that a session detects: each is a phantom in the place of the real thing. */
export function createSurfaceObjects<S extends DetectedSurface>(output: ObjectList, builder: SurfaceBuilder<S>): SurfaceObjects<S> {
  const entries = new Map<string, Entry<S>>();
  let round = 0;

  function remove(entry: Entry<S>): void {
    entries.delete(entry.surface.id);
    entry.built?.dispose();
    if (!entry.item) return;
    output.items.splice(output.items.indexOf(entry.item), 1);
    output.version++;
  }

  function add(surface: S): Entry<S> {
    const built = builder.wants(surface) ? builder.build(surface) : null;
    const item: ObjectItem | null = built && {
      key: surface.id,
      root: built.root,
      worldFromObject: built.worldFromObject,
      role: 'phantom',
      castsShadow: false,
      receivesShadow: true,
    };
    if (item) {
      output.items.push(item);
      output.version++;
    }
    const entry = { surface, version: surface.version, built, item, seen: round };
    entries.set(surface.id, entry);
    return entry;
  }

  function entryOf(surface: S): Entry<S> {
    const known = entries.get(surface.id);
    if (known?.surface === surface && known.version === surface.version) return known;
    if (known) remove(known);
    return add(surface);
  }

  // Made once: the map is walked in every frame.
  function dropUnseen(entry: Entry<S>): void {
    if (entry.seen !== round) remove(entry);
  }

  return {
    update: (surfaces) => {
      round++;
      for (let i = 0; i < surfaces.length; i++) {
        const surface = surfaces[i];
        if (!surface) continue;
        const entry = entryOf(surface);
        entry.seen = round;
        if (!entry.item) continue;
        entry.item.worldFromObject.fromArray(surface.worldFromSurface);
        builder.adjust(entry.item);
      }
      entries.forEach(dropUnseen);
    },
    dispose: () => {
      for (const { built } of entries.values()) built?.dispose();
      entries.clear();
    },
  };
}
