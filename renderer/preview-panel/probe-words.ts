import type { PreviewProbe } from '../preview-protocol.ts';

/** Text of a pixel probe: the color in hexadecimal and as 0 to 255, depth in meters. */
export function probeWords({ color: [r, g, b, a], depth }: PreviewProbe): { readonly css: string; readonly lines: readonly string[] } {
  const hex = `#${[r, g, b].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
  const lines = [`${hex} · ${r} ${g} ${b}${a === 255 ? '' : ` · ${Math.round((a / 255) * 100)} % opaque`}`];
  if (depth === null) lines.push('No depth');
  else {
    lines.push(`${depth.meters.toFixed(2)} m, ${depth.of === 'room' ? 'the room' : 'the layer'}`);
    const [x, y, z] = depth.positionWorld.map((part) => part.toFixed(2));
    lines.push(`x ${x}  y ${y}  z ${z} m`);
  }
  return { css: hex, lines };
}
