/** What the benches of a real room draw, ours and by three.js alone: the same models, light and floor, seen from the same place. */
export interface RoomPlan {
  readonly count: number;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly shadowMapPx: number;
  /** Depth of the real room hides what is behind it; here nothing is, so that every pixel is both tested and drawn. */
  readonly occlusion: boolean;
  readonly shadow: boolean;
  /** How the edges of shadows are found; three.js alone always filters (`PCFShadowMap`), which is `pcf` here. */
  readonly filter: 'basic' | 'pcf' | 'soft' | 'vsm' | 'pcss';
  /** One model and a node that copies it, instead of a node for each. */
  readonly copies?: true;
}

/** The antique camera's file is about 7 units tall. */
export const CAMERA_SCALE = 0.075;
/** As in the paper, §3.5: the side of the area that has shadows. */
export const SHADOW_AREA_M = 5;
export const EYE_M = [0, 2.3, 3] as const;
export const LOOK_M = [0, 0.2, 0] as const;
export const FOV_DEG = 60;
export const FLOOR_M = [5, 5] as const;
/** Of the light estimate: white from all sides, the sun from the left, before and above. */
export const AMBIENT = 0.6;
export const SUN_IRRADIANCE = [2.2, 2.1, 1.9] as const;
export const TOWARDS_SUN = [-0.48, 0.8, 0.36] as const;

const COLUMNS = 14;
export const SPACING_M = 0.33;

/** Where each of them stands, on the floor, all in sight; few stand as close together as many. */
export function placesOf(count: number): (readonly [x: number, y: number, z: number])[] {
  const columns = Math.min(COLUMNS, Math.ceil(Math.sqrt(count * 1.75)));
  const rows = Math.ceil(count / columns);
  return Array.from({ length: count }, (_, i) => [
    ((i % columns) - (columns - 1) / 2) * SPACING_M,
    0,
    (Math.floor(i / columns) - (rows - 1) / 2) * SPACING_M,
  ]);
}
