/**
 * Three components of a color, written in place. The functions of this file allocate nothing: they write their result into `out`.
 */
export type Triple = { [index: number]: number } & ArrayLike<number>;

/**
 * Clamps a channel to [0, 1].
 *
 * @example
 * clamp01(1.5); // 1
 */
export function clamp01(x: number): number {
  return Math.min(Math.max(x, 0), 1);
}

/**
 * Converts RGB to HSV by the hexcone model (Smith 1978).
 *
 * @param out Receives hue in turns, [0, 1), saturation and value in [0, 1]. Grays have the hue 0.
 * @param r Red, display-referred sRGB in [0, 1]; likewise `g` and `b`.
 *
 * @example
 * hsvFromRgb(out, 1, 0, 0); // out = [0, 1, 1]
 */
export function hsvFromRgb(out: Triple, r: number, g: number, b: number): void {
  const value = Math.max(r, g, b);
  const chroma = value - Math.min(r, g, b);
  out[0] = hueOf(r, g, b, value, chroma);
  out[1] = value === 0 ? 0 : chroma / value;
  out[2] = value;
}

/**
 * Converts HSV to RGB.
 *
 * @param out Receives display-referred sRGB in [0, 1].
 * @param hue In turns; any number.
 * @param saturation In [0, 1].
 * @param value In [0, 1].
 *
 * @example
 * rgbFromHsv(out, 1 / 3, 1, 1); // out = [0, 1, 0]
 */
export function rgbFromHsv(out: Triple, hue: number, saturation: number, value: number): void {
  const chroma = value * saturation;
  writeHue(out, hue, chroma, value - chroma);
}

/**
 * Converts RGB to HSL as CSS Color 4, §7.
 *
 * @param out Receives hue in turns, [0, 1), saturation and lightness in [0, 1].
 * @param r Red, display-referred sRGB in [0, 1]; likewise `g` and `b`.
 *
 * @example
 * hslFromRgb(out, 1, 1, 1); // out = [0, 0, 1]
 */
export function hslFromRgb(out: Triple, r: number, g: number, b: number): void {
  const most = Math.max(r, g, b);
  const chroma = most - Math.min(r, g, b);
  const lightness = most - chroma / 2;
  out[0] = hueOf(r, g, b, most, chroma);
  out[1] = chroma === 0 ? 0 : chroma / (1 - Math.abs(2 * lightness - 1));
  out[2] = lightness;
}

/**
 * Converts HSL to RGB as CSS Color 4, §7.
 *
 * @param out Receives display-referred sRGB in [0, 1].
 * @param hue In turns; any number.
 * @param saturation In [0, 1].
 * @param lightness In [0, 1].
 *
 * @example
 * rgbFromHsl(out, 0, 1, 0.5); // out = [1, 0, 0]
 */
export function rgbFromHsl(out: Triple, hue: number, saturation: number, lightness: number): void {
  const chroma = (1 - Math.abs(2 * lightness - 1)) * saturation;
  writeHue(out, hue, chroma, lightness - chroma / 2);
}

/**
 * Decodes one channel of sRGB (IEC 61966-2-1).
 *
 * @param c Display-referred, in [0, 1].
 * @returns Linear, in [0, 1].
 *
 * @example
 * linearFromSrgb(0.5); // 0.214
 */
