import { expect, test } from '@jest/globals';
import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { DetectedPlane, DetectedSurfaces } from '../../../../nodes/kit/session.ts';
import { createRoomCapture } from './room-capture.ts';

const PLANES: ReadonlySet<Capability> = new Set(['planes']);
const NOTHING: DetectedSurfaces = { planes: [], meshes: [] };
const FLOOR: DetectedSurfaces = { planes: [{} as DetectedPlane], meshes: [] };

function setUp(answer: () => Promise<void> = async () => {}) {
  let asked = 0;
  const session = {
    initiateRoomCapture: () => {
      asked++;
      return answer();
    },
  };
  const offers: ((() => Promise<boolean>) | null)[] = [];
  const capture = createRoomCapture(session as unknown as XRSession, PLANES, (offer) => offers.push(offer));
  return { capture, offers, asked: () => asked };
}

test('a scan is offered once where the device knows no surface after five seconds, and starts only when it is asked for', async () => {
  const { capture, offers, asked } = setUp();
  for (const timeS of [0, 2, 4.9]) capture?.update(timeS, NOTHING);
  expect(offers).toEqual([]);
  for (const timeS of [5, 6, 60]) capture?.update(timeS, NOTHING);
  expect(offers).toHaveLength(1);
  expect(asked()).toBe(0);
  await expect(offers[0]?.()).resolves.toBe(true);
  // A session can scan once.
  await expect(offers[0]?.()).resolves.toBe(false);
  expect(asked()).toBe(1);
  capture?.update(61, FLOOR);
  expect(offers).toHaveLength(1);
});

test('a refused scan is told, and is not offered again', async () => {
  const { capture, offers } = setUp(() => Promise.reject(new DOMException('No.', 'NotAllowedError')));
  capture?.update(5, NOTHING);
  await expect(offers[0]?.()).resolves.toBe(false);
  capture?.update(20, NOTHING);
  expect(offers).toHaveLength(1);
});

test('the offer is withdrawn when surfaces come', async () => {
  const { capture, offers, asked } = setUp();
  capture?.update(5, NOTHING);
  capture?.update(7, FLOOR);
  capture?.update(20, NOTHING);
  expect(offers).toEqual([expect.any(Function), null]);
  await expect(offers[0]?.()).resolves.toBe(false);
  expect(asked()).toBe(0);
});

test('a device that knows the room offers nothing, even if its surfaces are lost later', () => {
  const { capture, offers } = setUp();
  capture?.update(1, FLOOR);
  capture?.update(20, NOTHING);
  expect(offers).toEqual([]);
});

test('there is no capture where the page reads no planes, or the browser has none', () => {
  const session = { initiateRoomCapture: async () => {} } as unknown as XRSession;
  expect(createRoomCapture(session, new Set(['depth']), () => {})).toBeNull();
  expect(createRoomCapture({} as XRSession, PLANES, () => {})).toBeNull();
});
