import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { PHONE_GPU_BYTES } from '../../../nodes/kit/phone-memory.ts';
import { type Place, sizeOfCapture, sizeOfSplats } from './phone-shares.ts';
import type { PreparedAsset, ReportedAsset } from './prepared-asset.ts';

/** What the assets of a page take on the GPU, bytes. */
export interface PageGpuBytes {
  /** All assets, on computers. */
  readonly assets: number;
  /** All assets, on phones and headsets. */
  readonly onPhones: number;
  /** The captures and splats, on computers and on phones and headsets, where they share a limit; null if there are none. */
  readonly places: { readonly onComputers: number; readonly onPhones: number; readonly phoneLimit: number } | null;
}

/** Sums the assets of a page. A file that several assets name counts once. */
export function pageGpuBytes(assets: readonly ReportedAsset[]): PageGpuBytes {
  const files = [...new Map(assets.map((asset) => [asset.path, asset])).values()];
  const places = files.filter(({ gpuBytes }) => gpuBytes.onPhones !== undefined);
  const sum = (of: readonly ReportedAsset[], bytes: (gpuBytes: ReportedAsset['gpuBytes']) => number): number =>
    of.reduce((total, { gpuBytes }) => total + bytes(gpuBytes), 0);
  const onComputers = ({ after }: ReportedAsset['gpuBytes']): number => after;
  const onPhones = ({ after, onPhones: reduced = after }: ReportedAsset['gpuBytes']): number => reduced;
  return {
    assets: sum(files, onComputers),
    onPhones: sum(files, onPhones),
    places:
      places.length === 0 ? null : { onComputers: sum(places, onComputers), onPhones: sum(places, onPhones), phoneLimit: PHONE_GPU_BYTES },
  };
}

/**
 * What a page shows less of a place on phones and headsets than elsewhere: predicates, such as `has photographs of 800 × 600 pixels instead of
 * 1600 × 1200`. Empty if the place is the same.
 */
export function phoneReductions(place: Place, mostBytes: number): readonly string[] {
  const capture = { whole: sizeOfCapture(place, undefined), there: sizeOfCapture(place, mostBytes) };
  if (capture.whole && capture.there) {
    const { whole, there } = capture;
    const pixels = ([widthPx, heightPx]: readonly [number, number]): string => `${widthPx} × ${heightPx}`;
    return [
      there.photoPx[0] < whole.photoPx[0] ? `has photographs of ${pixels(there.photoPx)} pixels instead of ${pixels(whole.photoPx)}` : '',
      whole.depthMeshes && !there.depthMeshes ? 'is drawn as a lumigraph instead of by its depth meshes' : '',
      there.wholeMesh
        ? ''
        : `has a mesh of ${place.capture?.coarseMesh?.triangleCount} triangles instead of ${place.capture?.mesh.triangleCount}`,
    ].filter(Boolean);
  }
  const splats = { whole: sizeOfSplats(place, undefined), there: sizeOfSplats(place, mostBytes) };
  if (!splats.whole || !splats.there) return [];
  const { whole, there } = splats;
  const least = there.degree === 0 ? 'has colors that do not change with the direction' : `has harmonics of degree ${there.degree}`;
  return [
    there.degree < whole.degree ? `${least} instead of harmonics of degree ${whole.degree}` : '',
    there.count < whole.count ? `has its ${there.count} most important splats instead of ${whole.count}` : '',
  ].filter(Boolean);
}

/** Names the places of a page that are reduced on phones and headsets (SCR034). */
export function reducedPlaces(assets: readonly PreparedAsset[]): readonly Diagnostic[] {
  const { places } = pageGpuBytes(assets.map(({ report }) => report));
  if (places === null) return [];
  const most = `the captures and splats of a page take at most ${megabytes(places.phoneLimit)} MB of graphics memory together`;
  const elsewhere = `those of this page take ${megabytes(places.onComputers)} MB elsewhere`;
  return assets.flatMap(({ asset: { path }, report: { kind, reducedOnPhones = [] } }): Diagnostic[] => {
    if (reducedOnPhones.length === 0) return [];
    const message = `On phones and headsets, ${path} ${reducedOnPhones.join(', and ')}: ${most}, and ${elsewhere}.`;
    return [{ code: 'SCR034', severity: 'info', message, file: path, fix: FIXES[kind === 'splats' ? 'splats' : 'capture'] }];
  });
}

const FIXES = {
  capture: 'Import the capture with fewer or smaller photographs if other places of the page need the memory more.',
  splats: 'Remove splats in an editor for splats, or export them with harmonics of a lower degree, to choose what is left out.',
} as const;

function megabytes(bytes: number): number {
  return Math.round(bytes / 1e6);
}
