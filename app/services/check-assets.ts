import { constants } from 'node:fs';
import { open } from 'node:fs/promises';
import type { Asset } from '../../export/graph/project.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import { resolveInside } from './confine.ts';
import { errorCode } from './file-errors.ts';

/**
 * What can be said of a project's asset files without decoding them: missing (SCR030), outside (SCR031), cut off or not what
 * they claim to be (SCR032). What `used` names is an error, everything else a warning, because nothing on screen needs it.
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

type Problem = Pick<Diagnostic, 'code' | 'message' | 'fix'>;

/** Enough for every signature below. */
const HEAD_BYTES = 16;

async function problemOf(root: string, { path, kind }: Asset): Promise<Problem | null> {
  try {
    const file = await open(await resolveInside(root, path), constants.O_RDONLY | (constants.O_NOFOLLOW ?? 0));
    try {
      const { size } = await file.stat();
      const head = Buffer.alloc(HEAD_BYTES);
      await file.read(head, 0, HEAD_BYTES, 0);
      const wrong = kind === 'model' ? wrongModel(head, size) : wrongPicture(head, size);
      return wrong === null ? null : { code: 'SCR032', message: `${path} ${wrong}`, fix: 'Export it again, or choose another file.' };
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