export function linearFromSrgb(c: number): number {
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

/**
 * Encodes one channel as sRGB (IEC 61966-2-1).
 *
 * @param c Linear, in [0, 1].
 * @returns Display-referred, in [0, 1].
 *
 * @example
 * srgbFromLinear(0.214); // 0.5
 */
export function srgbFromLinear(c: number): number {
  return c <= 0.0031308 ? c * 12.92 : 1.055 * c ** (1 / 2.4) - 0.055;
}

/**
 * Converts linear-sRGB to Oklab (Björn Ottosson, "A perceptual color space for image processing", 2020).
 *
 * @param out Receives lightness in [0, 1], `a` and `b`.
 * @param r Red, linear-sRGB in [0, 1]; likewise `g` and `b`.
 *
 * @example
 * oklabFromLinear(out, 1, 1, 1); // out = [1, 0, 0]
 */
export function oklabFromLinear(out: Triple, r: number, g: number, b: number): void {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  out[0] = 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s;
  out[1] = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s;
  out[2] = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s;
}

/**
 * Converts Oklab to linear-sRGB.
 *
 * @param out Receives linear-sRGB; outside [0, 1] where sRGB does not contain the color.
 * @param lightness In [0, 1].
 *
 * @example
 * linearFromOklab(out, 1, 0, 0); // out = [1, 1, 1]
 */
export function linearFromOklab(out: Triple, lightness: number, a: number, b: number): void {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  out[0] = 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s;
  out[1] = -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s;
  out[2] = -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s;
}

function hueOf(r: number, g: number, b: number, most: number, chroma: number): number {
  if (chroma === 0) return 0;
  if (most === r) return ((g - b) / chroma / 6 + 1) % 1;
  return most === g ? (b - r) / chroma / 6 + 1 / 3 : (r - g) / chroma / 6 + 2 / 3;
}

/**
 * Writes the color of a hue at a chroma, on top of `base`. Each channel is a trapezoid function of the hue; the functions are a third of a
 * turn apart.
 */
function writeHue(out: Triple, hue: number, chroma: number, base: number): void {
  for (let i = 0; i < 3; i++) {
    const turn = hue - i / 3;
    const away = Math.abs((turn - Math.floor(turn)) * 6 - 3);
    out[i] = base + chroma * Math.min(Math.max(away - 1, 0), 1);
  }
}

/**
 * Writes the color of a hue, saturation, brightness and alpha. All but the hue are clamped to [0, 1].
 *
 * @param out Receives four components.
 * @param hueRad The angle on the color wheel, in radians.
 *
 * @example
 * writeHsvColor(out, 0, 1, 1, 1); // out = [1, 0, 0, 1]
 */
export function writeHsvColor(out: Triple, hueRad: number, saturation: number, brightness: number, alpha: number): void {
  rgbFromHsv(out, hueRad / (2 * Math.PI), clamp01(saturation), clamp01(brightness));
  out[3] = clamp01(alpha);
}

/**
 * Writes a color whose hue is rotated, whose saturation is multiplied, and whose lightness (HSL) is increased. Alpha is kept.
 *
 * @param out Receives four components.
 * @param hueRad The rotation, in radians.
 *
 * @example
 * writeAdjustedColor(out, [1, 0, 0, 1], Math.PI, 1, 0); // out = [0, 1, 1, 1]
 */
export function writeAdjustedColor(out: Triple, base: ArrayLike<number>, hueRad: number, saturation: number, lightness: number): void {
  hslFromRgb(out, base[0] ?? 0, base[1] ?? 0, base[2] ?? 0);
  const hue = (out[0] ?? 0) + hueRad / (2 * Math.PI);
  rgbFromHsl(out, hue, clamp01((out[1] ?? 0) * saturation), clamp01((out[2] ?? 0) + lightness));
  out[3] = base[3] ?? 1;
}

/** The color space in which colors are mixed: Oklab, linear sRGB or sRGB. */
export type MixSpace = 'perceived' | 'light' | 'screen';

const FROM = new Float64Array(3);
const TO = new Float64Array(3);

/**
 * Mixes premultiplied colors, as CSS Color 4 §12.3, so that a transparent color does not contribute.
 *
 * @param out Receives four components; not `a` or `b`.
 * @param amount 0 gives `a`, 1 gives `b`; clamped to [0, 1].
 *
 * @example
 * writeMixedColor(out, [0, 0, 0, 1], [1, 1, 1, 1], 0.5, 'screen'); // out = [0.5, 0.5, 0.5, 1]
 */
export function writeMixedColor(out: Triple, a: ArrayLike<number>, b: ArrayLike<number>, amount: number, space: MixSpace): void {
  enterSpace(FROM, a, space);
  enterSpace(TO, b, space);
  const part = clamp01(amount);
  const alphaA = (a[3] ?? 1) * (1 - part);
  const alphaB = (b[3] ?? 1) * part;
  const alpha = alphaA + alphaB;
  // Between two fully transparent colors, mix the channels: a later node may make them opaque.
  const weightB = alpha === 0 ? part : alphaB / alpha;
  for (let i = 0; i < 3; i++) out[i] = (FROM[i] ?? 0) * (1 - weightB) + (TO[i] ?? 0) * weightB;
  if (space === 'perceived') linearFromOklab(out, out[0] ?? 0, out[1] ?? 0, out[2] ?? 0);
  for (let i = 0; i < 3; i++) {
    const channel = clamp01(out[i] ?? 0);
    out[i] = space === 'screen' ? channel : srgbFromLinear(channel);
  }
  out[3] = alpha;
}

function enterSpace(out: Float64Array, color: ArrayLike<number>, space: MixSpace): void {
  for (let i = 0; i < 3; i++) out[i] = space === 'screen' ? (color[i] ?? 0) : linearFromSrgb(color[i] ?? 0);
  if (space === 'perceived') oklabFromLinear(out, out[0] ?? 0, out[1] ?? 0, out[2] ?? 0);
}
