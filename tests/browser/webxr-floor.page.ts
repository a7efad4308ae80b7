/// <reference types="webxr" />
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { stand } from './runtime-kit.ts';
import { at, MODULES, SHOWS_CAMERA } from './runtime-webxr.page.ts';

/** Where the eyes are after the visitor re-centered, where no browser knows the floor, and the color of the pixel at the bottom of what is drawn. */
export async function withoutFloor(mode: 'immersive-ar' | 'immersive-vr') {
  const emulator = installEmulator({ device: 'headset', clock: 'manual', display: false, sizePx: [128, 64], refuse: ['local-floor'] });
  emulator.setPose({ position: [0, 1.3, 0] });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { player } = await stand(SHOWS_CAMERA, { gl, modules: MODULES });
  const { output: session, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, mode, needs: [], antialias: false });
  if (!session) throw new Error(diagnostics.map((d) => d.message).join(' '));
  const heights: number[] = [];
  let resets = 0;
  player.setSession(session);
  session.start(
    (frame) => {
      player.draw(frame);
      heights.push(frame.views[0]?.worldFromView[13] ?? 0);
    },
    ({ kind }) => {
      if (kind === 'recentered') resets++;
    },
  );
  await emulator.stepFrame(2);
  emulator.recenter();
  await emulator.stepFrame(2);
  const first = heights.at(-1);
  emulator.setPose({ position: [0, 1.5, 0] });
  await emulator.stepFrame(2);
  const layer = emulator.readLayer();
  const [floor, sky] = [at(layer, 32, 60), at(layer, 32, 3)];
  await session.end();
  player.dispose();
  await emulator.uninstall();
  return { first, last: heights.at(-1), resets, floor, sky };
}
