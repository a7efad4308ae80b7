/// <reference types="webxr" />
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { createContext, lookAt, point, round, TABLE_ROOM } from './emulator-kit.ts';

/**
 * The calls of pages of the WebXR samples (https://github.com/immersive-web/webxr-samples), in their order, on the emulated device. The
 * pages draw with a renderer of their own, which is left out: what it would be given is returned.
 */

interface Visit {
  readonly emulator: Emulator;
  readonly session: XRSession;
  readonly gl: WebGL2RenderingContext;
}

/** Requests a session as the pages do, at a click, and gives it a layer. */
async function visit<T>(options: EmulatorOptions, mode: XRSessionMode, init: XRSessionInit, act: (visit: Visit) => Promise<T>): Promise<T> {
  const emulator = installEmulator({ clock: 'manual', room: TABLE_ROOM, display: false, sizePx: [64, 32], ...options });
  emulator.setPose(lookAt([0, 1.6, 0], [0, 0.8, -1.8]));
  try {
    const { xr } = navigator;
    if (!xr || !(await xr.isSessionSupported(mode))) throw new Error(`${mode} is not supported.`);
    const session = await xr.requestSession(mode, init);
    const gl = createContext();
    session.updateRenderState({ baseLayer: new XRWebGLLayer(session, gl) });
    return await act({ emulator, session, gl });
  } finally {
    await emulator.uninstall();
  }
}

/** Calls `onFrame` in each frame, which requests the next one first, as the pages do. */
function loop(session: XRSession, onFrame: (frame: XRFrame) => void): void {
  const next: XRFrameRequestCallback = (_time, frame) => {
    frame.session.requestAnimationFrame(next);
    onFrame(frame);
  };
  session.requestAnimationFrame(next);
}

/**
 * hit-test.html and hit-test-anchors.html: a reticle at the hit of the viewer's ray, an anchor from the last result at `select`, objects
 * at their anchors while these are in `trackedAnchors`.
 */
export function hitTestAnchors() {
  const init = { requiredFeatures: ['local', 'hit-test', 'anchors'] };
  return visit({ device: 'phone' }, 'immersive-ar', init, async ({ emulator, session }) => {
    let ended = false;
    session.addEventListener('end', () => {
      ended = true;
    });
    const anchors: XRAnchor[] = [];
    const placed = new Map<XRAnchor, number[]>();
    let last: XRHitTestResult | null = null;
    let reticle: number[] | null = null;
    const errors: unknown[] = [];
    session.addEventListener('select', () => {
      if (reticle)
        last?.createAnchor?.()?.then(
          (anchor) => anchors.push(anchor),
          (error: unknown) => errors.push(error),
        );
    });
    const viewerSpace = await session.requestReferenceSpace('viewer');
    const source = await session.requestHitTestSource?.({ space: viewerSpace });
    const space = await session.requestReferenceSpace('local');
    loop(session, (frame) => {
      const pose = frame.getViewerPose(space);
      reticle = null;
      if (source && pose) {
        const [first] = frame.getHitTestResults(source);
        if (first) {
          reticle = point(first.getPose(space)?.transform.position);
          last = first;
        }
      }
      for (const anchor of anchors) {
        if (!frame.trackedAnchors?.has(anchor)) continue;
        placed.set(anchor, point(frame.getPose(anchor.anchorSpace, space)?.transform.position));
      }
    });
    await emulator.stepFrame(2);
    const onTable = reticle;
    emulator.press(0.5, 0.5);
    await emulator.stepFrame();
    emulator.release();
    await emulator.stepFrame(3);
    const first = [...placed.values()];
    emulator.setPose(lookAt([0, 1.6, 0], [0, 3, -1]));
    await emulator.stepFrame();
    const atCeiling = reticle;
    anchors[0]?.delete();
    placed.clear();
    await emulator.stepFrame();
    const deleted = [...placed.values()];
    source?.cancel();
    await session.end();
    return { onTable, first, atCeiling, deleted, errors: errors.map(String), ended };
  });
}

/** anchors.html: a reticle 1 m ahead by an offset viewer space, and a free anchor there at `select`, in `unbounded` space. */
export function anchors() {
  const init = { requiredFeatures: ['viewer', 'unbounded', 'anchors'] };
  return visit({ device: 'headset' }, 'immersive-ar', init, async ({ emulator, session }) => {
    const ahead = new XRRigidTransform({ x: 0, y: 0, z: -1 }, { x: 0, y: 0, z: 1, w: 1 });
    const viewerSpace = (await session.requestReferenceSpace('viewer')).getOffsetReferenceSpace(ahead);
    const space = await session.requestReferenceSpace('unbounded');
    let reticle: XRRigidTransform | null = null;
    let anchor: XRAnchor | null = null;
    let at: number[] = [];
    session.addEventListener('select', ({ frame }) => {
      if (!reticle) return;
      void frame.createAnchor?.(reticle, space)?.then((made) => {
        anchor = made;
      });
    });
    loop(session, (frame) => {
      reticle = frame.getPose(viewerSpace, space)?.transform ?? null;
      at = anchor ? point(frame.getPose(anchor.anchorSpace, space)?.transform.position) : [];
    });
    await emulator.stepFrame(2);
    const shown = point((reticle as XRRigidTransform | null)?.position);
    emulator.device.controllers.right?.updateButtonValue('trigger', 1);
    await emulator.stepFrame();
    emulator.device.controllers.right?.updateButtonValue('trigger', 0);
    await emulator.stepFrame(3);
    emulator.setPose(lookAt([1, 1.6, 0], [1, 1.6, -1]));
    await emulator.stepFrame();
    return { shown, at, moved: point((reticle as XRRigidTransform | null)?.position) };
  });
}

