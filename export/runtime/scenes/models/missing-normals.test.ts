import { describe, expect, test } from '@jest/globals';
import {
  BoxGeometry,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  IcosahedronGeometry,
  Mesh,
  MeshStandardMaterial,
  Vector3,
} from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { addMissingNormals } from './missing-normals.ts';

/** Indexed, without normals, as files without normals are read. */
function bare(from: BufferGeometry): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute('position', from.attributes.position?.clone() ?? new Float32BufferAttribute([], 3));
  if (from.index) made.setIndex(from.index.clone());
  return mergeVertices(made);
}

function modelOf(...geometries: BufferGeometry[]): Group {
  const material = new MeshStandardMaterial({ flatShading: true });
  return new Group().add(...geometries.map((geometry) => new Mesh(geometry, material)));
}

const meshOf = (root: Group, i = 0): Mesh<BufferGeometry, MeshStandardMaterial> =>
  root.children[i] as Mesh<BufferGeometry, MeshStandardMaterial>;

function normalsOf({ attributes: { normal } }: BufferGeometry): Vector3[] {
  if (!normal) throw new Error('There are no normals.');
  return Array.from({ length: normal.count }, (_, i) => new Vector3().fromBufferAttribute(normal, i));
}

describe('missing normals', () => {
  test('are flat: each corner of a box has the normal of its side', () => {
    const model = modelOf(bare(new BoxGeometry(1, 2, 3)));
    expect(meshOf(model).geometry.attributes.position?.count).toBe(8);
    addMissingNormals(model);
    const normals = normalsOf(meshOf(model).geometry);
    expect(normals).toHaveLength(36);
    for (const { x, y, z } of normals) expect([x, y, z].map(Math.abs).sort()).toEqual([0, 0, 1]);
    const { position } = meshOf(model).geometry.attributes;
    for (const [i, normal] of normals.entries()) {
      // On a side, the coordinate along the normal is half the length of the box.
      const at = new Vector3().fromBufferAttribute(position as never, i);
      expect(at.dot(normal)).toBeCloseTo(Math.abs(normal.x) * 0.5 + Math.abs(normal.y) + Math.abs(normal.z) * 1.5, 6);
    }
  });

  test('are smooth by choice: on a ball they point away from its center, and flat instances stay flat', () => {
    const model = modelOf(bare(new IcosahedronGeometry(1, 6)));
    const missing = addMissingNormals(model);
    const [flat, smooth, other] = [model.clone(), model.clone(), model.clone()];
    missing.smooth(smooth);
    missing.smooth(other);
    const { position } = meshOf(smooth).geometry.attributes;
    for (const [i, normal] of normalsOf(meshOf(smooth).geometry).entries()) {
      expect(normal.angleTo(new Vector3().fromBufferAttribute(position as never, i))).toBeLessThan(0.03);
    }
    expect(meshOf(smooth).material.flatShading).toBe(false);
    expect(meshOf(other).geometry).toBe(meshOf(smooth).geometry);
    expect(meshOf(flat).material.flatShading).toBe(true);
    expect(meshOf(flat).geometry).not.toBe(meshOf(smooth).geometry);
  });

  test('of a file stay as they are, and meshes that share a geometry go on sharing it', () => {
    const own = new BoxGeometry();
    const shared = bare(own);
    const model = modelOf(own, shared, shared);
    const missing = addMissingNormals(model);
    expect(meshOf(model, 0).geometry).toBe(own);
    expect(meshOf(model, 1).geometry).toBe(meshOf(model, 2).geometry);
    missing.smooth(model);
    expect(meshOf(model, 0).geometry).toBe(own);
    expect(meshOf(model, 1).geometry).toBe(meshOf(model, 2).geometry);
  });
});
