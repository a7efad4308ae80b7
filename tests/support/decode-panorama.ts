import { readFile } from 'node:fs/promises';
import { readRadianceHeader } from '../../export/runtime/scenes/environments/radiance-header.ts';
import { readRadiance } from '../../export/runtime/scenes/environments/read-radiance.ts';
import type { PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';

/** Decodes a panorama in Node: HDR and EXR to floats, other images to bytes without color conversion. */
export async function decodePanorama(path: string): Promise<PanoramaPixels> {
  const file = await readFile(path);
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength) as ArrayBuffer;
  const header = readRadianceHeader(bytes);
  if (header) return readRadiance.floats(bytes, header);
  // Only tests with data need it.
  const { default: sharp } = await import('sharp');
  const { data, info } = await sharp(file).removeAlpha().raw().toBuffer({ resolveWithObject: true });
  return { widthPx: info.width, heightPx: info.height, channels: 3, data: new Uint8Array(data) };
}
