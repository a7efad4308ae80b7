import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { encode } from 'fast-png';
import type { ToolMain } from '../lib/tool.ts';
import { makeTonalArtMaps, type TonalArtMaps } from './make-maps.ts';
import { packTones } from './pack.ts';

/** The images to write, and the tones in their three channels, lightest first. */
const PICTURES = [
  { name: 'hatching-light.png', tones: [0, 1, 2] },
  { name: 'hatching-dark.png', tones: [3, 4, 5] },
] as const;

/** Draws the strokes of `techniques/hatching.glsl` into `shader-library/pictures`. The result is the same in each run. */
export const main: ToolMain = async (_args, { root }) => {
  const folder = join(root, 'shader-library', 'pictures');
  await mkdir(folder, { recursive: true });
  for (const { name, bytes } of drawImages()) {
    await writeFile(join(folder, name), bytes);
    console.log(`${join(folder, name)}: ${bytes.length} bytes`);
  }
  return 0;
};

export function drawImages(maps: TonalArtMaps = makeTonalArtMaps()): readonly { readonly name: string; readonly bytes: Uint8Array }[] {
  return PICTURES.map(({ name, tones }) => ({ name, bytes: encode(packTones(maps, tones), { zlib: { level: 9 } }) }));
}
