import { AXES, type Axis } from '../../../export/captures/upright.ts';
import { type ImportedCapture, importCapture } from '../../services/add-capture.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { findProject } from '../../services/project-files.ts';
import { type Call, type Command, UsageError } from '../command.ts';

const DEFAULT_SIDE_PX = 1600;

export const importCaptureCommand: Command = {
  name: 'import capture',
  usage: 'FOLDER --project PROJECT [--name NAME] [--size PX] [--up AXIS] [--unit METERS]',
  summary: 'Import photographs of a place',
  doc: 'Imports the photographs in FOLDER with their cameras and the mesh of what they show, for the node Capture. Cameras are those of COLMAP (text or binary) or of transforms.json; the mesh is a PLY, OBJ or glTF file. Distorted photographs are straightened, and their metadata are removed. Prints what was found, with the reprojection error of each photograph.',
  project: 'required',
  operand: { word: 'FOLDER', doc: 'the folder with images/, the cameras and the mesh' },
  options: {
    project: { type: 'string', value: 'PROJECT', doc: 'Project that the capture is added to.' },
    name: { type: 'string', value: 'NAME', doc: 'Name of the capture. Default: that of the folder.' },
    size: {
      type: 'string',
      value: 'PX',
      doc: `Longest side of photographs, in pixels; larger ones are reduced. Default: ${DEFAULT_SIDE_PX}.`,
    },
    up: {
      type: 'string',
      value: 'AXIS',
      doc: `Axis of the reconstruction that points up: ${AXES.join(', ')}. Default: the one nearest to up in the photographs.`,
    },
    unit: { type: 'string', value: 'METERS', doc: 'Meters per unit of the reconstruction. Default: 1.' },
  },
  examples: [
    { line: 'scrim import capture scans/kitchen --project my-room', says: 'Adds assets/kitchen.capture to the project.' },
    {
      line: 'scrim import capture scans/vase --project my-room --size 1024 --unit 0.35',
      says: 'With smaller photographs, at a known scale.',
    },
  ],
  run: async (call, { say, interrupted }) => {
    const project = call.text('project');
    if (project === null) throw new UsageError('The project is missing: add --project PROJECT.');
    const imported = await importCapture({
      folder: call.project,
      root: await findProject(project),
      name: call.text('name'),
      maxSidePx: positive(call, 'size', DEFAULT_SIDE_PX),
      metersPerUnit: positive(call, 'unit', 1),
      up: axis(call),
      files: NODE_FILES,
      say,
      interrupted,
    });
    return { status: 0, json: { ok: true, ...imported }, text: textOf(imported), diagnostics: imported.diagnostics };
  },
};

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

function textOf({ path, form, up, views, pointCount, vertexCount, triangleCount, sizeM, fileBytes }: ImportedCapture): string {
  const errors = views.flatMap(({ errorPx }) => errorPx ?? []);
  const mean = errors.reduce((sum, error) => sum + error, 0) / errors.length;
  const lines = [
    `Imported ${path} from ${form}, ${(fileBytes / 1e6).toFixed(1)} MB.`,
    `${views.length} photographs, ${pointCount} points, a mesh of ${vertexCount} vertices and ${triangleCount} triangles.`,
    `The mesh is ${sizeM.map((m) => m.toFixed(2)).join(' × ')} m; up is the ${up} axis of the reconstruction.`,
  ];
  if (errors.length > 0) {
    lines.push(`Mean reprojection error ${mean.toFixed(2)} px:`);
    for (const { photo, errorPx, points } of views) {
      lines.push(`  ${photo}: ${errorPx === null ? 'no points' : `${errorPx.toFixed(2)} px over ${points} points`}`);
    }
  }
  return lines.join('\n');
}
