import type { FileHandle } from 'node:fs/promises';
import type { Asset } from '../../export/graph/project.ts';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { SplatError } from '../../nodes/kit/splats/splats.ts';
import { type AssetProblem, fileProblem } from './asset-problem.ts';
import { captureProblem } from './check-capture.ts';
import { exrFault, imageFileFault, radianceFault } from './check-image-files.ts';
import { countSplats, manySplats } from './check-splats.ts';
import { mp4Fault, webmFault } from './check-video-files.ts';
import { resolveInside } from './confine.ts';
import { openFile } from './read-file.ts';

/**
 * Checks asset files without decoding them: missing (SCR030), outside the project (SCR031), truncated, of invalid size, or of another
 * format (SCR032). Files in `used` give errors, others warnings. Warns about slow downloads of videos and panoramas (SCR034); models
 * are checked when they are read.
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

/** Number of bytes that are read from the start of a file: enough for all signatures below. */
const HEAD_BYTES = 16;

async function problemOf(root: string, { path, kind }: Asset): Promise<AssetProblem | null> {
  try {
    const file = await openFile(await resolveInside(root, path));
    try {
      const { size } = await file.stat();
      const head = Buffer.alloc(HEAD_BYTES);
      await file.read(head, 0, HEAD_BYTES, 0);
      const wrong = WRONG[kind](head, size) ?? (await contentFault(file, kind, head, size));
      const fix = kind === 'capture' ? 'Import its photographs again.' : 'Export it again, or choose another file.';
      if (wrong !== null) return { code: 'SCR032', message: `${path} ${wrong}`, fix };
      if (kind === 'capture') return await captureProblem(root, path, await file.readFile('utf8'));
      if (kind === 'splats') return await splatProblem(file, path, size);
      return tooLarge(path, kind, size);
    } finally {
      await file.close();
    }
  } catch (error) {
    return fileProblem(error, path);
  }
}

/** Checks the content after a valid header. Models are checked later (`check-models.ts`). */
async function contentFault(file: FileHandle, kind: AssetKind, head: Buffer, size: number): Promise<string | null> {
  switch (kind) {
    case 'image':
      return imageFileFault(file, size);
    case 'environment':
      if (isRadiance(head)) return radianceFault(file, size);
      return isExr(head) ? exrFault(file, size) : imageFileFault(file, size);
    case 'video':
      return isEbml(head) ? webmFault(file, size) : mp4Fault(file, size);
    case 'audio':
    case 'model':
    // Captures and splats are checked below.
    case 'capture':
    case 'splats':
      return null;
  }
}

/**
 * Checks the header of a .glb file (glTF 2.0, §4.4): magic, version, length. JSON starts with a brace and is checked when it is
 * loaded.
 */
