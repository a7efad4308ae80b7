import { P_DEVICE, P_REF_SPACE, P_SESSION, P_SPACE, P_SYSTEM, XRReferenceSpaceType } from 'iwer';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { createBrowserClock } from '../runtime/clock.ts';
import { createScreen } from './display/screen.ts';
import { EmulatedDevice } from './emulated-device.ts';
import type { Emulator, HeadPose } from './emulator.ts';
import { createReadback } from './emulator-readback.ts';
import { createFreeSource, createManualSource } from './frame-source.ts';
import { castRay } from './hit-test/cast-ray.ts';
import { createHandControls } from './input/hand-controls.ts';
import { installGlobals } from './install-globals.ts';
import { LIGHT_DEFAULTS, type LightOptions } from './light/session-light.ts';
import {
  DEPTH_DEFAULTS,
  type DepthOptions,
  EMULATOR_DEFAULTS,
  type EmulatorOptions,
  type SettledDefaults,
  withDefaults,
} from './options.ts';
import { P_EMULATED } from './private.ts';
import { DEVICE_PROFILES } from './profiles.ts';
import { createRoomServices, type OwnedRoomServices } from './room-services.ts';
import { deleteAnchors, driftSpaces } from './session/drift.ts';
import { levelPose, moveOrigin } from './session/emulated-reference-space.ts';
import type { EmulatedSession } from './session/emulated-session.ts';
import { checkModes, grantSession, type SessionWorld } from './session/grant-session.ts';
import { createPersistentAnchors } from './session/persistent-anchors.ts';
import type { EmulatedRenderState } from './session/render-state.ts';
import { showLastFrame } from './session/run-frame.ts';
import type { Drift, WorldSettings } from './world.ts';

const STEADY: Drift = { offsetM: [0, 0, 0], yawRad: 0 };

/**
 * Installs an emulated WebXR device in this page: `navigator.xr` and its interfaces, until `uninstall`. The room is created when the first
 * immersive session is requested.
 *
 * @param options Missing options have the values of `EMULATOR_DEFAULTS` and of the device's profile. Meters and radians.
 * @returns The controls of the device.
 *
 * @example
 * const emulator = installEmulator({ device: 'phone', room: 'studio', clock: 'manual' });
 * emulator.setPose({ position: [0, 1.5, 1] });
 * // … the page requests a session …
 * await emulator.frameRequested();
 * await emulator.stepFrame();
 * const { rgba } = emulator.readComposite();
 */
export function installEmulator(options: EmulatorOptions = {}): Emulator {
  const resolved = withDefaults<EmulatorOptions, keyof SettledDefaults>(EMULATOR_DEFAULTS, options);
  const profile = DEVICE_PROFILES[resolved.device];
  const device = new EmulatedDevice(resolved.device, resolved.fovYRad ?? profile.fovYRad, resolved.ipdM, resolved.modes);
  let roomServices: OwnedRoomServices | null = null;
  const world: SessionWorld = {
    device,
    profile,
    settings: resolveSettings(resolved),
    frames:
      resolved.clock === 'manual'
        ? createManualSource(resolved.framesPerSecond)
        : createFreeSource(resolved.frameClock ?? createBrowserClock()),
    screen: createScreen(resolved.container),
    screenInput: device.screenInput,
    roomServices: () => {
      roomServices ??= createRoomServices(resolved.room, resolved.antialias ?? resolved.clock === 'free');
      return roomServices;
    },
    tracked: true,
    depthState: 'working',
    lightState: 'room',
    anchorState: 'tracked',
    persistentAnchors: createPersistentAnchors(profile.persistentAnchors),
    drift: STEADY,
    session: null,
    inlineSessions: new Set(),
  };
  const uninstallGlobals = installGlobals(device);
  const system = device[P_DEVICE].xrSystem;
  if (system) {
    system[P_SYSTEM].grantSession = (request) => grantSession(world, system, request);
    checkModes(system);
  }
  // Layers own their framebuffer, and the page's canvas stays in place, so iwer's handling of both is disabled.
  device[P_DEVICE].onBaseLayerSet = () => {};
  device[P_DEVICE].onSessionEnd = () => {};

  return {
    device,
    setPose: (pose) => setPose(device, pose),
    viewPose: () => world.session?.[P_EMULATED].eyes[0]?.worldFromView ?? null,
    setFovY: (fovYRad) => {
      device.fovy = fovYRad;
    },
    setSize: (sizePx) => {
      world.settings.sizePx = sizePx;
    },
    setTracked: (tracked) => {
      world.tracked = tracked;
    },
    setDepth: (state) => {
      world.depthState = state;
    },
    setLight: (state) => {
      world.lightState = state;
    },
    moveLight: (directionWorld) => world.roomServices().moveLight(directionWorld),
    setVisibility: (state) => device.updateVisibilityState(state as Parameters<EmulatedDevice['updateVisibilityState']>[0]),
    setAnchors: (state) => {
      world.anchorState = state;
    },
    deleteAnchors: () => {
      if (world.session) deleteAnchors(world.session);
    },
    drift: (offsetM, yawRad) => {
      if (world.session) driftSpaces(world.session, offsetM, yawRad);
    },
    setDrift: (drift) => {
      world.drift = drift ?? STEADY;
    },
    forgetPersistentAnchors: () => world.persistentAnchors.clear(),
    recenter: () => recenter(world),
    endSession: async () => world.session?.end(),
    ...createHandControls(device),
    ...createTouch(world),
    ...createStepping(world),
    ...createReadback(world),
    measure: ([ox = 0, oy = 0, oz = 0], [dx = 0, dy = 0, dz = 0]) => {
      const { room } = world.roomServices();
      if (!room) return null;
      const hits = castRay(room, new Vector3(ox, oy, oz), new Vector3(dx, dy, dz).normalize(), new Set(['mesh']));
      return hits[0]?.distanceM ?? null;
    },
    uninstall: async () => {
      await world.session?.end();
      for (const session of [...world.inlineSessions]) await session.end();
      uninstallGlobals();
      roomServices?.dispose();
      roomServices = null;
    },
  };
}

