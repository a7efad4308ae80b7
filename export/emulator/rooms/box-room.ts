import { BoxGeometry, Group, Mesh } from 'three';
import { createMovableLight } from './movable-light.ts';
import { type Room, type RoomMesh, type RoomPlane, rectanglePlane } from './room.ts';
import { createScanMaterial } from './scan-material.ts';

/** A solid block, rotated about the y axis. Plain data. */
export interface RoomBox {
  /** A semantic label of WebXR. Labels of horizontal surfaces, such as `floor` and `table`, also add a plane at the top. */
  readonly label: string;
  readonly centerWorld: readonly [number, number, number];
  readonly sizeM: readonly [number, number, number];
  readonly yawRad?: number;
  /** Reflectance, linear-sRGB. */
  readonly albedo?: readonly [number, number, number];
}

const TOP_IS_PLANE = new Set(['floor', 'table', 'desk', 'couch', 'shelf', 'bed']);

/**
 * Creates a room of blocks, for tests that compute geometry by hand.
 *
 * @example
 * const room = createBoxRoom([{ label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [4, 0.1, 4] }]);
 */
export function createBoxRoom(boxes: readonly RoomBox[]): Room {
  const solids = new Group();
  const movableLight = createMovableLight();
  for (const box of boxes) {
    const mesh = new Mesh(new BoxGeometry(...box.sizeM), createScanMaterial(box.albedo ?? [0.6, 0.6, 0.6], movableLight));
    mesh.position.set(...box.centerWorld);
    mesh.rotation.y = box.yawRad ?? 0;
    mesh.name = box.label;
    solids.add(mesh);
  }
  solids.updateMatrixWorld(true);
  const meshes = solids.children as Mesh<BoxGeometry>[];
  return {
    solids,
    planes: boxes.filter(({ label }) => TOP_IS_PLANE.has(label)).map(topOf),
    meshes: meshes.map(toRoomMesh),
    get primaryLight() {
      return movableLight.light;
    },
    moveLight: movableLight.move,
    probeWorld: [0, 1.4, 0],
    dispose: () => {
      for (const mesh of meshes) {
        mesh.geometry.dispose();
        if (!Array.isArray(mesh.material)) mesh.material.dispose();
      }
    },
  };
}

function topOf({ label, centerWorld: [x, y, z], sizeM, yawRad = 0 }: RoomBox): RoomPlane {
  const across = [Math.cos(yawRad), 0, -Math.sin(yawRad)] as const;
  return rectanglePlane(label, [x, y + sizeM[1] / 2, z], across, [0, 1, 0], [sizeM[0], sizeM[2]]);
}

function toRoomMesh(mesh: Mesh<BoxGeometry>): RoomMesh {
  return {
    label: mesh.name,
    worldFromMesh: mesh.matrixWorld.toArray(),
    vertices: Float32Array.from(mesh.geometry.getAttribute('position').array),
    indices: Uint32Array.from(mesh.geometry.index?.array ?? []),
  };
}
