import type { PageUse } from '../page-entry.ts';

/** A source file of three.js that no page, or only some pages need. */
interface ThreePart {
  /** Path in `node_modules/three/src`. */
  readonly file: string;
  /** Code that stands for it. */
  readonly otherwise: string;
  readonly isNeeded?: (use: PageUse) => boolean;
}

const SHADERS = 'renderers/shaders';
const NO_SHADERS = "export const vertex = '', fragment = '';";

const shaderLib = (name: string, isNeeded?: ThreePart['isNeeded']): ThreePart => ({
  file: `${SHADERS}/ShaderLib/${name}.glsl.js`,
  otherwise: NO_SHADERS,
  ...(isNeeded && { isNeeded }),
});
const chunk = (name: string): ThreePart => ({ file: `${SHADERS}/ShaderChunk/${name}.glsl.js`, otherwise: "export default '';" });

const hasPoints = ({ models }: PageUse): boolean => models.points;

/**
 * Parts of three.js that Scrim does not use: it has sessions and shadow maps of its own, filters panoramas itself, clips nothing, and
 * draws with the materials of glTF and its own. The code that stands for them does what the renderer of three.js calls.
 */
export const THREE_PARTS: readonly ThreePart[] = [
  {
    file: 'renderers/webxr/WebXRManager.js',
    otherwise: 'export class WebXRManager { addEventListener() {} removeEventListener() {} getEnvironmentBlendMode() {} dispose() {} }',
  },
  { file: 'extras/PMREMGenerator.js', otherwise: 'export class PMREMGenerator {}' },
  { file: 'math/FrustumArray.js', otherwise: 'export class FrustumArray {}' },
  { file: 'renderers/webgl/WebGLOutput.js', otherwise: 'export class WebGLOutput {}' },
  { file: 'renderers/webgl/WebGLUniformsGroups.js', otherwise: 'export const WebGLUniformsGroups = class { dispose() {} };' },
  {
    file: 'renderers/webgl/WebGLClipping.js',
    otherwise: 'export class WebGLClipping { numPlanes = 0; numIntersection = 0; init() { return false; } }',
  },
  { file: 'renderers/webgl/WebGLShadowMap.js', otherwise: 'export class WebGLShadowMap { render() {} }' },
  ...['background', 'backgroundCube', 'cube', 'distance', 'equirect', 'linedashed', 'meshlambert', 'meshmatcap', 'meshnormal'].map((name) =>
    shaderLib(name),
  ),
  ...['meshphong', 'meshtoon', 'shadow', 'sprite'].map((name) => shaderLib(name)),
  shaderLib('points', hasPoints),
  ...['envmap_fragment', 'envmap_pars_fragment', 'envmap_pars_vertex', 'envmap_vertex', 'gradientmap_pars_fragment'].map(chunk),
  ...['lights_lambert_fragment', 'lights_lambert_pars_fragment', 'lights_phong_fragment', 'lights_phong_pars_fragment'].map(chunk),
  ...['lights_toon_fragment', 'lights_toon_pars_fragment', 'shadowmask_pars_fragment', 'tonemapping_pars_fragment'].map(chunk),
];

/** Macros of three.js' shaders that no material of Scrim defines, and numbers that are 0 in all scenes. */
const NEVER = [
  'ALPHA_TO_COVERAGE',
  'DITHERING',
  'ENVMAP_TYPE_CUBE',
  'FOG_EXP2',
  'LAMBERT',
  'NUM_CLIPPING_PLANES',
  'NUM_HEMI_LIGHTS',
  'NUM_LIGHT_PROBE_GRIDS',
  'NUM_RECT_AREA_LIGHTS',
  'NUM_SUN_LIGHTS',
  'NUM_SUN_LIGHT_SHADOWS',
  'PHONG',
  'SHADOWMAP_TYPE_BASIC',
  'SHADOWMAP_TYPE_VSM',
  'TONE_MAPPING',
  'USE_ALPHAHASH',
  'USE_ALPHAMAP',
  'USE_BATCHING',
  'USE_BATCHING_COLOR',
  'USE_DISPLACEMENTMAP',
  'USE_FOG',
  'USE_GRADIENTMAP',
  'USE_LIGHTMAP',
  'USE_LOGARITHMIC_DEPTH_BUFFER',
  'USE_MATCAP',
  'USE_NORMALMAP_OBJECTSPACE',
  'USE_RETROREFLECTION',
  'USE_REVERSED_DEPTH_BUFFER',
  'USE_SPECULARMAP',
] as const;

