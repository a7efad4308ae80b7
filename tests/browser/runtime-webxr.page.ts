/// <reference types="webxr" />
import { metaQuest3, XRDevice } from 'iwer';
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import type { Program } from '../../export/program/program.ts';
import type { Player } from '../../export/runtime/player.ts';
import { requestWebXrSession, supportsWebXr } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Capability } from '../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Session, SessionFrame } from '../../nodes/kit/session.ts';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { colorSampler, MEASURED_DEPTH, pass, plainFrame, program, shader, sourceOperation, stand } from './runtime-kit.ts';

export const MODULES = { 'source/camera-video': cameraVideo, 'world/depth': MEASURED_DEPTH } satisfies Record<string, NodeModule>;

export function need(capability: Capability, required = false): ProgramNeed {
  return { capability, required, nodes: [], why: 'to test', without: `There is no ${capability}.` };
}

interface Entered {
  readonly emulator: Emulator;
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly session: Session;
  readonly diagnostics: readonly Diagnostic[];
  readonly events: string[];
  readonly frames: SessionFrame[];
  readonly leaks: () => readonly string[];
  leave(): Promise<void>;
}

/** A page that plays a program in a session of an emulated device, frame by frame. */
async function enter(options: EmulatorOptions, plays: Program, without: string[] = []): Promise<Entered> {
  const emulator = installEmulator({ clock: 'manual', display: false, sizePx: [128, 64], ...options });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const extension = gl.getExtension.bind(gl) as (name: string) => unknown;
  Object.assign(gl, { getExtension: (name: string) => (without.includes(name) ? null : extension(name)) });
  const leaks = trackGl(gl);
  const { player } = await stand(plays, { gl, modules: MODULES });
  const { output: session, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: plays.needs, antialias: false });
  if (!session) throw new Error(diagnostics.map((d) => d.message).join(' '));
  const events: string[] = [];
  const frames: SessionFrame[] = [];
  player.setSession(session);
  session.start(
    (frame) => {
      player.draw(frame);
      frames.push(plainFrame(frame));
    },
    (event) =>
      events.push(
        'by' in event
          ? `${event.kind} by ${event.by}`
          : 'visible' in event
            ? `visible ${event.visible}`
            : 'tracked' in event
              ? `tracked ${event.tracked}`
              : event.kind,
      ),
  );
  return {
    emulator,
    gl,
    player,
    session,
    diagnostics,
    events,
    frames,
    leaks: leaks.report,
    leave: async () => {
      await session.end();
      player.dispose();
      await emulator.uninstall();
    },
  };
}

/** Where in its view a pixel lies: red from left to right, green from the bottom up. */
const PLACES = program({
  shaders: [shader('places', 'color = vec4(uv, 0.0, 1.0);')],
  operations: [pass('places', 0, 'screen')],
});

/** Pixels are counted from the top left of the whole framebuffer. */
export function at({ widthPx, rgba }: { widthPx: number; rgba: Uint8Array }, x: number, y: number): number[] {
  return [...rgba.subarray((y * widthPx + x) * 4, (y * widthPx + x + 1) * 4)];
}

/** Each view is drawn into its part of the session's framebuffer, from where its eye is. */
export async function views(device: 'phone' | 'headset' | 'glasses') {
  const { emulator, gl, session, frames, leave } = await enter({ device, ipdM: 0.06 }, PLACES);
  emulator.setPose({ position: [1, 1.5, 2] });
  await emulator.stepFrame(3);
  const layer = emulator.readLayer();
  const [frame] = frames.slice(-1);
  const result = {
    world: session.world,
    blend: session.blend,
    views: frame?.views.slice(0, frame.viewCount).map((view) => ({
      eye: view.eye,
      viewport: view.viewport,
      position: [...view.worldFromView.slice(12, 15)],
      viewFromWorld: [...view.viewFromWorld.slice(12, 15)],
    })),
    times: frames.map(({ index, timeS, deltaS }) => [index, timeS, deltaS]),
    corners: [at(layer, 0, 63), at(layer, 63, 63), at(layer, 64, 63), at(layer, 127, 0)],
    error: gl.getError(),
  };
  await leave();
  return result;
}

