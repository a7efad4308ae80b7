import { mkdir, mkdtemp, rm, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import sharp from 'sharp';
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

const box = (type: string, content = '') => {
  const head = Buffer.alloc(4);
  head.writeUInt32BE(8 + content.length);
  return `${head.toString('latin1')}${type}${content}`;
};
/** The boxes that every MP4 has, with the handler of one track. */
const mp4 = (handler = 'vide') =>
  box('ftyp', 'isom\0\0\0\0') + box('moov', box('hdlr', `\0\0\0\0\0\0\0\0${handler}`)) + box('mdat', '\0\0');
const MP4 = mp4();
const EBML = '\x1a\x45\xdf\xa3\x84\0\0\0\0';
/** A segment of unknown length, as recorders write it, with one track of a codec whose name has 5 letters. */
const webm = (codec: string) => `${EBML}\x18\x53\x80\x67\x01\xff\xff\xff\xff\xff\xff\xff\x16\x54\xae\x6b\x89\xae\x87\x86\x85${codec}`;
const WEBM = webm('V_VP9');
const hdr = (width: number, height: number) => `#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`;
const HDR = `${hdr(4, 2)}\0`;
const EXR = '\x76\x2f\x31\x01\x02\0\0\0dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0\x03\0\0\0\x01\0\0\0';
const SIGNATURE = '\x89PNG\r\n\x1a\n';
const png = (width: number, height: number) => {
  const sides = Buffer.alloc(8);
  sides.writeUInt32BE(width, 0);
  sides.writeUInt32BE(height, 4);
  return `${SIGNATURE}\0\0\0\rIHDR${sides.toString('latin1')}${'\0'.repeat(9)}\0\0\0\0IEND\0\0\0\0`;
};
const PNG = png(4, 2);

test.each<[Asset['kind'], string]>([
  ['video', MP4],
  ['video', WEBM],
  ['environment', HDR],
  ['environment', EXR],
  ['environment', PNG],
  ['image', PNG],
  ['image', 'GIF89a\x04\0\x02\0'],
])('takes a %s of a size, with what belongs to it', async (kind, content) => {
  expect(await said(kind, content)).toEqual([]);
});

test.each(['png', 'jpeg', 'webp', 'gif', 'avif'] as const)(
  'takes what encoders make, and not without its second half: %s',
  async (format) => {
    const pixels = sharp({
      create: { width: 64, height: 32, channels: 3, background: 'teal', noise: { type: 'gaussian', mean: 128, sigma: 60 } },
    });
    const bytes = (await pixels.toFormat(format).toBuffer()).toString('latin1');
    expect(await said('image', bytes)).toEqual([]);
    // Nothing in the head of a GIF tells its length.
    if (format === 'gif') return;
    expect(await said('image', bytes.slice(0, bytes.length / 2))).toEqual(['error SCR032 assets/a is incomplete.']);
  },
);

const TOO_WIDE = (size: string) => `error SCR032 assets/a is ${size} pixels; the limit is 16384 in each direction.`;
const NO_VIDEO = 'error SCR032 assets/a is broken: its content is not a video.';
const CUT_VIDEO = 'error SCR032 assets/a is incomplete: a chunk is longer than the file.';

test.each<[string, Asset['kind'], string, string]>([
  ['an image without pixels', 'image', png(0, 0), 'error SCR032 assets/a has no pixels: it is 0 × 0.'],
  ['an image of 50,000²', 'image', png(50_000, 50_000), TOO_WIDE('50000 × 50000')],
  ['an image without an end', 'image', PNG.slice(0, -8), 'error SCR032 assets/a is incomplete.'],
  ['an image of a signature', 'image', SIGNATURE, 'error SCR032 assets/a is damaged or has an unsupported format. Use PNG, JPEG or WebP.'],
  ['a panorama without pixels', 'environment', `${hdr(0, 0)}\0`, 'error SCR032 assets/a has no pixels: it is 0 × 0.'],
  ['a panorama of 10⁹', 'environment', `${hdr(1e9, 1e9)}\0`, TOO_WIDE('1000000000 × 1000000000')],
  ['a panorama of a head', 'environment', hdr(4, 2), 'error SCR032 assets/a is incomplete: it has no pixels.'],
  [
    'a panorama of no size',
    'environment',
    EXR.replace('box2i', 'other'),
    'error SCR032 assets/a is broken: it does not say how large it is.',
  ],
  [
    'a panorama of less than nothing',
    'environment',
    `${EXR.slice(0, -8)}\xff\xff\xff\xff\xff\xff\xff\xff`,
    'error SCR032 assets/a has no pixels: it is 0 × 0.',
  ],
  ['an MP4 of junk', 'video', `${box('ftyp', 'isom\0\0\0\0')}${'\x07junk\x01'.repeat(50)}`, NO_VIDEO],
  ['an MP4 that is cut off', 'video', MP4.slice(0, -1), CUT_VIDEO],
  [
    'an MP4 of a head',
    'video',
    box('ftyp', 'isom\0\0\0\0'),
    'error SCR032 assets/a is incomplete or not a video: its index (“moov”) is missing.',
  ],
  ['an MP4 of sound', 'video', mp4('soun'), 'error SCR032 assets/a has no images in it.'],
  ['a WebM of junk', 'video', `${EBML}${'\x07junk\x01'.repeat(50)}`, NO_VIDEO],
  ['a WebM that is cut off', 'video', WEBM.slice(0, -1), CUT_VIDEO],
  ['a WebM of a head', 'video', EBML, CUT_VIDEO],
  ['a WebM of sound', 'video', webm('A_AAC'), 'error SCR032 assets/a has no images in it.'],
])('refuses %s', async (_name, kind, content, message) => {
  expect(await said(kind, content)).toEqual([message]);
});

test.each<[Asset['kind'], string | null, string]>([
  ['video', null, 'error SCR030 assets/a is missing from the project folder.'],
  ['video', '', 'error SCR032 assets/a is empty.'],
  ['video', PNG, 'error SCR032 assets/a is not a video that browsers can play. Use MP4 or WebM.'],
  ['video', '\0\0\0\x20ftypavif\0\0\0\0', 'error SCR032 assets/a is an image, not a video.'],
  ['environment', '', 'error SCR032 assets/a is empty.'],
  ['environment', MP4, 'error SCR032 assets/a is not a panorama. Use Radiance HDR, OpenEXR, JPEG, PNG, WebP or AVIF.'],
  ['image', HDR, 'error SCR032 assets/a is not an image that browsers can show. Use PNG, JPEG, WebP, AVIF or GIF.'],
])('refuses as %s what is none: %j', async (kind, content, message) => {
  expect(await said(kind, content)).toEqual([message]);
});

test('warns of what visitors wait long for, whether it is used or not', async () => {
  expect(await said('video', WEBM, 60 * 2 ** 20)).toEqual(['warning SCR034 assets/a has 60 MB; above 40 MB visitors wait long.']);
  expect(await said('environment', HDR, 20 * 2 ** 20)).toEqual(['warning SCR034 assets/a has 20 MB; above 16 MB visitors wait long.']);
});
