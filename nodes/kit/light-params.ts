/** Params that several lights share: one word and one range for the same thing. */

/** The range of a spot or point light, meters. */
export const LOCAL_LIGHT_RANGE_M = {
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

/** Of spot and point lights. The limit is that of `export/runtime/scenes/lights/light-limits.ts`. */
export const LOCAL_LIGHT_CASTS_SHADOW = {
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

/** What a map of parallel light covers. */
const SHADOW_AREA_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Shadow area',
  doc: 'Side of the square around the objects in which they throw shadows, in meters. Smaller is sharper.',
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
  'Side of the shadow map in pixels. Finer takes more memory and time: 2048 needs 20 MB, with variance edges 170 MB, and each step up four times as much. A device that cannot make it so large takes the largest it can; with variance edges, that is at most 4096.';

/** Of parallel light. */
const SHADOW_MAP_SIZE = { ...MAP_SIZES, doc: MAP_SIZE_DOC, default: '2048' } as const;

/** Of a light in a cone. */
export const CONE_MAP_SIZE = {
  ...MAP_SIZES,
  doc: `${MAP_SIZE_DOC} The map covers the whole cone, so a narrow one is sharper.`,
  default: '1024',
} as const;

const FILTERS = [
  { value: 'basic', label: 'Hard' },
  { value: 'pcf', label: 'Filtered' },
  { value: 'soft', label: 'Soft' },
] as const;

const FILTER_DOC =
  'How the edges of shadows on real things look. Hard: the pixels of the map show. Filtered: these are smoothed. Soft: a little wider. On virtual things they are always as filtered ones; a Shadow layer on “Everything”, with “Shadows” of the Scene off, gives virtual things these edges too.';

const FILTER = { type: 'choice', stage: 'structure', label: 'Shadow edges', default: 'soft' } as const;

/** Of lights with one map: on virtual things, shadows are always a little soft. */
export const SHADOW_FILTER = {
  ...FILTER,
  doc: `${FILTER_DOC} Variance: blurred evenly, the dearest. Contact-hardening: sharp where a thing touches what its shadow falls on, and the wider, the farther away it is, as real shadows are.`,
  options: [...FILTERS, { value: 'vsm', label: 'Variance' }, { value: 'pcss', label: 'Contact-hardening' }],
} as const;

/** Of lights with six. */
export const POINT_SHADOW_FILTER = { ...FILTER, doc: FILTER_DOC, options: FILTERS } as const;

/** How large parallel light seems. */
const SHADOW_SOURCE_RAD = {
  type: 'number',
  stage: 'uniform',
  label: 'Size of the light',
  doc: 'The angle that the light fills, for contact-hardening shadows: the sun half a degree, a ceiling lamp five, a window thirty.',
  default: 0.1,
  min: 0,
  max: 1.5,
  step: 0.01,
  unit: 'rad',
} as const;

/** Diameter of a spot or point light, meters. */
export const SHADOW_SOURCE_M = {
  type: 'number',
  stage: 'uniform',
  label: 'Size of the lamp',
  doc: 'How wide the lamp is, for contact-hardening shadows: a bulb 6 cm, a shade 30 cm.',
  default: 0.1,
  min: 0,
  max: 2,
  step: 0.01,
  unit: 'm',
} as const;

/** How dark it is where things touch. */
const CONTACT_SHADOW = {
  type: 'number',
  stage: 'uniform',
  label: 'Contact shadow',
  doc: 'Light from all sides, as a part of this light, and the dark that it leaves where things touch real ones. It lightens the other shadow a little, as a bright room does. It is cast from straight above, whichever way surfaces face: walls and the undersides of things get none. 0: none.',
  default: 0,
  min: 0,
  max: 1,
  step: 0.01,
  unit: 'ratio',
} as const;

/** How parallel light throws shadows, all of it: one node's worth of params. */
export const SUN_SHADOW = {
  areaM: SHADOW_AREA_M,
  mapSize: SHADOW_MAP_SIZE,
  biasPx: SHADOW_BIAS_PX,
  filter: SHADOW_FILTER,
  sourceRad: SHADOW_SOURCE_RAD,
  contact: CONTACT_SHADOW,
} as const;