/** Millimeters in red and green; blue where unknown. */
const DEPTH = `
  vec3 at = room_uvFromViewUv * vec3(uv, 1.0);
  float mm = floor(texture(room, at.xy / at.z).r * 1000.0 + 0.5);
  color = mm == 0.0 ? vec4(0.0, 0.0, 1.0, 1.0) : vec4(floor(mm / 256.0), mod(mm, 256.0), 0.0, 255.0) / 255.0;`;

const SHOWS_DEPTH = program({
  needs: [need('depth')],
  resources: [{ id: 'room', kind: 'room-depth' }],
  shaders: [shader('depth', DEPTH, 'uniform sampler2D room; uniform mat3 room_uvFromViewUv;')],
  operations: [
    sourceOperation('world/depth', 'depth', 'room'),
    pass('show', 0, 'screen', { samplers: [{ name: 'room', source: { kind: 'room-depth', resource: 'room' }, fit: 'none' }] }),
  ],
});

/** A block in each quarter of the view, each at a distance of its own: left and right, below and above cannot be mixed up. */
const QUARTERS = [
  { x: -1, y: -1, distanceM: 1.5 },
  { x: 1, y: -1, distanceM: 2.25 },
  { x: -1, y: 1, distanceM: 3 },
  { x: 1, y: 1, distanceM: 4.125 },
];

const ROOM = {
  boxes: QUARTERS.map(({ x, y, distanceM }) => ({
    label: 'wall',
    centerWorld: [x * 3, 1.5 + y * 3, -distanceM - 0.5] as const,
    sizeM: [6, 6, 1] as const,
  })),
};

/** Millimeters found in the middle of each quarter, view by view. */
export async function depth(options: EmulatorOptions, legacy: QuestForm | null = null, withoutExtensions: string[] = []) {
  if (legacy) answerAsQuestDoes(legacy);
  const { emulator, gl, frames, diagnostics, leave, leaks } = await enter({ room: ROOM, ...options }, SHOWS_DEPTH, withoutExtensions);
  emulator.setPose({ position: [0, 1.5, 0] });
  await emulator.stepFrame(3);
  const layer = emulator.readLayer();
  const [frame] = frames.slice(-1);
  const found = frame?.views.slice(0, frame.viewCount).map(({ viewport }) =>
    QUARTERS.map(({ x, y }) => {
      const px = viewport.x + Math.floor(viewport.widthPx * (0.5 + x * 0.15));
      const py = viewport.y + Math.floor(viewport.heightPx * (0.5 + y * 0.15));
      const [high = 0, low = 0, unknown] = at(layer, px, layer.heightPx - 1 - py);
      return unknown === 255 ? null : high * 256 + low;
    }),
  );
  const error = gl.getError();
  await leave();
  return { found, diagnostics, leaks: leaks(), error };
}

/** Quest Browser's and iwer's form: window depth without a far plane, first row at the bottom, an array with a layer per eye. */
type QuestForm = 'whole' | 'without textureType and imageIndex' | 'not valid';

function answerAsQuestDoes(form: QuestForm): void {
  // Put in place when the emulator has brought its interfaces.
  let Binding: typeof XRWebGLBinding | undefined;
  Object.defineProperty(globalThis, 'XRWebGLBinding', {
    configurable: true,
    get: () => Binding,
    set: (real: (new (...args: never[]) => object) | undefined) => {
      Binding = real && (questBinding(real, form) as unknown as typeof XRWebGLBinding);
    },
  });
}

