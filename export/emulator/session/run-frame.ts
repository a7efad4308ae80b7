import { P_DEVICE, P_FRAME, P_SESSION, P_SPACE } from 'iwer';
import { Matrix4 } from 'three';
import type { Eye } from '../display/eye.ts';
import { P_EMULATED } from '../private.ts';
import type { World } from '../world.ts';
import { EmulatedFrame } from './emulated-frame.ts';
import { EmulatedLayer } from './emulated-layer.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { projectEye } from './projection.ts';

/**
 * One frame of the device: WebXR Device API §4.2, "run the animation frames", with the poses taken first and everything else from
 * them. Returns false when there was nothing to draw into.
 */
export function runFrame(session: EmulatedSession, timeS: number): boolean {
  const state = session[P_SESSION];
  const { world, surroundings } = session[P_EMULATED];
  const device = world.device[P_DEVICE];
  applyRenderState(session);
  const layer = currentLayer(session);
  if (state.ended || !layer) return false;

  if (world.settings.sizePx && layer.fit(world.settings.sizePx)) {
    surroundings.view.resize(layer.target.widthPx, layer.target.heightPx);
  }
  device.updateViews();
  const frame = new EmulatedFrame(session, state.frameHandle, timeS * 1000);
  // Inputs, visibility and resets, with their events; it also applies the poses that a recording plays.
  device.onFrameStart(frame);
  session[P_EMULATED].eyes = aimEyes(world, layer, state.renderState.depthNear, state.renderState.depthFar);
  world.screenInput.aim(session[P_EMULATED].eyes[0]?.clipFromView ?? new Float32Array(16));
  world.screenInput.fire(frame, session, state.updateActiveInputSources);
  state.updateActiveInputSources();
  // An event's listener may have ended it.
  if (state.ended || device.visibilityState === 'hidden') {
    frame[P_FRAME].active = false;
    return !state.ended;
  }

  layer.target.clear();
  surroundings.view.drawRoom(state.mode === 'immersive-ar' ? session[P_EMULATED].eyes : []);
  if (state.hasAnchors) state.updateTrackedAnchors();
  if (state.hasPlanes) session[P_EMULATED].surfaces.addPlanes(frame);
  if (state.hasMeshes) session[P_EMULATED].surfaces.addMeshes(frame);
  session.announceReflections();
  session[P_EMULATED].depth?.follow(session[P_EMULATED].eyes, state.renderState.depthNear, state.renderState.depthFar, world.depthState);
  frame.beginAnimation();
  runCallbacks(session, frame, timeS * 1000);
  frame[P_FRAME].active = false;
  if (!state.ended && world.settings.display) showLayer(session, layer);
  return true;
}

/** Lays what the page drew over the room on the device's screen. */
export function showLayer(session: EmulatedSession, layer: EmulatedLayer): void {
  const { surroundings, world } = session[P_EMULATED];
  surroundings.view.drawLayer(readLayer(layer), session[P_SESSION].mode === 'immersive-ar' ? world.profile.blend : 'opaque');
}

/** The page's premultiplied pixels, rows from the bottom; the same array while the layer's size stays. */
export function readLayer({ target }: EmulatedLayer): Uint8Array {
  const bytes = target.widthPx * target.heightPx * 4;
  if (layerPixels.length !== bytes) layerPixels = new Uint8Array(bytes);
  target.read(layerPixels);
  return layerPixels;
}

// Read, uploaded and forgotten within one frame.
let layerPixels = new Uint8Array(0);

export function currentLayer(session: EmulatedSession): EmulatedLayer | null {
  const layer: unknown = session[P_SESSION].renderState.baseLayer;
  return layer instanceof EmulatedLayer ? layer : null;
}

/** "Apply the pending render state"; a new base layer turns the screen on. */
function applyRenderState(session: EmulatedSession): void {
  const state = session[P_SESSION];
  if (!state.pendingRenderState) return;
  const former = currentLayer(session);
  state.renderState = state.pendingRenderState;
  state.pendingRenderState = null;
  const layer = currentLayer(session);
  if (!layer || layer === former) return;
  const { surroundings, world, overlayRoot } = session[P_EMULATED];
  surroundings.view.resize(layer.target.widthPx, layer.target.heightPx);
  if (world.settings.display) world.screen.show(surroundings.view.canvas, overlayRoot);
}

function runCallbacks(session: EmulatedSession, frame: EmulatedFrame, timeMs: number): void {
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

function aimEyes(world: World, layer: EmulatedLayer, nearM: number, farM: number): Eye[] {
  const { widthPx, heightPx } = layer.target;
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
