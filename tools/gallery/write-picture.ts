import { mkdir, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import sharp from 'sharp';
import { pictureOf } from '../../app/services/find-examples.ts';

const WIDTH_PX = 240;
/** About 9 kB per image; all of them are sent to the editor at once. */
const QUALITY = 74;

/** Writes the small image of an example for the editor. */
export async function writePicture(examplesDir: string, name: string, png: Uint8Array): Promise<void> {
  const file = pictureOf(examplesDir, name);
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, await sharp(png).resize({ width: WIDTH_PX }).jpeg({ quality: QUALITY }).toBuffer());
}
