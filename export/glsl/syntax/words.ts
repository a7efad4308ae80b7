/** Types of GLSL ES 3.00 §4.1 that a shader can name, and `void`. */
export const TYPES: ReadonlySet<string> = new Set(
  (
    'void bool int uint float bvec2 bvec3 bvec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 vec2 vec3 vec4 ' +
    'mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ' +
    'sampler2D sampler3D samplerCube sampler2DShadow samplerCubeShadow sampler2DArray sampler2DArrayShadow ' +
    'isampler2D isampler3D isamplerCube isampler2DArray usampler2D usampler3D usamplerCube usampler2DArray sampler2DRect'
  ).split(' '),
);

export const PRECISIONS: ReadonlySet<string> = new Set(['lowp', 'mediump', 'highp']);

/** Qualifiers without effect here: everything is highp, and the linker sets the interpolation. */
export const DROPPED_QUALIFIERS: ReadonlySet<string> = new Set([
  ...PRECISIONS,
  'invariant',
  'precise',
  'smooth',
  'flat',
  'noperspective',
  'centroid',
]);

export const QUALIFIERS: ReadonlySet<string> = new Set([
  ...DROPPED_QUALIFIERS,
  ...['const', 'in', 'out', 'inout', 'uniform', 'varying', 'attribute', 'layout'],
]);

const STATEMENT_WORDS = [
  'if',
  'else',
  'for',
  'while',
  'do',
  'switch',
  'case',
  'default',
  'break',
  'continue',
  'return',
  'discard',
  'struct',
  'precision',
  'true',
  'false',
];

/** Words that cannot be names in older GLSL; the parser rejects them as names. */
export const KEYWORDS: ReadonlySet<string> = new Set([
  ...TYPES,
  ...STATEMENT_WORDS,
  'const',
  'in',
  'out',
  'inout',
  'uniform',
  'varying',
  'attribute',
  ...PRECISIONS,
]);

/** Keywords that GLSL ES 1.00 (§3.6) neither has nor reserves, so its files may use them as names. */
export const NEW_WORDS: ReadonlySet<string> = new Set([
  ...[...TYPES].filter((type) => /^(?:u|mat\dx|[iu]?sampler2DArray|[iu]sampler|samplerCubeShadow)/.test(type)),
  'case',
]);

/** Reserved by GLSL ES 3.00 §3.7 but allowed in older GLSL: the printer renames them. */
export const RESERVED: ReadonlySet<string> = new Set(
  (
    'centroid flat smooth layout invariant switch case default coherent volatile restrict readonly writeonly resource atomic_uint noperspective patch sample subroutine ' +
    'common partition active asm class union enum typedef template this goto inline noinline volatile public static extern external interface ' +
    'long short double half fixed unsigned superp input output hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 fvec4 ' +
    'sampler3DRect filter image1D image2D image3D imageCube iimage1D iimage2D iimage3D iimageCube uimage1D uimage2D uimage3D uimageCube ' +
    'image1DArray image2DArray iimage1DArray iimage2DArray uimage1DArray uimage2DArray image1DShadow image2DShadow image1DArrayShadow image2DArrayShadow ' +
    'imageBuffer iimageBuffer uimageBuffer sampler1D sampler1DShadow sampler1DArray sampler1DArrayShadow isampler1D isampler1DArray usampler1D usampler1DArray ' +
    'sampler2DRect sampler2DRectShadow isampler2DRect usampler2DRect samplerBuffer isamplerBuffer usamplerBuffer sampler2DMS isampler2DMS usampler2DMS ' +
    'sampler2DMSArray isampler2DMSArray usampler2DMSArray sizeof cast namespace using precise shared buffer'
  ).split(' '),
);
