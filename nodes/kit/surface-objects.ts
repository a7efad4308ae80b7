import type { Matrix4, Object3D } from 'three';
import type { ObjectItem, ObjectList } from './scene-lists.ts';
import type { DetectedSurface } from './session.ts';

/** An object list with one object per surface that a session detects. */
export interface SurfaceObjects<S extends DetectedSurface> {
  /** Adds and removes items, updates poses, and rebuilds changed shapes. Call it once per frame. */
  update(surfaces: readonly S[]): void;
  dispose(): void;
}

/** The functions by which a node turns detected surfaces into objects. */
export interface SurfaceBuilder<S extends DetectedSurface> {
  /**
   * Creates the object of a surface; called again when its shape changes.
   *
   * @returns Null for a surface without area.
   */
  build(surface: S): BuiltSurface | null;
  /** Whether the list contains the surface. The result must depend only on the surface and its shape. */
  wants(surface: S): boolean;
  /** Called for each item in every frame, to set flags from the params of the node. */
  adjust(item: ObjectItem): void;
}

/** The object that a node has made of a surface. */
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

/**
 * Creates a list of phantoms at the positions of detected surfaces.
 *
 * @param output The node's output.
 *
 * @example
 * const planes = createSurfaceObjects<DetectedPlane>(ctx.outputs.objects, { wants, build, adjust });
 * // Every frame:
 * planes.update(frame.surfaces?.planes ?? NONE);
 */
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

  // Created once, because it is passed to `forEach` in every frame.
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
