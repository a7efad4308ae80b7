import {
  Camera,
  FloatType,
  LinearFilter,
  Mesh,
  NoBlending,
  PlaneGeometry,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  type Texture,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import type { SceneRenderer } from '../scene-renderer.ts';

/**
 * Blurred moments of a shadow map (Donnelly and Lauritzen 2006), of casters only: red is the fraction of the blur window with casters,
 * green their depth in meters along the light's axis, blue the squared depth, both times red. Perspective depth is not suitable: with a
 * caster near the light, all others are within its last thousandth, whose squares 32 bits do not resolve. Empty texels are excluded,
 * because the background would move the mean behind the receivers.
 */
export interface Moments {
  readonly texture: Texture;
  /**
   * Computes the moments. Called after the shadow map was drawn, with its near and far distance in meters; near is 0 for directional
   * lights.
   */
  update(renderer: SceneRenderer, nearM: number, farM: number): void;
  dispose(): void;
}

/**
 * Creates the blurred moments of a shadow map, which variance shadows read.
 *
 * @param depths Shadow map with 1 minus the depth in the red channel.
 * @param sizePx Width and height of both maps.
 */
export function createMoments(depths: Texture, sizePx: number): Moments {
  const across = createTarget(sizePx);
  const both = createTarget(sizePx);
  const reach = new Vector2();
  const first = createBlur(FIRST, { source: { value: depths }, along: { value: new Vector2(1 / sizePx, 0) }, reach: { value: reach } });
  const second = createBlur(SECOND, { source: { value: across.texture }, along: { value: new Vector2(0, 1 / sizePx) } });
  return {
    texture: both.texture,
    update: (renderer, nearM, farM) => {
      reach.set(nearM, farM);
      renderer.drawOver(across, first.scene, CAMERA);
      renderer.drawOver(both, second.scene, CAMERA);
    },
    dispose: () => {
      for (const part of [across, both, first, second]) part.dispose();
    },
  };
}

const CAMERA = createStill();

function createStill(): Camera {
  const camera = new Camera();
  camera.matrixWorldAutoUpdate = false;
  return camera;
}

function createTarget(sizePx: number): WebGLRenderTarget {
  return new WebGLRenderTarget(sizePx, sizePx, {
    format: RGBAFormat,
    type: FloatType,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
}

function createBlur(read: string, uniforms: ShaderMaterial['uniforms']): { readonly scene: Scene; dispose(): void } {
  const material = new ShaderMaterial({
    name: 'shadow moments',
    vertexShader: VERTEX,
    fragmentShader: fragment(read),
    uniforms,
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });
  const mesh = new Mesh(new PlaneGeometry(2, 2), material);
  mesh.frustumCulled = false;
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  scene.add(mesh);
  return {
    scene,
    dispose: () => {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}

const VERTEX = /* glsl */ `
varying vec2 vUv;

void main() {
  vUv = uv;
  gl_Position = vec4( position.xy, 0.0, 1.0 );
}
`;

/** GLSL that computes the moments of one texel of the shadow map. A stored 0 means that no caster was drawn (depth 1). */
const FIRST = /* glsl */ `
  float stored = texture2D( source, at ).r;
  float meters = reach.x > 0.0 ? reach.x * reach.y / ( reach.x + stored * ( reach.y - reach.x ) ) : ( 1.0 - stored ) * reach.y;
  return stored > 0.0 ? vec3( 1.0, meters, meters * meters ) : vec3( 0.0 );
`;
const SECOND = 'return texture2D( source, at ).rgb;';

/**
 * Creates a fragment shader that blurs what `read` returns along one axis: a Gaussian over nine texels with a standard deviation of two,
 * about as wide as three texels of the `soft` filter.
 */
function fragment(read: string): string {
  const weights = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((i) => Math.exp(-(i * i) / 8));
  const sum = weights.reduce((total, weight) => total + weight, 0);
  const taps = weights.map((weight, i) => `  sum += ${(weight / sum).toFixed(6)} * momentsAt( vUv + along * ${(i - 4).toFixed(1)} );`);
  return /* glsl */ `
uniform sampler2D source;
uniform vec2 along;
uniform vec2 reach;
varying vec2 vUv;

vec3 momentsAt( const in vec2 at ) { ${read} }

void main() {
  vec3 sum = vec3( 0.0 );
${taps.join('\n')}
  gl_FragColor = vec4( sum, 1.0 );
}
`;
}
