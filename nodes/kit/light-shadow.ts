/**
 * How receivers sample a shadow map. `basic`: one texel, without filtering. `pcf`: four texels, weighted (Reeves et al. 1987). `soft`:
 * nine times four texels. `vsm`: blurred moments of depth (Donnelly and Lauritzen 2006). `pcss`: a filter width that grows with the
 * distance of the receiver from the caster (Fernando 2005).
 */
export type ShadowFilter = 'basic' | 'pcf' | 'soft' | 'vsm' | 'pcss';

interface AnyShadow {
  /** Side of the shadow map in pixels; a point light has six maps. */
  mapSizePx: number;
  /** How receivers sample the map. Absent: `soft`. Point lights support only `basic`, `pcf` and `soft`. */
  filter?: ShadowFilter;
}

/** The shadow of a directional light. */
export interface LightShadow extends AnyShadow {
  /** Side of the square that the map covers around the casters, meters. */
  areaM: number;
  /** Offset in normalized depth, against shadow acne. */
  bias: number;
  /** Offset of receivers along their normal, against shadow acne. */
  normalBiasM: number;
  /** Only for `pcss`: the angular diameter of the light. */
  sourceRad?: number;
}

/** The shadow of a spot or point light. Its map covers everything that the light reaches. */
export interface LocalLightShadow extends AnyShadow {
  /** Offset of receivers along their normal, in pixels of the map at their distance. */
  biasPx: number;
  /** Only for `pcss`: the diameter of the light, meters. */
  sourceM?: number;
}

/** Reported by nodes that draw shadows on real surfaces while nothing is connected that has surfaces. */
export const NOTHING_TO_FALL_ON = {
  code: 'SCR015',
  severity: 'warning',
  port: 'receivers',
  message: 'Neither “Receivers” nor “Room depth” is connected, so no shadow is visible.',
  fix: 'Connect Detected planes, Room depth or a Phantom.',
} as const;