function questBinding(Real: new (...args: never[]) => object, form: QuestForm) {
  return class extends (Real as new (session: XRSession, gl: WebGL2RenderingContext) => object) {
    private readonly texture: WebGLTexture;
    constructor(
      session: XRSession,
      private readonly context: WebGL2RenderingContext,
    ) {
      super(session, context);
      const size = 8;
      const nearM = 0.25;
      const values = new Float32Array(size * size * 2);
      for (let i = 0; i < values.length; i++) {
        const x = i % size < size / 2 ? -1 : 1;
        const y = Math.floor(i / size) % size < size / 2 ? -1 : 1;
        const meters = QUARTERS.find((q) => q.x === x && q.y === y)?.distanceM ?? 0;
        values[i] = 1 - nearM / meters;
      }
      this.texture = context.createTexture();
      context.bindTexture(context.TEXTURE_2D_ARRAY, this.texture);
      context.texImage3D(context.TEXTURE_2D_ARRAY, 0, context.R32F, size, size, 2, 0, context.RED, context.FLOAT, values);
      session.addEventListener('end', () => context.deleteTexture(this.texture));
    }
    getDepthInformation(view: XRView) {
      const matrix = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
      return {
        texture: this.texture,
        ...(form !== 'without textureType and imageIndex' && { textureType: 'texture-array', imageIndex: view.eye === 'right' ? 1 : 0 }),
        isValid: form !== 'not valid',
        width: 8,
        height: 8,
        rawValueToMeters: 1,
        normDepthBufferFromNormView: { matrix },
        depthNear: 0.25,
        depthFar: Number.POSITIVE_INFINITY,
      };
    }
  };
}

export const SHOWS_CAMERA = program({
  needs: [need('camera-image')],
  resources: [{ id: 'video', kind: 'external', domain: 'view' }],
  shaders: [
    shader(
      'show',
      'vec2 at = (picture_uvFromViewUv * vec3(uv, 1.0)).xy; color = texture(picture, at);',
      'uniform sampler2D picture; uniform mat3 picture_uvFromViewUv;',
    ),
  ],
  operations: [
    sourceOperation('source/camera-video', 'layer', 'video', { config: { withoutImage: 'transparent' } }),
    pass('show', 0, 'screen', { samplers: [colorSampler('picture', 'video')] }),
  ],
});

/** How far what the page draws of the camera picture is from what the camera saw. */
export async function camera(refuse: string[]) {
  const { emulator, session, diagnostics, leave, leaks } = await enter({ device: 'phone', room: 'studio', refuse }, SHOWS_CAMERA);
  emulator.setPose({ position: [0.3, 1.5, 0.2] });
  await emulator.stepFrame(2);
  const layer = emulator.readLayer();
  const room = emulator.readRoom();
  let largest = 0;
  const alphas = new Set<number | undefined>();
  const colors = new Set<string>();
  for (let i = 0; i < layer.rgba.length; i += 4) {
    for (let c = i; c < i + 3; c++) largest = Math.max(largest, Math.abs((layer.rgba[c] ?? 0) - (room.rgba[c] ?? 0)));
    alphas.add(layer.rgba[i + 3]);
    colors.add(layer.rgba.subarray(i, i + 3).join());
  }
  await leave();
  return { largest, alphas: [...alphas], colors: colors.size, capabilities: [...session.capabilities], diagnostics, leaks: leaks() };
}

/** The light that the device says there is. */
export async function light() {
  const { emulator, frames, leave } = await enter({ device: 'phone', room: ROOM }, { ...PLACES, needs: [need('light-estimation')] });
  await emulator.stepFrame(4);
  const { light: estimate } = frames.at(-1) ?? {};
  await leave();
  return (
    estimate && {
      direction: [...estimate.primaryDirectionWorld],
      intensity: [...estimate.primaryIntensity],
      coefficients: estimate.sphericalHarmonics.length,
    }
  );
}

/** What befalls a session, and what the page hears of it. */
export async function events(endedBy: 'page' | 'device') {
  const { emulator, session, events: heard, frames, leave, leaks } = await enter({ device: 'headset', room: ROOM }, SHOWS_DEPTH);
  await emulator.stepFrame();
  emulator.setTracked(false);
  const before = frames.length;
  await emulator.stepFrame(2);
  const whileLost = frames.length - before;
  emulator.setTracked(true);
  await emulator.stepFrame();
  for (const state of ['visible-blurred', 'hidden', 'visible'] as const) {
    emulator.setVisibility(state);
    await emulator.stepFrame();
  }
  emulator.recenter();
  await emulator.stepFrame();
  if (endedBy === 'page') {
    await Promise.all([session.end(), session.end()]);
  } else {
    await emulator.endSession();
    await session.end();
  }
  await leave();
  return { heard, whileLost, leaks: leaks() };
}

