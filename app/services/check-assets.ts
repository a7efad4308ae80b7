import { constants } from 'node:fs';
import { open } from 'node:fs/promises';
import type { Asset } from '../../export/graph/project.ts';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';

/**
 * What can be said of a project's asset files without decoding them: missing (SCR030), outside (SCR031), cut off or not what
 * they claim to be (SCR032). What `used` names is an error, everything else a warning, because nothing on screen needs it. Videos and
 * panoramas that visitors would wait long for are warned of (SCR034); what is large about a model is told when it is read.
 */
export async function checkAssets(
  root: string,
  assets: Readonly<Record<string, Asset>>,
  used: ReadonlySet<string>,
): Promise<readonly Diagnostic[]> {
  const found = await Promise.all(
    Object.entries(assets).map(async ([id, asset]): Promise<Diagnostic | null> => {
      const problem = await problemOf(root, asset);
      return problem && { severity: used.has(id) ? 'error' : 'warning', file: asset.path, ...problem };
    }),
  );
  return found.filter((diagnostic) => diagnostic !== null);
}

type Problem = Pick<Diagnostic, 'code' | 'message' | 'fix'> & { readonly severity?: 'warning' };

/** Enough for every signature below. */
const HEAD_BYTES = 16;

async function problemOf(root: string, { path, kind }: Asset): Promise<Problem | null> {
  try {
    const file = await open(await resolveInside(root, path), constants.O_RDONLY | (constants.O_NOFOLLOW ?? 0));
    try {
      const { size } = await file.stat();
      const head = Buffer.alloc(HEAD_BYTES);
      await file.read(head, 0, HEAD_BYTES, 0);
      const wrong = WRONG[kind](head, size);
      if (wrong !== null) return { code: 'SCR032', message: `${path} ${wrong}`, fix: 'Export it again, or choose another file.' };
      return tooLarge(path, kind, size);
    } finally {
      await file.close();
    }
  } catch (error) {
    if (error instanceof HostError) return { code: 'SCR031', message: error.diagnostic.message };
    if (errorCode(error) === 'ENOENT') {
      return { code: 'SCR030', message: `${path} is missing from the project folder.`, fix: 'Put the file back, or choose another one.' };
    }
    return { code: 'SCR030', message: `${path} cannot be read (${errorCode(error) ?? String(error)}).` };
  }
}

/** glTF 2.0 §4.4: magic, version, and the length of the whole file. JSON begins with a brace and is judged when it is loaded. */
function wrongModel(head: Buffer, size: number): string | null {
  if (head.toString('latin1', 0, 4) !== 'glTF') return /^\s*\{/.test(head.toString('latin1')) ? null : 'is no glTF model.';
  if (size < 20) return 'is cut off: it has no more than a header.';
  const version = head.readUInt32LE(4);
  if (version !== 2) return `is glTF version ${version}; only version 2 can be read.`;
  const length = head.readUInt32LE(8);
  return size >= length ? null : `is cut off: it has ${size} of ${length} bytes.`;
}

/** What visitors load before they see it, bytes; a video is loaded whole, so that it can be sought and needs no network later. */
const LARGE = {
  video: { bytes: 40 * 2 ** 20, fix: 'Make it shorter or smaller, or save it with a lower bit rate.' },
  environment: { bytes: 16 * 2 ** 20, fix: 'Make it smaller: 2048 × 1024 is enough to light with, 4096 × 2048 to look at.' },
} as const;

function tooLarge(path: string, kind: AssetKind, size: number): Problem | null {
  if (kind !== 'video' && kind !== 'environment') return null;
  const { bytes, fix } = LARGE[kind];
  if (size <= bytes) return null;
  const message = `${path} is a file of ${Math.round(size / 2 ** 20)} MB; above ${bytes / 2 ** 20} MB visitors wait long.`;
  return { code: 'SCR034', severity: 'warning', message, fix };
}

/** ISO 14496-12 §4.3 and RFC 8794 §11.2. */
function wrongVideo(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  if (head.toString('latin1', 4, 8) === 'ftyp') {
    // What QuickTime alone understands is found when it is played; that it is no video at all is found here.
    return /^(avif|avis|mif1|heic|heix)$/.test(head.toString('latin1', 8, 12)) ? 'is a picture, no video.' : null;
  }
  return head.readUInt32BE(0) === 0x1a45dfa3 ? null : 'is no video that browsers can play: use MP4 or WebM.';
}

/** WAVE, MPEG audio with or without a tag, Ogg, FLAC, MP4 and WebM: what browsers decode by their first bytes. */
function wrongSound(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  const text = head.toString('latin1');
  const isMpeg = text.startsWith('ID3') || (head.readUInt16BE(0) & 0xffe0) === 0xffe0;
  const isWave = text.startsWith('RIFF') && text.slice(8, 12) === 'WAVE';
  const isOther = text.startsWith('OggS') || text.startsWith('fLaC') || text.slice(4, 8) === 'ftyp' || head.readUInt32BE(0) === 0x1a45dfa3;
  return isMpeg || isWave || isOther ? null : 'is no sound that browsers can play: use MP3, M4A, WAV, OGG or FLAC.';
}

function wrongPanorama(head: Buffer, size: number): string | null {
  const isRadiance = head.toString('latin1', 0, 2) === '#?' || head.readUInt32LE(0) === 20000630;
  if (isRadiance || wrongPicture(head, size) === null) return null;
  return size === 0 ? 'is empty.' : 'is no panorama: use Radiance HDR, OpenEXR, JPEG, PNG or WebP.';
}

const WRONG: Readonly<Record<AssetKind, (head: Buffer, size: number) => string | null>> = {
  image: wrongPicture,
  model: wrongModel,
  video: wrongVideo,
  audio: wrongSound,
  environment: wrongPanorama,
};

const PICTURES: readonly ((head: Buffer) => boolean)[] = [
  (head) => head.toString('latin1', 0, 8) === '\x89PNG\r\n\x1a\n',
  (head) => head.readUInt16BE(0) === 0xffd8,
  (head) => head.toString('latin1', 0, 4) === 'RIFF' && head.toString('latin1', 8, 12) === 'WEBP',
  (head) => head.toString('latin1', 0, 4) === 'GIF8',
  (head) => head.toString('latin1', 4, 8) === 'ftyp' && /^(avif|avis|mif1)$/.test(head.toString('latin1', 8, 12)),
  (head) => head.toString('latin1', 0, 2) === 'BM',
];

function wrongPicture(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  return PICTURES.some((is) => is(head)) ? null : 'is no picture that browsers can show: use PNG, JPEG, WebP, AVIF or GIF.';
}
