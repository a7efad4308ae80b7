import type { Material, MeshDepthMaterial, Texture } from 'three';

/**
 * A material derived from a master for one scene, because scenes differ in blending, occlusion and lights, and three.js compiles a material
 * for one set of lights. Textures are shared; values follow the master's every frame.
 */
export interface Twin {
  readonly material: Material;
  /** Copies the master's values; allocates nothing unless the master's version changed. */
  sync(): void;
  dispose(): void;
}

export function setMap(
  material: MeshDepthMaterial,
  name: 'map' | 'alphaMap' | 'displacementMap',
  texture: Texture | null | undefined,
): void {
  const next = texture ?? null;
  // Programs differ with and without a map.
  if ((material[name] === null) !== (next === null)) material.needsUpdate = true;
  material[name] = next;
}

/** Keeps twins when a scene is rebuilt, so that a changed wire recompiles nothing. */
export interface TwinCache {
  /** Returns the material of a master and variant, created by `create` at the first call. */
  get(master: Material, variant: string, create: () => Twin): Material;
  /** Disposes twins that no `get` has requested since the last call. */
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
