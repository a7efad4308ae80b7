import { ROOM_DEPTH_TEXT } from './room-depth-glsl.ts';
import type { RoomDepthOutput } from './scene-lists.ts';
import type { NumberView } from './value-views.ts';

/** Room depth and the current params of a `layer/depth-occlusion` that is applied while its layer is drawn (ADR 26). */
export interface OcclusionView {
  readonly roomDepth: RoomDepthOutput;
  readonly params: Readonly<Record<string, NumberView>>;
}

/** `scrim_roomM`, declared once, because several parts of a shader may need it. */
export const ROOM_DEPTH_CHUNK = /* glsl */ `
#ifndef SCRIM_ROOM_DEPTH
#define SCRIM_ROOM_DEPTH
${ROOM_DEPTH_TEXT}
#endif
`;

/**
 * GLSL of an occlusion that is applied while drawing, with the formula of `layer/depth-occlusion` (ADR 26).
 *
 * `scrimVisibility(viewUv, depthM)` is the visible part of a fragment. `viewUv` is its place in the view; `depthM` its distance along the
 * view axis, meters. The node that draws writes the uniforms.
 */
export const OCCLUSION_GLSL = /* glsl */ `
uniform sampler2D scrimRoomDepth;
uniform mat3 scrimRoomUvFromViewUv;
// x: 1 with room depth, 2 with interpolation; y: soft border, meters; z: tolerance behind the room, meters; w: radius of the border,
// pixels.
uniform vec4 scrimOcclusion;
uniform vec2 scrimViewPx;
${ROOM_DEPTH_CHUNK}
float scrimVisibilityAt( vec2 viewUv, float depthM ) {
  vec3 uv = scrimRoomUvFromViewUv * vec3( clamp( viewUv, 0.0, 1.0 ), 1.0 );
  vec2 at = uv.xy / uv.z;
  // Unknown depth hides nothing, nor does the area outside of the depth image.
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return 1.0;
  float roomM = scrim_roomM( scrimRoomDepth, scrimOcclusion.x > 1.5, at );
  if ( roomM <= 0.0 ) return 1.0;
  float behindM = depthM - roomM - scrimOcclusion.z;
  if ( scrimOcclusion.y <= 0.0 ) return behindM > 0.0 ? 0.0 : 1.0;
  return 1.0 - clamp( behindM / scrimOcclusion.y, 0.0, 1.0 );
}

float scrimVisibility( vec2 viewUv, float depthM ) {
  if ( scrimOcclusion.x == 0.0 ) return 1.0;
  // The exact center of the pixel, as a pass over the finished layer has it.
  vec2 here = ( floor( viewUv * scrimViewPx ) + 0.5 ) / scrimViewPx;
  if ( scrimOcclusion.w <= 0.0 ) return scrimVisibilityAt( here, depthM );
  float seen = 0.0;
  for ( int i = 0; i < 16; i ++ ) {
    float angle = 2.399963 * float( i );
    float away = scrimOcclusion.w * sqrt( ( float( i ) + 0.5 ) / 16.0 );
    seen += scrimVisibilityAt( here + away * vec2( cos( angle ), sin( angle ) ) / scrimViewPx, depthM );
  }
  return seen / 16.0;
}`;