const LOCAL_LIGHT_COUNTS = [
  'NUM_POINT_LIGHTS',
  'NUM_POINT_LIGHT_SHADOWS',
  'NUM_SPOT_LIGHTS',
  'NUM_SPOT_LIGHT_COORDS',
  'NUM_SPOT_LIGHT_MAPS',
  'NUM_SPOT_LIGHT_SHADOWS',
];

/** Node types that create lights with a position. A test compares them with the runtimes. */
export const LOCAL_LIGHTS: readonly string[] = ['light/from-panorama', 'light/point', 'light/spot'];

const glass = ['USE_TRANSMISSION', 'USE_TRANSMISSIONMAP', 'USE_THICKNESSMAP', 'USE_DISPERSION'];

/** glTF extension of a physical material → the macros that three.js defines for it. */
const MACROS_OF_EXTENSIONS: Readonly<Record<string, readonly string[]>> = {
  KHR_materials_anisotropy: ['USE_ANISOTROPY', 'USE_ANISOTROPYMAP'],
  KHR_materials_clearcoat: ['USE_CLEARCOAT', 'USE_CLEARCOATMAP', 'USE_CLEARCOAT_NORMALMAP', 'USE_CLEARCOAT_ROUGHNESSMAP'],
  KHR_materials_diffuse_roughness: ['USE_DIFFUSE_ROUGHNESS', 'USE_DIFFUSE_ROUGHNESSMAP'],
  KHR_materials_dispersion: glass,
  KHR_materials_ior: [],
  KHR_materials_iridescence: ['USE_IRIDESCENCE', 'USE_IRIDESCENCEMAP', 'USE_IRIDESCENCE_THICKNESSMAP'],
  KHR_materials_sheen: ['USE_SHEEN', 'USE_SHEEN_COLORMAP', 'USE_SHEEN_ROUGHNESSMAP'],
  KHR_materials_specular: ['USE_SPECULAR_COLORMAP', 'USE_SPECULAR_INTENSITYMAP'],
  KHR_materials_transmission: glass,
  KHR_materials_volume: glass,
  EXT_materials_bump: ['USE_BUMPMAP'],
};

/** The extensions of a physical material, by which three.js' loader makes such a material. */
export const PHYSICAL_EXTENSIONS: readonly string[] = Object.keys(MACROS_OF_EXTENSIONS).filter((name) => name.startsWith('KHR_'));

/** Macros of three.js' shaders that no material of the page defines. */
export function undefinedMacros({ models, nodeTypes }: Pick<PageUse, 'models' | 'nodeTypes'>): ReadonlySet<string> {
  const used = Object.entries(MACROS_OF_EXTENSIONS).filter(([name]) => models.extensions.has(name));
  const defined = new Set(used.flatMap(([, macros]) => macros));
  const isPhysical = PHYSICAL_EXTENSIONS.some((name) => models.extensions.has(name));
  const possible = Object.values(MACROS_OF_EXTENSIONS).flat();
  return new Set([
    ...NEVER,
    ...possible.filter((macro) => !defined.has(macro)),
    ...(isPhysical ? [] : ['PHYSICAL', 'USE_SPECULAR']),
    ...(LOCAL_LIGHTS.some((type) => nodeTypes.includes(type)) ? [] : LOCAL_LIGHT_COUNTS),
  ]);
}

/** Methods of three.js' classes that no page calls. */
export const UNUSED_METHODS: readonly string[] = ['toJSON', 'fromJSON', 'raycast'];
