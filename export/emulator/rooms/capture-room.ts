import { SpatialEntity, SpatialEntityType } from '@iwer/sem';
import { NativePlane } from 'iwer';
import { Group, type Intersection, type Material, type Mesh, type Raycaster } from 'three';
import { acceleratedRaycast, MeshBVH } from 'three-mesh-bvh';
import { createMovableLight } from './movable-light.ts';
import type { Room, RoomMesh, RoomPlane } from './room.ts';
import { createScanMaterial } from './scan-material.ts';

type EntityJson = Parameters<typeof SpatialEntity.fromPBJSON>[0];

/** Position of the light probe at eye height, because captures contain no light. */
const PROBE_WORLD = [0, 1.4, 0] as const;
const ALBEDO = [0.62, 0.6, 0.57] as const;

/**
 * Creates a room from a scan: the JSON in `@iwer/sem/captures`, which has one mesh of everything, planes, and labeled boxes. The mesh is
 * drawn and measured; the boxes bound furniture that the mesh contains and are only detected.
 *
 * @throws Error if `capture` is not such JSON.
 */
export function createCaptureRoom(capture: unknown): Room {
  const solids = new Group();
  const movableLight = createMovableLight();
  const planes: RoomPlane[] = [];
  const meshes: RoomMesh[] = [];
  const material = createScanMaterial(ALBEDO, movableLight);
  for (const json of readEntities(capture)) {
    const entity = SpatialEntity.fromPBJSON(json);
    if (!entity) continue;
    entity.updateMatrixWorld(true);
    if (entity.entityType === SpatialEntityType.Plane) {
      planes.push(toPlane(entity));
      entity.geometry.dispose();
    } else {
      meshes.push(toMesh(entity));
      if (entity.entityType === SpatialEntityType.Mesh) {
        entity.raycast = raycastByTree;
        solids.add(entity);
      } else entity.geometry.dispose();
    }
    (entity.material as Material).dispose();
    entity.material = material;
  }
  solids.updateMatrixWorld(true);
  return {
    solids,
    planes,
    meshes,
    get primaryLight() {
      return movableLight.light;
    },
    moveLight: movableLight.move,
    probeWorld: PROBE_WORLD,
    dispose: () => {
      for (const solid of solids.children) (solid as Mesh).geometry.dispose();
      material.dispose();
    },
  };
}

/**
 * Intersects a ray with a mesh through a tree of bounding volumes, built for the first ray: a scan has some 10⁵ triangles. The order of
 * the triangles stays, so that the mesh is drawn as before.
 */
function raycastByTree(this: Mesh, raycaster: Raycaster, intersections: Intersection[]): void {
  this.geometry.boundsTree ??= new MeshBVH(this.geometry, { indirect: true });
  acceleratedRaycast.call(this, raycaster, intersections);
}

function readEntities(capture: unknown): EntityJson[] {
  const entities = (capture as { spatialEntities?: unknown } | null)?.spatialEntities;
  if (!Array.isArray(entities)) throw new Error('The capture is invalid: "spatialEntities" is missing.');
  return entities as EntityJson[];
}

function toPlane(entity: SpatialEntity): RoomPlane {
  const native = entity.nativeEntity;
  if (!(native instanceof NativePlane)) throw new Error(`The plane ${entity.spatialUUID} of the capture has no polygon.`);
  const worldFromPlane = entity.matrixWorld.toArray();
  // The file repeats the first corner at the end.
  const corners = native.polygon.slice(0, -1);
  return {
    label: native.semanticLabel,
    orientation: Math.abs(worldFromPlane[5] ?? 0) > Math.SQRT1_2 ? 'horizontal' : 'vertical',
    worldFromPlane,
    polygonXZ: corners.map(({ x, z }) => [x, z] as const),
  };
}

function toMesh(entity: SpatialEntity): RoomMesh {
  const index = entity.geometry.index;
  if (!index) throw new Error(`The mesh ${entity.spatialUUID} of the capture has no triangles.`);
  return {
    label: entity.nativeEntity?.semanticLabel ?? 'other',
    worldFromMesh: entity.matrixWorld.toArray(),
    vertices: Float32Array.from(entity.geometry.getAttribute('position').array),
    indices: Uint32Array.from(index.array),
  };
}
