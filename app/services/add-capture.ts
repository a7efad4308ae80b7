import { randomInt } from 'node:crypto';
import { readdir } from 'node:fs/promises';
import { basename, dirname, resolve } from 'node:path';
import { unitWarning } from '../../export/captures/plausible.ts';
import { reprojectionErrorPx } from '../../export/captures/source-view.ts';
import { type Axis, upAxis, uprightMesh, uprightPose } from '../../export/captures/upright.ts';
import { putAsset } from '../../export/graph/commands/asset-commands.ts';
import { makeAssetId } from '../../export/graph/document-names.ts';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { CAPTURE_FILE, type CaptureDocument, CaptureError, type CaptureMesh, type CaptureView } from '../../nodes/kit/capture.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { resolveInside } from './confine.ts';
import { refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { packPhoto } from './pack-photo.ts';
import { writePageFolder } from './page-folder.ts';
import { ASSETS_FOLDER, revisionOf } from './project-files.ts';
import { type FoundView, readCaptureFolder } from './read-capture-folder.ts';
import { readBytes } from './read-file.ts';
import { readConsistentFiles } from './recover-folder.ts';
import { saveOver } from './save-over.ts';

export interface CaptureJob {
  /** Folder with photographs, cameras and mesh. */
  readonly folder: string;
  /** Real path of the project. */
  readonly root: string;
  /** Name of the capture; null: that of the folder. */
  readonly name: string | null;
  /** Photographs are reduced to this longest side, pixels. */
  readonly maxSidePx: number;
  /** The axis of the reconstruction that points up; null: estimated. */
  readonly up: Axis | null;
  /** Meters per unit of the reconstruction. */
  readonly metersPerUnit: number;
  readonly files: FileLayer;
  /** Receives progress texts. */
  readonly say: (text: string) => void;
  readonly interrupted: AbortSignal;
}

/** What was imported. */
export interface ImportedCapture {
  /** Path of the capture in the project. */
  readonly path: string;
  readonly asset: string;
  /** The files that it was made from, such as `COLMAP (text)`. */
  readonly form: string;
  readonly up: Axis;
  readonly views: readonly ImportedView[];
  readonly pointCount: number;
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** Size of the mesh along x, y and z, meters. */
  readonly sizeM: readonly number[];
  readonly fileBytes: number;
  readonly diagnostics: readonly Diagnostic[];
}

export interface ImportedView {
  readonly photo: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Mean reprojection error in pixels of the photograph; null if the files have no points. */
  readonly errorPx: number | null;
  /** Number of points that the error is measured with. */
  readonly points: number;
}

/**
 * Imports photographs with their cameras and mesh into `assets/NAME.capture/` of a project, whole or not at all, and adds the asset.
 *
 * @throws SCR004, SCR060, SCR062, SCR069
 */
export async function importCapture(job: CaptureJob): Promise<ImportedCapture> {
  try {
    return await importWhole(job);
  } catch (error) {
    if (!(error instanceof CaptureError)) throw error;
    throw refusal('SCR069', `${job.folder} cannot be imported: ${error.message}.`);
  }
}

async function importWhole(job: CaptureJob): Promise<ImportedCapture> {
  const { folder, root, files, say, interrupted } = job;
  say('Reading cameras and mesh…');
  const { source, views, mesh, diagnostics } = await readCaptureFolder(resolve(folder));
  const up = job.up ?? upAxis(views.map(({ view }) => view.worldFromCamera));
  uprightMesh(mesh, up, job.metersPerUnit);
  const sizeM = sizeOf(mesh);
  const unit = unitWarning(sizeM);
  const path = await freePath(root, job.name ?? basename(resolve(folder)));
  let fileBytes = 0;
  await writePageFolder(await resolveInside(root, path), files, async (sink) => {
    const write = async (file: string, bytes: Uint8Array): Promise<void> => {
      fileBytes += bytes.length;
      await sink.write(file, bytes);
    };
    const packed: CaptureView[] = [];
    for (const [i, { file, lens, view }] of views.entries()) {
      interrupted.throwIfAborted();
      say(`Packing photographs (${i + 1} of ${views.length})…`);
      const { bytes, extension, pinhole } = packPhoto(await readBytes(file, MAX_PHOTO_BYTES), view.name, lens, job.maxSidePx);
      const name = `views/${String(i).padStart(3, '0')}${extension}`;
      await write(name, bytes);
      packed.push({ file: name, ...pinhole, worldFromCamera: uprightPose(view.worldFromCamera, up, job.metersPerUnit) });
    }
    const meshBytes = meshFile(mesh);
    await write(MESH_FILE, meshBytes);
    const counts = { vertexCount: mesh.positions.length / 3, triangleCount: mesh.indices.length / 3 };
    const document: CaptureDocument = {
      format: 'scrim-capture',
      version: 1,
      mesh: { file: MESH_FILE, ...counts },
      views: packed,
    };
    await write(CAPTURE_FILE, new TextEncoder().encode(`${JSON.stringify(document, null, 1)}\n`));
    return true;
  });
  return {
    path: `${path}/${CAPTURE_FILE}`,
    asset: await addToProject(job, `${path}/${CAPTURE_FILE}`),
    form: source.form,
    up,
    views: views.map(reportOf),
    pointCount: source.pointCount,
    vertexCount: mesh.positions.length / 3,
    triangleCount: mesh.indices.length / 3,
    sizeM,
    fileBytes,
    diagnostics: unit === null ? diagnostics : [...diagnostics, { code: 'SCR069', severity: 'warning', message: unit }],
  };
}

const MESH_FILE = 'mesh.bin';
const MAX_PHOTO_BYTES = 256 * 2 ** 20;

function reportOf({ view, lens }: FoundView): ImportedView {
  return {
    photo: view.name,
    widthPx: lens.widthPx,
    heightPx: lens.heightPx,
    errorPx: reprojectionErrorPx(view, lens),
    points: view.observations.length / 5,
  };
}

function meshFile({ positions, indices }: CaptureMesh): Uint8Array {
  const bytes = new Uint8Array(positions.byteLength + indices.byteLength);
  bytes.set(new Uint8Array(positions.buffer, positions.byteOffset, positions.byteLength));
  bytes.set(new Uint8Array(indices.buffer, indices.byteOffset, indices.byteLength), positions.byteLength);
  return bytes;
}

function sizeOf({ positions }: CaptureMesh): readonly number[] {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const x = positions[i] ?? 0;
    least[i % 3] = Math.min(least[i % 3] ?? x, x);
    most[i % 3] = Math.max(most[i % 3] ?? x, x);
  }
  return most.map((x, i) => x - (least[i] ?? 0));
}

