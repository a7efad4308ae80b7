import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DetectedMesh } from '../../kit/session.ts';
import { type BuiltSurface, createSurfaceObjects } from '../../kit/surface-objects.ts';
import type { definition } from './definition.ts';

const NOTHING: readonly DetectedMesh[] = [];

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { castShadow, receiveShadow } = ctx.params;
  // Devices do not specify the front side of triangles.
  const material = new MeshBasicMaterial({ side: DoubleSide });
  const meshes = createSurfaceObjects<DetectedMesh>(ctx.outputs.objects, {
    wants: () => true,
    build: (mesh) => buildMesh(mesh, material),
    adjust: (item) => {
      item.castsShadow = castShadow.value;
      item.receivesShadow = receiveShadow.value;
    },
  });
  return {
    update: (frame) => meshes.update(frame.surfaces?.meshes ?? NOTHING),
    dispose: () => {
      meshes.dispose();
      material.dispose();
    },
  };
}

function buildMesh({ positions, indices }: DetectedMesh, material: MeshBasicMaterial): BuiltSurface | null {
  if (indices.length < 3) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return { root: new Mesh(geometry, material), worldFromObject: new Matrix4(), dispose: () => geometry.dispose() };
}
