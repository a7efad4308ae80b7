/** Params that nodes with panoramas share, so that the same param has the same label and range everywhere. */

/** The rotation of something about the vertical axis, without its text. */
export const ROTATION_ABOUT_Y = {
  type: 'number',
  stage: 'uniform',
  label: 'Rotation',
  default: 0,
  min: -Math.PI,
  max: Math.PI,
  step: 0.01,
  unit: 'rad',
} as const;

/** A factor on brightness, without its label and text. */
export const BRIGHTNESS_FACTOR = {
  type: 'number',
  stage: 'uniform',
  default: 1,
  min: 0,
  max: 10,
  step: 0.01,
  unit: 'ratio',
} as const;

/**
 * The params of a node that outputs a panorama.
 *
 * @example
 * params: { file: …, ...PANORAMA_PARAMS },
 */
export const PANORAMA_PARAMS = {
  rotationRad: {
    ...ROTATION_ABOUT_Y,
    doc: 'Rotates the panorama about the vertical axis, counterclockwise seen from above. At 0 its center is straight ahead (−z).',
  },
  exposure: {
    type: 'number',
    stage: 'uniform',
    label: 'Exposure',
    doc: 'Brightness in stops: each stop doubles it.',
    default: 0,
    min: -10,
    max: 10,
    step: 0.1,
    unit: 'none',
  },
} as const;
