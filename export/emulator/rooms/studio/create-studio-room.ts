import { Group, Mesh, Vector3 } from 'three';
import { type Room, type RoomPlane, rectanglePlane } from '../room.ts';
import { createLightBaker, type Daylight } from './bake-light.ts';
import { mergeBySurface, type SurfaceGeometry, toBufferGeometry } from './build-geometry.ts';
import { furnish, type Part, ROOM, WINDOW } from './furniture.ts';
import type { Solid, Triple } from './solid.ts';
import { createStudioMaterial, type StudioUniforms } from './studio-material.ts';
import { createSunMap } from './sun-map.ts';
import { SURFACES, type SurfaceName } from './surfaces.ts';
import { type PaintedTexture, paintTexture } from './textures.ts';

const SUN_MAP_PX = 1024;
/** Half the size of the sun's shadow map, in meters: it covers the room from corner to corner. */
const SUN_REACH_M = 3.9;
const SHELL = new Set<SurfaceName>(['oak', 'ceiling', 'plaster', 'wallpaper', 'outdoors']);
const HALF: Triple = [ROOM.widthM / 2, ROOM.heightM / 2, ROOM.depthM / 2];

const DAYLIGHT: Daylight = {
  window: { center: [-HALF[0] - 0.05, WINDOW.centerY, WINDOW.centerZ], heightM: WINDOW.heightM, widthM: WINDOW.widthM, normal: [1, 0, 0] },
  sky: [7.6, 8, 8.6],
  sunDirection: unit([-0.78, 0.56, 0.2]),
  sun: [9.5, 8.2, 6.3],
};
/**
 * Estimated irradiance of the sun for the whole room. It is below the real value because most of the room is in shadow and devices
 * normalize white.
 */
const ESTIMATED_SUN: Triple = [3.3, 2.9, 2.3];

/**
 * Creates a textured living room of exactly known geometry, lit through a window, with sunlight on the rug. Code generates all of it from
 * fixed seeds, in about a second. Moving the sun does not update indirect light.
 *
 * @example
 * const room = createStudioRoom();
 * room.moveLight([0, 1, 0]);
 */
export function createStudioRoom(): Room {
  const parts = furnish();
  const textures = new Map(namesOf(parts).map((name) => [name, paintTexture(SURFACES[name])]));
  const merged = mergeBySurface(parts);
  const bake = createLightBaker(toSolids(parts, textures), DAYLIGHT);
  const sunMap = createSunMap(SUN_MAP_PX, SUN_REACH_M);
  const shared: StudioUniforms = {
    sunDirection: { value: new Vector3() },
    sun: { value: new Vector3() },
    throughWindow: { value: 1 },
    sky: { value: new Vector3(...DAYLIGHT.sky) },
    windowX: { value: DAYLIGHT.window.center[0] },
    sunMap: { value: sunMap.texture },
    sunMapFromWorld: { value: sunMap.mapFromWorld },
  };
  const meshes = merged.map((geometry) => {
    const { surface, positions, normals } = geometry;
    const painted = textures.get(surface);
    if (!painted) throw new Error(`No texture was painted for ${surface}.`);
    const material = createStudioMaterial(SURFACES[surface], painted.texture, SUN_MAP_PX, shared);
    const mesh = new Mesh(toBufferGeometry(geometry, bake(positions, normals)), material);
    mesh.name = surface;
    // Furniture is drawn before the shell, so hidden pixels of the shell are not shaded.
    mesh.renderOrder = SHELL.has(surface) ? 1 : 0;
    return mesh;
  });
  const solids = new Group();
  solids.add(...meshes);
  /** Null: the original direction. */
  let moved: Triple | null = null;
  const moveLight = (directionWorld: Triple | null) => {
    moved = directionWorld;
    const sunDirection = moved ?? DAYLIGHT.sunDirection;
    shared.sunDirection.value.set(...sunDirection);
    shared.sun.value.set(...(moved ? ESTIMATED_SUN : DAYLIGHT.sun)).divideScalar(Math.PI);
    shared.throughWindow.value = moved ? 0 : 1;
    sunMap.aim(sunDirection);
  };
  moveLight(null);
  return {
    solids,
    planes: planes(),
    meshes: [mergeMesh(merged)],
    get primaryLight() {
      return { directionWorld: moved ?? DAYLIGHT.sunDirection, intensity: ESTIMATED_SUN };
    },
    moveLight,
    probeWorld: [0, 1, 0.2],
    prepare: (renderer, scene) => {
      // The outdoor image is behind the window, where the sun comes in. A moved light passes through walls and ceiling.
      for (const mesh of meshes) mesh.visible = moved ? !SHELL.has(mesh.name as SurfaceName) : mesh.name !== 'outdoors';
      sunMap.draw(renderer, scene);
      for (const mesh of meshes) mesh.visible = true;
    },
    dispose: () => {
      for (const mesh of meshes) {
        mesh.geometry.dispose();
        mesh.material.dispose();
      }
      for (const { texture } of textures.values()) texture.dispose();
      sunMap.dispose();
    },
  };
}

