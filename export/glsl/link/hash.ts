/**
 * Hashes a text to 64 bits as 16 hexadecimal digits, for names and comparisons, not for security. FNV-1a in two halves with different seeds
 * and a final mix (murmur3's); synchronous and without dependencies.
 */
export function hashText(text: string): string {
  let a = 0x811c9dc5;
  let b = 0x1000193;
  for (let i = 0; i < text.length; i += 1) {
    const unit = text.charCodeAt(i);
    a = Math.imul(a ^ unit, 0x01000193);
    b = Math.imul(b ^ (unit + 0x9e37), 0x5bd1e995);
  }
  return hex(mix(a ^ (b >>> 15))) + hex(mix(b ^ (a >>> 13)));
}

function mix(value: number): number {
  let h = value;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}

function hex(value: number): string {
  return (value >>> 0).toString(16).padStart(8, '0');
}
