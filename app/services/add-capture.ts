import { randomInt } from 'node:crypto';
import { basename, dirname, resolve } from 'node:path';
import type { FileSink } from '../../export/bundle/bundle-page.ts';
import type { DepthScale } from '../../export/captures/depth/depth-scale.ts';
import { createDepthFusion } from '../../export/captures/depth/fuse-depth-meshes.ts';
import { DOME_EYE_M, DOME_RADIUS_M, makeDomeMesh } from '../../export/captures/dome-mesh.ts';
import { unitWarning } from '../../export/captures/plausible.ts';
import { sizeOfMesh } from '../../export/captures/report/capture-report.ts';
import { IMPORT_FILE, importRecordFile, MOST_PLACES, type RecordedView } from '../../export/captures/report/import-record.ts';
import type { ScaleSource } from '../../export/captures/report/scale-source.ts';
import { reprojectedPlaces, reprojectionErrorPx } from '../../export/captures/source-view.ts';
import { type Axis, upAxis, uprightMesh, uprightPose } from '../../export/captures/upright.ts';
import { putAsset } from '../../export/graph/commands/asset-commands.ts';
import { makeAssetId } from '../../export/graph/document-names.ts';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import {
  CAPTURE_FILE,
  type CaptureDocument,
  CaptureError,
  type CaptureMesh,
  type CaptureView,
  captureMeshFile,
  meshCounts,
} from '../../nodes/kit/capture.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { findDepths, readDepthM } from './capture-depths.ts';
import { type ScaleJob, scaleOfCapture } from './capture-scale.ts';
import { resolveInside } from './confine.ts';
import { refusal } from './file-errors.ts';
import { withFreeCapture } from './free-capture.ts';
import { heightAboveFloorM, packDepthFiles } from './pack-depth.ts';
import { type PackedPhotos, type PackingJob, withPackedPhotos } from './pack-photos.ts';
import { writePageFolder } from './page-folder.ts';
import { revisionOf } from './project-files.ts';
import { type FoundCapture, type FoundView, PANORAMA_FORM, readCaptureFolder } from './read-capture-folder.ts';
import { readConsistentFiles } from './recover-folder.ts';
import { saveOver } from './save-over.ts';

export interface CaptureJob extends PackingJob, ScaleJob {
  /** Name of the capture; null: that of the folder. */
  readonly name: string | null;
  /** The axis of the reconstruction that points up; null: estimated. */
  readonly up: Axis | null;
  /** Makes the mesh of the folder smaller; absent: it stays as it is. */
  readonly simplify?: (mesh: CaptureMesh) => Promise<CaptureMesh>;
  /** Names of the photographs whose cameras were searched; absent: those in the folder. */
  readonly searched?: readonly string[];
  /** Warnings from before, which are recorded with those of the import. */
  readonly warnings?: readonly Diagnostic[];
  /** Receives progress texts. */
  readonly say: (text: string) => void;
}

/** What was packed. */
export interface PackedCapture {
  /** Path of the capture in the project. */
  readonly path: string;
  /** The files that it was made from, such as `COLMAP (text)`. */
  readonly form: string;
  readonly up: Axis;
  /** Meters per unit of the reconstruction. */
  readonly metersPerUnit: number;
  readonly scale: ScaleSource;
  readonly views: readonly ImportedView[];
  readonly pointCount: number;
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** What the depth files have; null without them. */
  readonly depth: (Pick<DepthScale, 'unit' | 'kind'> & { readonly count: number }) | null;
  /** Triangles of all depth meshes together. */
  readonly depthTriangles: number;
  /** Size of the mesh along x, y and z, meters. */
  readonly sizeM: readonly number[];
  readonly fileBytes: number;
  readonly diagnostics: readonly Diagnostic[];
}

