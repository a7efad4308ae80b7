import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { CaptureMesh } from '../../kit/capture.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { setShadows } from '../../kit/three/mesh-item.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { positionM, rotationRad, scale } = ctx.params;
  const { objects } = ctx.outputs;
  const id = ctx.assetIds.file;
  const handle = id === null ? null : ctx.assets.capture(id);
  // Reconstructions do not specify the front side of triangles.
  const material = new MeshBasicMaterial({ side: DoubleSide });
  const rigid = new Float32Array(16);
  const factors = new Vector3();
  let shown: CaptureMesh | null = null;
  let geometry: BufferGeometry | null = null;
  let item: ObjectItem | null = null;

  /** Pages draw a coarse mesh until they have loaded the whole one. */
  function show({ positions, indices }: CaptureMesh): ObjectItem {
    geometry?.dispose();
    geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    const root = new Mesh(geometry, material);
    const made: ObjectItem = {
      key: 'mesh',
      root,
      worldFromObject: new Matrix4(),
      role: 'phantom',
      castsShadow: false,
      receivesShadow: true,
    };
    objects.items[0] = made;
    objects.version++;
    return made;
  }

  return {
    get version() {
      return objects.version;
    },
    update: () => {
      const mesh = handle?.value?.mesh ?? null;
      if (mesh === null) return;
      if (mesh !== shown) item = show(mesh);
      shown = mesh;
      if (item === null) return;
      setFromAngles(rigid, positionM.value, rotationRad.value);
      item.worldFromObject.fromArray(rigid).scale(factors.setScalar(Math.max(scale.value, 1e-6)));
      setShadows(item, ctx.params);
    },
    dispose: () => {
      geometry?.dispose();
      material.dispose();
      handle?.release();
    },
  };
}