/**
 * immersive-hands.html: radii and poses of 25 joints at once from the iterator of the hand, into arrays that are reused, and the tip of
 * the index finger by its name.
 */
export function hands() {
  const init = { optionalFeatures: ['local-floor', 'bounded-floor', 'hand-tracking'] };
  return visit({ device: 'headset' }, 'immersive-vr', init, async ({ emulator, session, gl }) => {
    emulator.setInput('hands');
    const [radii, poses] = [new Float32Array(25), new Float32Array(16 * 25)];
    const local = await session.requestReferenceSpace('local');
    const space = local.getOffsetReferenceSpace(new XRRigidTransform({ x: 0, y: 0, z: 0 }));
    const seen: Record<string, { tip: number[]; filled: number[]; radii: number[]; modes: string[]; size: number }> = {};
    let views = 0;
    loop(session, (frame) => {
      for (const source of session.inputSources) {
        const ray = frame.getPose(source.targetRaySpace, space);
        const { hand } = source;
        if (!hand || !ray) continue;
        // The types of the page's calls: iterators in place of lists, as the specification says “sequence”.
        const { fillJointRadii, fillPoses } = frame as unknown as Record<string, (...args: unknown[]) => boolean>;
        if (!fillJointRadii?.call(frame, hand.values(), radii) || !fillPoses?.call(frame, hand.values(), space, poses)) continue;
        const joint = hand.get('index-finger-tip');
        const tip = joint && frame.getJointPose?.(joint, space);
        seen[source.handedness] = {
          tip: point(tip?.transform.position),
          filled: [...poses.slice(16 * 9 + 12, 16 * 9 + 15)].map(round),
          radii: [...radii],
          modes: [source.targetRayMode],
          size: hand.size,
        };
      }
      const layer = frame.session.renderState.baseLayer;
      const pose = frame.getViewerPose(space);
      if (!pose || !layer) return;
      gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      views = pose.views.filter((view) => (layer.getViewport(view)?.width ?? 0) > 0).length;
    });
    await emulator.stepFrame(3);
    const states: string[] = [];
    session.addEventListener('visibilitychange', () => states.push(session.visibilityState));
    emulator.setVisibility('visible-blurred');
    await emulator.stepFrame(2);
    return { seen, views, states, hasClass: typeof XRHand !== 'undefined', error: gl.getError() };
  });
}

/**
 * input-selection.html and controller-state.html: select and squeeze events with the ray of their frame, beside an inline session; the
 * gamepad of each source.
 */
export function input() {
  const init = { requiredFeatures: ['local-floor'] };
  return visit({ device: 'headset' }, 'immersive-vr', init, async ({ emulator, session }) => {
    const inline = await navigator.xr?.requestSession('inline');
    const viewer = await inline?.requestReferenceSpace('viewer');
    const space = await session.requestReferenceSpace('local-floor');
    const events: string[] = [];
    const origins: number[][] = [];
    for (const type of ['selectstart', 'select', 'selectend', 'squeezestart', 'squeeze', 'squeezeend'] as const) {
      session.addEventListener(type, ({ frame, inputSource }) => {
        events.push(`${type} ${inputSource.handedness}`);
        if (type.endsWith('start')) origins.push(point(frame.getPose(inputSource.targetRaySpace, space)?.transform.position));
      });
    }
    let pads: { hand: string; mapping: string; pressed: number[]; axes: number[] }[] = [];
    loop(session, () => {
      pads = [...session.inputSources].flatMap(({ gamepad, handedness }) =>
        gamepad
          ? [
              {
                hand: handedness,
                mapping: gamepad.mapping,
                pressed: gamepad.buttons.flatMap(({ pressed }, i) => (pressed ? [i] : [])),
                axes: [...gamepad.axes],
              },
            ]
          : [],
      );
    });
    const { left, right } = emulator.device.controllers;
    left?.position.set(-0.2, 1.2, -0.3);
    right?.position.set(0.2, 1.2, -0.3);
    await emulator.stepFrame();
    left?.updateButtonValue('trigger', 1);
    right?.updateButtonValue('squeeze', 1);
    right?.updateAxes('thumbstick', 0.5, -1);
    await emulator.stepFrame(2);
    const held = pads;
    left?.updateButtonValue('trigger', 0);
    right?.updateButtonValue('squeeze', 0);
    await emulator.stepFrame(2);
    await inline?.end();
    return { events, origins, held, released: pads.map(({ pressed }) => pressed.length), hasInlineViewer: viewer !== undefined };
  });
}
