/// <reference types="webxr" />
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import type { Spatial } from '../../export/runtime/spatial/spatial.ts';
import type { Anchor } from '../../nodes/kit/anchors.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';

const NEEDS: readonly ProgramNeed[] = (['anchors', 'hit-test'] as const).map((capability) => ({
  capability,
  required: false,
  nodes: [],
  why: 'to test',
  without: '',
}));

const poseAt = (x: number, y: number, z: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const positionOf = (m: ArrayLike<number>) => [12, 13, 14].map((i) => Math.round((m[i] ?? 0) * 1e4) / 1e4 + 0);

interface Visit {
  readonly emulator: Emulator;
  readonly spatial: Spatial;
  readonly session: XRSession;
  frame<T>(act: (frame: SessionFrame) => T): Promise<T>;
}

/** A visit of the page: its own session and runtime, on a device that stays. */
async function visit<T>(emulator: Emulator, page: string, act: (visit: Visit) => Promise<T>): Promise<T> {
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output } = await requestWebXrSession({ xr: navigator.xr, inputs: SESSION_INPUTS, gl, needs: NEEDS, antialias: false });
  if (!output) throw new Error('There is no session.');
  const spatial = createSpatial({ gl, held: false, keptAnchors: { storage: localStorage, page } });
  let job: ((frame: SessionFrame) => void) | null = null;
  let session: XRSession | null = null;
  output.start(
    (frame) => {
      session = frame.xr?.session as XRSession;
      spatial.enterFrame(frame);
      job?.(frame);
      job = null;
    },
    () => {},
  );
  const frame = async <R>(see: (frame: SessionFrame) => R): Promise<R> => {
    const seen: R[] = [];
    job = (now) => void seen.push(see(now));
    await emulator.stepFrame();
    if (seen.length === 0) throw new Error('There was no frame.');
    return seen[0] as R;
  };
  await frame(() => {});
  if (!session) throw new Error('There is no session.');
  const result = await act({ emulator, spatial, session, frame });
  spatial.dispose();
  const left = spatial.counts();
  if (left.anchors + left.hitTests + left.deviceSources > 0) throw new Error(`Left open: ${JSON.stringify(left)}.`);
  await output.end();
  return result;
}

async function onDevice<T>(device: 'phone' | 'headset', framesPerSecond: number, act: (emulator: Emulator) => Promise<T>): Promise<T> {
  localStorage.clear();
  const emulator = installEmulator({ device, clock: 'manual', framesPerSecond, display: false, sizePx: [32, 32] });
  try {
    return await act(emulator);
  } finally {
    await emulator.uninstall();
    localStorage.clear();
  }
}

