import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createBrowserClock, createManualClock } from '../../export/runtime/clock.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../export/runtime/scenes/environments/read-radiance.ts';
import { createGlass } from '../../export/runtime/scenes/glass/glass-scene.ts';
import { createRecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { findLampsAtOnce } from '../../nodes/kit/panorama/find-lamps.ts';
import { stand } from '../browser/runtime-kit.ts';

const WIDTH_PX = 330;
const HEIGHT_PX = 232;

export interface Held {
  /** How many pixels ever differed from the first picture, and by how much at most. */
  readonly pixels: number;
  readonly most: number;
  /** Pictures that were not those before. */
  readonly changes: readonly number[];
  readonly colors: number;
  readonly problems: readonly unknown[];
  readonly error: number;
}

/** Holds a recording at a moment, as the editor's preview does, and draws it over and over. */
export async function hold(program: Program, assetsUrl: string, sessionUrl: string, timeS: number, times: number): Promise<Held> {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH_PX;
  canvas.height = HEIGHT_PX;
  const { antialias } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
  if (!gl) throw new Error('no WebGL 2');
  const files = (url: string) => createFetchAssetSource(new URL(url, location.href).href, (...args) => fetch(...args));
  const createScenes = createScenesWith({
    decoders: {},
    files: () => Promise.reject(new Error('no decoders')),
    createGlass,
    readRadiance,
    findLamps: findLampsAtOnce,
  });
  // Drivers are waited for in real time.
  const clock = { ...createManualClock(), delay: createBrowserClock().delay };
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes, assets: files(assetsUrl), clock });
  const session = createRecordedSession({ gl, files: files(sessionUrl), mode: { kind: 'clock', clock } });
  await session.ready;
  player.setSession(session);
  const pictures: Uint8Array[] = [];
  let isDecoded = false;
  session.start(
    (frame) => {
      if (!isDecoded) return;
      player.draw(frame);
      const bytes = new Uint8Array(WIDTH_PX * HEIGHT_PX * 4);
      gl.readPixels(0, 0, WIDTH_PX, HEIGHT_PX, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      pictures.push(bytes);
    },
    (event) => {
      if (event.kind === 'reset') player.reset();
    },
  );
  clock.advance(0.01);
  session.seekTime(timeS);
  // Until the frame of the moment is decoded, the session gives an earlier one.
  do {
    clock.advance(0);
    await new Promise((resolve) => setTimeout(resolve, 20));
  } while (session.isLate);
  isDecoded = true;
  session.seekTime(timeS);
  // Decoded files and prefiltered panoramas arrive during these frames.
  for (let i = 0; i < 3; i++) {
    clock.advance(0);
    await new Promise((resolve) => setTimeout(resolve, 160));
  }
  pictures.length = 0;
  for (let i = 0; i < times; i++) {
    clock.advance(0);
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  const first = pictures[0] ?? new Uint8Array();
  const ever = new Set<number>();
  const changes: number[] = [];
  let most = 0;
  for (const [i, picture] of pictures.entries()) {
    let differs = false;
    for (let at = 0; at < picture.length; at++) {
      const by = Math.abs((picture[at] ?? 0) - (first[at] ?? 0));
      if (by === 0) continue;
      ever.add(at >> 2);
      most = Math.max(most, by);
      differs = true;
    }
    if (differs) changes.push(i);
  }
  const colors = new Set(new Uint32Array(first.buffer)).size;
  const error = gl.getError();
  await session.end();
  player.dispose();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { pixels: ever.size, most, changes, colors, problems: diagnostics(), error };
}
