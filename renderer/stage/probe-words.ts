import type { PreviewProbe } from '../preview-protocol.ts';

/** What a probe found, as people read it: colour in hexadecimal and in 255ths, distances in metres. */
export function probeWords({ color: [r, g, b, a], depth }: PreviewProbe): { readonly css: string; readonly lines: readonly string[] } {
  const hex = `#${[r, g, b].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
  const lines = [`${hex} · ${r} ${g} ${b}${a === 255 ? '' : ` · ${Math.round((a / 255) * 100)} % opaque`}`];
  if (depth === null) lines.push('No depth here');
  else {
    lines.push(`${depth.metres.toFixed(2)} m, ${depth.of === 'room' ? 'the room' : 'the layer'}`);
    const [x, y, z] = depth.positionWorld.map((part) => part.toFixed(2));
    lines.push(`x ${x}  y ${y}  z ${z} m`);
  }
  return { css: hex, lines };
}
