import {
  BufferGeometry,
  ExternalTexture,
  Float32BufferAttribute,
  Matrix3,
  Mesh,
  NoBlending,
  type Scene,
  ShaderMaterial,
  Vector4,
} from 'three';
import type { UnderLayer } from '../../../../nodes/kit/runtime.ts';

/** Draws the layer under a scene into the image of what is behind glass, before all objects. */
export interface UnderImage {
  show(under: UnderLayer | null | undefined): void;
  dispose(): void;
}

/** Render order of the image: before the panorama of the scene (`environments/backdrop.ts`). */
const BEHIND_ALL = -4e9;

/**
 * Adds the image of the layer under a scene to the scene.
 *
 * @param layer Number of the three.js layer that contains only this image.
 */
export function createUnderImage(scene: Scene, layer: number): UnderImage {
  const picture = new ExternalTexture();
  const uniforms = {
    picture: { value: picture },
    uvFromViewUv: { value: new Matrix3() },
    isScene: { value: false },
    plain: { value: new Vector4() },
  };
  const material = new ShaderMaterial({
    name: 'under',
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });
  material.uniforms = uniforms;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = BEHIND_ALL;
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.matrixWorldAutoUpdate = false;
  mesh.layers.set(layer);
  scene.add(mesh);
  return {
    show: (under) => {
      const texture = under?.texture ?? null;
      const color = under?.color ?? null;
      mesh.visible = texture !== null || color !== null;
      if (!under) return;
      picture.sourceTexture = texture;
      uniforms.uvFromViewUv.value.fromArray(under.uvFromViewUv);
      uniforms.isScene.value = under.encoding === 'scene';
      uniforms.plain.value.set(0, 0, 0, 0);
      if (texture === null && color) uniforms.plain.value.fromArray(color);
    },
    dispose: () => {
      scene.remove(mesh);
      geometry.dispose();
      material.dispose();
    },
  };
}

const VERTEX = /* glsl */ `
varying vec2 vUv;
void main() {
  vUv = position.xy * 0.5 + 0.5;
  gl_Position = vec4( position.xy, 0.0, 1.0 );
}
`;

/**
 * Fragment shader that draws the layer under a scene in linear light. Display layers are decoded by the transfer function of IEC 61966-2-1.
 * NaN is found by its bits, because drivers optimize `isnan` away.
 */
const FRAGMENT = /* glsl */ `
uniform sampler2D picture;
uniform mat3 uvFromViewUv;
uniform bool isScene;
// Display-referred, premultiplied; without a picture.
uniform vec4 plain;
varying vec2 vUv;

float finite( const in float x ) {
  return ( floatBitsToUint( x ) & 0x7FFFFFFFu ) > 0x7F800000u ? 0.0 : clamp( x, 0.0, 65504.0 );
}

void main() {
  vec3 uv = uvFromViewUv * vec3( vUv, 1.0 );
  vec4 c = plain + textureLod( picture, uv.xy / uv.z, 0.0 ) * ( plain.a > 0.0 ? 0.0 : 1.0 );
  if ( isScene ) {
    gl_FragColor = vec4( finite( c.r ), finite( c.g ), finite( c.b ), clamp( finite( c.a ), 0.0, 1.0 ) );
    return;
  }
  vec3 straight = clamp( c.rgb / max( c.a, 1e-4 ), 0.0, 1.0 );
  vec3 curve = pow( ( straight + 0.055 ) / 1.055, vec3( 2.4 ) );
  gl_FragColor = vec4( mix( curve, straight / 12.92, vec3( lessThanEqual( straight, vec3( 0.04045 ) ) ) ) * c.a, c.a );
}
`;
