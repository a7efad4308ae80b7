import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createRenderClock } from '../../../export/runtime/clock.ts';
import { createPlayer, type Player } from '../../../export/runtime/player.ts';
import { createScenesWith } from '../../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../../export/runtime/scenes/environments/read-radiance.ts';
import { createGlass } from '../../../export/runtime/scenes/glass/glass-scene.ts';
import { ALL_DECODERS } from '../../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../../nodes/generated/runtimes.gen.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';

/** A program to draw, as Node passes it to the page. URLs are relative to the page. */
export interface PlayedProgram {
  readonly program: Program;
  readonly assetBaseUrl: string;
  readonly decodersBaseUrl: string;
  readonly widthPx: number;
  readonly heightPx: number;
}

const SEED = 1;

/** A player on a canvas outside the page, with fixed time, date and random seed, and all parts of the runtime. */
export function createRenderPlayer(
  { program, assetBaseUrl, decodersBaseUrl, widthPx, heightPx }: PlayedProgram,
  onDiagnostics: (diagnostics: readonly Diagnostic[]) => void,
): { readonly gl: WebGL2RenderingContext; readonly player: Player } {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  const { antialias } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const fetchFile = fetch.bind(globalThis);
  const player = createPlayer({
    gl,
    canvas,
    program,
    modules: RUNTIMES,
    createSpatial,
    seed: SEED,
    clock: createRenderClock(),
    held: true,
    onDiagnostics,
    createScenes: createScenesWith({
      decoders: ALL_DECODERS,
      files: createFetchAssetSource(new URL(decodersBaseUrl, document.baseURI).href, fetchFile).load,
      readRadiance,
      findLamps: findLampsAtOnce,
      createGlass,
    }),
    assets: createFetchAssetSource(new URL(assetBaseUrl, document.baseURI).href, fetchFile),
  });
  return { gl, player };
}
