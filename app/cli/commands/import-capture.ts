import { dirname, join } from 'node:path';
import type { DepthKind } from '../../../export/captures/depth/depth-map.ts';
import type { DepthUnit } from '../../../export/captures/depth/depth-scale.ts';
import { scaleWords } from '../../../export/captures/report/scale-source.ts';
import { AXES, type Axis } from '../../../export/captures/upright.ts';
import { type CaptureJob, type ImportedCapture, importCapture } from '../../services/add-capture.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { IMPORT_MARK, writeImportReport } from '../../services/import-report/import-report.ts';
import { simplifyMesh } from '../../services/outside/simplify-mesh.ts';
import { writePageFolder } from '../../services/page-folder.ts';
import { findProject } from '../../services/project-files.ts';
import { readKnownSize } from '../capture/known-size.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import { simplifyOptions } from './simplify.ts';

const DEPTH_WORDS: Readonly<Record<DepthKind, string>> = { z: 'along the axis of the camera', ray: 'along the rays of pixels' };
const SOURCES = ['files', 'mesh', 'none'] as const;
const DEFAULT_SIDE_PX = 1600;

export const importCaptureCommand: Command = {
  name: 'import capture',
  usage: 'FOLDER --project PROJECT',
  summary: 'Import photographs of a place',
  doc: 'Imports the photographs in FOLDER with their cameras and the mesh of what they show, for the node Capture. Cameras are those of COLMAP (text or binary) or of transforms.json; the mesh is a PLY, OBJ or glTF file. One 360° photograph with its depth needs neither. Depth files (PNG with 16 bits, EXR, PFM, or those of COLMAP) are found by the names of the photographs. Distorted photographs are straightened, and their metadata are removed. Prints what was found, with the reprojection error of each photograph. One process imports captures of the same name into a project at a time.',
  project: 'required',
  operand: { word: 'FOLDER', doc: 'the folder with images/, the cameras and the mesh' },
  options: {
    project: { type: 'string', value: 'PROJECT', doc: 'Project that the capture is added to.' },
    name: { type: 'string', value: 'NAME', doc: 'Name of the capture. Default: that of the folder.' },
    size: {
      type: 'string',
      value: 'PX',
      doc: `Longest side of photographs, in pixels; larger ones are reduced; 2.5 times that for 360° photographs. Default: ${DEFAULT_SIDE_PX}.`,
    },
    up: {
      type: 'string',
      value: 'AXIS',
      doc: `Axis of the reconstruction that points up: ${AXES.join(', ')}. Default: the one nearest to up in the photographs.`,
    },
    unit: { type: 'string', value: 'METERS', doc: 'Meters per unit of the reconstruction. Default: 1.' },
    distance: {
      type: 'string',
      value: 'PHOTO:X,Y:X,Y=METERS',
      doc: 'The true distance of two points of the mesh, which gives the unit. X and Y are pixels from the left and top edges of a photograph that shows both.',
    },
    floor: {
      type: 'string',
      value: 'PHOTO:X,Y',
      doc: 'A point of the floor, in pixels of a photograph that shows it. The capture is moved so that the floor is at height 0.',
    },
    'camera-height': {
      type: 'string',
      value: 'METERS',
      doc: 'With --floor: how high the camera of that photograph was above the floor, which gives the unit.',
    },
    depth: {
      type: 'string',
      value: 'FROM',
      doc: `What depth meshes are made from: ${SOURCES.join(', ')}. Default: depth files where they are, else the mesh.`,
    },
    'depth-unit': {
      type: 'string',
      value: 'UNIT',
      doc: 'Unit of the depth files: m, mm, reconstruction, or a number of meters. Default: the one that fits the mesh.',
    },
    'depth-kind': {
      type: 'string',
      value: 'KIND',
      doc: 'What depth is: z (along the axis of the camera) or ray (along the ray of the pixel). Default: what fits the mesh.',
    },
    report: {
      type: 'string',
      value: 'DIR',
      doc: 'Folder for a page that shows the cameras over the mesh, and for each photograph where points were seen and where its camera projects them.',
    },
    triangles: {
      type: 'string',
      value: 'N',
      doc: 'Reduces the mesh of the folder to at most N triangles, as scrim simplify does. Default: the mesh is kept as it is.',
    },
    program: { type: 'string', value: 'NAME', doc: 'With --triangles: blender or instant-meshes. Default: blender.' },
    path: { type: 'string', value: 'PATH', doc: 'With --triangles: the executable file of that program.' },
  },
  examples: [
    { line: 'scrim import capture scans/kitchen --project my-room', says: 'Adds assets/kitchen.capture to the project.' },
    {
      line: 'scrim import capture scans/vase --project my-room --size 1024 --unit 0.35',
      says: 'With smaller photographs, at a known scale.',
    },
    {
      line: 'scrim import capture scans/hall --project hall --distance a.jpg:310,842:1490,830=2.1 --floor a.jpg:900,1400',
      says: 'A door is 2.1 m high; the floor comes to height 0.',
    },
    {
      line: 'scrim import capture scans/hall --project hall --report hall-import',
      says: 'Opened in a browser, hall-import/index.html shows whether cameras, photographs and mesh belong together.',
    },
  ],
  run: async (call, { installation, say, interrupted }) => {
    const project = call.text('project');
    if (project === null) throw new UsageError('The project is missing: add --project PROJECT.');
    const simplify = simplifyOptions(call, { say, interrupted });
    const root = await findProject(project);
    const job: CaptureJob = {
      folder: call.project,
      root,
      sources: installation.root,
      name: call.text('name'),
      maxSidePx: positive(call, 'size', DEFAULT_SIDE_PX),
      metersPerUnit: positive(call, 'unit', 1),
      ...(call.text('unit') !== null && { unitFrom: 'given' as const }),
      known: readKnownSize(call),
      up: axis(call),
      depth: { from: depthSource(call), unit: depthUnit(call), kind: depthKind(call) },
      ...(simplify && { simplify: async (mesh) => (await simplifyMesh(mesh, simplify)).mesh }),
      files: NODE_FILES,
      say,
      interrupted,
    };
    const out = call.text('report');
    const imported = out === null ? await importCapture(job) : await importWithReport(job, out);
    const text = out === null ? textOf(imported) : `${textOf(imported)}\nWrote ${join(out, 'index.html')}`;
    return { status: 0, json: { ok: true, ...imported }, text, diagnostics: imported.diagnostics };
  },
};

