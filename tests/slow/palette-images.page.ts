import { open, playAndRead } from '../../app/cli/render/render.page.ts';
import { readColor } from '../../export/runtime/readback.ts';

export { open };

/** Plays the first frame and returns viewed layers: premultiplied RGBA as base64, rows from the top; null for layers without an image. */
export async function layers(taps: readonly string[]) {
  const found: ({ readonly widthPx: number; readonly heightPx: number; readonly base64: string } | null)[] = [];
  await playAndRead(0, ({ player }) => {
    for (const tap of taps) {
      const layer = readColor(player.inspect(tap), 0);
      found.push(layer && { widthPx: layer.widthPx, heightPx: layer.heightPx, base64: base64Of(layer.pixels) });
    }
  });
  return found;
}

function base64Of(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  return btoa(text);
}
