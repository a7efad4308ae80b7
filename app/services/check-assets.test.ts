import { mkdir, mkdtemp, rm, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import type { Asset } from '../../export/graph/project.ts';
import { checkAssets } from './check-assets.ts';

let root: string;

beforeEach(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-check-assets-'));
  await mkdir(join(root, 'assets'));
});
afterEach(() => rm(root, { recursive: true, force: true }));

/** What is said of a file of this content, and of this size where it is to be larger than that. */
async function said(kind: Asset['kind'], content: string | null, bytes?: number): Promise<string[]> {
  const path = join(root, 'assets/a');
  if (content !== null) await writeFile(path, content, 'latin1');
  if (bytes !== undefined) await truncate(path, bytes);
  const found = await checkAssets(root, { a: { path: 'assets/a', kind } }, new Set(['a']));
  return found.map(({ severity, code, message }) => `${severity} ${code} ${message}`);
}

const MP4 = '\0\0\0\x20ftypisom\0\0\0\0';
const WEBM = '\x1a\x45\xdf\xa3\x01\0\0\0\0\0\0\x1f\0\0\0\0';
const HDR = '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n';
const EXR = '\x76\x2f\x31\x01\x02\0\0\0channels';
const PNG = '\x89PNG\r\n\x1a\n\0\0\0\rIHDR';

test.each<[Asset['kind'], string]>([
  ['video', MP4],
  ['video', WEBM],
  ['environment', HDR],
  ['environment', EXR],
  ['environment', PNG],
])('takes a %s that begins as one', async (kind, content) => {
  expect(await said(kind, content)).toEqual([]);
});

test.each<[Asset['kind'], string | null, string]>([
  ['video', null, 'error SCR030 assets/a is missing from the project folder.'],
  ['video', '', 'error SCR032 assets/a is empty.'],
  ['video', PNG, 'error SCR032 assets/a is no video that browsers can play: use MP4 or WebM.'],
  ['video', '\0\0\0\x20ftypavif\0\0\0\0', 'error SCR032 assets/a is a picture, no video.'],
  ['environment', '', 'error SCR032 assets/a is empty.'],
  ['environment', MP4, 'error SCR032 assets/a is no panorama: use Radiance HDR, OpenEXR, JPEG, PNG or WebP.'],
  ['image', HDR, 'error SCR032 assets/a is no picture that browsers can show: use PNG, JPEG, WebP, AVIF or GIF.'],
])('refuses as %s what is none: %j', async (kind, content, message) => {
  expect(await said(kind, content)).toEqual([message]);
});

test('warns of what visitors wait long for, whether it is used or not', async () => {
  expect(await said('video', WEBM, 60 * 2 ** 20)).toEqual(['warning SCR034 assets/a is a file of 60 MB; above 40 MB visitors wait long.']);
  expect(await said('environment', HDR, 20 * 2 ** 20)).toEqual([
    'warning SCR034 assets/a is a file of 20 MB; above 16 MB visitors wait long.',
  ]);
});