function resolveSettings(resolved: EmulatorOptions & SettledDefaults): WorldSettings {
  const { views, depth, features } = DEVICE_PROFILES[resolved.device];
  const refused = new Set(resolved.refuse);
  return {
    views: resolved.views ?? views,
    features: new Set([...features, ...resolved.extra].filter((feature) => !refused.has(feature))),
    roomScanned: resolved.roomScanned,
    sizePx: resolved.sizePx,
    depth: withDefaults<DepthOptions, keyof DepthOptions>({ ...depth, ...DEPTH_DEFAULTS }, resolved.depth ?? {}),
    light: withDefaults<LightOptions, keyof LightOptions>(LIGHT_DEFAULTS, resolved.light ?? {}),
    display: resolved.display,
    displayGain: resolved.displayGain,
    requireGesture: resolved.requireGesture,
  };
}

const scratchPosition = new Vector3();
const scratchRotation = new Quaternion();
const scratchScale = new Vector3();

function setPose(device: EmulatedDevice, pose: HeadPose): void {
  if ('matrix' in pose) new Matrix4().fromArray(Array.from(pose.matrix)).decompose(scratchPosition, scratchRotation, scratchScale);
  else {
    scratchPosition.set(...pose.position);
    scratchRotation.set(...(pose.quaternion ?? [0, 0, 0, 1])).normalize();
  }
  device.position.set(scratchPosition.x, scratchPosition.y, scratchPosition.z);
  device.quaternion.set(scratchRotation.x, scratchRotation.y, scratchRotation.z, scratchRotation.w);
}

/** Re-centers at the viewer; iwer's own method moves the head to the center of the room instead. */
function recenter({ device, session }: SessionWorld): void {
  const state = device[P_DEVICE];
  state.updateViews();
  const origin = levelPose(state.viewerSpace[P_SPACE].offsetMatrix);
  const onFloor = origin.slice();
  onFloor[13] = 0;
  for (const space of session?.[P_SESSION].referenceSpaces ?? []) {
    const { type } = space[P_REF_SPACE];
    if (type === XRReferenceSpaceType.Local) moveOrigin(space, origin);
    if (type === XRReferenceSpaceType.LocalFloor) moveOrigin(space, onFloor);
  }
  if (session) session[P_EMULATED].localOrigin = origin;
  state.pendingReferenceSpaceReset = true;
}

function createTouch(world: SessionWorld): Pick<Emulator, 'press' | 'move' | 'release'> {
  return {
    press: (x, y, finger = 0) => {
      const root = world.session?.[P_EMULATED].overlayRoot;
      const touched = root ? document.elementFromPoint(x * window.innerWidth, y * window.innerHeight) : null;
      // WebXR DOM Overlays §3.3: the overlay may cancel the event to keep the touch.
      const event = new Event('beforexrselect', { bubbles: true, cancelable: true, composed: true });
      world.screenInput.press(x, y, finger, touched !== null && (root?.contains(touched) ?? false) && !touched.dispatchEvent(event));
    },
    move: (x, y, finger = 0) => world.screenInput.move(x, y, finger),
    release: (finger = 0) => world.screenInput.release(finger),
  };
}

function createStepping(world: SessionWorld): Pick<Emulator, 'frameRequested' | 'stepFrame'> {
  return {
    frameRequested: async () => {
      while (!(world.session && isWaiting(world.session))) await nextTask();
    },
    stepFrame: async (count = 1) => {
      for (let i = 0; i < count; i++) {
        const sessions = world.session ? [world.session] : [...world.inlineSessions];
        if (sessions.length === 0) throw new Error('No session is running, so no frame can be stepped.');
        if (!sessions.some(isWaiting)) throw new Error('The page has not requested a frame. Await frameRequested() first.');
        world.frames.step();
        await nextTask();
      }
      if (world.session) showLastFrame(world.session);
    },
  };
}

function isWaiting(session: EmulatedSession): boolean {
  const { ended, frameCallbacks, pendingRenderState, renderState } = session[P_SESSION];
  const { baseLayer, layers } = (pendingRenderState ?? renderState) as EmulatedRenderState;
  return !ended && frameCallbacks.length > 0 && (baseLayer !== null || layers.length > 0);
}

/** Waits for one iteration of the event loop, so that promises and messages of the page are handled. Unlike timers, it is not throttled. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
