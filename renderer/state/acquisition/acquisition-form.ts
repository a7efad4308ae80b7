import { ACQUISITION_DEFAULTS, FOV_DEG } from '../../../export/captures/acquire/acquisition-defaults.ts';
import { type CameraPlaces, cameraPoses } from '../../../export/captures/acquire/camera-places.ts';
import type { AcquiredCamera } from '../../../export/captures/acquire/write-transforms.ts';
import { CAPTURE_LIMITS } from '../../../nodes/kit/capture.ts';
import { captureSize } from '../../../nodes/kit/capture-size.ts';

type Texts = readonly [x: string, y: string, z: string];

/** The fields of the dialog, as they are typed. */
export interface AcquisitionForm {
  readonly name: string;
  readonly shape: CameraPlaces['shape'];
  readonly projection: AcquiredCamera['projection'];
  /** Cameras on a sphere. */
  readonly count: string;
  /** Cameras of a grid along x, y and z. */
  readonly counts: Texts;
  readonly center: Texts;
  readonly extent: Texts;
  /** The part of a sphere that has cameras, degrees. */
  readonly lowest: string;
  readonly highest: string;
  readonly yaw: string;
  readonly fov: string;
  readonly width: string;
  /** 360° photographs are half as high as wide. */
  readonly height: string;
}

/** A field, or a group of three. */
export type AcquisitionField = 'name' | 'count' | 'counts' | 'center' | 'extent' | 'elevation' | 'yaw' | 'fov' | 'size' | 'layer';

/** An acquisition that can begin. */
export interface AcquisitionPlan {
  readonly name: string;
  readonly camera: AcquiredCamera;
  /** Column-major 4×4. */
  readonly poses: readonly (readonly number[])[];
}

export interface ReadForm {
  /** Null if there are errors. */
  readonly plan: AcquisitionPlan | null;
  readonly errors: Readonly<Partial<Record<AcquisitionField, string>>>;
}

const { size: SIZE, aroundSize: AROUND_SIZE } = ACQUISITION_DEFAULTS;
const MAX_NAME = 80;
const RAD = Math.PI / 180;

const threeTexts = (values: readonly [number, number, number]): Texts => [String(values[0]), String(values[1]), String(values[2])];

/** @param title Title of the project, which names the capture. */
export function defaultForm(title: string): AcquisitionForm {
  const { shape, sphere, grid, centerM, extentM, fovDeg } = ACQUISITION_DEFAULTS;
  return {
    name: title.trim().slice(0, MAX_NAME) || 'scene',
    shape,
    projection: 'perspective',
    count: String(sphere),
    counts: threeTexts(grid),
    center: threeTexts(centerM),
    extent: threeTexts([extentM, extentM, extentM]),
    lowest: '-90',
    highest: '90',
    yaw: '0',
    fov: String(fovDeg),
    width: String(SIZE.widthPx),
    height: String(SIZE.heightPx),
  };
}

/** The form with another projection, in its usual size. */
export function withProjection(form: AcquisitionForm, projection: AcquiredCamera['projection']): AcquisitionForm {
  const { widthPx, heightPx } = projection === 'perspective' ? SIZE : AROUND_SIZE;
  return { ...form, projection, width: String(widthPx), height: String(heightPx) };
}

/** Whether all cameras look the same way, so that the yaw turns them. */
export function hasYaw({ shape, projection }: Pick<AcquisitionForm, 'shape' | 'projection'>): boolean {
  return shape === 'grid' || projection === 'equirectangular';
}

export function readForm(form: AcquisitionForm): ReadForm {
  const errors: Partial<Record<AcquisitionField, string>> = {};
  const isGrid = form.shape === 'grid';
  const name = form.name.trim();
  if (!/[A-Za-z0-9]/.test(name) || name.length > MAX_NAME) errors.name = `Enter a name with letters, of at most ${MAX_NAME} characters.`;
  const counts = isGrid ? three(form.counts) : ([number(form.count), 1, 1] as const);
  const all = counts[0] * counts[1] * counts[2];
  const most = CAPTURE_LIMITS.views;
  if (!counts.every((count) => Number.isInteger(count) && count >= 1)) {
    errors[isGrid ? 'counts' : 'count'] = isGrid ? 'Enter whole numbers of at least 1.' : `Enter a whole number from 1 to ${most}.`;
  } else if (all > most) {
    errors[isGrid ? 'counts' : 'count'] = `These are ${all} cameras. A capture has at most ${most}.`;
  }
  const centerM = three(form.center);
  if (!centerM.every(Number.isFinite)) errors.center = 'Enter three numbers.';
  const extentM = three(form.extent);
  if (!extentM.every((size) => Number.isFinite(size) && (isGrid ? size >= 0 : size > 0))) {
    errors.extent = isGrid ? 'Enter three numbers of at least 0.' : 'Enter three numbers above 0.';
  }
  const [lowest, highest] = isGrid ? [-90, 90] : [number(form.lowest), number(form.highest)];
  if (!(lowest >= -90 && highest <= 90 && lowest <= highest)) errors.elevation = 'Enter two angles from −90° to 90°, the lower one first.';
  const yawDeg = hasYaw(form) ? number(form.yaw) : 0;
  if (!Number.isFinite(yawDeg)) errors.yaw = 'Enter a number.';
  const camera = readCamera(form, errors);
  if (camera === null || Object.keys(errors).length > 0) return { plan: null, errors };
  const places: CameraPlaces = {
    shape: form.shape,
    counts,
    centerM,
    extentM,
    yawRad: yawDeg * RAD,
    elevationRad: [lowest * RAD, highest * RAD],
  };
  return { plan: { name, camera, poses: cameraPoses(places, camera.projection === 'equirectangular') }, errors };
}

