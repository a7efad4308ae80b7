import { describe, expect, test } from '@jest/globals';
import { listenForOrientation, type OrientationWindow, requestOrientationPermission } from './orientation-sensor.ts';

type Listener = (event: { alpha: number | null; beta: number | null; gamma: number | null }) => void;

function fakeWindow(screenDegrees = 0) {
  const listeners = new Set<Listener>();
  const screenListeners = new Set<() => void>();
  const orientation = {
    angle: screenDegrees,
    addEventListener: (_: string, listener: () => void) => screenListeners.add(listener),
    removeEventListener: (_: string, listener: () => void) => screenListeners.delete(listener),
  };
  const window = {
    addEventListener: (_: string, listener: Listener) => listeners.add(listener),
    removeEventListener: (_: string, listener: Listener) => listeners.delete(listener),
    screen: { orientation },
  } as unknown as OrientationWindow;
  return {
    window,
    turn: (alpha: number | null, beta: number | null, gamma: number | null) => {
      for (const listener of listeners) listener({ alpha, beta, gamma });
    },
    turnPage: (degrees: number) => {
      orientation.angle = degrees;
      for (const listener of screenListeners) listener();
    },
    listening: () => listeners.size + screenListeners.size,
  };
}

const asking = (requestPermission: unknown): OrientationWindow =>
  ({ ...fakeWindow().window, DeviceOrientationEvent: { requestPermission } }) as OrientationWindow;

describe('the orientation sensor', () => {
  test('gives radians, and notices that the page was turned', () => {
    const { window, turn, turnPage } = fakeWindow();
    const sensor = listenForOrientation(window);
    expect(sensor.present).toBe(false);
    turn(180, 90, -45);
    expect(sensor.present).toBe(true);
    expect(sensor.angles).toEqual({ alphaRad: Math.PI, betaRad: Math.PI / 2, gammaRad: -Math.PI / 4, screenRad: 0 });
    turnPage(90);
    expect(sensor.angles.screenRad).toBe(Math.PI / 2);
  });

  test('is not there on computers, whose one reading is empty', () => {
    const { window, turn } = fakeWindow(90);
    const sensor = listenForOrientation(window);
    turn(null, null, null);
    expect(sensor.present).toBe(false);
    expect(sensor.angles).toEqual({ alphaRad: 0, betaRad: Math.PI / 2, gammaRad: 0, screenRad: 0 });
  });

  test('is let go', () => {
    const { window, listening } = fakeWindow();
    listenForOrientation(window).dispose();
    expect(listening()).toBe(0);
  });

  test.each([
    ['granted', async () => 'granted', 'granted'],
    ['denied', async () => 'denied', 'denied'],
    ['not asked in a click', () => Promise.reject(new Error('NotAllowedError')), 'denied'],
    ['free to read', undefined, 'granted'],
  ])('leave to read it: %s', async (_name, requestPermission, expected) => {
    expect(await requestOrientationPermission(asking(requestPermission))).toBe(expected);
  });

  test('leave to read what is not there', async () => {
    expect(await requestOrientationPermission(fakeWindow().window)).toBe('absent');
  });
});
