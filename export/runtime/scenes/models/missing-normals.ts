import {
  type BufferAttribute,
  type BufferGeometry,
  Float32BufferAttribute,
  Mesh,
  type MeshStandardMaterial,
  type Object3D,
  Vector3,
} from 'three';

/** The meshes of one model for which its file has no normals. */
export interface MissingNormals {
  /** Gives the meshes of an instance smooth normals instead of flat ones. They are computed once and shared by all instances. */
  smooth(instance: Object3D): void;
  dispose(): void;
}

// Valid within one call.
const scratchNormal = new Vector3();

/**
 * Computes the normals that a model lacks: flat, as glTF 2.0 demands (section 3.7.2.1). Triangles get vertices of their own, as the normals
 * of a shared vertex would differ.
 *
 * three.js shades such meshes by screen-space derivatives, which needs no normals, but offsets shadow receivers along normals: without them,
 * lit surfaces shadow themselves in stripes.
 */
export function addMissingNormals(root: Object3D): MissingNormals {
  const flat = new Map<BufferGeometry, BufferGeometry>();
  root.traverse((object) => {
    if (!(object instanceof Mesh) || object.geometry.attributes.normal || !object.geometry.attributes.position) return;
    const own: BufferGeometry = object.geometry;
    const made = flat.get(own) ?? flatten(own);
    flat.set(own, made);
    object.geometry = made;
  });
  const added = new Set(flat.values());
  const smooth = new Map<BufferGeometry, BufferGeometry>();
  const materials = new Map<MeshStandardMaterial, MeshStandardMaterial>();

  function smoothMaterial(own: MeshStandardMaterial): MeshStandardMaterial {
    const known = materials.get(own) ?? own.clone();
    known.flatShading = false;
    materials.set(own, known);
    return known;
  }

  return {
    smooth: (instance) =>
      instance.traverse((object) => {
        if (!(object instanceof Mesh) || !added.has(object.geometry)) return;
        const made = smooth.get(object.geometry) ?? smoothed(object.geometry);
        smooth.set(object.geometry, made);
        object.geometry = made;
        object.material = Array.isArray(object.material) ? object.material.map(smoothMaterial) : smoothMaterial(object.material);
      }),
    dispose: () => {
      for (const made of [...smooth.values(), ...materials.values()]) made.dispose();
    },
  };
}

function flatten(own: BufferGeometry): BufferGeometry {
  const made = own.index ? own.toNonIndexed() : own;
  made.name = own.name;
  made.computeVertexNormals();
  return made;
}

/** Returns a copy of a geometry with smooth normals: corners at the same place get the mean normal of their triangles, weighted by area. */
function smoothed(flat: BufferGeometry): BufferGeometry {
  const position = flat.attributes.position as BufferAttribute;
  const sums = new Map<string, Vector3>();
  const keyAt = (i: number): string => `${position.getX(i)} ${position.getY(i)} ${position.getZ(i)}`;
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  for (let i = 0; i + 2 < position.count; i += 3) {
    for (const [corner, at] of [a, b, c].entries()) at.fromBufferAttribute(position, i + corner);
    // The length of the cross product is twice the area.
    scratchNormal.copy(c).sub(b).cross(a.sub(b));
    for (let corner = 0; corner < 3; corner++) {
      const key = keyAt(i + corner);
      const sum = sums.get(key) ?? new Vector3();
      sums.set(key, sum.add(scratchNormal));
    }
  }
  const normals = new Float32BufferAttribute(new Float32Array(position.count * 3), 3);
  for (let i = 0; i < position.count; i++) {
    const { x, y, z } = scratchNormal.copy(sums.get(keyAt(i)) ?? scratchNormal.set(0, 0, 0)).normalize();
    normals.setXYZ(i, x, y, z);
  }
  const made = flat.clone();
  made.setAttribute('normal', normals);
  return made;
}
