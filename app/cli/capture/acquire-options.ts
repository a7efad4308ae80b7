import { ACQUISITION_DEFAULTS, FOV_DEG } from '../../../export/captures/acquire/acquisition-defaults.ts';
import type { CameraPlaces } from '../../../export/captures/acquire/camera-places.ts';
import type { AcquiredCamera } from '../../../export/captures/acquire/write-transforms.ts';
import { CAPTURE_LIMITS } from '../../../nodes/kit/capture.ts';
import type { DepthFormat } from '../../services/write-acquisition.ts';
import { type Call, type Option, UsageError } from '../command.ts';
import { readSize } from '../render/render-options.ts';

export const SHAPES: readonly CameraPlaces['shape'][] = ['grid', 'inside-out', 'outside-in'];
const DEPTH_FORMATS: readonly DepthFormat[] = ['pfm', 'png'];

const { size: SIZE, aroundSize: AROUND_SIZE, fovDeg: DEFAULT_FOV_DEG } = ACQUISITION_DEFAULTS;
const DEFAULTS = {
  count: { grid: ACQUISITION_DEFAULTS.grid.join('x'), sphere: String(ACQUISITION_DEFAULTS.sphere) },
  extent: String(ACQUISITION_DEFAULTS.extentM),
  center: ACQUISITION_DEFAULTS.centerM.join(','),
};

export const ACQUIRE_OPTIONS: Readonly<Record<string, Option>> = {
  out: { type: 'string', value: 'DIR', doc: 'Folder for images/, depth/, transforms.json and acquisition.json.' },
  shape: {
    type: 'string',
    value: 'SHAPE',
    doc: 'Where the cameras stand: outside-in, on a sphere, looking at its center, as for an object; inside-out, on a sphere, looking out, as for a room; grid, all looking the same way. Default: outside-in.',
  },
  count: {
    type: 'string',
    value: 'N|AxBxC',
    doc: `Number of cameras on the sphere, or of a grid along x, y and z. Default: ${DEFAULTS.count.sphere}, or ${DEFAULTS.count.grid}.`,
  },
  extent: {
    type: 'string',
    value: 'X,Y,Z',
    doc: `Size of the grid, or diameters of the sphere, along x, y and z, in meters; one number for all. Default: ${DEFAULTS.extent}.`,
  },
  center: { type: 'string', value: 'X,Y,Z', doc: `Center of the cameras in meters. Default: ${DEFAULTS.center}.` },
  elevation: {
    type: 'string',
    value: 'A..B',
    doc: 'The part of the sphere that has cameras, in degrees above its center, as 10..60 above a table. Default: -90..90.',
  },
  yaw: {
    type: 'string',
    value: 'DEG',
    doc: 'Turns the cameras of a grid, or the middle of 360° photographs, to the left by this angle. Default: 0, which looks along −z.',
  },
  fov: { type: 'string', value: 'DEG', doc: `Vertical field of view. Default: ${DEFAULT_FOV_DEG}.` },
  size: {
    type: 'string',
    value: 'WxH',
    doc: `Size of the photographs in pixels. Default: ${SIZE.widthPx}x${SIZE.heightPx}, or ${AROUND_SIZE.widthPx}x${AROUND_SIZE.heightPx} for 360°.`,
  },
  around: { type: 'boolean', doc: 'Take 360° photographs.' },
  layer: { type: 'string', value: 'NODE.PORT', doc: 'Photograph this layer instead of the screen output. It needs depth.' },
  'depth-format': {
    type: 'string',
    value: 'pfm|png',
    doc: 'Depth as PFM (32-bit floats, meters) or as PNG (16 bits, millimeters, up to 65 m). Default: pfm.',
  },
};

/** @throws UsageError */
export function readPlaces(call: Call): CameraPlaces {
  const named = call.text('shape') ?? ACQUISITION_DEFAULTS.shape;
  const shape = SHAPES.find((known) => known === named);
  if (!shape) throw new UsageError(`--shape needs one of ${SHAPES.join(', ')}, not ${JSON.stringify(named)}.`);
  if (shape === 'grid' && call.text('elevation') !== null) throw new UsageError('--elevation is for spheres; a grid has none.');
  const extentM = vector(call, 'extent', DEFAULTS.extent);
  if (extentM.some((size) => size < 0)) throw new UsageError('--extent needs sizes of 0 or more.');
  if (shape !== 'grid' && extentM.some((size) => size === 0)) throw new UsageError('--extent of a sphere needs sizes above 0.');
  if (shape !== 'grid' && call.text('yaw') !== null && !call.flag('around'))
    throw new UsageError('--yaw is for grids and 360° photographs; the cameras of a sphere look at its center, or away from it.');
  const yawRad = radians(number(call, 'yaw', 0));
  return {
    shape,
    counts: readCounts(call, shape),
    centerM: vector(call, 'center', DEFAULTS.center),
    extentM,
    yawRad,
    elevationRad: readElevation(call),
  };
}

