import { rm } from 'node:fs/promises';
import { join } from 'node:path';
import {
  CAPTURE_FILE,
  CaptureError,
  type CaptureMesh,
  captureMeshFile,
  meshCounts,
  readCapture,
  readCaptureMesh,
} from '../../../nodes/kit/capture.ts';
import { errorCode, readRefusal, refusal } from '../file-errors.ts';
import { readBytes, readText } from '../read-file.ts';
import { writeWhole } from '../write-whole.ts';

const MAX_DOCUMENT_BYTES = 2 ** 24;
const MAX_MESH_BYTES = 2 ** 28;

/** Triangles before and after. */
export interface SimplifiedCapture {
  readonly before: number;
  readonly after: number;
}

/**
 * Replaces the mesh of an imported capture. The new mesh is a file of its own until the document names it, so that an interrupt leaves the
 * capture as it was.
 *
 * @param folder `assets/NAME.capture` of a project.
 * @throws SCR004, SCR060, SCR062, SCR069
 */
export async function simplifyCapture(folder: string, simplify: (mesh: CaptureMesh) => Promise<CaptureMesh>): Promise<SimplifiedCapture> {
  const path = join(folder, CAPTURE_FILE);
  try {
    const document = readCapture(await readText(path, MAX_DOCUMENT_BYTES));
    const old = document.mesh.file;
    const before = readCaptureMesh(document.mesh, (await readBytes(join(folder, old), MAX_MESH_BYTES)).buffer);
    const mesh = await simplify(before);
    const counts = meshCounts(mesh);
    const file = old === `mesh-${counts.triangleCount}.bin` ? 'mesh.bin' : `mesh-${counts.triangleCount}.bin`;
    await writeWhole(join(folder, file), captureMeshFile(mesh));
    const next = { ...document, mesh: { file, ...counts } };
    await writeWhole(path, new TextEncoder().encode(`${JSON.stringify(next, null, 1)}\n`));
    await rm(join(folder, old), { force: true });
    return { before: before.indices.length / 3, after: counts.triangleCount };
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR069', `${folder} cannot be simplified: ${error.message}.`);
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}
