/** A photograph of an acquisition. */
export interface AcquiredView {
  /** Paths relative to the folder of `transforms.json`. */
  readonly file: string;
  readonly depthFile: string;
  /** Column-major 4×4. */
  readonly worldFromCamera: readonly number[];
}

/** The camera of all photographs: a pinhole with its center in the middle, or all directions. */
export type AcquiredCamera = { readonly widthPx: number; readonly heightPx: number } & (
  | { readonly projection: 'perspective'; readonly fovYRad: number }
  | { readonly projection: 'equirectangular' }
);

/**
 * Writes `transforms.json` as `readTransforms` reads it (docs.nerf.studio, “Data conventions”): camera-to-world matrices row by row, with y up
 * and −z forward.
 */
export function transformsText(camera: AcquiredCamera, views: readonly AcquiredView[]): string {
  const { widthPx, heightPx } = camera;
  const size = { w: widthPx, h: heightPx };
  const lens =
    camera.projection === 'equirectangular'
      ? { camera_model: 'EQUIRECTANGULAR', ...size }
      : { camera_model: 'PINHOLE', ...size, ...pinholeOf(camera.fovYRad, widthPx, heightPx) };
  const frames = views.map(({ file, depthFile, worldFromCamera: m }) => ({
    file_path: file,
    depth_file_path: depthFile,
    transform_matrix: [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => m[4 * column + row] ?? 0)),
  }));
  return `${JSON.stringify({ ...lens, frames }, null, 1)}\n`;
}

function pinholeOf(fovYRad: number, widthPx: number, heightPx: number) {
  const focalPx = heightPx / 2 / Math.tan(fovYRad / 2);
  return { fl_x: focalPx, fl_y: focalPx, cx: widthPx / 2, cy: heightPx / 2 };
}