/** A path in `assets/` that is free: `NAME.capture`, or with a number. */
async function freePath(root: string, name: string): Promise<string> {
  const stem = name
    .replace(/[^A-Za-z0-9_-]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 80);
  const taken = new Set(await readdir(await resolveInside(root, ASSETS_FOLDER)).catch(() => []));
  for (let number = 1; ; number++) {
    const folder = `${stem || 'capture'}${number === 1 ? '' : `-${number}`}.capture`;
    if (!taken.has(folder)) return `${ASSETS_FOLDER}/${folder}`;
  }
}

/** Adds the capture to the asset table of the project. Returns its id. */
async function addToProject({ root, files }: CaptureJob, path: string): Promise<string> {
  const texts = await readConsistentFiles(root, files);
  const { output: project, diagnostics } = loadProject(texts);
  const [problem] = diagnostics;
  if (project === null) throw refusal(problem?.code ?? 'SCR002', problem?.message ?? 'The project is damaged.');
  const id = makeAssetId(project, dirname(path), () => randomInt(2 ** 32) / 2 ** 32);
  const next = saveProject(putAsset(project, { id, asset: { path, kind: 'capture' } }).project);
  await saveOver({ root, next, loaded: new Set(Object.keys(texts.sources)), revision: revisionOf(texts), files });
  return id;
}