/** What was imported. */
export interface ImportedCapture extends PackedCapture {
  /** Its id in the asset table. */
  readonly asset: string;
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
 * After an interrupt, the same call continues with the photographs that are not packed yet.
 *
 * @throws SCR004, SCR060, SCR062, SCR066 if another process imports a capture of the same name, SCR069
 */
export async function importCapture(job: CaptureJob): Promise<ImportedCapture> {
  const packed = await packCapture(job);
  return { ...packed, asset: await addToProject(job, packed.path) };
}

/**
 * Packs photographs with their cameras and mesh into `assets/NAME.capture/` of a project, as `importCapture` does, and leaves the asset
 * table to the caller.
 */
export async function packCapture(job: CaptureJob): Promise<PackedCapture> {
  const { root, files, name, folder } = job;
  try {
    return await withFreeCapture(root, name ?? basename(resolve(folder)), files, (path) => packWhole(job, path));
  } catch (error) {
    if (!(error instanceof CaptureError)) throw error;
    throw refusal('SCR069', `${job.folder} cannot be imported: ${error.message}.`);
  }
}

async function packWhole(job: CaptureJob, path: string): Promise<PackedCapture> {
  const { folder, root, files, say, interrupted } = job;
  say('Reading cameras and mesh…');
  const found = await readCaptureFolder(resolve(folder));
  const { source, views, mesh: wholeMesh } = found;
  const diagnostics = [...(job.warnings ?? []), ...found.diagnostics];
  const depths = await findUsedDepths(job, views);
  const missing = views.filter((_, i) => depths[i] == null);
  const hasDepth = depths.some((path) => path !== null);
  const isDome = source.form === PANORAMA_FORM && !wholeMesh && !hasDepth && job.depth.from !== 'files';
  if (isDome) diagnostics.push(DOME);
  const readMesh = isDome ? makeDomeMesh() : wholeMesh;
  const ownMesh = readMesh && job.simplify ? await job.simplify(readMesh) : readMesh;
  if (!ownMesh && !hasDepth) throw new CaptureError(NO_MESH);
  if (job.depth.from === 'files' && !hasDepth) throw new CaptureError('it has no depth files with the names of the photographs');
  if (hasDepth && missing.length > 0) diagnostics.push(withoutDepth(missing.length, missing[0]?.view.name ?? ''));
  const up = job.up ?? upAxis(views.map(({ view }) => view.worldFromCamera));
  const { metersPerUnit, floorM: measuredM, scale: scaleFrom, depth: scale } = await scaleOfCapture(job, found, depths, ownMesh, up);
  const floorM = isDome ? -DOME_EYE_M * metersPerUnit : measuredM;
  if (ownMesh) uprightMesh(ownMesh, up, metersPerUnit, floorM);
  const depth = scale && { unit: scale.unit, kind: scale.kind, count: views.length - missing.length };
  let mesh = ownMesh;
  let sizeM: readonly number[] = [];
  let fileBytes = 0;
  let depthTriangles = 0;
  const target = await resolveInside(root, path);
  const writeAll = async (sink: FileSink, photos: PackedPhotos): Promise<true> => {
    const write = async (file: string, bytes: Uint8Array): Promise<void> => {
      fileBytes += bytes.length;
      await sink.write(file, bytes);
    };
    const packed: CaptureView[] = [];
    const recorded: RecordedView[] = [];
    const fusion = createDepthFusion();
    for (const [i, each] of views.entries()) {
      const { lens, view } = each;
      interrupted.throwIfAborted();
      say(`Packing photographs (${i + 1} of ${views.length})…`);
      const { bytes, extension, pinhole } = await photos.next();
      const name = `views/${String(i).padStart(3, '0')}${extension}`;
      await write(name, bytes);
      const worldFromCamera = uprightPose(view.worldFromCamera, up, metersPerUnit, floorM);
      const depthFile = depths[i] ?? null;
      const map = depthFile === null || scale === null ? null : await readDepthM(depthFile, each, pinhole, scale, metersPerUnit);
      if (map && source.form === PANORAMA_FORM) worldFromCamera[13] = heightAboveFloorM(map) ?? 0;
      // What one photograph does not show, the mesh of the place does, in the colors of others.
      const photo = ownMesh || !map ? null : await photos.decode(bytes, view.name);
      const more = packDepthFiles(map, job.depth.from === 'none' ? null : ownMesh, photo, pinhole, worldFromCamera, i, views.length);
      for (const [name, content] of more.files) await write(name, content);
      depthTriangles += more.members.depthMesh?.triangleCount ?? 0;
      if (!ownMesh && more.fused) fusion.add(more.fused);
      packed.push({ file: name, ...pinhole, worldFromCamera, ...more.members });
      recorded.push({ ...reportOf(each), model: view.model, places: reprojectedPlaces(view, lens, pinhole, MOST_PLACES) });
    }
    mesh ??= fusion.mesh();
    if (mesh.indices.length === 0) throw new CaptureError('its depth files have too few neighboring depths for a surface');
    sizeM = sizeOfMesh(mesh);
    if (!sizeM.every(Number.isFinite)) throw new CaptureError(`its mesh is too large with ${metersPerUnit} meters per unit`);
    const unit = unitWarning(sizeM);
    if (unit !== null) diagnostics.push({ code: 'SCR069', severity: 'warning', message: unit });
    const meshBytes = captureMeshFile(mesh);
    await write(MESH_FILE, meshBytes);
    const document: CaptureDocument = {
      format: 'scrim-capture',
      version: versionOf(packed),
      mesh: { file: MESH_FILE, ...meshCounts(mesh) },
      views: packed,
    };
    const warnings = diagnostics.map(({ message }) => message);
    const { form, pointCount } = source;
    const record = { ...leftOut(found, job), form, up, metersPerUnit, scale: scaleFrom, pointCount, depth, depthTriangles };
    await write(IMPORT_FILE, importRecordFile({ ...record, warnings, views: recorded }));
    await write(CAPTURE_FILE, new TextEncoder().encode(`${JSON.stringify(document, null, 1)}\n`));
    return true;
  };
  await withPackedPhotos(job, views, (photos) => writePageFolder(target, files, (sink) => writeAll(sink, photos)));
  if (!mesh) throw new Error('The capture has no mesh.');
  return {
    path: `${path}/${CAPTURE_FILE}`,
    form: source.form,
    up,
    metersPerUnit,
    scale: scaleFrom,
    views: views.map(reportOf),
    pointCount: source.pointCount,
    vertexCount: mesh.positions.length / 3,
    triangleCount: mesh.indices.length / 3,
    depth,
    depthTriangles,
    sizeM,
    fileBytes,
    diagnostics,
  };
}

async function findUsedDepths({ folder, depth }: CaptureJob, views: readonly FoundView[]): Promise<readonly (string | null)[]> {
  if (depth.from === 'mesh' || depth.from === 'none') return views.map(() => null);
  return findDepths(resolve(folder), views);
}

function withoutDepth(count: number, name: string): Diagnostic {
  const photographs = count === 1 ? '1 photograph has' : `${count} photographs have`;
  return { code: 'SCR069', severity: 'warning', message: `${photographs} no depth, such as ${name}.` };
}

const DOME: Diagnostic = {
  code: 'SCR069',
  severity: 'warning',
  message: `It is one 360° photograph without depth. So its floor is ${DOME_EYE_M} m below the camera, and all else is ${DOME_RADIUS_M} m away. With depth or a mesh, things are where they were.`,
};
const NO_MESH =
  'it has neither a mesh (.ply, .obj, .glb or .gltf) nor depth of its photographs. Make a mesh, as with COLMAP’s poisson_mesher, and put it into the folder';
const MESH_FILE = 'mesh.bin';

/** What the import leaves out, by name. */
function leftOut({ source, withoutPhotograph, withoutCamera }: FoundCapture, { searched }: CaptureJob) {
  const hasCamera = new Set(source.views.map(({ name }) => name));
  return { withoutPhotograph, withoutCamera: searched?.filter((name) => !hasCamera.has(name)) ?? withoutCamera };
}

/** The oldest version of the format that has all that the views have. */
function versionOf(views: readonly CaptureView[]): CaptureDocument['version'] {
  if (views.some(({ file }) => file.endsWith('.avif'))) return 4;
  if (views.some(({ hiddenMesh }) => hiddenMesh)) return 3;
  return views.some(({ projection, depth, depthMesh }) => projection ?? depth ?? depthMesh) ? 2 : 1;
}

function reportOf({ view, lens }: FoundView): ImportedView {
  return {
    photo: view.name,
    widthPx: lens.widthPx,
    heightPx: lens.heightPx,
    errorPx: reprojectionErrorPx(view, lens),
    points: view.observations.length / 5,
  };
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
