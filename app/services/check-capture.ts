import type { FileHandle } from 'node:fs/promises';
import { DAMAGED_CAPTURE_FIX, meshesOfCapture, type PieceCheck } from '../../export/captures/file-faults.ts';
import { type CaptureDocument, CaptureError, readCapture } from '../../nodes/kit/capture.ts';
import { type AssetProblem, fileProblem } from './asset-problem.ts';
import { imageFileFault } from './check-image-files.ts';
import { resolveInside } from './confine.ts';
import { openFile, statFile } from './read-file.ts';

/**
 * Checks the document of a capture in a project, and whether its files are there.
 *
 * @param root Real path of the project.
 * @param path Path of the document in the project.
 * @param text The document.
 */
export async function captureProblem(root: string, path: string, text: string): Promise<AssetProblem | null> {
  try {
    const folder = path.slice(0, path.lastIndexOf('/') + 1);
    return await captureFilesProblem(readCapture(text), folder, async (file) => resolveInside(root, folder + file));
  } catch (error) {
    if (!(error instanceof CaptureError)) throw error;
    const message = `${path} is not a valid capture: ${error.message}.`;
    return { code: 'SCR032', message, fix: 'Export it again, or choose another file.' };
  }
}

/** Meshes are read in pieces of this size. */
const PIECE_BYTES = 2 ** 20;

/**
 * The first file of a capture that is missing, is no file, or is damaged: a mesh of another size than its document says or with numbers that no
 * mesh has, or a photograph that is empty or cut off. One file at a time is read. Files of depth are not needed to draw it.
 *
 * @param folder What messages begin paths with; ends in `/`.
 * @param resolve Gives the absolute path of a file of the capture.
 */
export async function captureFilesProblem(document: CaptureDocument, folder: string, resolve: Resolve): Promise<AssetProblem | null> {
  const files = filesOf(document);
  const sizes = await Promise.all(files.map(({ file, bytes }) => problemOf(folder + file, () => sizeFault(resolve, file, bytes))));
  const wrongSize = sizes.find((problem) => problem !== null);
  if (wrongSize) return wrongSize;
  for (const { file, faultOf } of files) {
    const problem = await problemOf(folder + file, () => contentFault(resolve, file, faultOf));
    if (problem !== null) return problem;
  }
  return null;
}

type Resolve = (file: string) => Promise<string>;
type FaultOf = (file: FileHandle, size: number) => Promise<string | null>;

interface CheckedFile {
  readonly file: string;
  /** The size that it must have; null if every size but 0 is valid. */
  readonly bytes: number | null;
  readonly faultOf: FaultOf;
}

function filesOf(document: CaptureDocument): readonly CheckedFile[] {
  const meshes = meshesOfCapture(document).map(({ mesh, bytes, check }) => ({
    file: mesh.file,
    bytes,
    faultOf: (file: FileHandle) => meshFault(file, check()),
  }));
  return [...meshes, ...document.views.map(({ file }) => ({ file, bytes: null, faultOf: imageFileFault }))];
}

/** `fault` gives the predicate of a message. */
async function problemOf(path: string, fault: () => Promise<string | null>): Promise<AssetProblem | null> {
  try {
    const found = await fault();
    return found === null ? null : { code: 'SCR032', message: `${path} ${found}`, fix: DAMAGED_CAPTURE_FIX };
  } catch (error) {
    return fileProblem(error, path);
  }
}

async function sizeFault(resolve: Resolve, file: string, bytes: number | null): Promise<string | null> {
  const { size } = await statFile(await resolve(file));
  if (bytes !== null && size !== bytes) return `has ${size} bytes, but capture.json says ${bytes}.`;
  return size === 0 ? 'is empty.' : null;
}

async function contentFault(resolve: Resolve, file: string, faultOf: FaultOf): Promise<string | null> {
  const opened = await openFile(await resolve(file));
  try {
    return await faultOf(opened, (await opened.stat()).size);
  } finally {
    await opened.close();
  }
}

async function meshFault(file: FileHandle, check: PieceCheck): Promise<string | null> {
  const piece = Buffer.alloc(PIECE_BYTES);
  for (;;) {
    let length = 0;
    // A read may give less than was asked for.
    for (let read = -1; read !== 0 && length < PIECE_BYTES; length += read) {
      read = (await file.read(piece, length, PIECE_BYTES - length)).bytesRead;
    }
    const fault = check(piece.subarray(0, length));
    if (fault !== null || length < PIECE_BYTES) return fault;
  }
}
