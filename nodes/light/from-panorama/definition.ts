import { type ChoiceParam, defineNode, type NumberParam, type ParamDefinition, type ToggleParam } from '../../kit/definition.ts';
import { LOCAL_LIGHT_CASTS_SHADOW, SUN_SHADOW } from '../../kit/light-params.ts';
import { BRIGHTNESS_FACTOR, ROTATION_ABOUT_Y } from '../../kit/panorama/params.ts';

const NTH = ['first', 'second', 'third'] as const;

/** Creates the params that change lamp `n` alone, which the editor shows at the lamp. Lamp 1 is the strongest. */
function ofLamp<const N extends 1 | 2 | 3>(n: N) {
  const which = NTH[n - 1];
  return {
    [`lamp${n}Pinned`]: {
      type: 'toggle',
      stage: 'uniform',
      label: `Lamp ${n} pinned`,
      doc: `Whether the ${which} lamp stays at “Lamp ${n} azimuth” and “Lamp ${n} elevation” instead of where it was found.`,
      default: false,
    },
    [`lamp${n}AzimuthRad`]: {
      type: 'number',
      stage: 'uniform',
      label: `Lamp ${n} azimuth`,
      doc: `Of a pinned lamp: the horizontal direction that its light comes from, before “Rotation”: 0° is the front (+z), 90° the right (+x), 180° the back (−z), which is the center of the panorama.`,
      default: Math.PI,
      min: -Math.PI,
      max: Math.PI,
      step: 0.001,
      unit: 'rad',
    },
    [`lamp${n}ElevationRad`]: {
      type: 'number',
      stage: 'uniform',
      label: `Lamp ${n} elevation`,
      doc: 'Of a pinned lamp: its angle above the horizon.',
      default: 0.8,
      min: -Math.PI / 2,
      max: Math.PI / 2,
      step: 0.001,
      unit: 'rad',
    },
    [`lamp${n}Kind`]: {
      type: 'choice',
      stage: 'uniform',
      label: `Lamp ${n} type`,
      doc: `The type of the ${which} lamp, if it is not that of “Type of light”.`,
      default: 0,
      options: [
        { value: 0, label: 'As all' },
        { value: 1, label: 'Directional' },
        { value: 2, label: 'Spot' },
        { value: 3, label: 'Point' },
      ],
    },
    [`lamp${n}DistanceM`]: {
      type: 'number',
      stage: 'uniform',
      label: `Lamp ${n} distance`,
      doc: `Of a spot or point lamp: its distance from “Center”, in meters. At 0 it is that of all lamps.`,
      default: 0,
      min: 0,
      max: 100,
      step: 0.1,
      unit: 'm',
    },
  } as const satisfies Readonly<Record<string, ParamDefinition>> as LampParams<N>;
}

type LampParams<N extends number> = { readonly [K in `lamp${N}Pinned`]: ToggleParam & { readonly stage: 'uniform' } } & {
  readonly [K in `lamp${N}${'AzimuthRad' | 'ElevationRad' | 'DistanceM'}`]: NumberParam & { readonly stage: 'uniform' };
} & { readonly [K in `lamp${N}Kind`]: ChoiceParam & { readonly stage: 'uniform' } };

