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
// 1 for vertices that stand for others moved away from the light.
attribute float away;
// Place of the light with w 1, or with w 0 the direction towards it; world.
uniform vec4 lightWorld;

void main() {
  // As three's project_vertex does, to the last digit: the cap has to cover the pixels that its surface covers.
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
 * Counts one side of shadow volumes in the stencil, where they lie behind what is drawn: backs up and fronts down, so that pixels
 * within a volume end up other than 0, wherever the eye stands (z-fail; Bilodeau and Songy 1999, Carmack 2000).
 */
export function createVolumeMaterial(side: 'back' | 'front', lightWorld: { readonly value: Vector4 }): ShaderMaterial {
  const material = new ShaderMaterial({ name: `shadow volume ${side}`, vertexShader: VERTEX, fragmentShader: FRAGMENT });
  material.uniforms = { lightWorld };
  material.side = side === 'back' ? BackSide : FrontSide;
  // Sorted among what has an order.
  material.transparent = true;
  material.colorWrite = false;
  material.depthWrite = false;
  material.depthFunc = LessDepth;
  // The cap lies in the surface that casts, and has to count as behind it, also where it is seen edge-on and its depth is known to a
  // few digits only: by 0.2 mm at 1.5 m. Not by its slope: that would push what is seen edge-on far away.
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
