import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { type Crop, setCoverCrop, setUvFromViewUv } from '../../../export/runtime/sessions/recorded/camera-crop.ts';
import { decodeDepth } from '../../../export/runtime/sessions/recorded/decode-depth.ts';
import { readSessionFile, SESSION_FILE } from '../../../export/runtime/sessions/recorded/read-session-file.ts';
import type { SessionFile } from '../../../export/runtime/sessions/session-format.ts';
import type { Shot } from '../../../export/score/flicker.ts';

/** The measurements of a recorded session, without any filter. */
export interface TrueDepth {
  /** What the camera of a frame measured, at the size of the view; null if the frame has no depth. */
  shot(index: number): Promise<Shot | null>;
}

/** Opens the session at a URL. The session has been opened by the player before, so its file is valid. */
export async function openTrueDepth(url: string, widthPx: number, heightPx: number): Promise<TrueDepth> {
  const files = createFetchAssetSource(new URL(url, document.baseURI).href, fetch.bind(globalThis));
  const { output: file } = readSessionFile(JSON.parse(new TextDecoder().decode(await files.load(SESSION_FILE))));
  if (!file) throw new Error('The session is not valid.');
  const crop: Crop = { x0: 0, y0: 0, x1: 0, y1: 0 };
  setCoverCrop(crop, file.color.widthPx, file.color.heightPx, widthPx, heightPx);
  const { fxPx, fyPx, cxPx, cyPx } = file.color.intrinsics;
  const [scaleX, scaleY] = [widthPx / (crop.x1 - crop.x0), heightPx / (crop.y1 - crop.y0)];
  const camera = { fxPx: fxPx * scaleX, fyPx: fyPx * scaleY, cxPx: (cxPx - crop.x0) * scaleX, cyPx: (cyPx - crop.y0) * scaleY };
  return {
    shot: async (index) => {
      const frame = file.frames[index];
      if (!file.depth || frame?.depth === undefined) return null;
      const meters = decodeDepth(await files.load(frame.depth), file.depth);
      const { worldFromCamera } = frame;
      return { widthPx, heightPx, camera, worldFromCamera, depthM: inView(meters, file, file.depth, crop, widthPx, heightPx) };
    },
  };
}

/** The nearest measurement to the center of each pixel of the view. */
function inView(
  meters: Float32Array,
  { color }: SessionFile,
  depth: NonNullable<SessionFile['depth']>,
  crop: Crop,
  widthPx: number,
  heightPx: number,
): Float32Array {
  const uv = new Float32Array(9);
  setUvFromViewUv(uv, crop, color.intrinsics, depth.intrinsics, depth.widthPx, depth.heightPx);
  const out = new Float32Array(widthPx * heightPx);
  for (let y = 0; y < heightPx; y++) {
    const row = Math.floor(((uv[4] ?? 0) * (1 - (y + 0.5) / heightPx) + (uv[7] ?? 0)) * depth.heightPx);
    if (row < 0 || row >= depth.heightPx) continue;
    for (let x = 0; x < widthPx; x++) {
      const column = Math.floor((((uv[0] ?? 0) * (x + 0.5)) / widthPx + (uv[6] ?? 0)) * depth.widthPx);
      if (column >= 0 && column < depth.widthPx) out[y * widthPx + x] = meters[row * depth.widthPx + column] ?? 0;
    }
  }
  return out;
}
