/** Params that several lights share: one word and one range for the same thing. */

/** Where a lamp's light ends, metres. */
export const LAMP_RANGE_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Range',
  doc: 'Where its light ends; it fades out on the way there. 0: it has no end, as real light.',
  default: 0,
  min: 0,
  max: 100,
  step: 0.1,
  unit: 'm',
} as const;

/** Of lamps: the limit is that of `export/runtime/scenes/lights/light-limits.ts`. */
export const LAMP_CASTS_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Cast shadows',
  doc: 'Whether objects in this light throw shadows. At most six lights of a layer do.',
  default: true,
} as const;

/** How far shadows are held off their surfaces, pixels of the shadow map. */
export const SHADOW_BIAS_PX = {
  type: 'number',
  stage: 'uniform',
  label: 'Shadow offset',
  doc: 'How far the shadow is held off its surface, in pixels of the shadow map. Raise it where lit surfaces show stripes; lower it where a shadow comes loose from its object.',
  default: 2.5,
  min: 0,
  max: 10,
  step: 0.1,
  unit: 'px',
} as const;
