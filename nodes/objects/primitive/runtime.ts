import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  FrontSide,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { setSurface } from '../../kit/three/material-color.ts';
import { createMeshItem, setShadows } from '../../kit/three/mesh-item.ts';
import type { definition } from './definition.ts';

type Shape = NodeContext<typeof definition>['config']['shape'];

/**
 * The geometry of each shape. Each fills a cube of one meter at the origin; the torus has a fifth of that height. There are enough segments
 * to look smooth at arm's length.
 */
const GEOMETRIES: { readonly [S in Shape]: () => BufferGeometry } = {
  box: () => new BoxGeometry(1, 1, 1),
  sphere: () => new SphereGeometry(0.5, 48, 32),
  plane: () => new PlaneGeometry(1, 1).rotateX(-Math.PI / 2),
  cylinder: () => new CylinderGeometry(0.5, 0.5, 1, 64),
  cone: () => new ConeGeometry(0.5, 1, 64),
  torus: () => new TorusGeometry(0.4, 0.1, 24, 64).rotateX(-Math.PI / 2),
};

// Filled and read within one call.
const scratchSize = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { sizeM } = ctx.params;
  const { shape } = ctx.config;
  const geometry = GEOMETRIES[shape]();
  // A plane has no interior, so one pass draws both sides correctly when it is transparent.
  const material = new MeshStandardMaterial({ side: shape === 'plane' ? DoubleSide : FrontSide, forceSinglePass: true });
  const mesh = new Mesh(geometry, material);
  const item = createMeshItem(shape, mesh, { castsShadow: true, receivesShadow: true });
  ctx.outputs.objects.items.push(item);
  ctx.outputs.objects.version++;

  return {
    version: 0,
    update: () => {
      scratchSize.fromArray(sizeM.value);
      if (shape === 'plane') scratchSize.y = 1;
      mesh.matrixWorld.makeScale(scratchSize.x, scratchSize.y, scratchSize.z);
      setSurface(material, ctx.params);
      setShadows(item, ctx.params);
    },
    dispose: () => {
      geometry.dispose();
      material.dispose();
    },
  };
}
