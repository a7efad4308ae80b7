import {
  CustomBlending,
  ExternalTexture,
  LessDepth,
  Matrix3,
  Matrix4,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  Vector2,
  Vector4,
} from 'three';
import { ROOM_DEPTH_CHUNK } from '../../../../nodes/kit/early-occlusion.ts';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { RoomDepthOutput } from '../../../../nodes/kit/scene-lists.ts';
import type { NumberView } from '../../../../nodes/kit/value-views.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';
import type { CatcherSurface } from './shadow-catcher-shader.ts';

/** The surface of the real room, found from room depth, for shadows that fall on it. */
export interface RoomSurface {
  readonly uniforms: RoomUniforms;
  /** Discards fragments that are farther behind the room than the tolerance; they would appear on a nearer real surface. */
  readonly clip: ShaderPatch;
  /** Applies the view's room depth; called before every draw. Returns false without room depth. */
  bind(view: DrawView): boolean;
}

export interface RoomUniforms {
  readonly [uniform: string]: { value: unknown };
}

// Valid within one call.
const scratchInverse = new Matrix3();

export function createRoomSurface(roomDepth: RoomDepthOutput, toleranceM: NumberView): RoomSurface {
  const texture = new ExternalTexture();
  const uniforms = {
    roomDepth: { value: texture },
    roomUvFromViewUv: { value: new Matrix3() },
    // One texel along each axis of the depth image, in view UV.
    roomStepX: { value: new Vector2() },
    roomStepY: { value: new Vector2() },
    // Scale and shift of x and y in the projection.
    roomLens: { value: new Vector4() },
    roomWorldFromView: { value: new Matrix4() },
    // x: 1 with room depth, 2 with interpolation; y: tolerance, meters.
    roomClip: { value: new Vector2() },
  };
  return {
    uniforms,
    clip: {
      key: 'room clip',
      apply: (shader) => {
        Object.assign(shader.uniforms, {
          roomDepth: uniforms.roomDepth,
          roomUvFromViewUv: uniforms.roomUvFromViewUv,
          roomClip: uniforms.roomClip,
        });
        shader.vertexShader = wrapMain(shader.vertexShader, CLIP_VERTEX);
        shader.fragmentShader = wrapMain(shader.fragmentShader, CLIP_FRAGMENT);
      },
    },
    bind: ({ view, viewIndex }) => {
      const depth = roomDepth.views[viewIndex] ?? null;
      texture.sourceTexture = depth?.texture ?? null;
      uniforms.roomClip.value.set(depth ? (depth.interpolate ? 2 : 1) : 0, toleranceM.value);
      if (!depth) return false;
      uniforms.roomUvFromViewUv.value.fromArray(depth.uvFromViewUv);
      scratchInverse.copy(uniforms.roomUvFromViewUv.value).invert();
      const { elements: m } = scratchInverse;
      uniforms.roomStepX.value.set(m[0], m[1]).multiplyScalar(1 / depth.widthPx);
      uniforms.roomStepY.value.set(m[3], m[4]).multiplyScalar(1 / depth.heightPx);
      const { clipFromView: p } = view;
      uniforms.roomLens.value.set(p[0] ?? 1, p[5] ?? 1, p[8] ?? 0, p[9] ?? 0);
      uniforms.roomWorldFromView.value.fromArray(view.worldFromView);
      return true;
    },
  };
}

const CLIP_VERTEX = { before: 'varying vec4 vRoomClip;', start: '', end: 'vRoomClip = gl_Position;' };

const CLIP_FRAGMENT = {
  before: /* glsl */ `
uniform sampler2D roomDepth;
uniform mat3 roomUvFromViewUv;
uniform vec2 roomClip;
varying vec4 vRoomClip;
${ROOM_DEPTH_CHUNK}
bool behindRoom() {
  if ( roomClip.x == 0.0 ) return false;
  vec3 uv = roomUvFromViewUv * vec3( vRoomClip.xy / vRoomClip.w * 0.5 + 0.5, 1.0 );
  vec2 at = uv.xy / uv.z;
  // Unknown depth clips nothing, nor does the area outside of the depth image.
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return false;
  // Read as an occlusion reads it, so that shadows end where objects are hidden.
  float roomM = scrim_roomM( roomDepth, roomClip.x > 1.5, at );
  return roomM > 0.0 && vRoomClip.w > roomM + roomClip.y;
}`,
  start: '',
  // Last, because derivatives of what a shader computes are undefined beside a fragment that was discarded (GLSL ES 3.00, section 8.9).
  end: 'if ( behindRoom() ) discard;',
};

/**
 * Finds the surface of room depth per pixel: the plane through nearby samples of similar depth, by least squares. Depth of sensors is
 * coarse and noisy, so normals from differences have random directions, and shadows would have cracks and grain. The inverse depth of a
 * plane is linear in the image, so inverse depth is fitted; samples beyond a depth step are excluded. If no samples remain, the surface
 * faces the eye.
 */
