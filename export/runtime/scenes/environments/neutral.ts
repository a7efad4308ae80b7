import type { Texture } from 'three';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createCubeMaterial, createPmremTarget, type PmremTarget } from './pmrem-target.ts';
import { withRoughness } from './prefilter.ts';

/** The neutral environment that lights a scene besides its lights. It is created on first use and shared by all scenes. */
export interface NeutralEnvironment {
  texture(): Texture;
  dispose(): void;
}

/** Size of the sharpest level. Its pixels cover 1.4°, which suffices because the lights of the studio are soft. */
const FACE_PX = 64;
/** Size of the roughest level, which holds irradiance; three.js uses the same. */
const ROUGHEST_FACE_PX = 8;

/**
 * A colorless studio with light from above and four soft boxes, so that objects without lights are not black and metals have something to
 * reflect. Its mean radiance is 1: on average over all directions it renders a white matte surface white.
 *
 * It consists of spherical Gaussians, whose convolution with a rough surface has a closed form, so each level of three.js' prefiltered cube
 * map is drawn directly. Filtering a rendered room (`RoomEnvironment` through `PMREMGenerator`) took 2.5 s on SwiftShader; this takes 25
 * ms.
 */
export function createNeutralEnvironment(renderer: SceneRenderer): NeutralEnvironment {
  let target: PmremTarget | null = null;
  return {
    texture: () => {
      target ??= render(renderer);
      return target.texture;
    },
    dispose: () => target?.dispose(),
  };
}

function render(renderer: SceneRenderer): PmremTarget {
  const target = createPmremTarget(FACE_PX, ROUGHEST_FACE_PX);
  const material = createCubeMaterial('neutral environment', FRAGMENT, { roughness: { value: 0 } });
  renderer.work((three) => target.draw(three, (roughness) => withRoughness(material, roughness)));
  material.dispose();
  return target;
}

const FRAGMENT = /* glsl */ `
uniform float roughness;
varying vec3 vDirection;

// Mean radiances of the ambient term, its gradient and the lobes below; they add up to 1.
#define AROUND 0.62
#define FROM_ABOVE 0.3

// A surface gathers light in a lobe: the clamped cosine about its normal, fitted by a Gaussian of sharpness 2.133, times GGX seen head on,
// of sharpness 1 / (2 alpha^2) about the mirrored direction (Wang et al. 2009, section 4), treated as constant at alpha = 1.
float gatheringSharpness() {
  float alpha = max( roughness * roughness, 0.01 );
  return 2.133 + 0.5 / ( alpha * alpha ) - 0.5;
}

// Integral of exp( sharpness * ( cos - 1 ) ) over the sphere, divided by 4 pi.
float meanOf( float sharpness ) {
  return ( 1.0 - exp( -2.0 * sharpness ) ) / ( 2.0 * sharpness );
}

// Factor of a linear gradient after the convolution with a lobe. (tanh overflows for sharp lobes.)
float meanCosine( float sharpness ) {
  float tail = exp( -2.0 * sharpness );
  return ( 1.0 + tail ) / ( 1.0 - tail ) - 1.0 / sharpness;
}

// A soft box of the given mean radiance after the convolution: sharpnesses combine like resistors in parallel, and the mean is constant.
float softBox( vec3 at, vec3 center, float sharpness, float mean, float gathering ) {
  float blurred = sharpness * gathering / ( sharpness + gathering );
  return mean / meanOf( blurred ) * exp( blurred * ( dot( at, normalize( center ) ) - 1.0 ) );
}

void main() {
  vec3 at = normalize( vDirection );
  float gathering = roughness < 0.001 ? 1e4 : gatheringSharpness();
  float radiance = AROUND + FROM_ABOVE * at.y * meanCosine( gathering );
  radiance += softBox( at, vec3( 0.4, 1.0, 0.3 ), 14.0, 0.16, gathering );
  radiance += softBox( at, vec3( -1.0, 0.35, 0.5 ), 40.0, 0.08, gathering );
  radiance += softBox( at, vec3( 1.0, 0.2, 0.2 ), 60.0, 0.06, gathering );
  radiance += softBox( at, vec3( 0.1, 0.4, -1.0 ), 40.0, 0.08, gathering );
  gl_FragColor = vec4( vec3( radiance ), 1.0 );
}
`;
