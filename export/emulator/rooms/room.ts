import type { Object3D, Scene, WebGLRenderer } from 'three';

/** A room for the emulated device, in world space: meters, y up, floor at y = 0. Images, depth and hit tests use the same solids. */
export interface Room {
  /** Meshes with opaque materials that write display-referred sRGB to the screen and linear light into other targets. */
  readonly solids: Object3D;
  /** Planes that plane detection reports. */
  readonly planes: readonly RoomPlane[];
  /** Meshes that mesh detection reports. */
  readonly meshes: readonly RoomMesh[];
  /** The strongest light. The rest of the light estimate is measured from the solids at `probeWorld`. */
  readonly primaryLight: PrimaryLight;
  readonly probeWorld: readonly [number, number, number];
  /** Moves the strongest light: a unit vector from the scene towards the light, or null to restore it. Call `prepare` afterwards. */
  moveLight(directionWorld: PrimaryLight['directionWorld'] | null): void;
  /** Renders what the solids' materials need, such as shadow maps, with the renderer and scene that draw them. */
  prepare?(renderer: WebGLRenderer, scene: Scene): void;
  dispose(): void;
}

export interface PrimaryLight {
  /** Unit vector from the scene towards the light. */
  readonly directionWorld: readonly [number, number, number];
  /** Linear-sRGB irradiance on a surface that faces the light, averaged over the room as devices estimate it. */
  readonly intensity: readonly [number, number, number];
}

/** A plane whose y axis is the normal; the polygon is in its x–z plane. */
export interface RoomPlane {
  /** A semantic label of WebXR: `floor`, `wall`, `table`, … */
  readonly label: string;
  readonly orientation: 'horizontal' | 'vertical';
  /** Column-major 4×4. */
  readonly worldFromPlane: readonly number[];
  readonly polygonXZ: readonly (readonly [x: number, z: number])[];
}

export interface RoomMesh {
  readonly label: string;
  readonly worldFromMesh: readonly number[];
  /** Three numbers per vertex. */
  readonly vertices: Float32Array;
  readonly indices: Uint32Array;
}

/** Creates a rectangular plane around `originWorld` from its normal `yWorld` and the axis `xWorld` in the plane. */
export function rectanglePlane(
  label: string,
  originWorld: readonly [number, number, number],
  xWorld: readonly [number, number, number],
  yWorld: readonly [number, number, number],
  sizeXZ: readonly [number, number],
): RoomPlane {
  const [x, y] = [xWorld, yWorld];
  const z = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]] as const;
  const [halfX, halfZ] = [sizeXZ[0] / 2, sizeXZ[1] / 2];
  return {
    label,
    orientation: Math.abs(y[1]) > Math.SQRT1_2 ? 'horizontal' : 'vertical',
    worldFromPlane: [...x, 0, ...y, 0, ...z, 0, ...originWorld, 1],
    polygonXZ: [
      [-halfX, -halfZ],
      [halfX, -halfZ],
      [halfX, halfZ],
      [-halfX, halfZ],
    ],
  };
}
