import type { XRSession, XRSystem } from 'iwer';
import { P_SYSTEM } from 'iwer';
import { grantFeatures, type SessionWishes } from '../features.ts';
import type { World } from '../world.ts';
import { EmulatedSession } from './emulated-session.ts';
import { runFrame } from './run-frame.ts';
import { runInlineFrame } from './run-inline-frame.ts';

type Request = Parameters<XRSystem[typeof P_SYSTEM]['grantSession']>[0];

/** The device and its sessions. */
export interface SessionWorld extends World {
  /** The immersive session; at most one exists. */
  session: EmulatedSession | null;
  /** The running inline sessions. */
  readonly inlineSessions: Set<EmulatedSession>;
}

/** Rejects unknown session modes with a TypeError (WebIDL enumerations); iwer treats them as not supported. */
export function checkModes(system: XRSystem): void {
  const ask = system.isSessionSupported.bind(system);
  system.isSessionSupported = async (mode) => {
    if (!MODES.includes(mode)) throw new TypeError(`"${mode}" is not a session mode. Use one of ${MODES.join(', ')}.`);
    return ask(mode);
  };
}

const MODES: readonly string[] = ['inline', 'immersive-vr', 'immersive-ar'];

/** Continues `requestSession` after the mode was found to be supported (WebXR Device API §4.1). */
export function grantSession(world: SessionWorld, system: XRSystem, { mode, options, resolve, reject }: Request): void {
  try {
    const session = makeSession(world, system, mode, options as SessionWishes);
    session.startFrames(mode === 'inline' ? runInlineFrame : runFrame);
    if (mode === 'inline') world.inlineSessions.add(session);
    else {
      system[P_SYSTEM].activeSession = session;
      world.session = session;
    }
    const forget = (): void => {
      if (world.inlineSessions.delete(session)) return;
      delete system[P_SYSTEM].activeSession;
      world.session = null;
    };
    session.addEventListener('end', forget, { once: true });
    resolve(session as XRSession);
  } catch (error) {
    reject(error);
  }
}

function makeSession(world: World, system: XRSystem, mode: Request['mode'], wishes: SessionWishes): EmulatedSession {
  if (mode === 'inline') return makeInlineSession(world, wishes);
  if (system[P_SYSTEM].activeSession) throw new DOMException('An immersive session is already running.', 'InvalidStateError');
  if (world.settings.requireGesture && !navigator.userActivation.isActive) {
    throw new DOMException('An immersive session can only be requested in the handler of a user gesture.', 'SecurityError');
  }
  const grant = grantFeatures(wishes, world.settings.features, world.settings.depth);
  if ('missing' in grant)
    throw new DOMException(`The device does not support the required feature "${grant.missing}".`, 'NotSupportedError');
  const root = wishes.domOverlay?.root;
  const overlayRoot = grant.features.includes('dom-overlay') && root instanceof HTMLElement ? root : null;
  return withLocalStorage(() => new EmulatedSession(world, { ...grant, mode, overlayRoot }));
}

/** Creates an inline session, which may run beside an immersive one and supports the reference space `viewer` only. */
function makeInlineSession(world: World, wishes: SessionWishes): EmulatedSession {
  const grant = grantFeatures(wishes, new Set(['viewer']), world.settings.depth);
  if ('missing' in grant) {
    throw new DOMException(`Inline sessions do not support "${grant.missing}", only the reference space "viewer".`, 'NotSupportedError');
  }
  return withLocalStorage(() => new EmulatedSession(world, { mode: 'inline', features: ['viewer'], depth: null, overlayRoot: null }));
}

/**
 * Calls `make`, with an empty `localStorage` in pages that have none, such as sandboxed frames. iwer reads stored anchors when it creates a
 * session, which would throw there.
 */
function withLocalStorage<T>(make: () => T): T {
  if (hasStorage()) return make();
  const former = Object.getOwnPropertyDescriptor(globalThis, 'localStorage');
  Object.defineProperty(globalThis, 'localStorage', { configurable: true, value: { getItem: () => null } });
  try {
    return make();
  } finally {
    if (former) Object.defineProperty(globalThis, 'localStorage', former);
  }
}

function hasStorage(): boolean {
  try {
    return globalThis.localStorage !== null;
  } catch {
    return false;
  }
}
