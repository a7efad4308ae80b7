import type { Gltf } from '../../export/gltf/document.ts';
import { findingsOf } from '../../export/gltf/findings.ts';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { createGlLedger } from '../../export/runtime/gl/gl-ledger.ts';
import { createPlayer, type Player, type PlayResult } from '../../export/runtime/player.ts';
import { createLoopGuard } from '../../export/runtime/program-instance/loop-watch.ts';
import type { OperationMonitor } from '../../export/runtime/program-instance/step.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { readRadianceInWorker } from '../../export/runtime/scenes/environments/read-radiance-in-worker.ts';
import { createGlass } from '../../export/runtime/scenes/glass/glass-scene.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { text as decodeRadiance } from '../../nodes/generated/workers/decode-radiance.gen.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { FromPreview } from '../preview-protocol.ts';
import { withCheckedCaptures } from './checked-captures.ts';
import { type CostMeter, createCostMeter } from './cost-meter.ts';
import { previewDecoderFile } from './decoder-files.ts';
import type { LayerGate } from './layer-gate.ts';
import { pageFetch } from './network.ts';

/** A canvas, its GL context and the player on it. A new program reuses them if `canPlay` accepts it. */
export interface PlayerHost {
  readonly canvas: HTMLCanvasElement;
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly meter: CostMeter;
  /**
   * Whether the program can be played without a new context: antialiasing is fixed per context, and assets are loaded from one base
   * URL.
   */
  canPlay(program: Program, assetBaseUrl: string): boolean;
  /** Releases the player. The canvas keeps its last image until the returned function removes it. */
  dispose(): () => void;
}

export interface PlayerHostOptions {
  readonly parent: HTMLElement;
  readonly program: Program;
  readonly assetBaseUrl: string;
  readonly clock: FrameClock;
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
  /** Called when the context is lost, with null, and when it is restored, with the result of playing the newest program again. */
  readonly onContext: (played: PlayResult | null) => void;
  readonly send: (message: FromPreview) => void;
  readonly gate: Pick<LayerGate, 'isDrawn'>;
}

/**
 * Checks every model for problems as if it were a phantom. Whether a model is a phantom depends on the program, so the controller filters
 * the findings later.
 */
const inspect = (gltf: Gltf, path: string, fileBytes: number) => findingsOf(gltf, path, fileBytes, true);

/** The seed of exported pages, so that equal programs draw equal frames. */
const SEED = 1;

/**
 * Creates a canvas with a context and a player.
 *
 * @throws If the browser does not support WebGL 2.
 */
export function createPlayerHost(options: PlayerHostOptions): PlayerHost {
  const { parent, program, assetBaseUrl, clock, onDiagnostics, onContext, send, gate } = options;
  const canvas = document.createElement('canvas');
  canvas.id = 'picture';
  parent.prepend(canvas);
  const { antialias } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false, powerPreference: 'high-performance' });
  if (!gl) throw new Error('This browser has no WebGL 2.');
  const assets = withCheckedCaptures(createFetchAssetSource(assetBaseUrl, pageFetch), clock.delay);
  const createScenes = createScenesWith({
    decoders: ALL_DECODERS,
    files: previewDecoderFile,
    inspect,
    readRadiance: readRadianceInWorker(decodeRadiance),
    createGlass,
  });
  const ledger = createGlLedger(gl);
  const meter = createCostMeter(gl, clock, send, ledger.owners);
  const player = createPlayer({
    monitor: monitorOf(meter, gate),
    owned: ledger,
    createLoopGuard,
    gl,
    canvas,
    program,
    modules: RUNTIMES,
    createSpatial,
    createScenes,
    assets,
    seed: SEED,
    onDiagnostics,
    clock,
  });
  const lost = (event: Event) => {
    // Without this the browser never restores the context.
    event.preventDefault();
    player.contextLost();
    onContext(null);
  };
  const restored = () => void player.restore().then(onContext);
  canvas.addEventListener('webglcontextlost', lost);
  canvas.addEventListener('webglcontextrestored', restored);
  return {
    canvas,
    gl,
    player,
    meter,
    canPlay: (next, base) => next.presentation.antialias === antialias && base === assetBaseUrl,
    dispose: () => {
      canvas.removeEventListener('webglcontextlost', lost);
      canvas.removeEventListener('webglcontextrestored', restored);
      meter.dispose();
      player.dispose();
      ledger.dispose();
      return () => {
        // Browsers limit the number of contexts and drop the oldest. Garbage collection would release this one too late.
        gl.getExtension('WEBGL_lose_context')?.loseContext();
        canvas.remove();
      };
    },
  };
}

/** Skips what the frame does not show, and measures the rest. */
function monitorOf(meter: CostMeter, gate: Pick<LayerGate, 'isDrawn'>): OperationMonitor {
  return {
    begin: (operation) => {
      if (!gate.isDrawn(operation)) return false;
      meter.begin(operation);
      return true;
    },
    end: meter.end,
  };
}