function namesOf(parts: readonly Part[]): SurfaceName[] {
  return [...new Set(parts.map(({ surface }) => surface))];
}

/** Converts parts to the solids for light baking: first the shell of the room, then the furniture. */
function toSolids(parts: readonly Part[], textures: ReadonlyMap<SurfaceName, PaintedTexture>): Solid[] {
  const shell: Solid = { center: [0, HALF[1], 0], half: HALF, yawRad: 0, albedo: [0.6, 0.57, 0.5] };
  const blockers = parts.flatMap(({ blocker, yawRad = 0, surface, tint = [1, 1, 1] }): Solid[] => {
    if (!blocker) return [];
    const mean = textures.get(surface)?.meanAlbedo ?? [0.5, 0.5, 0.5];
    return [
      {
        center: blocker.center,
        half: [blocker.size[0] / 2, blocker.size[1] / 2, blocker.size[2] / 2],
        yawRad,
        albedo: [mean[0] * tint[0], mean[1] * tint[1], mean[2] * tint[2]],
      },
    ];
  });
  return [shell, ...blockers];
}

function planes(): RoomPlane[] {
  const [x, y, z] = HALF;
  const vertical = (label: string, at: Triple, normal: Triple, width: number, height: number): RoomPlane =>
    rectanglePlane(label, at, [normal[2], 0, -normal[0]], normal, [width, height]);
  const top = (label: string, at: Triple, size: readonly [number, number]): RoomPlane =>
    rectanglePlane(label, at, [1, 0, 0], [0, 1, 0], size);
  return [
    top('floor', [0, 0, 0], [ROOM.widthM, ROOM.depthM]),
    rectanglePlane('ceiling', [0, ROOM.heightM, 0], [1, 0, 0], [0, -1, 0], [ROOM.widthM, ROOM.depthM]),
    vertical('wall', [0, y, -z], [0, 0, 1], ROOM.widthM, ROOM.heightM),
    vertical('wall', [0, y, z], [0, 0, -1], ROOM.widthM, ROOM.heightM),
    vertical('wall', [-x, y, 0], [1, 0, 0], ROOM.depthM, ROOM.heightM),
    vertical('wall', [x, y, 0], [-1, 0, 0], ROOM.depthM, ROOM.heightM),
    vertical('window', [-x, WINDOW.centerY, WINDOW.centerZ], [1, 0, 0], WINDOW.widthM, WINDOW.heightM),
    top('table', [-0.2, 0.4225, -0.42], [1.05, 0.56]),
    top('couch', [-0.45, 0.455, -1.64], [1.6, 0.7]),
    top('shelf', [2.36, 0.73, 0.45], [0.42, 1.45]),
  ];
}

function mergeMesh(merged: readonly SurfaceGeometry[]): Room['meshes'][number] {
  const vertices: number[] = [];
  const indices: number[] = [];
  for (const geometry of merged) {
    const first = vertices.length / 3;
    for (const value of geometry.positions) vertices.push(value);
    for (const index of geometry.indices) indices.push(first + index);
  }
  return {
    label: 'global mesh',
    worldFromMesh: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    vertices: new Float32Array(vertices),
    indices: new Uint32Array(indices),
  };
}

function unit([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}