function wrongModel(head: Buffer, size: number): string | null {
  if (head.toString('latin1', 0, 4) !== 'glTF') return /^\s*\{/.test(head.toString('latin1')) ? null : 'is not a glTF model.';
  if (size < 20) return 'is incomplete: it contains only a header.';
  const version = head.readUInt32LE(4);
  if (version !== 2) return `is glTF version ${version}; only version 2 can be read.`;
  const length = head.readUInt32LE(8);
  return size >= length ? null : `is incomplete: it has ${size} of ${length} bytes.`;
}

/** Limits in bytes of what visitors download. Videos are loaded completely, so that they can seek and play offline. */
const LARGE: Readonly<Record<AssetKind, { readonly bytes: number; readonly fix: string } | null>> = {
  image: null,
  model: null,
  audio: null,
  capture: null,
  splats: null,
  video: { bytes: 40 * 2 ** 20, fix: 'Shorten it, reduce its size, or lower its bit rate.' },
  environment: { bytes: 16 * 2 ** 20, fix: 'Reduce its size: 2048 × 1024 is enough for light, 4096 × 2048 for a visible background.' },
};

function tooLarge(path: string, kind: AssetKind, size: number): AssetProblem | null {
  const large = LARGE[kind];
  if (large === null || size <= large.bytes) return null;
  const { bytes, fix } = large;
  const message = `${path} has ${Math.round(size / 2 ** 20)} MB; above ${bytes / 2 ** 20} MB visitors wait long.`;
  return { code: 'SCR034', severity: 'warning', message, fix };
}

async function splatProblem(file: FileHandle, path: string, size: number): Promise<AssetProblem | null> {
  try {
    const many = manySplats(await countSplats(file, path, size));
    return many && { code: 'SCR034', severity: 'warning', message: `${path} ${many.message}`, fix: many.fix };
  } catch (error) {
    if (!(error instanceof SplatError)) throw error;
    return { code: 'SCR032', message: `${path} cannot be shown: ${error.message}.`, fix: error.fix };
  }
}

/** Checks the header of a video (ISO 14496-12, §4.3; RFC 8794, §11.2). */
function wrongVideo(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  if (head.toString('latin1', 4, 8) === 'ftyp') {
    // Formats that only QuickTime plays are found during playback. Images in the same container are found here.
    return /^(avif|avis|mif1|heic|heix)$/.test(head.toString('latin1', 8, 12)) ? 'is an image, not a video.' : null;
  }
  return isEbml(head) ? null : 'is not a video that browsers can play. Use MP4 or WebM.';
}

/** Checks the signature of a sound: WAVE, MPEG audio with or without a tag, Ogg, FLAC, MP4 or WebM. */
function wrongSound(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  const text = head.toString('latin1');
  const isMpeg = text.startsWith('ID3') || (head.readUInt16BE(0) & 0xffe0) === 0xffe0;
  const isWave = text.startsWith('RIFF') && text.slice(8, 12) === 'WAVE';
  const isOther = text.startsWith('OggS') || text.startsWith('fLaC') || text.slice(4, 8) === 'ftyp' || isEbml(head);
  return isMpeg || isWave || isOther ? null : 'is not audio that browsers can play. Use MP3, M4A, WAV, OGG or FLAC.';
}

function wrongPanorama(head: Buffer, size: number): string | null {
  if (isRadiance(head) || isExr(head) || wrongImage(head, size) === null) return null;
  return size === 0 ? 'is empty.' : 'is not a panorama. Use Radiance HDR, OpenEXR, JPEG, PNG, WebP or AVIF.';
}

function isRadiance(head: Buffer): boolean {
  return head.toString('latin1', 0, 2) === '#?';
}

function isExr(head: Buffer): boolean {
  return head.readUInt32LE(0) === 20000630;
}

function isEbml(head: Buffer): boolean {
  return head.readUInt32BE(0) === 0x1a45dfa3;
}

const WRONG: Readonly<Record<AssetKind, (head: Buffer, size: number) => string | null>> = {
  image: wrongImage,
  model: wrongModel,
  video: wrongVideo,
  audio: wrongSound,
  environment: wrongPanorama,
  splats: (_, size) => (size === 0 ? 'is empty.' : null),
  capture: (head, size) => (size < MAX_CAPTURE_BYTES && head.toString('latin1').startsWith('{') ? null : 'is not a capture.'),
};

/** A document of the most views has a third of it. */
const MAX_CAPTURE_BYTES = 4 * 2 ** 20;

const IMAGES: readonly ((head: Buffer) => boolean)[] = [
  (head) => head.toString('latin1', 0, 8) === '\x89PNG\r\n\x1a\n',
  (head) => head.readUInt16BE(0) === 0xffd8,
  (head) => head.toString('latin1', 0, 4) === 'RIFF' && head.toString('latin1', 8, 12) === 'WEBP',
  (head) => head.toString('latin1', 0, 4) === 'GIF8',
  (head) => head.toString('latin1', 4, 8) === 'ftyp' && /^(avif|avis|mif1)$/.test(head.toString('latin1', 8, 12)),
  (head) => head.toString('latin1', 0, 2) === 'BM',
];

function wrongImage(head: Buffer, size: number): string | null {
  if (size === 0) return 'is empty.';
  return IMAGES.some((is) => is(head)) ? null : 'is not an image that browsers can show. Use PNG, JPEG, WebP, AVIF or GIF.';
}
