/** The param for a place in the space around a node, in meters. Spread it into a definition’s params. */
export const POSITION_PARAM = {
  type: 'vector3',
  stage: 'uniform',
  handle: 'position',
  label: 'Position',
  doc: 'Translation in meters: x to the right, y up, z towards the viewer.',
  default: [0, 0, 0],
  min: [-10, -10, -10],
  max: [10, 10, 10],
  unit: 'm',
} as const;

/** The param for a rotation by Euler angles in radians, applied in the order z, x, y. Spread it into a definition’s params. */
export const ROTATION_PARAM = {
  type: 'vector3',
  stage: 'uniform',
  label: 'Rotation',
  doc: 'Rotation about each axis, counterclockwise seen from its tip: first z (roll), then x (pitch), then y (yaw).',
  default: [0, 0, 0],
  min: [-Math.PI, -Math.PI, -Math.PI],
  max: [Math.PI, Math.PI, Math.PI],
  unit: 'rad',
} as const;

/** The param for a uniform scale factor. Spread it into a definition’s params. */
export const SCALE_PARAM = {
  type: 'number',
  stage: 'uniform',
  handle: 'scale',
  label: 'Scale',
  doc: 'Uniform scale factor.',
  default: 1,
  min: 0.01,
  max: 10,
  step: 0.01,
  unit: 'ratio',
} as const;
