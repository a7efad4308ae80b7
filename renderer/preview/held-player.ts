import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createRenderClock } from '../../export/runtime/clock.ts';
import { createPlayer, type Player } from '../../export/runtime/player.ts';
import { createLoopGuard } from '../../export/runtime/program-instance/loop-watch.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../export/runtime/scenes/environments/read-radiance.ts';
import { createGlass } from '../../export/runtime/scenes/glass/glass-scene.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { findLampsAtOnce } from '../../nodes/kit/panorama/find-lamps.ts';
import type { FrameRenderRequest } from '../preview-protocol.ts';
import { previewDecoderFile } from './decoder-files.ts';
import type { LayerGate } from './layer-gate.ts';
import { pageFetch } from './network.ts';

export interface HeldPlayerOptions {
  readonly request: Pick<FrameRenderRequest, 'program' | 'values' | 'assetBaseUrl'>;
  readonly widthPx: number;
  readonly heightPx: number;
  /** The program is that of the preview, with layers that only its viewers and thumbnails show. */
  readonly gate: LayerGate;
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
}

export interface HeldPlayer {
  readonly canvas: HTMLCanvasElement;
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
}

/** The seed of the preview and of exported pages. */
const SEED = 1;

/**
 * Loads a program of the preview into a player whose clock is held, on a canvas outside the page.
 *
 * @throws Error if this computer cannot draw images of this size.
 */
export async function openHeldPlayer({ request, widthPx, heightPx, gate, onDiagnostics }: HeldPlayerOptions): Promise<HeldPlayer> {
  const { program, values, assetBaseUrl } = request;
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  const { antialias } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
  if (!gl || gl.drawingBufferWidth !== widthPx || gl.drawingBufferHeight !== heightPx) {
    throw new Error(`this computer cannot draw images of ${widthPx} × ${heightPx}.`);
  }
  const createScenes = createScenesWith({
    decoders: ALL_DECODERS,
    files: previewDecoderFile,
    readRadiance,
    findLamps: findLampsAtOnce,
    createGlass,
  });
  gate.follow(program);
  const player = createPlayer({
    monitor: { begin: gate.isDrawn, end: () => {} },
    gl,
    canvas,
    program,
    modules: RUNTIMES,
    createSpatial,
    createScenes,
    assets: createFetchAssetSource(assetBaseUrl, pageFetch),
    seed: SEED,
    clock: createRenderClock(),
    held: true,
    createLoopGuard,
    onDiagnostics,
  });
  await player.ready;
  for (const { node, param, value } of values) player.setParam(node, param, value);
  return { canvas, gl, player };
}
