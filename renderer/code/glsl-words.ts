/** GLSL ES 3.00 §3.6 to §8, as far as the code panel colours and completes them. */
export const KEYWORDS =
  'attribute break case centroid const continue default discard do else flat for highp if in inout invariant layout lowp mediump out precision return smooth struct switch uniform varying while true false'.split(
    ' ',
  );

export const TYPES =
  'void bool int uint float vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 sampler2D samplerCube sampler2DArray sampler3D'.split(
    ' ',
  );

export const BUILTIN_FUNCTIONS =
  'radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt inversesqrt abs sign floor trunc round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan isinf length distance dot cross normalize faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not texture textureSize textureLod texelFetch dFdx dFdy fwidth'.split(
    ' ',
  );

/** What an ISF host declares by itself (docs.isf.video, "Automatically Created Uniforms" and "ISF Built-in Functions"). */
export const ISF_WORDS: Readonly<Record<string, string>> = {
  TIME: 'Seconds since the first frame.',
  TIMEDELTA: 'Seconds since the last frame.',
  FRAMEINDEX: 'Number of this frame, from 0.',
  DATE: 'Year, month, day, and seconds of the day.',
  RENDERSIZE: 'Width and height of this pass, pixels.',
  PASSINDEX: 'Number of this pass, from 0.',
  isf_FragNormCoord: 'This pixel, from (0, 0) at the bottom left to (1, 1) at the top right.',
  IMG_PIXEL: 'Colour of an image at pixel coordinates.',
  IMG_NORM_PIXEL: 'Colour of an image at coordinates from 0 to 1.',
  IMG_THIS_PIXEL: 'Colour of an image at this pixel.',
  IMG_THIS_NORM_PIXEL: 'Colour of an image at this pixel.',
  IMG_SIZE: 'Width and height of an image, pixels.',
};
