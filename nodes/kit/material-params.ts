/** Params of objects that nodes make: the same param has the same label and range in each of them. */

/** The param for the color of a surface, without a default. */
export const BASE_COLOR = {
  type: 'color',
  stage: 'uniform',
  label: 'Color',
  doc: 'Base color of the surface. With alpha below 1 it is transparent.',
} as const;

/** The param for the roughness of a surface. */
export const ROUGHNESS = {
  type: 'number',
  stage: 'uniform',
  label: 'Roughness',
  doc: '0 is a mirror, 1 is matte.',
  default: 0.6,
  min: 0,
  max: 1,
  step: 0.01,
  unit: 'ratio',
} as const;

/** The param for the metalness of a surface. */
export const METALNESS = {
  type: 'number',
  stage: 'uniform',
  label: 'Metalness',
  doc: '0 for plastic, wood or stone; 1 for metal.',
  default: 0,
  min: 0,
  max: 1,
  step: 0.01,
  unit: 'ratio',
} as const;

/** The param for whether an object casts a shadow. */
export const CASTS_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Cast shadows',
  doc: 'Whether it casts a shadow.',
  default: true,
} as const;

/** The param for whether an object receives shadows. */
export const RECEIVES_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Receive shadows',
  doc: 'Whether it receives shadows, its own included.',
  default: true,
} as const;