export const definition = defineNode({
  type: 'light/from-panorama',
  version: 1,
  title: 'Lights from panorama',
  doc: 'Finds the lamps and windows in a panorama and makes lights of them, which cast shadows. The rest of the panorama lights the scene from all sides; the lamps are filled from their surroundings there, so that no light counts twice. If the panorama has no lamp that stands out, it lights the scene as a whole.',
  keywords: ['hdri', 'lamp', 'window', 'sun', 'detect', 'image-based lighting', 'ibl', 'shadow', 'environment', 'probe'],
  inputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama to search.', required: true },
  },
  outputs: {
    lights: { type: 'lights', label: 'Lights', doc: 'The lamps and the rest of the panorama, for Scene and Shadow nodes.' },
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama as it was connected, with its lamps.' },
  },
  params: {
    method: {
      type: 'choice',
      stage: 'structure',
      label: 'Method',
      doc: '“Solid angle” measures brightness, color and size of each lamp on the sphere, and suits most panoramas. “Brightest areas” is the method of the ARPAS paper: it uses areas of nearly the same brightness as the brightest pixel, with fixed intensities.',
      default: 'solid-angle',
      options: [
        { value: 'solid-angle', label: 'Solid angle' },
        { value: 'paper', label: 'Brightest areas' },
      ],
    },
    lamps: {
      type: 'number',
      stage: 'structure',
      label: 'Lamps',
      doc: 'Maximum number of lamps. Further lamps stay in the rest, without shadows of their own.',
      default: 3,
      min: 1,
      max: 5,
      step: 1,
      unit: 'none',
    },
    iterations: {
      type: 'number',
      stage: 'structure',
      label: 'Iterations',
      doc: 'Of “Brightest areas”: how often the search repeats, each time without the lamps found before, so that a dim window beside a lamp is found.',
      default: 2,
      min: 1,
      max: 6,
      step: 1,
      unit: 'none',
    },
    intensities: {
      type: 'choice',
      stage: 'structure',
      label: 'Intensities',
      doc: 'Of “Brightest areas”: the strongest lamp has 100 %, the next 70 % and the others 40 %, or each in proportion to its area in pixels.',
      default: 'ranks',
      options: [
        { value: 'ranks', label: '100 %, 70 %, 40 %' },
        { value: 'area', label: 'By area' },
      ],
    },
    clippedShare: {
      type: 'number',
      stage: 'structure',
      label: 'Share of white',
      doc: 'Of “Solid angle” with JPEG, PNG or WebP files, in which lamps are clipped to white: the part of all light that white areas give. Indoors it is about 0.5. At 0, white is as bright as it looks.',
      default: 0.5,
      min: 0,
      max: 0.95,
      step: 0.01,
      unit: 'ratio',
    },
    intensity: {
      ...BRIGHTNESS_FACTOR,
      label: 'Intensity',
      doc: 'Factor on the brightness of the lamps.',
    },
    ambient: {
      ...BRIGHTNESS_FACTOR,
      label: 'Ambient light',
      doc: 'Factor on the brightness of the rest of the panorama.',
    },
    rotationRad: {
      ...ROTATION_ABOUT_Y,
      doc: 'Rotates lamps and panorama about the vertical axis, counterclockwise seen from above. It adds to the rotation of the Panorama node.',
    },
    kind: {
      type: 'choice',
      stage: 'uniform',
      label: 'Type of light',
      doc: '“Directional” lamps are infinitely far away. “Spot” and “Point” lamps are at “Distance” from “Center”, so that shadows spread and light fades with distance.',
      default: 0,
      options: [
        { value: 0, label: 'Directional' },
        { value: 1, label: 'Spot' },
        { value: 2, label: 'Point' },
      ],
    },
    distanceM: {
      type: 'number',
      stage: 'uniform',
      label: 'Distance',
      doc: 'Of spot and point lamps: distance from “Center”, in meters. Their brightness at the center does not depend on it.',
      default: 2.5,
      min: 0.1,
      max: 100,
      step: 0.1,
      unit: 'm',
    },
    distanceFrom: {
      type: 'choice',
      stage: 'structure',
      label: 'Distance from',
      doc: 'Of spot and point lamps: “Room” places a lamp on what its direction meets in the room: detected planes and meshes, and room depth. Where it meets nothing, “Distance” counts.',
      default: 'param',
      options: [
        { value: 'param', label: 'Distance' },
        { value: 'room', label: 'Room' },
      ],
    },
    centerM: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'position',
      label: 'Center',
      doc: 'Where the panorama was taken, in world space, in meters. Only spot and point lamps depend on it.',
      default: [0, 1.6, 0],
      unit: 'm',
    },
    visible: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Show behind objects',
      doc: 'Whether the panorama, without its lamps, is visible behind the objects of the scene.',
      default: false,
    },
    castShadow: LOCAL_LIGHT_CASTS_SHADOW,
    softness: {
      type: 'number',
      stage: 'uniform',
      label: 'Softness',
      doc: 'Factor on the size of the lamps, which softens contact-hardening shadows with distance.',
      default: 1,
      min: 0,
      max: 4,
      step: 0.01,
      unit: 'ratio',
    },
    contact: {
      type: 'number',
      stage: 'uniform',
      label: 'Shadow of the rest',
      doc: 'Strength of the soft shadow that objects cast in the rest of the light: 1 as measured, 0 for none. Only with “Solid angle” and directional lamps.',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    areaM: SUN_SHADOW.areaM,
    mapSize: { ...SUN_SHADOW.mapSize, default: '1024' },
    biasPx: SUN_SHADOW.biasPx,
    filter: { ...SUN_SHADOW.filter, default: 'pcss' },
    visitorControls: {
      type: 'toggle',
      stage: 'structure',
      label: 'Controls on the page',
      doc: 'Whether visitors can set type, distance and strength of the lamps, the ambient light, and turn all a little. Their values last for the visit.',
      default: false,
    },
    ...ofLamp(1),
    ...ofLamp(2),
    ...ofLamp(3),
  },
  visitorParams: {
    by: 'visitorControls',
    params: [
      { param: 'kind' },
      { param: 'distanceM' },
      { param: 'intensity' },
      { param: 'ambient' },
      { param: 'rotationRad', around: Math.PI / 6 },
    ],
  },
  needs: [
    {
      capability: 'hit-test',
      required: false,
      when: 'always',
      where: { param: 'distanceFrom', is: 'room' },
      why: 'to find how far away the lamps of the room are',
      without: 'Lamps are at the distance that is set.',
    },
  ],
  lowering: { kind: 'geometry' },
  worker: true,
});
