import { ExternalTexture, Matrix3, Vector2, Vector4 } from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import { ROOM_DEPTH_TEXT } from '../../../program/room-depth.ts';
import type { OcclusionBinding } from '../../scene-backend.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';

/** Declares `scrim_roomM` in materials once, because several patches may need it. */
export const ROOM_DEPTH_CHUNK = /* glsl */ `
#ifndef SCRIM_ROOM_DEPTH
#define SCRIM_ROOM_DEPTH
${ROOM_DEPTH_TEXT}
#endif
`;

/**
 * Hides fragments behind the room while a scene is drawn: the early form of `layer/depth-occlusion`, with the formula of its
 * `occlusion.fs`.
 *
 * Both forms give the same image, except that the layer form hides a pixel by the depth of its nearest surface, transparent or not, while
 * here each fragment is tested by its own depth. The compiler uses the layer form only for layers that were changed after drawing (ADR 26).
 * At a soft border the layer form fades the finished pixel. To match it, soft scenes draw the depth of opaque surfaces first
 * (`shaded-scene.ts`), so that a fading surface does not show those behind it.
 */
export interface OcclusionPatch extends ShaderPatch {
  /** Whether the border is soft, so that surfaces fade. */
  readonly isSoft: () => boolean;
  /** Applies the view's room depth and the params; called before every draw. */
  bind(view: DrawView): void;
}

/**
 * Passes the clip position to the fragment shader. It gives the view UV in any viewport, and its w is the view-space depth, because
 * sessions use perspective.
 */
const VERTEX = {
  before: 'varying vec4 scrimPositionClip;',
  start: '',
  end: 'scrimPositionClip = gl_Position;',
};

const FRAGMENT = {
  before: /* glsl */ `
uniform sampler2D scrimRoomDepth;
uniform mat3 scrimRoomUvFromViewUv;
// x: 1 with room depth, 2 with interpolation; y: soft border, meters; z: tolerance behind the room, meters; w: radius of the border,
// pixels.
uniform vec4 scrimOcclusion;
uniform vec2 scrimViewPx;
varying vec4 scrimPositionClip;
${ROOM_DEPTH_CHUNK}
float scrimVisibilityAt( vec2 viewUv ) {
  vec3 uv = scrimRoomUvFromViewUv * vec3( clamp( viewUv, 0.0, 1.0 ), 1.0 );
  vec2 at = uv.xy / uv.z;
  // Unknown depth hides nothing, nor does the area outside of the depth image.
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return 1.0;
  float roomM = scrim_roomM( scrimRoomDepth, scrimOcclusion.x > 1.5, at );
  if ( roomM <= 0.0 ) return 1.0;
  float behindM = scrimPositionClip.w - roomM - scrimOcclusion.z;
  if ( scrimOcclusion.y <= 0.0 ) return behindM > 0.0 ? 0.0 : 1.0;
  return 1.0 - clamp( behindM / scrimOcclusion.y, 0.0, 1.0 );
}

float scrimVisibility() {
  if ( scrimOcclusion.x == 0.0 ) return 1.0;
  vec2 here = scrimPositionClip.xy / scrimPositionClip.w * 0.5 + 0.5;
  // The exact center of the pixel, as a pass over the finished layer has it.
  here = ( floor( here * scrimViewPx ) + 0.5 ) / scrimViewPx;
  if ( scrimOcclusion.w <= 0.0 ) return scrimVisibilityAt( here );
  float seen = 0.0;
  for ( int i = 0; i < 16; i ++ ) {
    float angle = 2.399963 * float( i );
    float away = scrimOcclusion.w * sqrt( ( float( i ) + 0.5 ) / 16.0 );
    seen += scrimVisibilityAt( here + away * vec2( cos( angle ), sin( angle ) ) / scrimViewPx );
  }
  return seen / 16.0;
}`,
  start: /* glsl */ `
  float scrimVisible = scrimVisibility();
  if ( scrimVisible <= 0.0 ) discard;`,
  end: /* glsl */ `
  #ifdef PREMULTIPLIED_OUTPUT
    gl_FragColor *= scrimVisible;
  #else
    gl_FragColor.a *= scrimVisible;
  #endif`,
};

/** Creates the occlusion patch of a scene. All materials of the scene share its uniforms, so that setting a view is a few assignments. */
export function createOcclusionPatch({ roomDepth, params }: OcclusionBinding): OcclusionPatch {
  const texture = new ExternalTexture();
  const uniforms = {
    scrimRoomDepth: { value: texture },
    scrimRoomUvFromViewUv: { value: new Matrix3() },
    scrimOcclusion: { value: new Vector4() },
    scrimViewPx: { value: new Vector2() },
  };
  const softness = params.softnessM;
  const bias = params.biasM;
  const border = params.borderPx;
  return {
    key: 'occlusion',
    isSoft: () => (softness?.value ?? 0) > 0 || (border?.value ?? 0) > 0,
    apply: (shader) => {
      Object.assign(shader.uniforms, uniforms);
      shader.vertexShader = wrapMain(shader.vertexShader, VERTEX);
      shader.fragmentShader = wrapMain(shader.fragmentShader, FRAGMENT);
    },
    bind: ({ viewIndex, viewport }) => {
      const depth = roomDepth.views[viewIndex] ?? null;
      texture.sourceTexture = depth?.texture ?? null;
      const reading = depth ? (depth.interpolate ? 2 : 1) : 0;
      uniforms.scrimOcclusion.value.set(reading, softness?.value ?? 0, bias?.value ?? 0, (border?.value ?? 0) / 2);
      uniforms.scrimViewPx.value.set(viewport.widthPx, viewport.heightPx);
      if (depth) uniforms.scrimRoomUvFromViewUv.value.fromArray(depth.uvFromViewUv);
    },
  };
}
