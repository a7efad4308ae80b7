import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { encode } from 'jpeg-js';

export const SCAN_SIZE = { widthPx: 64, heightPx: 48 } as const;

/**
 * Writes two photographs with their cameras, 1 m apart and turned to z, and a wall 2 m away. The camera of the second one projects its point
 * elsewhere.
 *
 * @param scan The folder.
 * @param camera Its line of `cameras.txt`, without the id.
 */
export async function writeTwoCameraScan(scan: string, camera = 'PINHOLE 64 48 32 32 32 24'): Promise<void> {
  const { widthPx, heightPx } = SCAN_SIZE;
  await mkdir(join(scan, 'images'), { recursive: true });
  const photo = encode({ width: widthPx, height: heightPx, data: new Uint8Array(widthPx * heightPx * 4).fill(90) }, 90).data;
  for (const name of ['a&b.jpg', 'c.jpg']) await writeFile(join(scan, 'images', name), photo);
  await writeFile(join(scan, 'cameras.txt'), `1 ${camera}\n`);
  await writeFile(join(scan, 'images.txt'), '1 1 0 0 0 0 0 0 1 a&b.jpg\n32 24 1\n2 1 0 0 0 -1 0 0 1 c.jpg\n17 24 1\n');
  await writeFile(join(scan, 'points3D.txt'), '1 0 0 2 0 0 0 0 1 0 2 0\n');
  await writeFile(join(scan, 'mesh.obj'), 'v -2 -1 2\nv 3 -1 2\nv 3 1 2\nv -2 1 2\nf 1 2 3 4\n');
}
