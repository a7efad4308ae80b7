import type { Material, MeshDepthMaterial, Texture } from 'three';

/**
 * A material made for one scene from a master's: scenes differ in blending, occlusion and lights, and three compiles a material
 * for one set of lights at a time. Textures are shared; values follow the master's every frame.
 */
export interface Twin {
  readonly material: Material;
  /** Takes over the master's values; allocates nothing unless the master's version changed. */
  sync(): void;
  dispose(): void;
}

export function setMap(
  material: MeshDepthMaterial,
  name: 'map' | 'alphaMap' | 'displacementMap',
  texture: Texture | null | undefined,
): void {
  const next = texture ?? null;
  // With or without a map are two programs.
  if ((material[name] === null) !== (next === null)) material.needsUpdate = true;
  material[name] = next;
}

/** Keeps twins over rebuilds of a scene, so that a moved wire recompiles nothing. */
export interface TwinCache {
  /** The same material for the same master and variant, made by `create` the first time. */
  get(master: Material, variant: string, create: () => Twin): Material;
  /** Drops twins that no `get` has asked for since the last call. */
  sweep(): void;
  sync(): void;
  dispose(): void;
}

export function createTwinCache(): TwinCache {
  const twins = new Map<Material, Map<string, Twin>>();
  const live: Twin[] = [];
  const used = new Set<Twin>();

  function get(master: Material, variant: string, create: () => Twin): Material {
    const variants = twins.get(master) ?? new Map<string, Twin>();
    twins.set(master, variants);
    let twin = variants.get(variant);
    if (!twin) {
      twin = create();
      variants.set(variant, twin);
      live.push(twin);
    }
    used.add(twin);
    return twin.material;
  }

  function sweep(): void {
    for (const [master, variants] of twins) {
      for (const [variant, twin] of variants) {
        if (used.has(twin)) continue;
        twin.dispose();
        variants.delete(variant);
        live.splice(live.indexOf(twin), 1);
      }
      if (variants.size === 0) twins.delete(master);
    }
    used.clear();
  }

  return {
    get,
    sweep,
    sync: () => {
      for (const twin of live) twin.sync();
    },
    dispose: () => {
      used.clear();
      sweep();
    },
  };
}
