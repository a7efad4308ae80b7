/** The scene of the room benches, in Scrim and in plain three.js: the same models, light and floor from the same camera. */
export interface RoomPlan {
  readonly count: number;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly shadowMapPx: number;
  /** Whether room depth hides objects. Here it hides nothing, so that every pixel is tested and drawn. */
  readonly occlusion: boolean;
  readonly shadow: boolean;
  /** Filter of the shadow map. The three.js page always uses `PCFShadowMap`, which corresponds to `pcf`. */
  readonly filter: 'basic' | 'pcf' | 'soft' | 'vsm' | 'pcss';
  /** Uses the depth as it is measured, without filling holes, which three.js has no counterpart for. */
  readonly plainDepth?: true;
  /** Draws the models by one model node and an Array node, instead of one model node per model. */
  readonly copies?: true;
  /** Counts the calls of WebGL, which slows frames down. */
  readonly counted?: true;
}

/** Scale of the model, an antique camera. In its file it is about 7 units tall. */
export const CAMERA_SCALE = 0.075;
/** Side of the square area with shadows (§3.5 of the paper). */
export const SHADOW_AREA_M = 5;
export const EYE_M = [0, 2.3, 3] as const;
export const LOOK_M = [0, 0.2, 0] as const;
export const FOV_DEG = 60;
export const FLOOR_M = [5, 5] as const;
/** Light estimate: white ambient light, sun from the front left and above. */
export const AMBIENT = 0.6;
export const SUN_IRRADIANCE = [2.2, 2.1, 1.9] as const;
export const TOWARDS_SUN = [-0.48, 0.8, 0.36] as const;

const COLUMNS = 14;
export const SPACING_M = 0.33;

/** Positions on the floor, all visible. The density does not depend on the number. */
export function placesOf(count: number): (readonly [x: number, y: number, z: number])[] {
  const columns = Math.min(COLUMNS, Math.ceil(Math.sqrt(count * 1.75)));
  const rows = Math.ceil(count / columns);
  return Array.from({ length: count }, (_, i) => [
    ((i % columns) - (columns - 1) / 2) * SPACING_M,
    0,
    (Math.floor(i / columns) - (rows - 1) / 2) * SPACING_M,
  ]);
}
