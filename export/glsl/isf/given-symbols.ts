import type { BuiltinUniform, PassUniform } from '../../program/program.ts';
import { isImageType } from '../check/glsl-type.ts';
import type { VariableSymbol } from '../syntax/ast.ts';
import type { IsfInputType, IsfShader } from './isf-shader.ts';

/** Names of uniforms with which hosts describe an image, such as `_inputImage_imgSize`. */
const PROPERTY = /^_(\w+)_(imgRect|imgSize|flip)$/;

export interface ImageProperty {
  readonly image: string;
  /** `imgRect`: origin and size of the used part, normalized; always all of it. `flip`: whether the image is upside down; always false. */
  readonly property: 'imgRect' | 'imgSize' | 'flip';
}

export const IMAGE_PROPERTY_TYPES = { imgRect: 'vec4', imgSize: 'vec2', flip: 'bool' } as const;

/** GLSL type of an input. Images, depth, curves and gradients are only arguments of functions that read them. */
export const INPUT_TYPES: Readonly<Record<IsfInputType, string>> = {
  event: 'bool',
  bool: 'bool',
  long: 'int',
  float: 'float',
  point2D: 'vec2',
  color: 'vec4',
  image: 'sampler2D',
  audio: 'sampler2D',
  audioFFT: 'sampler2D',
  depth: 'sampler2D',
  curve: 'sampler2D',
  gradient: 'sampler2D',
  vector3: 'vec3',
  vector4: 'vec4',
};

/** ISF's automatic uniforms, and the matrices of the view. */
export const UNIFORM_TYPES: Readonly<Record<BuiltinUniform, PassUniform['type']>> = {
  TIME: 'float',
  TIMEDELTA: 'float',
  FRAMEINDEX: 'int',
  DATE: 'vec4',
  RENDERSIZE: 'vec2',
  PASSINDEX: 'int',
  SCRIM_CLIP_FROM_VIEW: 'mat4',
  SCRIM_WORLD_FROM_VIEW: 'mat4',
};

/** Variables of the host in a vertex shader, including names of version 1 and of other hosts, and those of GLSL. */
const VERTEX_BUILTINS: Readonly<Record<string, string>> = {
  ...UNIFORM_TYPES,
  isf_FragNormCoord: 'vec2',
  vv_FragNormCoord: 'vec2',
  gl_Position: 'vec4',
};

/** Variables of the host in a fragment shader, including names of version 1 and of other hosts, and those of GLSL. */
const BUILTINS: Readonly<Record<string, string>> = {
  ...UNIFORM_TYPES,
  isf_FragNormCoord: 'vec2',
  vv_FragNormCoord: 'vec2',
  isf_FragCoord: 'vec2',
  vv_FragCoord: 'vec2',
  gl_FragCoord: 'vec4',
  gl_FragColor: 'vec4',
  isf_FragColor: 'vec4',
  gl_FragData: 'vec4[]',
};

/** The variables that a shader may use without declaring them. Each call returns new symbols, because the check changes them. */
export function givenSymbols(shader: IsfShader, stage: 'vertex' | 'fragment' = 'fragment'): Map<string, VariableSymbol> {
  const given = new Map<string, VariableSymbol>();

  const give = (name: string, type: string, role: VariableSymbol['role']) => given.set(name, variableOf(name, type, role));
  for (const [name, type] of Object.entries(stage === 'vertex' ? VERTEX_BUILTINS : BUILTINS)) give(name, type, 'builtin');
  for (const input of shader.inputs) {
    const type = INPUT_TYPES[input.type];
    give(input.name, type, isImageType(type) ? 'image' : 'input');
  }
  for (const image of shader.imported) give(image.name, image.cube ? 'samplerCube' : 'sampler2D', 'image');
  for (const pass of shader.passes) if (pass.target !== null) give(pass.target, 'sampler2D', 'image');
  for (const { name, type, role } of [...given.values()]) {
    if (role !== 'image' || type !== 'sampler2D') continue;
    for (const [property, propertyType] of Object.entries(IMAGE_PROPERTY_TYPES)) give(`_${name}_${property}`, propertyType, 'builtin');
  }
  return given;
}

/** Creates the symbol of a variable that the host declares. */
export function variableOf(name: string, type: string, role: VariableSymbol['role']): VariableSymbol {
  return {
    kind: 'variable',
    name,
    type,
    role,
    token: null,
    constant: false,
    rename: false,
    written: false,
    declaration: null,
    parameterOf: null,
  };
}

export function imageProperty(name: string): ImageProperty | null {
  const [, image, property] = PROPERTY.exec(name) ?? [];
  return image === undefined ? null : { image, property: property as ImageProperty['property'] };
}
