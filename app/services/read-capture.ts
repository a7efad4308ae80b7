import { join } from 'node:path';
import { CAPTURE_FILE, type CaptureDocument, type CaptureMesh, readCapture, readCaptureMesh } from '../../nodes/kit/capture.ts';
import { resolveInside } from './confine.ts';
import { readBytes, readText } from './read-file.ts';

/** The largest document of a capture, and the largest record of its import. */
export const MAX_CAPTURE_TEXT_BYTES = 2 ** 24;
const MAX_MESH_BYTES = 2 ** 28;

/**
 * Reads the document of a capture.
 *
 * @param folder Real path of `assets/NAME.capture`.
 * @throws CaptureError if it is damaged; system errors if it cannot be read.
 */
export async function readCaptureDocument(folder: string): Promise<CaptureDocument> {
  return readCapture(await readText(join(folder, CAPTURE_FILE), MAX_CAPTURE_TEXT_BYTES));
}

/**
 * Reads the document and the mesh of a capture.
 *
 * @param folder Real path of `assets/NAME.capture`.
 * @throws CaptureError if one is damaged; SCR031; system errors if one cannot be read.
 */
export async function readCaptureWithMesh(folder: string): Promise<{ readonly document: CaptureDocument; readonly mesh: CaptureMesh }> {
  const document = await readCaptureDocument(folder);
  const { buffer } = await readBytes(await resolveInside(folder, document.mesh.file), MAX_MESH_BYTES);
  return { document, mesh: readCaptureMesh(document.mesh, buffer) };
}
