import { ExternalTexture, Matrix3, Vector3 } from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { OcclusionBinding } from '../../scene-backend.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';

/**
 * Hides fragments behind the room while a scene is drawn: the early form of `layer/depth-occlusion`, with the formula of its
 * `occlusion.fs`.
 *
 * The two forms give the same picture, but for what the layer form cannot know: it hides a pixel by the depth of the nearest
 * surface that wrote any, and blended surfaces write none; here each fragment is hidden by its own depth. At a soft border the
 * layer form fades the finished pixel. So that a surface which fades here lets through nothing of those behind it, soft scenes
 * draw the depth of opaque surfaces first (`shaded-scene.ts`).
 */
export interface OcclusionPatch extends ShaderPatch {
  /** Whether the border is soft, so that surfaces fade. */
  readonly isSoft: () => boolean;
  /** Takes over the view's room depth and the params; before every draw. */
  bind(view: DrawView): void;
}

/** The clip position tells the view UV whatever the viewport, and its w is the depth in view space: sessions are in perspective. */
const VERTEX = {
  before: 'varying vec4 scrimPositionClip;',
  start: '',
  end: 'scrimPositionClip = gl_Position;',
};

const FRAGMENT = {
  before: /* glsl */ `
uniform sampler2D scrimRoomDepth;
uniform mat3 scrimRoomUvFromViewUv;
// x: 1 where there is room depth; y: soft border, metres; z: how far behind the room something may be and still show, metres.
uniform vec3 scrimOcclusion;
varying vec4 scrimPositionClip;

float scrimVisibility() {
  if ( scrimOcclusion.x == 0.0 ) return 1.0;
  vec3 uv = scrimRoomUvFromViewUv * vec3( scrimPositionClip.xy / scrimPositionClip.w * 0.5 + 0.5, 1.0 );
  vec2 at = uv.xy / uv.z;
  // What is unknown hides nothing, and so does what the depth camera does not see.
  if ( any( greaterThan( abs( at - 0.5 ), vec2( 0.50001 ) ) ) ) return 1.0;
  float roomM = texture2D( scrimRoomDepth, at ).r;
  if ( roomM <= 0.0 ) return 1.0;
  float behindM = scrimPositionClip.w - roomM - scrimOcclusion.z;
  if ( scrimOcclusion.y <= 0.0 ) return behindM > 0.0 ? 0.0 : 1.0;
  return 1.0 - clamp( behindM / scrimOcclusion.y, 0.0, 1.0 );
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

/** All materials of one scene share the uniforms, so that binding a view is a few assignments. */
export function createOcclusionPatch({ roomDepth, params }: OcclusionBinding): OcclusionPatch {
  const texture = new ExternalTexture();
  const uniforms = {
    scrimRoomDepth: { value: texture },
    scrimRoomUvFromViewUv: { value: new Matrix3() },
    scrimOcclusion: { value: new Vector3() },
  };
  const softness = params.softnessM;
  const bias = params.biasM;
  return {
    key: 'occlusion',
    isSoft: () => (softness?.value ?? 0) > 0,
    apply: (shader) => {
      Object.assign(shader.uniforms, uniforms);
      shader.vertexShader = wrapMain(shader.vertexShader, VERTEX);
      shader.fragmentShader = wrapMain(shader.fragmentShader, FRAGMENT);
    },
    bind: ({ viewIndex }) => {
      const depth = roomDepth.views[viewIndex] ?? null;
      texture.sourceTexture = depth?.texture ?? null;
      uniforms.scrimOcclusion.value.set(depth ? 1 : 0, softness?.value ?? 0, bias?.value ?? 0);
      if (depth) uniforms.scrimRoomUvFromViewUv.value.fromArray(depth.uvFromViewUv);
    },
  };
}
