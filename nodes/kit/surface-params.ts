/** Params that nodes for detected surfaces share. */

export const SURFACE_CATCHES_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Receive shadows',
  doc: 'Whether virtual objects throw their shadow on them, drawn by a Shadow layer.',
  default: true,
} as const;

export const SURFACE_CASTS_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Cast shadows',
  doc: 'Whether they throw shadows themselves, as on virtual objects behind them. Best left off for floors and ceilings, over which the shadow map would have to stretch.',
  default: false,
} as const;
