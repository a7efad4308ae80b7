import {
  AlwaysStencilFunc,
  BackSide,
  DecrementWrapStencilOp,
  FrontSide,
  IncrementWrapStencilOp,
  KeepStencilOp,
  LessDepth,
  ShaderMaterial,
  type Vector4,
} from 'three';

const VERTEX = /* glsl */ `
// 1 for vertices that are moved away from the light.
attribute float away;
// Position of the light with w 1, or the direction towards it with w 0; world.
uniform vec4 lightWorld;

void main() {
  // The same operations as in three.js' project_vertex, because the cap must have the depth of its surface in every bit.
  vec4 mvPosition = modelViewMatrix * vec4( position, 1.0 );
  if ( away > 0.5 ) mvPosition = viewMatrix * vec4( ( modelMatrix * vec4( position, 1.0 ) ).xyz * lightWorld.w - lightWorld.xyz, 0.0 );
  gl_Position = projectionMatrix * mvPosition;
}
`;

const FRAGMENT = /* glsl */ `
void main() {
  gl_FragColor = vec4( 0.0 );
}
`;

/**
 * Counts back or front faces of shadow volumes behind the drawn surfaces in the stencil: backs increment and fronts decrement, so that
 * pixels within a volume differ from 0 for any position of the eye (z-fail; Bilodeau and Songy 1999, Carmack 2000).
 */
export function createVolumeMaterial(side: 'back' | 'front', lightWorld: { readonly value: Vector4 }): ShaderMaterial {
  const material = new ShaderMaterial({ name: `shadow volume ${side}`, vertexShader: VERTEX, fragmentShader: FRAGMENT });
  material.uniforms = { lightWorld };
  material.side = side === 'back' ? BackSide : FrontSide;
  // Makes three.js sort them by render order.
  material.transparent = true;
  material.colorWrite = false;
  material.depthWrite = false;
  material.depthFunc = LessDepth;
  // The cap is in the casting surface and must count as behind it, also at grazing angles with imprecise depth: by 0.2 mm at 1.5 m. The
  // offset does not depend on the slope, which would move surfaces seen edge-on far away.
  material.polygonOffset = true;
  material.polygonOffsetFactor = 0;
  material.polygonOffsetUnits = 128;
  material.stencilWrite = true;
  material.stencilFunc = AlwaysStencilFunc;
  material.stencilFail = KeepStencilOp;
  material.stencilZPass = KeepStencilOp;
  material.stencilZFail = side === 'back' ? IncrementWrapStencilOp : DecrementWrapStencilOp;
  return material;
}