export const ROOM_SURFACE: CatcherSurface = {
  declarations: /* glsl */ `
uniform sampler2D roomDepth;
uniform mat3 roomUvFromViewUv;
uniform vec2 roomStepX;
uniform vec2 roomStepY;
uniform vec4 roomLens;
uniform mat4 roomWorldFromView;
varying vec2 vViewUv;

// Maximum relative difference in depth between samples of one surface.
#define SAME_SURFACE 0.03
// Samples to each side, and their minimum number along the shorter side of the view: a footprint of a thirtieth.
#define REACH 2
#define ROWS 120
// Biases the plane towards one that faces the eye, for places where the samples are ambiguous: square steps.
#define UPRIGHT 0.02

float roomTexel( const in ivec2 at, const in ivec2 last ) {
  return texelFetch( roomDepth, clamp( at, ivec2( 0 ), last ), 0 ).r;
}

// The plane, in meters along the view's axis: here, and one sample farther along each axis of the depth image; 0 where unknown.
vec3 roomPlane( const in vec2 viewUv ) {
  vec3 uv = roomUvFromViewUv * vec3( viewUv, 1.0 );
  vec2 at = uv.xy / uv.z;
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return vec3( 0.0 );
  ivec2 size = textureSize( roomDepth, 0 );
  int stride = max( 1, min( size.x, size.y ) / ROWS );
  vec2 texel = at * vec2( size );
  ivec2 middle = ivec2( floor( texel ) );
  float middleM = roomTexel( middle, size - 1 );
  if ( middleM <= 0.0 ) return vec3( 0.0 );
  float weights = 0.0;
  // Sums of offsets (steps from here), of inverse depths (relative to the center's, minus 1), and of their products.
  vec3 sums = vec3( 0.0 );
  vec3 squares = vec3( 0.0 );
  vec2 products = vec2( 0.0 );
  for ( int y = -REACH; y <= REACH; y ++ ) {
    for ( int x = -REACH; x <= REACH; x ++ ) {
      ivec2 sampled = clamp( middle + stride * ivec2( x, y ), ivec2( 0 ), size - 1 );
      float meters = texelFetch( roomDepth, sampled, 0 ).r;
      vec2 place = ( vec2( sampled ) + 0.5 - texel ) / float( stride );
      float apart = ( meters - middleM ) / ( SAME_SURFACE * middleM );
      float weight = max( 0.0, 1.0 - dot( place, place ) / ( ( float( REACH ) + 0.5 ) * ( float( REACH ) + 0.5 ) ) ) * max( 0.0, 1.0 - apart * apart );
      if ( meters <= 0.0 || weight <= 0.0 ) continue;
      vec3 found = vec3( place, middleM / meters - 1.0 );
      weights += weight;
      sums += weight * found;
      squares += weight * vec3( place * place, place.x * place.y );
      products += weight * place * found.z;
    }
  }
  // The center sample always counts.
  vec3 mean = sums / weights;
  vec3 spread = squares / weights - vec3( mean.xy * mean.xy, mean.x * mean.y ) + vec3( UPRIGHT, UPRIGHT, 0.0 );
  vec2 along = products / weights - mean.xy * mean.z;
  vec2 slope = ( spread.yx * along - spread.z * along.yx ) / ( spread.x * spread.y - spread.z * spread.z );
  float here = mean.z - dot( slope, mean.xy );
  return middleM / ( 1.0 + here + vec3( 0.0, slope / float( stride ) ) );
}

vec3 roomPoint( const in vec2 viewUv, const in float meters ) {
  vec3 ray = vec3( ( viewUv * 2.0 - 1.0 + roomLens.zw ) / roomLens.xy, -1.0 );
  return ( roomWorldFromView * vec4( ray * meters, 1.0 ) ).xyz;
}
`,
  find: /* glsl */ `vec3 plane = roomPlane( vViewUv );
  positionWorld = roomPoint( vViewUv, plane.x );
  vec3 tangentX = roomPoint( vViewUv + roomStepX, plane.y ) - positionWorld;
  vec3 tangentY = roomPoint( vViewUv + roomStepY, plane.z ) - positionWorld;
  vec3 normal = normalize( cross( tangentX, tangentY ) );
  // A visible surface faces the eye, whatever the orientation of the image.
  normal *= sign( dot( normal, roomWorldFromView[ 3 ].xyz - positionWorld ) );`,
  drop: 'if ( plane.x <= 0.0 ) discard;',
};

/** Vertex shader of a quad over the view, near the far plane, so that it appears only where the layer has nothing else. */
const VERTEX = /* glsl */ `
varying vec2 vViewUv;

void main() {
  vViewUv = uv;
  gl_Position = vec4( position.xy, 0.9999, 1.0 );
}
`;

export function createRoomMaterial(fragmentShader: string, uniforms: ShaderMaterial['uniforms']): ShaderMaterial {
  const material = new ShaderMaterial({ name: 'shadow on the room', vertexShader: VERTEX, fragmentShader });
  material.uniforms = uniforms;
  material.transparent = true;
  material.depthWrite = false;
  material.depthFunc = LessDepth;
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  return material;
}
