import { P_DEVICE, P_FRAME, P_SESSION, P_SPACE } from 'iwer';
import { P_EMULATED } from '../private.ts';
import { EmulatedFrame } from './emulated-frame.ts';
import { EmulatedLayer } from './emulated-layer.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { projectEye } from './projection.ts';
import { runCallbacks } from './run-frame.ts';

/**
 * Runs one frame of an inline session (WebXR Device API §4.2): one view from the viewer, drawn to the page's canvas. The device does not
 * present it. Returns false if there is no layer.
 */
export function runInlineFrame(session: EmulatedSession, timeS: number): boolean {
  const state = session[P_SESSION];
  if (state.pendingRenderState) state.renderState = state.pendingRenderState;
  state.pendingRenderState = null;
  const layer: unknown = state.renderState.baseLayer;
  if (state.ended || !(layer instanceof EmulatedLayer)) return false;
  const { widthPx, heightPx } = layer.target;
  const { depthNear, depthFar, inlineVerticalFieldOfView } = state.renderState;
  session[P_EMULATED].eyes = [
    {
      name: 'none',
      clipFromView: projectEye('none', inlineVerticalFieldOfView ?? Math.PI / 2, widthPx / heightPx, depthNear, depthFar),
      worldFromView: new Float32Array(session[P_EMULATED].world.device[P_DEVICE].viewerSpace[P_SPACE].offsetMatrix),
      viewport: { x: 0, y: 0, widthPx, heightPx },
    },
  ];
  const frame = new EmulatedFrame(session, state.frameHandle, timeS * 1000);
  frame.beginAnimation();
  runCallbacks(session, frame, timeS * 1000);
  frame[P_FRAME].active = false;
  return true;
}
