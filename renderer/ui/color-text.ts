/** A color in display-referred sRGB with straight alpha, each component in [0, 1]. */
export type Rgba = readonly [number, number, number, number];

/** Converts a color to `#rrggbb`, without alpha. */
export function hexFromColor([r, g, b]: Rgba): string {
  const channel = (value: number) =>
    Math.round(Math.min(Math.max(value, 0), 1) * 255)
      .toString(16)
      .padStart(2, '0');
  return `#${channel(r)}${channel(g)}${channel(b)}`;
}

/** Parses 3, 6 or 8 hexadecimal digits, with or without `#`. Eight digits include alpha, else `alpha` is used. Returns null if invalid. */
export function colorFromHex(text: string, alpha: number): Rgba | null {
  const digits = text.trim().replace(/^#/, '').toLowerCase();
  if (!/^([0-9a-f]{3}|[0-9a-f]{6}|[0-9a-f]{8})$/.test(digits)) return null;
  const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join('') : digits;
  const channel = (index: number) => Number.parseInt(long.slice(index * 2, index * 2 + 2), 16) / 255;
  return [channel(0), channel(1), channel(2), long.length === 8 ? channel(3) : alpha];
}