/** A folder of other files is refused before the import. */
async function importWithReport(job: CaptureJob, out: string): Promise<ImportedCapture> {
  const imported = await writePageFolder(
    out,
    job.files,
    async (sink) => {
      const made = await importCapture(job);
      await writeImportReport(sink, dirname(join(job.root, made.path)), made);
      return made;
    },
    IMPORT_MARK,
  );
  if (imported === null) throw new Error('No report was written.');
  return imported;
}

function positive(call: Call, option: string, otherwise: number): number {
  const text = call.text(option);
  if (text === null) return otherwise;
  const value = Number(text);
  if (!(value > 0 && Number.isFinite(value))) throw new UsageError(`--${option} needs a number above 0, not ${JSON.stringify(text)}.`);
  return value;
}

function axis(call: Call): Axis | null {
  const text = call.text('up');
  const found = AXES.find((known) => known === text);
  if (text !== null && !found) throw new UsageError(`--up needs one of ${AXES.join(', ')}, not ${JSON.stringify(text)}.`);
  return found ?? null;
}

function depthSource(call: Call): CaptureJob['depth']['from'] {
  const text = call.text('depth');
  const found = SOURCES.find((known) => known === text);
  if (text !== null && !found) throw new UsageError(`--depth needs one of ${SOURCES.join(', ')}, not ${JSON.stringify(text)}.`);
  return found ?? null;
}

function depthUnit(call: Call): DepthUnit | null {
  const text = call.text('depth-unit');
  if (text === null || text === 'm' || text === 'mm' || text === 'reconstruction') return text;
  const meters = Number(text);
  if (meters > 0 && Number.isFinite(meters)) return meters;
  throw new UsageError(`--depth-unit needs m, mm, reconstruction or a number above 0, not ${JSON.stringify(text)}.`);
}

function depthKind(call: Call): DepthKind | null {
  const text = call.text('depth-kind');
  if (text === null || text === 'z' || text === 'ray') return text;
  throw new UsageError(`--depth-kind needs z or ray, not ${JSON.stringify(text)}.`);
}

function textOf({
  path,
  form,
  up,
  views,
  pointCount,
  vertexCount,
  triangleCount,
  depth,
  depthTriangles,
  metersPerUnit,
  scale,
  sizeM,
  fileBytes,
}: ImportedCapture): string {
  const errors = views.flatMap(({ errorPx }) => errorPx ?? []);
  const mean = errors.reduce((sum, error) => sum + error, 0) / errors.length;
  const { text: scaleText, advice } = scaleWords(scale);
  const lines = [
    `Imported ${path} from ${form}, ${(fileBytes / 1e6).toFixed(1)} MB.`,
    `${views.length === 1 ? '1 photograph' : `${views.length} photographs`}, ${pointCount} points, a mesh of ${vertexCount} vertices and ${triangleCount} triangles.`,
    `The mesh is ${sizeM.map((m) => m.toFixed(2)).join(' × ')} m; up is the ${up} axis of the reconstruction, whose unit is ${Number(metersPerUnit.toPrecision(4))} m (${scaleText}).`,
  ];
  if (advice !== null) lines.push(`${advice} Or import it again with --unit, --distance or --camera-height.`);
  if (depth !== null) {
    const unit = typeof depth.unit === 'number' ? `${depth.unit} m` : depth.unit;
    lines.push(
      `Depth of ${depth.count === 1 ? '1 photograph' : `${depth.count} photographs`}: ${DEPTH_WORDS[depth.kind]}, with the unit ${unit}.`,
    );
  }
  if (depthTriangles > 0) lines.push(`The depth meshes have ${depthTriangles} triangles.`);
  if (errors.length > 0) {
    lines.push(`Mean reprojection error ${mean.toFixed(2)} px:`);
    for (const { photo, errorPx, points } of views) {
      lines.push(`  ${photo}: ${errorPx === null ? 'no points' : `${errorPx.toFixed(2)} px over ${points} points`}`);
    }
  }
  return lines.join('\n');
}
