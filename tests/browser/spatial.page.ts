/// <reference types="webxr" />
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import type { Spatial } from '../../export/runtime/spatial/spatial.ts';
import type { Anchor } from '../../nodes/kit/anchors.ts';
import type { Capability } from '../../nodes/kit/definition.ts';
import { createHit, type Hit, type HitSource } from '../../nodes/kit/hit-test.ts';
import type { SessionEvent, SessionFrame } from '../../nodes/kit/session.ts';

function need(capability: Capability): ProgramNeed {
  return { capability, required: false, nodes: [], why: 'to test', without: '' };
}

interface Stage {
  readonly emulator: Emulator;
  readonly spatial: Spatial;
  readonly events: string[];
  /** Runs one frame, with what is to be done in it. */
  frame<T>(act: (frame: SessionFrame) => T): Promise<T>;
}

async function inSession<T>(options: EmulatorOptions, needs: readonly Capability[], act: (stage: Stage) => Promise<T>, held = false) {
  const emulator = installEmulator({ clock: 'manual', display: false, sizePx: [128, 96], ...options });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output: session } = await requestWebXrSession({
    xr: navigator.xr,
    inputs: SESSION_INPUTS,
    gl,
    needs: needs.map(need),
    antialias: false,
  });
  if (!session) throw new Error('There is no session.');
  const spatial = createSpatial({ gl, held });
  const events: string[] = [];
  let job: ((frame: SessionFrame) => void) | null = null;
  session.start(
    (frame) => {
      spatial.enterFrame(frame);
      job?.(frame);
      job = null;
    },
    (event: SessionEvent) => events.push(event.kind),
  );
  const frame = async <R>(run: (frame: SessionFrame) => R): Promise<R> => {
    let result: { readonly value: R } | null = null;
    job = (now) => {
      result = { value: run(now) };
    };
    await emulator.stepFrame();
    if (!result) throw new Error('There was no frame.');
    return (result as { readonly value: R }).value;
  };
  const result = await act({ emulator, spatial, events, frame });
  const before = spatial.counts();
  spatial.dispose();
  const after = spatial.counts();
  await session.end();
  await emulator.uninstall();
  return { ...result, before, after, error: gl.getError() };
}

function told({ worldFromHit: m, source, distanceM, anchorable, label, frame }: Hit) {
  return { at: [...m.slice(12, 15)], normal: [...m.slice(4, 7)], z: [...m.slice(8, 11)], source, distanceM, anchorable, label, frame };
}

/** Looks from (0, 1.5, 1) down by `pitchRad`. */
function lookDown(emulator: Emulator, pitchRad: number): void {
  emulator.setPose({ position: [0, 1.5, 1], quaternion: [-Math.sin(pitchRad / 2), 0, 0, Math.cos(pitchRad / 2)] });
}

/** The middle of a phone's view, a finger's tap beside it, and what the room says of both. */
export function phone(needs: readonly Capability[], options: EmulatorOptions = {}) {
  return inSession({ device: 'phone', room: 'studio', ...options }, needs, async ({ emulator, spatial, frame }) => {
    const viewer = spatial.openHitTest({ from: 'viewer' });
    const pointers = spatial.openHitTest({ from: 'pointers' });
    lookDown(emulator, 1);
    await frame(() => [viewer.read(), pointers.read()]);
    await frame(() => [viewer.read(), pointers.read()]);
    const center = await frame(() => (viewer.read().count > 0 ? told(viewer.read().at(0)) : null));
    emulator.press(0.6, 0.55);
    const seen: unknown[] = [];
    const step = () =>
      frame(({ input }) => {
        const hits = pointers.read();
        const ray = input.pointers[0]?.worldFromRay;
        seen.push({
          phases: input.pointers.slice(0, input.pointerCount).map(({ phase, by }) => `${by} ${phase}`),
          taps: input.tapCount,
          hit: hits.count > 0 ? told(hits.at(0)) : null,
          ray: ray && [...ray],
          pointer: hits.count > 0 && hits.at(0).pointer === input.pointers[0]?.id,
        });
      });
    await step();
    await step();
    await step();
    emulator.release();
    await step();
    await step();
    viewer.close();
    viewer.close();
    pointers.close();
    return { center, seen };
  });
}

/** Each source alone, along the middle of the view; depth on the GPU is read back without waiting. */
export function sources(options: EmulatorOptions, held: boolean) {
  return inSession(
    { device: 'headset', room: 'studio', ...options },
    ['hit-test', 'planes', 'meshes', 'depth'],
    async ({ emulator, spatial, frame }) => {
      lookDown(emulator, 1);
      const hit = createHit();
      const ray = new Float32Array([1, 0, 0, 0, 0, Math.cos(1), -Math.sin(1), 0, 0, Math.sin(1), Math.cos(1), 0, 0, 1.5, 1, 1]);
      const by: Partial<Record<HitSource, ReturnType<typeof told> | null>> = {};
      let waited = 0;
      for (const source of ['session', 'plane', 'mesh', 'depth', 'floor'] as const) {
        by[source] = await frame(() => (spatial.castRay(ray, hit, [source]) ? told(hit) : null));
        // Depth of the GPU comes some frames later.
        while (source === 'depth' && !by[source] && waited < 1000 && !held) {
          waited++;
          await new Promise((resolve) => requestAnimationFrame(resolve));
          by[source] = await frame(() => (spatial.castRay(ray, hit, [source]) ? told(hit) : null));
        }
      }
      const index = await frame((now) => now.index);
      const first = await frame(() => (spatial.castRay(ray, hit) ? hit.source : null));
      // There is a carpet.
      const solidM = emulator.measure([0, 1.5, 1], [0, -Math.sin(1), -Math.cos(1)]);
      return { by, first, waited, index, solidM };
    },
    held,
  );
}