/** An anchor that is kept, then drift, and the next visit with another origin: where it is, and what is left after it is forgotten. */
export function later() {
  return onDevice('headset', 60, async (emulator) => {
    emulator.setPose({ position: [0, 1.6, 0] });
    const first = await visit(emulator, '/a', async ({ spatial, session, frame }) => {
      const anchor = await frame(() => spatial.anchors.create(poseAt(0.5, 0.7, -1), 'table'));
      const asked = anchor.keeping;
      for (let i = 0; i < 3; i++) await frame(() => {});
      return { asked, keeping: anchor.keeping, at: positionOf(anchor.worldFromAnchor), handles: session.persistentAnchors?.length };
    });
    // The device starts the next session elsewhere: its space begins at the visitor.
    emulator.setPose({ position: [1, 1.6, 2], quaternion: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
    const second = await visit(emulator, '/a', async ({ spatial, session, frame }) => {
      emulator.recenter();
      const tracked = await frame(({ xr }) => (xr?.frame as XRFrame | undefined)?.trackedAnchors?.size);
      const anchor = (await frame(() => spatial.anchors.restore('table'))) as Anchor;
      const before = anchor.state;
      for (let i = 0; i < 3; i++) await frame(() => {});
      const at = positionOf(anchor.worldFromAnchor);
      const { state } = anchor;
      const elsewhere = await frame(() => spatial.anchors.restore('wall'));
      await frame(() => spatial.anchors.forget('table'));
      await frame(() => {});
      return { tracked, before, state, at, elsewhere, handles: session.persistentAnchors?.length };
    });
    const third = await visit(emulator, '/a', ({ spatial, frame }) => frame(() => spatial.anchors.restore('table')));
    return { first, second, third };
  });
}

/** Nine anchors of two pages, and one of which the device knows nothing any more. */
export function nine() {
  return onDevice('headset', 60, async (emulator) => {
    const kept = async (page: string, names: readonly string[]) =>
      visit(emulator, page, async ({ spatial, frame, session }) => {
        const anchors: Anchor[] = [];
        for (const [i, name] of names.entries()) {
          anchors.push(await frame(() => spatial.anchors.create(poseAt(i, 0, 0), name)));
          for (let turn = 0; turn < 3; turn++) await frame(() => {});
        }
        return { told: anchors.map(({ keeping, evicted }) => `${keeping} ${evicted}`), handles: session.persistentAnchors?.length };
      });
    const first = await kept('/a', ['oldest']);
    const second = await kept('/b', ['1', '2', '3', '4', '5', '6', '7', '8']);
    const oldest = await visit(emulator, '/a', ({ spatial, frame }) => frame(() => spatial.anchors.restore('oldest')));
    emulator.forgetPersistentAnchors();
    const gone = await visit(emulator, '/b', async ({ spatial, frame }) => {
      const anchor = await frame(() => spatial.anchors.restore('8'));
      await frame(() => {});
      return anchor?.state;
    });
    return { first, second, oldest, gone };
  });
}

/** A phone, which anchors but keeps none. */
export function phone() {
  return onDevice('phone', 60, (emulator) =>
    visit(emulator, '/', async ({ spatial, frame }) => {
      const anchor = await frame(() => spatial.anchors.create(poseAt(0, 0, -1), 'table'));
      for (let i = 0; i < 3; i++) await frame(() => {});
      return [anchor.state, anchor.keeping, spatial.anchors.restore('table')];
    }),
  );
}

/**
 * Ten minutes at a frame a second, in which tracking drifts by 2 cm and 1° a minute and the visitor re-centers twice: how far the
 * anchored and the loose pose are from the point of the room at most.
 */
export function tenMinutes() {
  return onDevice('headset', 1, (emulator) =>
    visit(emulator, '/', async ({ spatial, session, frame }) => {
      // What the device itself says of the point: an anchor that the page makes beside the runtime.
      const asked: (Promise<XRAnchor> | undefined)[] = [];
      await frame(({ xr }) => {
        const { frame: now, referenceSpace } = xr as unknown as { frame: XRFrame; referenceSpace: XRReferenceSpace };
        asked.push(now.createAnchor?.(new XRRigidTransform({ x: 0.8, y: 0.7, z: -1.2 }), referenceSpace));
      });
      const anchor = await frame(() => spatial.anchors.create(poseAt(0.8, 0.7, -1.2)));
      const loose = poseAt(0.8, 0.7, -1.2);
      for (let i = 0; i < 2; i++) await frame(() => {});
      const truth = await asked[0];
      const spatialBefore = spatial.counts();
      emulator.setDrift({ offsetM: [0.02, 0, 0], yawRad: Math.PI / 180 });
      let [anchored, unanchored] = [0, 0];
      for (let second = 0; second < 600; second++) {
        if (second === 200 || second === 400) {
          emulator.setPose({ position: [second / 500, 1.6, 0.3], quaternion: [0, Math.sin(0.2), 0, Math.cos(0.2)] });
          emulator.recenter();
        }
        await frame(({ xr }) => {
          const { frame: now, referenceSpace } = xr as unknown as { frame: XRFrame; referenceSpace: XRReferenceSpace };
          const pose = truth && now.getPose(truth.anchorSpace, referenceSpace)?.transform.matrix;
          if (!pose) throw new Error('The device has lost its anchor.');
          const from = (m: ArrayLike<number>) => Math.hypot(...[12, 13, 14].map((i) => (m[i] ?? 0) - (pose[i] ?? 0)));
          anchored = Math.max(anchored, from(anchor.worldFromAnchor));
          unanchored = Math.max(unanchored, from(loose));
        });
      }
      const spatialAfter = spatial.counts();
      truth?.delete();
      anchor.delete();
      await frame(() => {});
      const tracked = await frame(({ xr }) => (xr?.frame as XRFrame | undefined)?.trackedAnchors?.size);
      return { anchored, unanchored, spatialBefore, spatialAfter, tracked, ended: session.visibilityState };
    }),
  );
}
