import { P_DEVICE, P_FRAME, P_SESSION, P_SPACE } from 'iwer';
import { Matrix4 } from 'three';
import type { Eye } from '../display/eye.ts';
import { P_EMULATED } from '../private.ts';
import type { World } from '../world.ts';
import { driftSteadily } from './drift.ts';
import { EmulatedFrame } from './emulated-frame.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { type Presentation, presentationOf } from './presentation.ts';
import { projectEye } from './projection.ts';

/**
 * Runs one frame of the device (“run the animation frames”, WebXR Device API §4.2). All data is computed from poses taken at the start.
 * Returns false if there is no layer.
 */
export function runFrame(session: EmulatedSession, timeS: number): boolean {
  const state = session[P_SESSION];
  const { world, roomServices } = session[P_EMULATED];
  const device = world.device[P_DEVICE];
  applyRenderState(session);
  const shown = presentationOf(session);
  if (state.ended || !shown) return false;

  const { canvas } = roomServices.view;
  if (canvas.width !== shown.widthPx || canvas.height !== shown.heightPx) roomServices.view.resize(shown.widthPx, shown.heightPx);
  const { lastFrameS } = session[P_EMULATED];
  session[P_EMULATED].lastFrameS = timeS;
  if (lastFrameS !== null) driftSteadily(session, world.drift, timeS - lastFrameS);
  device.updateViews();
  const frame = new EmulatedFrame(session, state.frameHandle, timeS * 1000);
  // Updates input, visibility and resets and dispatches their events; also applies recorded poses.
  device.onFrameStart(frame);
  session[P_EMULATED].eyes = aimEyes(world, shown, state.renderState.depthNear, state.renderState.depthFar);
  world.screenInput.aim(session[P_EMULATED].eyes[0]?.clipFromView ?? new Float32Array(16));
  world.screenInput.fire(frame, session, state.updateActiveInputSources);
  state.updateActiveInputSources();
  // An event listener may have ended the session.
  if (state.ended || device.visibilityState === 'hidden') {
    frame[P_FRAME].active = false;
    return !state.ended;
  }

  shown.clear();
  roomServices.view.aimRoom(state.mode === 'immersive-ar' ? session[P_EMULATED].eyes : []);
  if (state.hasAnchors) state.updateTrackedAnchors();
  if (state.hasPlanes) session[P_EMULATED].surfaces.addPlanes(frame);
  if (state.hasMeshes) session[P_EMULATED].surfaces.addMeshes(frame);
  session.announceReflections();
  session[P_EMULATED].depth?.follow(session[P_EMULATED].eyes, state.renderState.depthNear, state.renderState.depthFar, world.depthState);
  frame.beginAnimation();
  runCallbacks(session, frame, timeS * 1000);
  frame[P_FRAME].active = false;
  session[P_EMULATED].isShown = false;
  // Who steps frames sees the last one only.
  if (!world.frames.manual) showLastFrame(session);
  return true;
}

/** Shows the last frame on the device's screen, unless that shows it or nothing. */
export function showLastFrame(session: EmulatedSession): void {
  const { world, isShown } = session[P_EMULATED];
  const shown = session[P_SESSION].ended || isShown || !world.settings.display ? null : presentationOf(session);
  if (!shown) return;
  session[P_EMULATED].isShown = true;
  showPresentation(session, shown);
}

/** Composites the page's layers over the room on the device's screen. */
export function showPresentation(session: EmulatedSession, shown: Presentation): void {
  const { roomServices, world } = session[P_EMULATED];
  roomServices.view.drawLayer(
    shown.read(),
    session[P_SESSION].mode === 'immersive-ar' ? world.profile.blend : 'opaque',
    world.settings.displayGain,
  );
}

/** “Apply the pending render state”: shows the screen if the layers changed. */
function applyRenderState(session: EmulatedSession): void {
  const state = session[P_SESSION];
  if (!state.pendingRenderState) return;
  const before = presentationOf(session) !== null;
  state.renderState = state.pendingRenderState;
  state.pendingRenderState = null;
  if (before || !presentationOf(session)) return;
  const { roomServices, world, overlayRoot } = session[P_EMULATED];
  if (world.settings.display) world.screen.show(roomServices.view.canvas, overlayRoot);
}

export function runCallbacks(session: EmulatedSession, frame: EmulatedFrame, timeMs: number): void {
  const state = session[P_SESSION];
  const callbacks = state.frameCallbacks;
  state.currentFrameCallbacks = callbacks;
  state.frameCallbacks = [];
  state.activeFrame = frame;
  for (const { callback, cancelled } of callbacks) {
    if (cancelled || state.ended) continue;
    try {
      callback(timeMs, frame);
    } catch (error) {
      reportError(error);
    }
  }
  state.currentFrameCallbacks = null;
  state.activeFrame = null;
}

const scratchWorldFromView = new Matrix4();
const scratchOffset = new Matrix4();

function aimEyes(world: World, { widthPx, heightPx }: Presentation, nearM: number, farM: number): Eye[] {
  const { device } = world;
  const names = world.settings.views === 1 ? (['none'] as const) : (['left', 'right'] as const);
  const eyeWidthPx = widthPx / names.length;
  return names.map((name, index) => {
    scratchWorldFromView.fromArray(Array.from(device.viewerSpace[P_SPACE].offsetMatrix));
    scratchOffset.fromArray(Array.from(device.viewSpaces[name][P_SPACE].offsetMatrix));
    return {
      name,
      clipFromView: projectEye(name, device.fovy, eyeWidthPx / heightPx, nearM, farM),
      worldFromView: new Float32Array(scratchWorldFromView.multiply(scratchOffset).elements),
      viewport: { x: index * eyeWidthPx, y: 0, widthPx: eyeWidthPx, heightPx },
    };
  });
}
