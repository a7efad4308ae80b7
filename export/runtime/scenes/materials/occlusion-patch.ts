import { ExternalTexture, Matrix3, Vector2, Vector4 } from 'three';
import { OCCLUSION_GLSL, type OcclusionView } from '../../../../nodes/kit/early-occlusion.ts';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';

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
  before: `${OCCLUSION_GLSL}
varying vec4 scrimPositionClip;
`,
  start: '',
  // Last, because derivatives of what a shader computes are undefined beside a discarded fragment (GLSL ES 3.00, section 8.9; ADR 26).
  end: /* glsl */ `
  float scrimVisible = scrimVisibility( scrimPositionClip.xy / scrimPositionClip.w * 0.5 + 0.5, scrimPositionClip.w );
  if ( scrimVisible <= 0.0 ) discard;
  #ifdef PREMULTIPLIED_OUTPUT
    gl_FragColor *= scrimVisible;
  #else
    gl_FragColor.a *= scrimVisible;
  #endif`,
};

/** Creates the occlusion patch of a scene. All materials of the scene share its uniforms, so that setting a view is a few assignments. */
export function createOcclusionPatch({ roomDepth, params }: OcclusionView): OcclusionPatch {
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