/** The right controller of a headset points at the floor, and then is gone. */
export function controllers() {
  return inSession({ device: 'headset', room: 'studio' }, ['hit-test', 'anchors'], async ({ emulator, spatial, frame }) => {
    const hits = spatial.openHitTest({ from: 'right' });
    const offset = spatial.openHitTest({ from: 'right', offsetRay: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1] });
    const controller = emulator.device.controllers.right;
    if (!controller) throw new Error('The headset has no right controller.');
    lookDown(emulator, 0.5);
    controller.position.set(0.2, 1, 0.5);
    controller.quaternion.set(-Math.SQRT1_2, 0, 0, Math.SQRT1_2);
    const read = () => frame(() => [hits.read(), offset.read()].map((list) => (list.count > 0 ? told(list.at(0)) : null)));
    await read();
    await read();
    const found = await read();
    const open = spatial.counts().deviceSources;
    controller.connected = false;
    await read();
    const gone = await read();
    const left = spatial.counts().deviceSources;
    controller.connected = true;
    await read();
    await read();
    const back = await read();
    hits.close();
    offset.close();
    return { found, open, gone, left, back };
  });
}

/** An anchor at the middle of the view, and the same point without one, while tracking drifts and the visitor re-centers. */
export function anchors() {
  return inSession({ device: 'phone', room: 'studio' }, ['hit-test', 'anchors'], async ({ emulator, spatial, events, frame }) => {
    const hits = spatial.openHitTest({ from: 'viewer' });
    lookDown(emulator, 1);
    await frame(() => hits.read());
    await frame(() => hits.read());
    const made: Anchor[] = [];
    const states: string[] = [];
    const loose = await frame(() => {
      const hit = hits.read().at(0);
      made.push(spatial.anchors.create(hit), spatial.anchors.create(hit.worldFromHit.slice()));
      states.push(made.map(({ state }) => state).join());
      return hit.worldFromHit.slice();
    });
    const state = () => states.push(made.map((anchor) => anchor.state).join());
    await frame(() => {});
    await frame(state);
    // The hit test measures where the point of the room is now, in the session's drifted space.
    const errors = () =>
      frame((now) => {
        const truth = hits.read().at(0).worldFromHit;
        const from = (m: Float32Array) => Math.hypot(...[12, 13, 14].map((i) => (m[i] ?? 0) - (truth[i] ?? 0)));
        return { anchored: made.map((anchor) => from(anchor.worldFromAnchor)), loose: from(loose), jumps: now.jumps };
      });
    const steady = await errors();
    for (let minute = 0; minute < 10; minute++) {
      emulator.drift([0.02, 0, 0.01], Math.PI / 180);
      await frame(() => {});
    }
    const drifted = await errors();
    emulator.recenter();
    await frame(() => {});
    await frame(() => {});
    const recentered = await errors();
    emulator.setAnchors('lost');
    await frame(state);
    emulator.setAnchors('tracked');
    await frame(state);
    emulator.deleteAnchors();
    await frame(() => {});
    await frame(state);
    const counted = spatial.counts().anchors;
    hits.close();
    return { states, steady, drifted, recentered, counted, events };
  });
}

/** Sessions that grant no anchors, that end with some, and poses that are none. */
export async function refusals() {
  const refused = await inSession(
    { device: 'phone', room: 'studio', refuse: ['anchors', 'hit-test'] },
    ['hit-test', 'anchors'],
    async ({ emulator, spatial, frame }) => {
      const hits = spatial.openHitTest({ from: 'viewer' });
      lookDown(emulator, 1);
      await frame(() => hits.read());
      const found = await frame(() => told(hits.read().at(0)));
      const anchor = await frame(() => spatial.anchors.create(hits.read().at(0)));
      const state = anchor.state;
      let wrong = '';
      try {
        spatial.anchors.create([Number.NaN]);
      } catch (error) {
        wrong = (error as Error).name;
      }
      const { counts } = spatial;
      anchor.delete();
      anchor.delete();
      return { found, state, wrong, deleted: anchor.state, left: counts().anchors };
    },
  );
  const ended = await inSession({ device: 'phone', room: 'studio' }, ['hit-test', 'anchors'], async ({ spatial, frame }) => {
    const anchor = await frame(() => spatial.anchors.create([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1]));
    await frame(() => {});
    await frame(() => {});
    const { state } = anchor;
    spatial.leaveSession();
    return { state, afterwards: anchor.state, at: [...anchor.worldFromAnchor.slice(12, 15)] };
  });
  return { refused, ended };
}
