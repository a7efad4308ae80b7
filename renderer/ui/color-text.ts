/** Display-referred sRGB, straight alpha, [0, 1]. */
export type Rgba = readonly [number, number, number, number];

/** `#rrggbb`; the alpha is not part of it. */
export function hexFromColor([r, g, b]: Rgba): string {
  const channel = (value: number) =>
    Math.round(Math.min(Math.max(value, 0), 1) * 255)
      .toString(16)
      .padStart(2, '0');
  return `#${channel(r)}${channel(g)}${channel(b)}`;
}

/** Three, six or eight hexadecimal digits, with or without `#`; null for anything else. Eight bring their own alpha. */
export function colorFromHex(text: string, alpha: number): Rgba | null {
  const digits = text.trim().replace(/^#/, '').toLowerCase();
  if (!/^([0-9a-f]{3}|[0-9a-f]{6}|[0-9a-f]{8})$/.test(digits)) return null;
  const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join('') : digits;
  const channel = (index: number) => Number.parseInt(long.slice(index * 2, index * 2 + 2), 16) / 255;
  return [channel(0), channel(1), channel(2), long.length === 8 ? channel(3) : alpha];
}