/** The context goes and comes back twice while the session runs: the same session draws on, in a framebuffer of the new context. */
export async function contextLoss() {
  const { emulator, gl, player, events: heard, frames, leave } = await enter({ device: 'headset', room: ROOM }, SHOWS_DEPTH);
  const lose = gl.getExtension('WEBGL_lose_context');
  const event = (name: string): Promise<void> =>
    new Promise((resolve) => {
      const listener = (e: Event): void => {
        e.preventDefault();
        resolve();
      };
      gl.canvas.addEventListener(name, listener, { once: true });
    });
  const picture = async () => {
    await emulator.stepFrame(3);
    return Array.from(emulator.readLayer().rgba);
  };
  const before = await picture();
  const whileLost: number[] = [];
  let same = true;
  for (let i = 0; i < 2; i++) {
    const lost = event('webglcontextlost');
    lose?.loseContext();
    await lost;
    player.contextLost();
    const drawn = frames.length;
    // A second and a half of the device's time.
    await emulator.stepFrame(90);
    whileLost.push(frames.length - drawn);
    const restored = event('webglcontextrestored');
    await new Promise((resolve) => setTimeout(resolve, 0));
    lose?.restoreContext();
    await restored;
    await player.restore();
    const after = await picture();
    same &&= after.length === before.length && after.every((value, at) => Math.abs(value - (before[at] ?? 0)) <= 1);
  }
  const blank = before.every((value) => value === 0);
  const error = gl.getError();
  await leave();
  return { same, blank, whileLost, heard, longest: Math.max(...frames.map(({ deltaS }) => deltaS)), error };
}

/** Why there is no session, or what it lacks. */
export async function refusals() {
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const ask = async (options: EmulatorOptions | null, ...needs: ProgramNeed[]) => {
    const emulator = options && installEmulator({ clock: 'manual', display: false, ...options });
    const xr = options ? navigator.xr : undefined;
    const supported = await supportsWebXr(xr);
    const { output, diagnostics } = await requestWebXrSession({ xr, gl, needs, antialias: true });
    await output?.end();
    await emulator?.uninstall();
    return [supported, output !== null, ...diagnostics.map(({ code, message }) => `${code} ${message}`)];
  };
  return {
    none: await ask(null),
    lacking: await ask({ refuse: ['hit-test'] }, need('hit-test', true)),
    optional: await ask({ device: 'glasses' }, need('depth'), need('hit-test')),
    complete: await ask({ device: 'phone' }, need('depth')),
  };
}

/** What the page says of each way in which a browser can refuse. */
export async function refusedBy(errorName: string) {
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const xr = { requestSession: () => Promise.reject(new DOMException('The device is busy.', errorName)) } as unknown as XRSystem;
  const { output, diagnostics } = await requestWebXrSession({ xr, gl, needs: [], antialias: true });
  return [output, ...diagnostics.map(({ code, message, fix }) => `${code} ${message} ${fix}`)];
}

/** iwer as it comes: no floor, a right view of no width when it has one eye, frames by the display's clock. */
export async function plainIwer(stereo: boolean) {
  const device = new XRDevice(metaQuest3, { stereoEnabled: stereo });
  device.installRuntime({ forceInstall: true });
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
  const { player } = await stand(PLACES, { gl });
  const { output: session, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: [], antialias: false });
  if (!session) throw new Error(diagnostics.map((d) => d.message).join(' '));
  const shown = await new Promise((resolve) => {
    session.start(
      (frame) => {
        player.draw(frame);
        const rgba = new Uint8Array(4);
        gl.readPixels(canvas.width - 1, canvas.height - 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
        const views = frame.views.slice(0, frame.viewCount);
        resolve({ viewports: views.map((v) => ({ ...v.viewport })), eyes: views.map((v) => v.eye), corner: [...rgba] });
      },
      () => {},
    );
  });
  await session.end();
  player.dispose();
  return shown;
}
