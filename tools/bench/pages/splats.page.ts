import { loadSplats } from '../../../export/runtime/assets/splats/load-splats.ts';
import { createGlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import type { DrawView } from '../../../nodes/kit/runtime.ts';
import { createSplatDrawing } from '../../../nodes/kit/splat-drawing/splat-drawing.ts';
import { createDepthSort, type DepthSort } from '../../../nodes/kit/splats/depth-sort.ts';
import { writeSplatFile } from '../../../nodes/kit/splats/splat-file.ts';
import { packSplats } from '../../../nodes/kit/splats/splat-packer.ts';
import { type Drawn, measureFrames } from './frame-ms.ts';

/** Splats on the walls of a room of 4 × 3 × 4 m, seen from its middle. */
interface Stage {
  readonly drawn: Drawn;
  readonly sort: DepthSort;
  readonly order: Uint32Array;
  readonly packedBytes: number;
}
let stage: Stage | null = null;
let turn = 0;

const HALF = [2, 1.5, 2] as const;

/** Makes splats of degree 3, and returns the bytes that a page loads. */
export async function open(count: number, widthPx: number, heightPx: number, readsDepth: boolean): Promise<number> {
  const gl = new OffscreenCanvas(widthPx, heightPx).getContext('webgl2', { antialias: false });
  if (!gl) throw new Error('No WebGL 2.');
  let state = 1;
  const dice = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const random = Float32Array.from({ length: 14 * count }, dice);
  // As large as neighbors are apart.
  const spread = 1.2 * Math.sqrt(80 / count);
  const splats = packSplats(count, 3, false, (index, splat) => {
    const at = (nth: number): number => random[14 * index + nth] ?? 0;
    const wall = Math.floor(6 * at(0));
    for (let axis = 0; axis < 3; axis++) {
      const half = HALF[axis] ?? 1;
      splat.position[axis] = axis === wall % 3 ? (wall < 3 ? -half : half) : half * (2 * at(1 + axis) - 1);
      splat.scale[axis] = axis === wall % 3 ? 0.1 * spread : spread * (0.4 + 0.8 * at(4 + axis));
      splat.rotation[axis] = 0;
      splat.base[axis] = at(7 + axis) - 0.5;
    }
    splat.rotation[3] = 1;
    splat.opacity = 0.3 + 0.7 * at(10);
    splat.harmonics.fill(0.1 * at(11));
  });
  const stream = new Blob([writeSplatFile(splats)]).stream().pipeThrough(new CompressionStream('gzip'));
  const packed = await new Response(stream).arrayBuffer();
  const asset = await loadSplats(createGlObjects(gl), packed, 'room.splats');
  const drawing = createSplatDrawing(gl, asset, false, null);
  const sort = createDepthSort(asset.positions);
  const order = new Uint32Array(count);
  sort.sort([0, 0, -1], order);
  drawing.setOrder(order);
  const focal = 1 / Math.tan(Math.PI / 6);
  const view = {
    view: { clipFromView: Float32Array.of((focal * heightPx) / widthPx, 0, 0, 0, 0, focal, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0) },
    viewIndex: 0,
    framebuffer: null,
    viewport: { x: 0, y: 0, widthPx, heightPx },
    readsDepth,
  } as unknown as DrawView;
  const identity = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const eye = new Float32Array(3);
  const draw = (): void => {
    gl.clear(gl.COLOR_BUFFER_BIT);
    drawing.draw(view, identity, eye);
  };
  stage = { drawn: { gl, draw }, sort, order, packedBytes: packed.byteLength };
  return packed.byteLength;
}

export function drawMs(): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage.drawn, 1);
}

/** Milliseconds of a sort after a turn of 5 degrees. */
export function sortMs(): number {
  if (!stage) throw new Error('Nothing is open.');
  turn += 0.087;
  const startMs = performance.now();
  stage.sort.sort([Math.sin(turn), 0, -Math.cos(turn)], stage.order);
  return performance.now() - startMs;
}
