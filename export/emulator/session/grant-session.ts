import type { XRSession, XRSystem } from 'iwer';
import { P_SYSTEM } from 'iwer';
import { grantFeatures, type SessionWishes } from '../features.ts';
import type { World } from '../world.ts';
import { EmulatedSession } from './emulated-session.ts';

type Request = Parameters<XRSystem[typeof P_SYSTEM]['grantSession']>[0];

/** What follows `requestSession` once the mode is known to be supported (WebXR Device API §4.1). */
export function grantSession(world: World, system: XRSystem, { mode, options, resolve, reject }: Request): void {
  try {
    const session = makeSession(world, system, mode, options as SessionWishes);
    system[P_SYSTEM].activeSession = session;
    world.session = session;
    const forget = (): void => {
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
  if (mode === 'inline') throw new DOMException('The emulated device has immersive sessions only.', 'NotSupportedError');
  if (system[P_SYSTEM].activeSession) throw new DOMException('There is an immersive session already.', 'InvalidStateError');
  if (world.settings.requireGesture && !navigator.userActivation.isActive) {
    throw new DOMException('An immersive session can only be requested in the handler of a user gesture.', 'SecurityError');
  }
  const grant = grantFeatures(wishes, world.settings.features, world.settings.depth);
  if ('missing' in grant) throw new DOMException(`The device does not grant the required feature "${grant.missing}".`, 'NotSupportedError');
  const root = wishes.domOverlay?.root;
  const overlayRoot = grant.features.includes('dom-overlay') && root instanceof HTMLElement ? root : null;
  return withLocalStorage(() => new EmulatedSession(world, { ...grant, mode, overlayRoot }));
}

/** iwer reads stored anchors when a session is made, which throws where a page has no storage (sandboxed frames, bare schemes). */
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