function readCounts(call: Call, shape: CameraPlaces['shape']): CameraPlaces['counts'] {
  const text = call.text('count') ?? DEFAULTS.count[shape === 'grid' ? 'grid' : 'sphere'];
  const pattern = shape === 'grid' ? /^(\d{1,4})[x×](\d{1,4})[x×](\d{1,4})$/i : /^(\d{1,4})$/;
  const [, a, b = '1', c = '1'] = pattern.exec(text) ?? [];
  const counts = [Number(a), Number(b), Number(c)] as const;
  const all = counts[0] * counts[1] * counts[2];
  if (!(all >= 1)) {
    const wanted = shape === 'grid' ? 'the numbers of cameras along x, y and z, such as 3x3x1' : 'a number of cameras, such as 24';
    throw new UsageError(`--count needs ${wanted}, not ${JSON.stringify(text)}.`);
  }
  if (all > CAPTURE_LIMITS.views)
    throw new UsageError(`--count ${text} is ${all} cameras, more than the ${CAPTURE_LIMITS.views} of a capture.`);
  return counts;
}

function readElevation(call: Call): CameraPlaces['elevationRad'] {
  const text = call.text('elevation') ?? '-90..90';
  const [, a, b] = /^(-?[\d.]+)\.\.(-?[\d.]+)$/.exec(text) ?? [];
  const [least, most] = [Number(a), Number(b)];
  if (least >= -90 && most <= 90 && least <= most) return [radians(least), radians(most)];
  throw new UsageError(`--elevation needs two angles from -90 to 90, such as --elevation=-10..60, not ${JSON.stringify(text)}.`);
}

/** @throws UsageError */
export function readCamera(call: Call): AcquiredCamera {
  const size = readSize(call.text('size'));
  if (call.flag('around')) {
    if (call.text('fov') !== null) throw new UsageError('--fov and --around exclude each other: 360° photographs show everything.');
    const { widthPx, heightPx } = size ?? AROUND_SIZE;
    if (widthPx !== 2 * heightPx) throw new UsageError(`--size ${widthPx}x${heightPx}: 360° photographs are twice as wide as high.`);
    return { projection: 'equirectangular', widthPx, heightPx };
  }
  const fovDeg = number(call, 'fov', DEFAULT_FOV_DEG);
  if (!(fovDeg >= FOV_DEG.least && fovDeg <= FOV_DEG.most))
    throw new UsageError(`--fov needs an angle from ${FOV_DEG.least} to ${FOV_DEG.most}, not ${fovDeg}.`);
  return { projection: 'perspective', ...(size ?? SIZE), fovYRad: radians(fovDeg) };
}

/** @throws UsageError */
export function readDepthFormat(call: Call): DepthFormat {
  const named = call.text('depth-format') ?? 'pfm';
  const format = DEPTH_FORMATS.find((known) => known === named);
  if (!format) throw new UsageError(`--depth-format needs one of ${DEPTH_FORMATS.join(', ')}, not ${JSON.stringify(named)}.`);
  return format;
}

function vector(call: Call, option: string, otherwise: string): readonly [number, number, number] {
  const text = call.text(option) ?? otherwise;
  const [x = Number.NaN, y = x, z = x, ...more] = text.split(',').map(parsed);
  const isOneOrThree = [1, 3].includes(text.split(',').length);
  if (isOneOrThree && more.length === 0 && [x, y, z].every(Number.isFinite)) return [x, y, z];
  throw new UsageError(`--${option} needs three numbers of meters, such as 2,1,2, not ${JSON.stringify(text)}.`);
}

function number(call: Call, option: string, otherwise: number): number {
  const text = call.text(option);
  const value = text === null ? otherwise : parsed(text);
  if (!Number.isFinite(value)) throw new UsageError(`--${option} needs a number, not ${JSON.stringify(text)}.`);
  return value;
}

function parsed(text: string): number {
  return text.trim() === '' ? Number.NaN : Number(text);
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}
