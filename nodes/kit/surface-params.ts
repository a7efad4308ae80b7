/** The param for whether detected surfaces receive shadows; the nodes for planes and for meshes share it. */
export const SURFACE_CATCHES_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Receive shadows',
  doc: 'Whether the surfaces receive shadows of virtual objects. A Shadow node draws them.',
  default: true,
} as const;

/** The param for whether detected surfaces cast shadows; the nodes for planes and for meshes share it. */
export const SURFACE_CASTS_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Cast shadows',
  doc: 'Whether the surfaces cast shadows, for example on virtual objects behind them. Leave it off for floors and ceilings: the shadow map would have to cover them and lose resolution.',
  default: false,
} as const;
