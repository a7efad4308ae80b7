import type { NameSignature } from './shader-name.ts';

export interface BuiltinFunction {
  readonly name: string;
  readonly signatures: readonly NameSignature[];
  readonly doc: string;
}

/**
 * The functions of GLSL ES 3.00 §8 that effects use, and the older names that ISF files have for them. `T` is float or a vector of floats,
 * `I` a whole number or a vector of them, `B` a vector of booleans; the same letter has the same size throughout.
 */
const TABLE = `
radians | T radians(T degrees) | Radians of an angle in degrees.
degrees | T degrees(T radians) | Degrees of an angle in radians.
sin | T sin(T angle) | Sine of an angle in radians.
cos | T cos(T angle) | Cosine of an angle in radians.
tan | T tan(T angle) | Tangent of an angle in radians.
asin | T asin(T x) | Angle between −π/2 and π/2 whose sine is x; undefined beyond −1 and 1.
acos | T acos(T x) | Angle between 0 and π whose cosine is x; undefined beyond −1 and 1.
atan | T atan(T y, T x); T atan(T slope) | Angle of the direction (x, y), between −π and π; with one value, the angle of a slope, between −π/2 and π/2.
sinh | T sinh(T x) | Hyperbolic sine.
cosh | T cosh(T x) | Hyperbolic cosine.
tanh | T tanh(T x) | Hyperbolic tangent: a soft clamp between −1 and 1.
asinh | T asinh(T x) | Inverse of sinh.
acosh | T acosh(T x) | Inverse of cosh; undefined below 1.
atanh | T atanh(T x) | Inverse of tanh; undefined from −1 and 1 on.
pow | T pow(T base, T exponent) | The base raised to the exponent; undefined for a base below 0.
exp | T exp(T x) | e raised to x.
log | T log(T x) | Natural logarithm; undefined from 0 down.
exp2 | T exp2(T x) | 2 raised to x.
log2 | T log2(T x) | Logarithm to the base 2; undefined from 0 down.
sqrt | T sqrt(T x) | Square root; undefined below 0.
inversesqrt | T inversesqrt(T x) | 1 divided by the square root; undefined from 0 down.
abs | T abs(T x); I abs(I x) | The value without its sign.
sign | T sign(T x); I sign(I x) | −1, 0 or 1, as the value is below, at or above 0.
floor | T floor(T x) | The nearest whole number that is not above the value.
trunc | T trunc(T x) | The value without its fraction, towards 0.
round | T round(T x) | The nearest whole number; halves go either way.
roundEven | T roundEven(T x) | The nearest whole number; halves go to the even one.
ceil | T ceil(T x) | The nearest whole number that is not below the value.
fract | T fract(T x) | What is left above the whole number: x − floor(x), from 0 up to 1.
mod | T mod(T x, T y); T mod(T x, float y) | x − y · floor(x / y): repeats every y, also below 0.
modf | T modf(T x, out T whole) | The fraction; the whole part goes into the second argument. Both have the sign of x.
min | T min(T a, T b); T min(T a, float b); I min(I a, I b) | The smaller of two values, by component.
max | T max(T a, T b); T max(T a, float b); I max(I a, I b) | The greater of two values, by component.
clamp | T clamp(T x, T low, T high); T clamp(T x, float low, float high); I clamp(I x, I low, I high) | The value kept between two limits.
mix | T mix(T a, T b, T share); T mix(T a, T b, float share); T mix(T a, T b, B choice) | Blends from a (share 0) to b (share 1) in a straight line; with truths, takes b where they are true.
step | T step(T edge, T x); T step(float edge, T x) | 0 below the edge, 1 from it on.
smoothstep | T smoothstep(T from, T to, T x); T smoothstep(float from, float to, T x) | 0 up to from, 1 beyond to, and a soft S-curve between; from must be below to.
isnan | B isnan(T x) | Whether the value is no number.
isinf | B isinf(T x) | Whether the value is infinite.
floatBitsToInt | I floatBitsToInt(T x) | The bits of a float, read as a whole number.
floatBitsToUint | I floatBitsToUint(T x) | The bits of a float, read as a whole number without sign.
intBitsToFloat | T intBitsToFloat(I bits) | Bits read as a float.
uintBitsToFloat | T uintBitsToFloat(I bits) | Bits read as a float.
length | float length(T x) | Length of a vector.
distance | float distance(T a, T b) | Length of the way between two points.
dot | float dot(T a, T b) | Dot product: for unit vectors the cosine of the angle between them.
cross | vec3 cross(vec3 a, vec3 b) | The vector at right angles to both.
normalize | T normalize(T x) | The vector with a length of 1; undefined for one of length 0.
faceforward | T faceforward(T normal, T incident, T reference) | The normal, turned to the side that the incident vector comes from.
reflect | T reflect(T incident, T normal) | The incident direction, mirrored at a surface; the normal must have length 1.
refract | T refract(T incident, T normal, float ratio) | The incident direction, bent at a surface by the ratio of the indices; 0 where all is reflected.
matrixCompMult | mat3 matrixCompMult(mat3 a, mat3 b) | Product of two matrices component by component; a * b is the usual product.
outerProduct | mat3 outerProduct(vec3 column, vec3 row) | The matrix of all products of two vectors.
transpose | mat3 transpose(mat3 m) | Rows become columns.
determinant | float determinant(mat3 m) | Determinant of a square matrix.
inverse | mat3 inverse(mat3 m) | Inverse of a square matrix.
lessThan | B lessThan(T a, T b) | By component, whether a < b.
lessThanEqual | B lessThanEqual(T a, T b) | By component, whether a ≤ b.
greaterThan | B greaterThan(T a, T b) | By component, whether a > b.
greaterThanEqual | B greaterThanEqual(T a, T b) | By component, whether a ≥ b.
equal | B equal(T a, T b) | By component, whether both are the same.
notEqual | B notEqual(T a, T b) | By component, whether both differ.
any | bool any(B x) | Whether one component is true.
all | bool all(B x) | Whether every component is true.
not | B not(B x) | Each component the other way round.
texture | vec4 texture(sampler2D image, vec2 uv); vec4 texture(sampler2D image, vec2 uv, float bias) | Color of an image at coordinates from 0 to 1. IMG_NORM_PIXEL also works in other ISF hosts.
texture2D | vec4 texture2D(sampler2D image, vec2 uv) | The older name of texture.
textureLod | vec4 textureLod(sampler2D image, vec2 uv, float level) | Color of an image at coordinates from 0 to 1, at a level of detail.
textureSize | ivec2 textureSize(sampler2D image, int level) | Width and height of an image, pixels. IMG_SIZE gives them as floats.
texelFetch | vec4 texelFetch(sampler2D image, ivec2 pixel, int level) | One pixel of an image, unfiltered.
dFdx | T dFdx(T x) | How much the value changes towards the next pixel to the right.
dFdy | T dFdy(T x) | How much the value changes towards the next pixel above.
fwidth | T fwidth(T x) | |dFdx(x)| + |dFdy(x)|: how wide a pixel is, for edges without jags.
`;

export const BUILTIN_FUNCTIONS: ReadonlyMap<string, BuiltinFunction> = new Map(
  TABLE.trim()
    .split('\n')
    .map((row) => {
      const [name = '', signatures = '', ...doc] = row.split(' | ');
      return [name, { name, signatures: signatures.split('; ').map(readSignature), doc: doc.join(' | ') }] as const;
    }),
);

/** Splits a signature such as `T mix(T a, T b, float share)` into its return type and parameters. */
export function readSignature(label: string): NameSignature {
  const [, returns = '', inside = ''] = /^(\S+) \w+\((.*)\)$/.exec(label) ?? [];
  return { label, returns, parameters: inside === '' ? [] : inside.split(', ') };
}
