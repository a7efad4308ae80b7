/**
 * How receivers read a shadow map. `basic`: one texel, whose edges show. `pcf`: four, weighted (Reeves et al. 1987). `soft`: nine
 * times four. `vsm`: blurred moments of depth (Donnelly and Lauritzen 2006). `pcss`: the wider, the farther the receiver is from
 * what casts (Fernando 2005).
 */
export type ShadowFilter = 'basic' | 'pcf' | 'soft' | 'vsm' | 'pcss';

interface AnyShadow {
  /** Side of the map; a point light has six. */
  mapSizePx: number;
  /** Absent: `soft`. Point lights have the first three. */
  filter?: ShadowFilter;
}

/** The shadow of parallel light. */
export interface LightShadow extends AnyShadow {
  /** Side of the square that the map covers around the casters, meters. */
  areaM: number;
  /** Normalized depth added against acne, and meters along the normal. */
  bias: number;
  normalBiasM: number;
  /** Of `pcss`: the angle that the light fills in the sky. */
  sourceRad?: number;
}

/** The shadow of a spot or point light: its map covers everything that the light reaches. */
export interface LocalLightShadow extends AnyShadow {
  /** How far the shadow is held off its surface, in the map's pixels there. */
  biasPx: number;
  /** Of `pcss`: diameter of the light, meters. */
  sourceM?: number;
}
