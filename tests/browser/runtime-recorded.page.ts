import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createManualClock } from '../../export/runtime/clock.ts';
import { createRecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import type { SessionEvent } from '../../nodes/kit/session.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { createGl, MEASURED_DEPTH, pass, pixel, program, shader, stand } from './runtime-kit.ts';

const files = (url: string) => createFetchAssetSource(new URL(url, location.href).href, (...args) => fetch(...args));

/** Meters as bytes: red whole tenths, green hundredths beyond; blue where unknown. */
const DEPTH = `
  vec2 at = (room_uvFromViewUv * vec3(uv, 1.0)).xy;
  float cm = floor(texture(room, at).r * 100.0 + 0.5);
  color = cm == 0.0 ? vec4(0.0, 0.0, 1.0, 1.0) : vec4(floor(cm / 10.0), mod(cm, 10.0), 0.0, 255.0) / 255.0;`;

const showDepth = program({
  resources: [{ id: 'room', kind: 'room-depth' }],
  shaders: [shader('depth', DEPTH, 'uniform sampler2D room; uniform mat3 room_uvFromViewUv;')],
  operations: [
    {
      kind: 'source',
      id: 'room',
      node: 'room',
      type: 'world/depth',
      reads: [],
      writes: ['room'],
      view: 'once',
      inputs: {},
      multiple: [],
      outputs: { depth: { kind: 'resource', resource: 'room' } },
      params: {},
      config: {},
      assets: {},
    },
    pass('show', 0, 'screen', { samplers: [{ name: 'room', source: { kind: 'room-depth', resource: 'room' }, fit: 'none' }] }),
  ],
});

export interface Shot {
  readonly index: number;
  readonly timeS: number;
  readonly deltaS: number;
  readonly clipFromView: readonly number[];
  readonly worldFromView: readonly number[];
  readonly light: readonly number[] | null;
  readonly pixels: readonly (readonly number[])[];
}

/** Steps through frames on a canvas of a given shape and says what stands at the given pixels, y from the bottom. */
export async function step(url: string, shows: 'color' | 'depth', sizePx: [number, number], frames: number[], at: [number, number][]) {
  const gl = createGl();
  gl.canvas.width = sizePx[0];
  gl.canvas.height = sizePx[1];
  const leaks = trackGl(gl);
  const { player } = await stand(shows === 'color' ? program({}) : showDepth, { gl, modules: { 'world/depth': MEASURED_DEPTH } });
  const session = createRecordedSession({ gl, files: files(url), mode: { kind: 'manual' } });
  const ready = await session.ready;
  const events: SessionEvent[] = [];
  const shots: Shot[] = [];
  player.setSession(session);
  session.start(
    (frame) => {
      player.draw(frame);
      const [view] = frame.views;
      shots.push({
        index: frame.index,
        timeS: frame.timeS,
        deltaS: frame.deltaS,
        clipFromView: [...(view?.clipFromView ?? [])],
        worldFromView: [...(view?.worldFromView ?? [])],
        light: frame.light && [...frame.light.primaryIntensity],
        pixels: at.map(([x, y]) => pixel(gl, x, y)),
      });
    },
    (event) => events.push(event),
  );
  const drawn: boolean[] = [];
  for (const index of frames) drawn.push(await session.step(index));
  const outside = await session.step(99).catch((error: unknown) => (error as Error).name);
  await session.end();
  await session.end();
  player.dispose();
  return { ready, capabilities: [...session.capabilities], shots, drawn, events, outside, leaks: leaks.report(), error: gl.getError() };
}

/** Nothing but whether the folder can be played. */
export async function open(url: string) {
  const gl = createGl();
  const leaks = trackGl(gl);
  const session = createRecordedSession({ gl, files: files(url), mode: { kind: 'manual' } });
  const { output, diagnostics } = await session.ready;
  await session.end();
  return { output, diagnostics, leaks: leaks.report() };
}

/** The context goes and comes back: pixels of frame 1 before and after. */
export async function contextLoss(url: string) {
  const gl = createGl();
  const { player } = await stand(program({}), { gl });
  const session = createRecordedSession({ gl, files: files(url), mode: { kind: 'manual' } });
  await session.ready;
  player.setSession(session);
  session.start(player.draw, () => {});
  await session.step(1);
  const before = pixel(gl, 20, 20);
  const lose = gl.getExtension('WEBGL_lose_context');
  const heard = (name: string): Promise<void> =>
    new Promise((resolve) => {
      const listener = (event: Event): void => {
        event.preventDefault();
        resolve();
      };
      gl.canvas.addEventListener(name, listener, { once: true });
    });
  const lost = heard('webglcontextlost');
  lose?.loseContext();
  await lost;
  player.contextLost();
  await session.step(2);
  const restored = heard('webglcontextrestored');
  lose?.restoreContext();
  await restored;
  await player.restore();
  await session.step(1);
  const after = pixel(gl, 20, 20);
  await session.end();
  player.dispose();
  return { before, after, error: gl.getError() };
}

/** Plays three frames of 0.1 s in time, over the end, with a jump. */
export async function play(url: string) {
  const gl = createGl();
  const clock = createManualClock();
  const session = createRecordedSession({ gl, files: files(url), mode: { kind: 'clock', clock } });
  await session.ready;
  await session.preload();
  const log: string[] = [];
  session.start(
    (frame) => log.push(`${frame.index}: ${frame.timeS.toFixed(2)} +${frame.deltaS.toFixed(2)} at x ${frame.views[0]?.worldFromView[12]}`),
    (event) => log.push(event.kind),
  );
  const move = (seconds: number): void => clock.advance(seconds);
  move(0.5);
  move(0.1);
  move(0.15);
  move(0.1);
  move(0);
  session.seek(1);
  move(0.02);
  move(0.02);
  await session.end();
  move(0.1);
  return log;
}
