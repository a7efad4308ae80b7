/** Params that several lights share, so that the same param has the same label and range everywhere. */

/** The param for the range of a spot or point light, meters. */
export const LOCAL_LIGHT_RANGE_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Range',
  doc: 'Distance at which the light has faded to nothing. 0 means unlimited, as real light.',
  default: 0,
  min: 0,
  max: 100,
  step: 0.1,
  unit: 'm',
} as const;

/**
 * The param for whether a spot, point or panorama light casts shadows. The limit in the text is that of
 * `export/runtime/scenes/lights/light-limits.ts`.
 */
export const LOCAL_LIGHT_CASTS_SHADOW = {
  type: 'toggle',
  stage: 'uniform',
  label: 'Cast shadows',
  doc: 'Whether objects in this light cast shadows. At most six lights of a layer cast shadows.',
  default: true,
} as const;

/** The param for the offset of receivers along their normals against shadow acne, pixels of the shadow map. */
export const SHADOW_BIAS_PX = {
  type: 'number',
  stage: 'uniform',
  label: 'Shadow offset',
  doc: 'Offset along the surface normal, in pixels of the shadow map. Raise it where lit surfaces show stripes (shadow acne); lower it where a shadow is detached from its object.',
  default: 2.5,
  min: 0,
  max: 10,
  step: 0.1,
  unit: 'px',
} as const;

/** The param for the area that a shadow map of a directional light covers. */
const SHADOW_AREA_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Shadow area',
  doc: 'Side of the square around the objects in which they cast shadows, in meters. A smaller area gives sharper shadows.',
  default: 5,
  min: 0.1,
  max: 50,
  step: 0.1,
  unit: 'm',
} as const;

const MAP_SIZES = {
  type: 'choice',
  stage: 'structure',
  label: 'Shadow resolution',
  options: [
    { value: '256', label: '256' },
    { value: '512', label: '512' },
    { value: '1024', label: '1024' },
    { value: '2048', label: '2048' },
    { value: '4096', label: '4096' },
    { value: '8192', label: '8192' },
  ],
} as const;

const MAP_SIZE_DOC =
  'Side of the shadow map in pixels. A larger map takes more memory and time: 2048 needs 20 MB, or 170 MB with “Variance”; each step up needs four times as much. A device that does not support the size uses the largest that it supports. With “Variance” the maximum is 4096.';

/** The param for the shadow map size of a directional light. */
const SHADOW_MAP_SIZE = { ...MAP_SIZES, doc: MAP_SIZE_DOC, default: '2048' } as const;

/** The param for the shadow map size of a spot light. */
export const CONE_MAP_SIZE = {
  ...MAP_SIZES,
  doc: `${MAP_SIZE_DOC} The map covers the whole cone, so a narrow cone gives sharper shadows.`,
  default: '1024',
} as const;

const FILTERS = [
  { value: 'basic', label: 'Hard' },
  { value: 'pcf', label: 'Filtered' },
  { value: 'soft', label: 'Soft' },
] as const;

const FILTER_DOC =
  'How the edges of shadows on real objects are filtered. “Hard” shows the pixels of the map. “Filtered” smooths them. “Soft” smooths over a wider area. Shadows on virtual objects always look as with “Filtered”. To give them these edges too, set “Receive on” of a Shadow node to “Everything” and turn off “Shadows” of the Scene node.';

const FILTER = { type: 'choice', stage: 'structure', label: 'Shadow edges', default: 'soft' } as const;

/** The param for the shadow filter of lights with one shadow map. */
export const SHADOW_FILTER = {
  ...FILTER,
  doc: `${FILTER_DOC} “Variance” blurs evenly and is the slowest. “Contact-hardening” is sharp where the object touches the receiver and softer with distance, as real shadows are.`,
  options: [...FILTERS, { value: 'vsm', label: 'Variance' }, { value: 'pcss', label: 'Contact-hardening' }],
} as const;

/** The param for the shadow filter of point lights, which have six shadow maps. */
export const POINT_SHADOW_FILTER = { ...FILTER, doc: FILTER_DOC, options: FILTERS } as const;

/** The param for the angular diameter of a directional light. */
const SHADOW_SOURCE_RAD = {
  type: 'number',
  stage: 'uniform',
  label: 'Angular size',
  doc: 'Apparent size of the light as an angle, for contact-hardening shadows: about 0.5° for the sun, 5° for a ceiling light, 30° for a window.',
  default: 0.1,
  min: 0,
  max: 1.5,
  step: 0.01,
  unit: 'rad',
} as const;

/** The param for the diameter of a spot or point light, meters. */
export const SHADOW_SOURCE_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Light size',
  doc: 'Diameter of the light, for contact-hardening shadows: about 0.06 m for a bulb, 0.3 m for a lampshade.',
  default: 0.1,
  min: 0,
  max: 2,
  step: 0.01,
  unit: 'm',
} as const;

/** The param for the strength of the contact shadow of a directional light. */
const CONTACT_SHADOW = {
  type: 'number',
  stage: 'uniform',
  label: 'Contact shadow',
  doc: 'Strength of a soft shadow where objects touch real surfaces, as a fraction of this light. It stands for ambient light, so it also lightens the main shadow a little. It is cast from straight above: walls and undersides get none. 0 turns it off.',
  default: 0,
  min: 0,
  max: 1,
  step: 0.01,
  unit: 'ratio',
} as const;

/**
 * All shadow params of a directional light. `createSunShadow` reads their values.
 *
 * @example
 * params: { castShadow: …, ...SUN_SHADOW },
 */
export const SUN_SHADOW = {
  areaM: SHADOW_AREA_M,
  mapSize: SHADOW_MAP_SIZE,
  biasPx: SHADOW_BIAS_PX,
  filter: SHADOW_FILTER,
  sourceRad: SHADOW_SOURCE_RAD,
  contact: CONTACT_SHADOW,
} as const;
