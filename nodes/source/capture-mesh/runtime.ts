import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { CaptureMesh } from '../../kit/capture.ts';
import { createCapturedPlace, writeCapturedPlace } from '../../kit/captured-place.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import { setShadows } from '../../kit/three/mesh-item.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { objects } = ctx.outputs;
  const wired = ctx.inputs.capture;
  const own = createCapturedPlace();
  const place = wired ?? own;
  const id = ctx.assetIds.file;
  const handle = wired || id === null ? null : ctx.assets.capture(id);
  // Reconstructions do not specify the front side of triangles.
  const material = new MeshBasicMaterial({ side: DoubleSide });
  const factors = new Vector3();
  let shown: CaptureMesh | null = null;
  let geometry: BufferGeometry | null = null;
  let item: ObjectItem | null = null;

  /** Pages draw a coarse mesh until they have loaded the whole one. A wire may bring another capture, or none. */
  function show(mesh: CaptureMesh | null): void {
    geometry?.dispose();
    geometry = null;
    item = mesh && makeItem(mesh);
    objects.items.length = 0;
    if (item) objects.items.push(item);
    objects.version++;
  }

  function makeItem({ positions, indices }: CaptureMesh): ObjectItem {
    geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    const root = new Mesh(geometry, material);
    return { key: 'mesh', root, worldFromObject: new Matrix4(), role: 'phantom', castsShadow: false, receivesShadow: true };
  }

  return {
    get version() {
      return objects.version;
    },
    update: () => {
      if (!wired) writeCapturedPlace(own, handle?.value ?? null, ctx.params);
      const mesh = place.facts?.mesh ?? null;
      if (mesh !== shown) show(mesh);
      shown = mesh;
      if (item === null) return;
      item.worldFromObject.fromArray(place.worldFromPlace).scale(factors.setScalar(place.scale));
      setShadows(item, ctx.params);
    },
    dispose: () => {
      geometry?.dispose();
      material.dispose();
      handle?.release();
    },
  };
}
