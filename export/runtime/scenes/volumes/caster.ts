import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  type Material,
  Matrix4,
  Mesh,
  type MeshStandardMaterial,
  type Scene,
  Vector4,
} from 'three';
import type { ObjectItem } from '../../../../nodes/kit/scene-lists.ts';
import { isTransmissive } from '../materials/layer-blending.ts';
import { type Drawable, isInstanced, isShown, materialsOf } from '../proxies/drawable.ts';
import { extrude, maxExtrusion } from './extrude.ts';
import type { MeshShape } from './mesh-shape.ts';
import { isDeformed, poseVertices, restVertices } from './pose-vertices.ts';
import type { VolumeLight } from './volume-light.ts';

/** Opacity below which a blended material lets light pass, as in `depth-twin.ts`. */
const SOLID_OPACITY = 0.5;

/** A mesh, or an instance of one, that casts shadow volumes, one per light. */
export interface Caster {
  /** Applies this frame's pose, vertices and lights. */
  update(): void;
  dispose(): void;
}

// Valid within one call.
const scratchMatrix = new Matrix4();
const scratchLight = new Vector4();

export function createCaster(
  scene: Scene,
  master: Mesh,
  item: ObjectItem,
  instance: number,
  shape: MeshShape,
  lights: readonly VolumeLight[],
): Caster {
  const vertices = createVertices(master, shape);
  const volumes = lights.map((light) => createVolume(scene, shape, vertices, light));
  const materials = materialsOf(master);
  const worldFromMesh = new Matrix4();

  function place(): void {
    worldFromMesh.multiplyMatrices(item.worldFromObject, master.matrixWorld);
    if (!isInstanced(master)) return;
    master.getMatrixAt(instance, scratchMatrix);
    worldFromMesh.multiply(scratchMatrix);
  }

  return {
    update: () => {
      const shows =
        item.castsShadow &&
        !item.hidden &&
        isShown(master, item.root) &&
        materials.some(castsAsSolid) &&
        !(isInstanced(master) && instance >= master.count);
      if (shows) {
        place();
        vertices.update();
      }
      for (const volume of volumes) volume.update(shows, worldFromMesh);
    },
    dispose: () => {
      for (const volume of volumes) volume.dispose();
    },
  };
}

/** Vertices of all volumes of a caster: each vertex twice, in place and to be moved away from the light. */
interface Vertices {
  readonly positions: Float32Array;
  readonly attributes: { readonly position: BufferAttribute; readonly away: BufferAttribute };
  /** Increases when vertices move. */
  readonly version: number;
  update(): void;
}

function createVertices(master: Drawable, shape: MeshShape): Vertices {
  const rest = restVertices(master, shape);
  const count = shape.vertices.length;
  const positions = new Float32Array(rest);
  const twice = new Float32Array(rest.length * 2);
  const position = new BufferAttribute(twice, 3);
  const copy = (): void => {
    twice.set(positions, 0);
    twice.set(positions, positions.length);
  };
  copy();
  const deformed = isDeformed(master);
  if (deformed) position.setUsage(DynamicDrawUsage);
  let version = 0;
  return {
    positions,
    attributes: { position, away: new BufferAttribute(new Float32Array(count * 2).fill(1, count), 1) },
    get version() {
      return version;
    },
    update: () => {
      if (!deformed) return;
      poseVertices(master, shape, rest, positions);
      copy();
      position.needsUpdate = true;
      version++;
    },
  };
}

interface Volume {
  update(shows: boolean, worldFromMesh: Matrix4): void;
  dispose(): void;
}

function createVolume(scene: Scene, shape: MeshShape, vertices: Vertices, light: VolumeLight): Volume {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', vertices.attributes.position);
  geometry.setAttribute('away', vertices.attributes.away);
  const indices = new Uint32Array(maxExtrusion(shape));
  const index = new BufferAttribute(indices, 1).setUsage(DynamicDrawUsage);
  geometry.setIndex(index);
  const sides = light.materials.map((material, i) => createSide(scene, geometry, material, light.renderOrder + i));
  const extrudedFor = new Vector4();
  let extrudedVersion = -1;
  return {
    update: (shows, worldFromMesh) => {
      const visible = shows && light.casts();
      for (const side of sides) {
        side.visible = visible;
        side.matrixWorld.copy(worldFromMesh);
      }
      if (!visible) return;
      scratchLight.copy(light.lightWorld.value).applyMatrix4(scratchMatrix.copy(worldFromMesh).invert());
      if (extrudedVersion === vertices.version && scratchLight.equals(extrudedFor)) return;
      extrudedVersion = vertices.version;
      extrudedFor.copy(scratchLight);
      const count = extrude(shape, vertices.positions, extrudedFor, indices);
      geometry.setDrawRange(0, count);
      index.clearUpdateRanges();
      index.addUpdateRange(0, count);
      index.needsUpdate = true;
    },
    dispose: () => {
      for (const side of sides) side.removeFromParent();
      geometry.dispose();
    },
  };
}

function createSide(scene: Scene, geometry: BufferGeometry, material: Mesh['material'], renderOrder: number): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  mesh.matrixWorldAutoUpdate = false;
  // Volumes are infinite.
  mesh.frustumCulled = false;
  mesh.renderOrder = renderOrder;
  scene.add(mesh);
  return mesh;
}

/** Whether a material casts a full shadow: it is visible and more than half opaque. */
export function castsAsSolid(material: Material): boolean {
  return material.visible && !(material.transparent && material.opacity <= SOLID_OPACITY);
}

/** Whether a material lets light pass evenly. A volume blocks all of it or none. */
export function isSeeThrough(material: Material): boolean {
  return material.visible && ((material.transparent && material.opacity < 1) || isTransmissive(material));
}

/** Whether textures of a material cut holes into triangles or displace them, which volumes ignore. */
export function isShapedByTexture(material: Material): boolean {
  const { map, alphaMap, displacementMap, alphaTest, transparent } = material as Partial<MeshStandardMaterial> & Material;
  return Boolean(displacementMap) || ((alphaTest > 0 || transparent) && Boolean(map ?? alphaMap));
}
