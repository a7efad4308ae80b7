import { rm } from 'node:fs/promises';
import { join } from 'node:path';
import { IMPORT_FILE } from '../../../export/captures/report/import-record.ts';
import {
  CAPTURE_FILE,
  type CaptureDocument,
  CaptureError,
  type CaptureMesh,
  type CaptureView,
  captureMeshFile,
  meshCounts,
} from '../../../nodes/kit/capture.ts';
import { resolveInside } from '../confine.ts';
import { errorCode, readRefusal, refusal } from '../file-errors.ts';
import type { FileLayer } from '../file-layer.ts';
import { writePageFolder } from '../page-folder.ts';
import { readCaptureWithMesh } from '../read-capture.ts';
import { readBytes } from '../read-file.ts';
import { writeWhole } from '../write-whole.ts';

const MAX_VIEW_BYTES = 2 ** 28;

/** Triangles before and after. */
export interface SimplifiedCapture {
  readonly before: number;
  readonly after: number;
}

interface SimplerCapture extends SimplifiedCapture {
  readonly document: CaptureDocument;
  /** The file of the mesh before, in the folder. */
  readonly old: string;
  /** The content of the new one, which the document names. */
  readonly mesh: Uint8Array<ArrayBuffer>;
}

type Simplify = (mesh: CaptureMesh) => Promise<CaptureMesh>;

/**
 * Replaces the mesh of an imported capture. The new mesh is a file of its own until the document names it, so that an interrupt leaves the
 * capture as it was.
 *
 * @param folder `assets/NAME.capture` of a project.
 * @throws SCR004, SCR060, SCR062, SCR069
 */
export async function simplifyCapture(folder: string, simplify: Simplify): Promise<SimplifiedCapture> {
  const { document, old, mesh, before, after } = await simplerCapture(folder, simplify);
  await writeWhole(join(folder, document.mesh.file), mesh);
  await writeWhole(join(folder, CAPTURE_FILE), documentBytes(document));
  await rm(join(folder, old), { force: true });
  return { before, after };
}

/**
 * Copies a capture with a simpler mesh.
 *
 * @param folder `assets/NAME.capture` of a project.
 * @param out The new folder.
 * @throws SCR004, SCR031, SCR060, SCR062, SCR069
 */
export async function copySimplified(folder: string, out: string, files: FileLayer, simplify: Simplify): Promise<SimplifiedCapture> {
  const { document, mesh, before, after } = await simplerCapture(folder, simplify);
  await writePageFolder(out, files, async (sink) => {
    for (const file of document.views.flatMap(filesOf)) {
      const bytes = await readBytes(await resolveInside(folder, file), MAX_VIEW_BYTES).catch((error: unknown) => {
        throw readRefusal(error, join(folder, file));
      });
      await sink.write(file, bytes);
    }
    const record = join(folder, IMPORT_FILE);
    const recorded = await readBytes(record, MAX_VIEW_BYTES).catch((error: unknown) => {
      if (errorCode(error) === 'ENOENT') return null;
      throw readRefusal(error, record);
    });
    if (recorded !== null) await sink.write(IMPORT_FILE, recorded);
    await sink.write(document.mesh.file, mesh);
    await sink.write(CAPTURE_FILE, documentBytes(document));
    return true;
  });
  return { before, after };
}

/** The mesh of a capture. @throws SCR004, SCR069 */
export async function readMeshOfCapture(folder: string): Promise<CaptureMesh> {
  return reading(folder, async () => (await readCaptureWithMesh(folder)).mesh);
}

function filesOf({ file, depth, depthMesh, hiddenMesh }: CaptureView): readonly string[] {
  return [file, ...[depth, depthMesh, hiddenMesh].flatMap((more) => more?.file ?? [])];
}

function documentBytes(document: CaptureDocument): Uint8Array {
  return new TextEncoder().encode(`${JSON.stringify(document, null, 1)}\n`);
}

function simplerCapture(folder: string, simplify: Simplify): Promise<SimplerCapture> {
  return reading(folder, async () => {
    const { document, mesh: before } = await readCaptureWithMesh(folder);
    const mesh = await simplify(before);
    const counts = meshCounts(mesh);
    const old = document.mesh.file;
    const file = old === `mesh-${counts.triangleCount}.bin` ? 'mesh.bin' : `mesh-${counts.triangleCount}.bin`;
    return {
      document: { ...document, mesh: { file, ...counts } },
      old,
      mesh: captureMeshFile(mesh),
      before: before.indices.length / 3,
      after: counts.triangleCount,
    };
  });
}

async function reading<T>(folder: string, read: () => Promise<T>): Promise<T> {
  try {
    return await read();
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR069', `${folder} cannot be simplified: ${error.message}.`);
    throw errorCode(error) === undefined ? error : readRefusal(error, join(folder, CAPTURE_FILE));
  }
}