function readCamera(form: AcquisitionForm, errors: Partial<Record<AcquisitionField, string>>): AcquiredCamera | null {
  const most = CAPTURE_LIMITS.sidePx;
  const widthPx = number(form.width);
  const isSide = (side: number) => Number.isInteger(side) && side >= 16 && side <= most;
  if (form.projection === 'equirectangular') {
    if (isSide(widthPx) && widthPx % 2 === 0) return { projection: 'equirectangular', widthPx, heightPx: widthPx / 2 };
    errors.size = `Enter an even number from 16 to ${most}.`;
    return null;
  }
  const heightPx = number(form.height);
  const fovDeg = number(form.fov);
  if (!isSide(widthPx) || !isSide(heightPx)) errors.size = `Enter whole numbers from 16 to ${most}.`;
  if (!(fovDeg >= FOV_DEG.least && fovDeg <= FOV_DEG.most)) errors.fov = `Enter an angle from ${FOV_DEG.least}° to ${FOV_DEG.most}°.`;
  return { projection: 'perspective', widthPx, heightPx, fovYRad: fovDeg * RAD };
}

/** The camera for a preview: at most this long a side. */
export function reducedCamera(camera: AcquiredCamera, maxSidePx: number): AcquiredCamera {
  const scale = Math.min(1, maxSidePx / Math.max(camera.widthPx, camera.heightPx));
  const heightPx = Math.max(1, Math.round(camera.heightPx * scale));
  const widthPx = camera.projection === 'equirectangular' ? 2 * heightPx : Math.max(1, Math.round(camera.widthPx * scale));
  return { ...camera, widthPx, heightPx };
}

/** JPEG files of packed photographs are about half as large as PNG files. */
const JPEG_SHARE = 0.5;
/** Triangles of a depth mesh per pixel of a photograph of a room, as measured, and at most in a mesh. */
const TRIANGLES_PER_PX = 0.15;
const MOST_TRIANGLES = 150_000;
/** A triangle with its share of vertices, in the depth mesh and in the mesh of all. */
const TRIANGLE_BYTES = 16 * 1.7;
/** PNG files of depth. */
const DEPTH_BYTES_PER_PX = 0.5;

/**
 * Estimates the size of a capture on disk.
 *
 * @param pngBytesPerPx Size of one of its photographs as PNG file, per pixel.
 */
export function captureFileBytes({ camera: { widthPx, heightPx }, poses }: AcquisitionPlan, pngBytesPerPx: number): number {
  const pixels = widthPx * heightPx;
  const geometry = Math.min(MOST_TRIANGLES, TRIANGLES_PER_PX * pixels) * TRIANGLE_BYTES + DEPTH_BYTES_PER_PX * pixels;
  return Math.round(poses.length * (JPEG_SHARE * pngBytesPerPx * pixels + geometry));
}

/** The largest texture of most phones. */
const MAX_TEXTURE_PX = 4096;

/** What the photographs take on the GPU when the capture is shown. */
export function photographsGpuBytes({ camera: { widthPx, heightPx }, poses }: AcquisitionPlan): number {
  const view = { widthPx, heightPx, file: '', fxPx: 1, fyPx: 1, cxPx: 0, cyPx: 0 };
  const views = poses.map((worldFromCamera) => ({ ...view, worldFromCamera }));
  const mesh = { file: '', vertexCount: 0, triangleCount: 0 };
  return captureSize({ format: 'scrim-capture', version: 1, mesh, views }, { maxSidePx: MAX_TEXTURE_PX, depthMeshes: false }).gpuBytes;
}

function three([x, y, z]: Texts): readonly [number, number, number] {
  return [number(x), number(y), number(z)];
}

/** Not a number if the text is none. */
function number(text: string): number {
  const plain = text.trim().replace('−', '-').replace(',', '.');
  return plain === '' ? Number.NaN : Number(plain);
}
