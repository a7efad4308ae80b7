import { BackSide, BoxGeometry, type Euler, Matrix3, Matrix4, Mesh, NoBlending, type Scene, ShaderMaterial } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import { PANORAMA_UV } from './panorama-uv.ts';

/** Draws the panorama behind all objects, infinitely far away and without depth. */
export interface Backdrop {
  show(environment: EnvironmentAsset, intensity: number, rotation: Euler): void;
  hide(): void;
  dispose(): void;
}

/** Render order of the backdrop: before phantoms, which come before all other objects (`shaded-scene.ts`). */
const BEHIND_ALL = -3e9;

// Valid within one call.
const scratchRotation = new Matrix4();

/** Creates the backdrop. three.js' own converts the panorama to a cube map, which takes six times the memory and looks softer. */
export function createBackdrop(scene: Scene): Backdrop {
  const uniforms = {
    panorama: { value: null as EnvironmentAsset['texture'] | null },
    intensity: { value: 1 },
    panoramaFromWorld: { value: new Matrix3() },
  };
  const material = new ShaderMaterial({
    name: 'backdrop',
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: BackSide,
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });
  material.uniforms = uniforms;
  const box = new Mesh(new BoxGeometry(2, 2, 2), material);
  box.renderOrder = BEHIND_ALL;
  box.frustumCulled = false;
  box.matrixAutoUpdate = false;
  box.matrixWorldAutoUpdate = false;
  return {
    show: (environment, intensity, rotation) => {
      if (box.parent === null) scene.add(box);
      uniforms.panorama.value = environment.texture;
      uniforms.intensity.value = intensity;
      uniforms.panoramaFromWorld.value.setFromMatrix4(scratchRotation.makeRotationFromEuler(rotation)).transpose();
    },
    hide: () => {
      if (box.parent !== null) scene.remove(box);
    },
    dispose: () => {
      scene.remove(box);
      box.geometry.dispose();
      material.dispose();
    },
  };
}

/** Vertex shader that places the geometry around the camera, independent of its position and of the near and far planes. */
const VERTEX = /* glsl */ `
uniform mat3 panoramaFromWorld;
varying vec3 vDirection;

void main() {
  vDirection = panoramaFromWorld * position;
  gl_Position = projectionMatrix * mat4( mat3( viewMatrix ) ) * vec4( position, 1.0 );
  gl_Position.z = 0.0;
}
`;

const FRAGMENT = /* glsl */ `
uniform sampler2D panorama;
uniform float intensity;
varying vec3 vDirection;
${PANORAMA_UV}
void main() {
  vec3 direction = normalize( vDirection );
  // Of two computed derivatives, the one without the jump at the seam is smaller.
  vec2 uv = panoramaUv( direction );
  vec2 other = vec2( fract( uv.x + 0.5 ), uv.y );
  bool far = fwidth( uv.x ) > fwidth( other.x );
  vec2 dx = far ? dFdx( other ) : dFdx( uv );
  vec2 dy = far ? dFdy( other ) : dFdy( uv );
  gl_FragColor = vec4( clamp( textureGrad( panorama, uv, dx, dy ).rgb * intensity, 0.0, 65504.0 ), 1.0 );
  #include <colorspace_fragment>
}
`;
