import { type IUniform, Matrix3, Matrix4, type Scene, type Texture } from 'three';

/** Uniforms by which techniques read the light of a scene's environment, as three.js' own lit materials do. */
export interface EnvironmentUniforms {
  readonly uniforms: Readonly<Record<string, IUniform>>;
  /** Sets the uniforms to the environment of the scene; black if it has none. */
  update(scene: Scene): void;
}

// Valid within one call.
const scratchRotation = new Matrix4();

export function createEnvironmentUniforms(): EnvironmentUniforms {
  const cube: IUniform<Texture | null> = { value: null };
  const cubeFromWorld = { value: new Matrix3() };
  const intensity = { value: 0 };
  const lastLevel = { value: 0 };
  return {
    uniforms: {
      scrimEnvironment: cube,
      scrimEnvironmentFromWorld: cubeFromWorld,
      scrimEnvironmentIntensity: intensity,
      scrimEnvironmentLastLevel: lastLevel,
    },
    update: ({ environment, environmentIntensity, environmentRotation }) => {
      cube.value = environment;
      intensity.value = environment ? environmentIntensity : 0;
      lastLevel.value = Math.max((environment?.mipmaps?.length ?? 0) - 1, 0);
      // As `WebGLMaterials.refreshUniformsCommon` of three.js.
      cubeFromWorld.value.setFromMatrix4(scratchRotation.makeRotationFromEuler(environmentRotation)).transpose();
    },
  };
}

/**
 * Whether the text of a technique calls a function of the interface. The text always contains its declaration, so a call is the second
 * occurrence.
 */
function calls(text: string, name: string): boolean {
  return text.split(`a_${name}(`).length > 2;
}

/**
 * Functions of the interface over the prefiltered cube map: one level per roughness, the last for irradiance. The same as `getIBLIrradiance`
 * and `getIBLRadiance` of three.js r187, with directions in world space.
 */
const FUNCTIONS = /* glsl */ `
uniform samplerCube scrimEnvironment;
uniform mat3 scrimEnvironmentFromWorld;
uniform float scrimEnvironmentIntensity;
uniform float scrimEnvironmentLastLevel;

vec3 a_IRRADIANCE( const in vec3 normal ) {
  return PI * scrimEnvironmentIntensity * textureLod( scrimEnvironment, scrimEnvironmentFromWorld * normal, scrimEnvironmentLastLevel ).rgb;
}

vec3 a_REFLECTION( const in vec3 direction, const in float roughness ) {
  float r = clamp( roughness, 0.0, 1.0 );
  float level = scrimEnvironmentLastLevel * r * ( 2.0 - r );
  return scrimEnvironmentIntensity * textureLod( scrimEnvironment, scrimEnvironmentFromWorld * direction, level ).rgb;
}
`;

/** Varyings with the environment as one directional light. The vertex stage computes it, because it is equal for all fragments. */
const AS_LIGHT_VARYINGS = /* glsl */ `
flat varying vec3 vEnvironmentTowards;
flat varying vec3 vEnvironmentRadiance;
`;

/**
 * GLSL for the vertex stage: declarations, and statements of its `main`. Both are empty unless the fragment stage of the technique,
 * `fragment`, reads the environment as a light.
 */
export function environmentVertex(fragment: string): { readonly pars: string; readonly main: string } {
  if (!calls(fragment, 'ENVIRONMENT')) return { pars: '', main: '' };
  return {
    pars: `${AS_LIGHT_VARYINGS}${FUNCTIONS}
float scrimRise( const in vec3 axis ) {
  return dot( a_IRRADIANCE( axis ) - a_IRRADIANCE( - axis ), vec3( 0.2126, 0.7152, 0.0722 ) );
}
`,
    main: `vec3 rise = vec3( scrimRise( vec3( 1.0, 0.0, 0.0 ) ), scrimRise( vec3( 0.0, 1.0, 0.0 ) ), scrimRise( vec3( 0.0, 0.0, 1.0 ) ) );
  vEnvironmentTowards = dot( rise, rise ) > 0.0 ? normalize( rise ) : vec3( 0.0, 1.0, 0.0 );
  // A directional light gives its radiance to the side that faces it, and nothing to the other.
  vEnvironmentRadiance = max( a_IRRADIANCE( vEnvironmentTowards ) - a_IRRADIANCE( - vEnvironmentTowards ), 0.0 );`,
  };
}

/** GLSL for the fragment stage: declarations that follow the technique's text. `scrimNormal` is the surface's normal. */
export function environmentFragment(fragment: string): string {
  const asLight = calls(fragment, 'ENVIRONMENT');
  return `${asLight ? AS_LIGHT_VARYINGS : ''}${FUNCTIONS}
vec3 scrimNormal;
vec3 scrimAmbient() {
  return a_IRRADIANCE( scrimNormal ) * RECIPROCAL_PI;
}
${asLight ? 'a_Light a_ENVIRONMENT() { return a_Light( vEnvironmentTowards, vEnvironmentRadiance, 1.0 ); }' : ''}
`;
}
