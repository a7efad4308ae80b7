import { CaptureError } from '../../nodes/kit/capture.ts';
import { checkLens, equirectangularLens, type Lens } from './lens.ts';
import { checkPose, type SourceCapture, type SourceView } from './source-view.ts';

type Fields = Readonly<Record<string, unknown>>;

/**
 * Reads `transforms.json` of Instant NGP and Nerfstudio (docs.nerf.studio, “Data conventions”): camera-to-world matrices row by row, with y
 * up and −z forward.
 *
 * @throws CaptureError
 */
export function readTransforms(bytes: Uint8Array): SourceCapture {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new CaptureError('transforms.json is not valid JSON');
  }
  const all = isRecord(json) ? json : {};
  const frames = all.frames;
  if (!Array.isArray(frames)) throw new CaptureError('transforms.json has no frames');
  const views = frames.map((frame: unknown, i) => readFrame(all, isRecord(frame) ? frame : {}, i));
  return { form: 'transforms.json', views, pointCount: 0 };
}

function readFrame(all: Fields, frame: Fields, index: number): SourceView {
  const name = frame.file_path;
  if (typeof name !== 'string' || name === '') throw new CaptureError(`frame ${index + 1} of transforms.json has no file_path`);
  const rows = frame.transform_matrix;
  if (!Array.isArray(rows) || rows.length < 3 || !rows.every((row) => Array.isArray(row) && row.length === 4)) {
    throw new CaptureError(`${name} has no transform_matrix of 4 by 4 numbers`);
  }
  const at = (row: number, column: number): number => (row === 3 ? Number(column === 3) : Number(rows[row]?.[column]));
  const worldFromCamera = Array.from({ length: 16 }, (_, i) => at(i % 4, Math.floor(i / 4)));
  checkPose(worldFromCamera, name);
  const field = (key: string): number | null => {
    const value = frame[key] ?? all[key];
    return typeof value === 'number' ? value : null;
  };
  const [width, height] = [field('w'), field('h')];
  const model = String(frame.camera_model ?? all.camera_model ?? 'OPENCV');
  return {
    name: name.replace(/^\.\//, ''),
    model,
    lens: (widthPx, heightPx) => lensOfFields(field, model, name, widthPx, heightPx),
    sizePx: width === null || height === null ? null : [width, height],
    worldFromCamera,
    depthName: typeof frame.depth_file_path === 'string' ? frame.depth_file_path.replace(/^\.\//, '') : null,
    observations: new Float64Array(0),
  };
}

const PERSPECTIVE = new Set(['OPENCV', 'PINHOLE', 'SIMPLE_PINHOLE', 'SIMPLE_RADIAL', 'RADIAL', 'FULL_OPENCV']);

function lensOfFields(field: (key: string) => number | null, model: string, name: string, widthPx: number, heightPx: number): Lens {
  if (model === 'EQUIRECTANGULAR') return equirectangularLens(widthPx, heightPx, name);
  if (model !== 'OPENCV_FISHEYE' && !PERSPECTIVE.has(model))
    throw new CaptureError(`the camera model ${model} of ${name} is not supported`);
  const angle = field('camera_angle_x');
  const fxPx = field('fl_x') ?? (angle === null ? null : widthPx / 2 / Math.tan(angle / 2));
  if (fxPx === null) throw new CaptureError(`${name} has neither fl_x nor camera_angle_x`);
  return checkLens({
    projection: model === 'OPENCV_FISHEYE' ? 'fisheye' : 'perspective',
    widthPx,
    heightPx,
    fxPx,
    fyPx: field('fl_y') ?? fxPx,
    cxPx: field('cx') ?? widthPx / 2,
    cyPx: field('cy') ?? heightPx / 2,
    radial: ['k1', 'k2', 'k3', 'k4', 'k5', 'k6'].map((key) => field(key) ?? 0),
    tangential: [field('p1') ?? 0, field('p2') ?? 0],
  });
}

function isRecord(value: unknown): value is Fields {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
