import { expect, test } from '@jest/globals';
import { Bone, BoxGeometry, Float32BufferAttribute, Mesh, Skeleton, SkinnedMesh, Uint16BufferAttribute, Vector3 } from 'three';
import { createMeshShape } from './mesh-shape.ts';
import { isDeformed, poseVertices, restVertices } from './pose-vertices.ts';

function posed(mesh: Mesh): number[] {
  const shape = createMeshShape(mesh.geometry, () => true);
  const rest = restVertices(mesh, shape);
  const into = new Float32Array(rest.length);
  poseVertices(mesh, shape, rest, into);
  return [...into];
}

/** As three.js places them on the CPU. */
function expected(mesh: Mesh): unknown[] {
  const { vertices } = createMeshShape(mesh.geometry, () => true);
  return [...vertices].flatMap((i) => mesh.getVertexPosition(i, new Vector3()).toArray()).map((x) => expect.closeTo(x, 5));
}

function withMorphs(relative: boolean): BoxGeometry {
  const geometry = new BoxGeometry(1, 2, 1);
  const count = geometry.attributes.position?.count ?? 0;
  const target = (k: number) =>
    new Float32BufferAttribute(
      Float32Array.from({ length: count * 3 }, (_, i) => Math.sin(i * k)),
      3,
    );
  geometry.morphAttributes.position = [target(1), target(2)];
  geometry.morphTargetsRelative = relative;
  return geometry;
}

test.each([true, false])('morphs as three.js does, with relative targets %s', (relative) => {
  const mesh = new Mesh(withMorphs(relative));
  mesh.morphTargetInfluences = [0.3, 0.5];
  expect(isDeformed(mesh)).toBe(true);
  expect(posed(mesh)).toEqual(expected(mesh));
});

test('bends skins as three.js does, morphs before', () => {
  const geometry = withMorphs(true);
  const count = geometry.attributes.position?.count ?? 0;
  const indices = Array.from({ length: count }, () => [0, 1, 0, 0]).flat();
  const weights = Array.from({ length: count }, (_, i) => [((geometry.attributes.position?.getY(i) ?? 0) + 1) / 2, 0.4, 0, 0]).flat();
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const mesh = new SkinnedMesh(geometry);
  mesh.normalizeSkinWeights();
  const [lower, upper] = [new Bone(), new Bone()];
  upper.position.y = 0.5;
  lower.add(upper);
  mesh.add(lower);
  mesh.updateMatrixWorld(true);
  mesh.bind(new Skeleton([lower, upper]));
  mesh.morphTargetInfluences = [0.2, 0.1];
  upper.rotation.set(0.3, 0.2, -1);
  lower.position.set(0.1, 0.2, 0.3);
  mesh.updateMatrixWorld(true);
  expect(posed(mesh)).toEqual(expected(mesh));
});

test('says of what does not bend that it stays', () => {
  expect(isDeformed(new Mesh(new BoxGeometry()))).toBe(false);
});
