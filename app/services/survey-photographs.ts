import { extname, join, resolve } from 'node:path';
import { isJpeg } from '../../export/bundle/photos/image-form.ts';
import { isDistorted, type Lens } from '../../export/captures/lens.ts';
import { upAxis } from '../../export/captures/upright.ts';
import { imageSize } from '../../export/gltf/image-size.ts';
import { meshCounts } from '../../nodes/kit/capture.ts';
import type { HostOutput } from '../contract/contract.ts';
import { findDepths, readDepthSamples } from './capture-depths.ts';
import { type FoundView, readCaptureFolder } from './read-capture-folder.ts';
import { readSource } from './read-source.ts';
import { photographsOf } from './reconstruct/reconstruct-photographs.ts';

type Survey = HostOutput<'photographs.survey'>;

/** Longest side of the depth maps that are sent to the editor. */
const DEPTH_SIDE_PX = 64;
const MAX_PHOTO_BYTES = 256 * 2 ** 20;

/**
 * Reads what an import of a folder must decide before: the size of its photographs, and what its depth files have.
 *
 * @param hasCameras Whether the folder has cameras; without, COLMAP finds them at the import.
 * @throws CaptureError if it cannot be imported.
 */
export async function surveyPhotographs(folder: string, hasCameras: boolean): Promise<Survey> {
  if (!hasCameras) {
    const { views, photographs } = await readWithoutCameras(folder);
    return { form: null, up: null, mesh: null, warnings: [], photographs, depth: await depthOf(folder, views, null, false) };
  }
  const found = await readCaptureFolder(resolve(folder));
  const { views, source, mesh, diagnostics } = found;
  const photographs: Survey['photographs'] = [];
  for (const { file, lens } of views) {
    photographs.push({ ...(await sizeOf(file, !isDistorted(lens))), isAround: lens.projection === 'equirectangular' });
  }
  return {
    form: source.form,
    up: upAxis(views.map(({ view }) => view.worldFromCamera)),
    mesh: mesh && meshCounts(mesh),
    warnings: diagnostics.map(({ message }) => message),
    photographs,
    depth: await depthOf(folder, views, mesh, true),
  };
}

/** 0 × 0 pixels if the file does not say how large it is. */
async function sizeOf(file: string, isStraight: boolean): Promise<Survey['photographs'][number]> {
  const bytes = await readSource(file, MAX_PHOTO_BYTES);
  const size = imageSize(bytes) ?? { widthPx: 0, heightPx: 0 };
  return { widthPx: size.widthPx, heightPx: size.heightPx, bytes: bytes.length, isKept: isStraight && isJpeg(bytes), isAround: false };
}

/** Photographs whose cameras are not known yet, one after the other: together they may not fit into memory. */
async function readWithoutCameras(folder: string) {
  const { place, names } = await photographsOf(folder);
  const views: FoundView[] = [];
  const photographs: Survey['photographs'] = [];
  for (const name of names) {
    const file = join(place, name);
    const photograph = await sizeOf(file, true);
    // COLMAP leaves out what it cannot read.
    if (photograph.widthPx === 0) continue;
    views.push({ view: { name, ...UNKNOWN_VIEW }, file, lens: wideLens(photograph.widthPx, photograph.heightPx) });
    photographs.push(photograph);
  }
  return { views, photographs };
}

const UNKNOWN_VIEW = {
  model: '',
  lens: wideLens,
  sizePx: null,
  worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  depthName: null,
  observations: new Float64Array(0),
};

/** Any lens: only the pixels of depth maps are needed. */
function wideLens(widthPx: number, heightPx: number): Lens {
  const middle = { cxPx: widthPx / 2, cyPx: heightPx / 2, radial: [], tangential: [0, 0] as const };
  return { projection: 'perspective', widthPx, heightPx, fxPx: widthPx, fyPx: widthPx, ...middle };
}

async function depthOf(
  folder: string,
  views: readonly FoundView[],
  mesh: Parameters<typeof readDepthSamples>[2],
  hasCameras: boolean,
): Promise<Survey['depth']> {
  const depths = await findDepths(resolve(folder), views);
  const paths = depths.flatMap((path) => path ?? []);
  if (paths.length === 0) return null;
  const samples = await readDepthSamples(views, depths, mesh, DEPTH_SIDE_PX);
  return {
    count: paths.length,
    files: formsOf(paths),
    hasCameras,
    samples: samples.map(({ name, usualUnit, pinhole, file, surface }) => ({
      name,
      usualUnit,
      pinhole: { ...pinhole, isAround: pinhole.projection !== undefined },
      values: Array.from(file.z.values, short),
      surface: surface && { kind: surface.kind, values: Array.from(surface.map.values, short) },
    })),
  };
}

const FORMS: Readonly<Record<string, string>> = { '.png': 'PNG', '.exr': 'EXR', '.pfm': 'PFM', '.bin': 'COLMAP' };

function formsOf(paths: readonly string[]): string {
  return [...new Set(paths.map((path) => FORMS[extname(path).toLowerCase()] ?? 'depth'))].join(' and ');
}

/** Unknown values are 0. */
function short(value: number): number {
  return value > 0 && value < 1e9 ? Number(value.toPrecision(5)) : 0;
}
