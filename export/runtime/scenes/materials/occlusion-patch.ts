import { ExternalTexture, Matrix3, Vector3 } from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { OcclusionBinding } from '../../scene-backend.ts';
import { type ShaderPatch, wrapMain } from './shader-patch.ts';

/** Hides fragments behind the room while a scene is drawn: the early form of `layer/depth-occlusion`. */
export interface OcclusionPatch extends ShaderPatch {
  /** Whether a border is soft, so that surfaces fade. */
  readonly isSoft: () => boolean;
  /** Takes over the view's room depth and the params; before every draw. */
  bind(view: DrawView): void;
}

const VERTEX = {
  before: 'varying vec4 scrimPositionClip;',
  start: '',
  end: 'scrimPositionClip = gl_Position;',
};

const FRAGMENT = {
  before: /* glsl */ `
uniform sampler2D scrimRoomDepth;
uniform mat3 scrimRoomUvFromViewUv;
uniform vec3 scrimOcclusion;
varying vec4 scrimPositionClip;

float scrimVisibility() {
  if ( scrimOcclusion.x == 0.0 ) return 1.0;
  vec3 uv = scrimRoomUvFromViewUv * vec3( scrimPositionClip.xy / scrimPositionClip.w * 0.5 + 0.5, 1.0 );
  float room = texture2D( scrimRoomDepth, uv.xy / uv.z ).r;
  if ( room <= 0.0 ) return 1.0;
  return 1.0;
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
  return {
    key: 'occlusion',
    isSoft: () => true,
    apply: (shader) => {
      Object.assign(shader.uniforms, uniforms);
      shader.vertexShader = wrapMain(shader.vertexShader, VERTEX);
      shader.fragmentShader = wrapMain(shader.fragmentShader, FRAGMENT);
    },
    bind: ({ viewIndex }) => {
      const depth = roomDepth.views[viewIndex] ?? null;
      texture.sourceTexture = depth?.texture ?? null;
      uniforms.scrimOcclusion.value.set(depth ? 1 : 0, params.x?.value ?? 0, 0);
      if (depth) uniforms.scrimRoomUvFromViewUv.value.fromArray(depth.uvFromViewUv);
    },
  };
}
