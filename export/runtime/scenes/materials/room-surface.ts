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
import type { DrawView, NumberView, RoomDepthOutput } from '../../../../nodes/kit/runtime.ts';
import { ROOM_DEPTH_CHUNK } from './room-depth-chunk.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';
import type { CatcherSurface } from './shadow-catcher-shader.ts';

/** What the depth of the room says of the view's pixels. */
export interface RoomSurface {
  readonly uniforms: RoomUniforms;
  /** Discards what lies farther behind the room than a tolerance, and so would lie on something nearer. */
  readonly clip: ShaderPatch;
  /** Takes over the view's room depth; before every draw. False where there is none. */
  bind(view: DrawView): boolean;
}

export interface RoomUniforms {
  readonly [uniform: string]: { value: unknown };
}

// Read by the call that fills it, before anything else can.
const scratchInverse = new Matrix3();

export function createRoomSurface(roomDepth: RoomDepthOutput, toleranceM: NumberView): RoomSurface {
  const texture = new ExternalTexture();
  const uniforms = {
    roomDepth: { value: texture },
    roomUvFromViewUv: { value: new Matrix3() },
    // Half a texel more than one along each axis of the depth picture, in UV of the view.
    roomStepX: { value: new Vector2() },
    roomStepY: { value: new Vector2() },
    // What the projection scales x and y by, and how far it shifts them.
    roomLens: { value: new Vector4() },
    roomWorldFromView: { value: new Matrix4() },
    // x: 1 where there is room depth, 2 where it is blended; y: tolerance, metres.
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
      uniforms.roomStepX.value.set(m[0], m[1]).multiplyScalar(1.5 / depth.widthPx);
      uniforms.roomStepY.value.set(m[3], m[4]).multiplyScalar(1.5 / depth.heightPx);
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
  // What is unknown clips nothing, and so does what the depth camera does not see.
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return false;
  // As an occlusion reads it, so that shadows end where things are hidden.
  float roomM = scrim_roomM( roomDepth, roomClip.x > 1.5, at );
  return roomM > 0.0 && vRoomClip.w > roomM + roomClip.y;
}`,
  start: 'if ( behindRoom() ) discard;',
  end: '',
};

/**
 * The surface that room depth shows, found pixel by pixel. Sensors give few pixels: between those that are close to each other in
 * depth, it is interpolated, and across an edge not. The normal is that of the neighbours on the side that is closer in depth.
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

// Part of the depth by which neighbours may differ and still be one surface.
#define SAME_SURFACE 0.06

float roomTexel( const in ivec2 at, const in ivec2 last ) {
  return texelFetch( roomDepth, clamp( at, ivec2( 0 ), last ), 0 ).r;
}

// Metres along the view's axis, 0 where unknown.
float roomMetres( const in vec2 viewUv ) {
  vec3 uv = roomUvFromViewUv * vec3( viewUv, 1.0 );
  vec2 at = uv.xy / uv.z;
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return 0.0;
  ivec2 size = textureSize( roomDepth, 0 );
  vec2 texel = at * vec2( size ) - 0.5;
  ivec2 first = ivec2( floor( texel ) );
  vec2 part = texel - vec2( first );
  vec4 m = vec4(
    roomTexel( first, size - 1 ),
    roomTexel( first + ivec2( 1, 0 ), size - 1 ),
    roomTexel( first + ivec2( 0, 1 ), size - 1 ),
    roomTexel( first + ivec2( 1, 1 ), size - 1 )
  );
  float least = min( min( m.x, m.y ), min( m.z, m.w ) );
  float most = max( max( m.x, m.y ), max( m.z, m.w ) );
  if ( least > 0.0 && most - least < SAME_SURFACE * most ) return mix( mix( m.x, m.y, part.x ), mix( m.z, m.w, part.x ), part.y );
  vec2 nearest = step( 0.5, part );
  return nearest.y < 0.5 ? ( nearest.x < 0.5 ? m.x : m.y ) : ( nearest.x < 0.5 ? m.z : m.w );
}

vec3 roomPoint( const in vec2 viewUv, const in float metres ) {
  vec3 ray = vec3( ( viewUv * 2.0 - 1.0 + roomLens.zw ) / roomLens.xy, -1.0 );
  return ( roomWorldFromView * vec4( ray * metres, 1.0 ) ).xyz;
}

// Along the surface, by one step of the depth picture to the side that is closer in depth.
vec3 roomTangent( const in vec2 viewUv, const in float metres, const in vec2 by ) {
  float before = roomMetres( viewUv - by );
  float after = roomMetres( viewUv + by );
  bool back = before > 0.0 && ( after <= 0.0 || abs( before - metres ) < abs( after - metres ) );
  return back
    ? roomPoint( viewUv, metres ) - roomPoint( viewUv - by, before )
    : roomPoint( viewUv + by, after > 0.0 ? after : metres ) - roomPoint( viewUv, metres );
}
`,
  find: /* glsl */ `float metres = roomMetres( vViewUv );
  if ( metres <= 0.0 ) discard;
  positionWorld = roomPoint( vViewUv, metres );
  vec3 normal = normalize( cross( roomTangent( vViewUv, metres, roomStepX ), roomTangent( vViewUv, metres, roomStepY ) ) );
  // Whichever way the picture lies, what is seen faces the eye.
  normal *= sign( dot( normal, roomWorldFromView[ 3 ].xyz - positionWorld ) );`,
};

/** As far away as can be: it shows where nothing else of the layer does. */
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
