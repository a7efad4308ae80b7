import { expect, test } from '@jest/globals';
import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { DetectedPlane, DetectedSurfaces } from '../../../../nodes/kit/session.ts';
import { createRoomCapture } from './room-capture.ts';

const PLANES: ReadonlySet<Capability> = new Set(['planes']);
const NOTHING: DetectedSurfaces = { planes: [], meshes: [] };

function sessionWith(answer: () => Promise<void>) {
  const asked: number[] = [];
  const session = {
    initiateRoomCapture: () => {
      asked.push(asked.length);
      return answer();
    },
  };
  return { asked, session: session as unknown as XRSession };
}

test('a device that knows no surface after five seconds is asked for a scan, once', async () => {
  const { asked, session } = sessionWith(() => Promise.reject(new DOMException('No.', 'NotAllowedError')));
  const capture = createRoomCapture(session, PLANES);
  for (const timeS of [0, 2, 4.9]) capture?.update(timeS, NOTHING);
  expect(asked).toHaveLength(0);
  for (const timeS of [5, 6, 60]) capture?.update(timeS, NOTHING);
  expect(asked).toHaveLength(1);
});

test('a device that knows the room is not asked, even if its surfaces are lost later', () => {
  const { asked, session } = sessionWith(async () => {});
  const capture = createRoomCapture(session, PLANES);
  capture?.update(1, { planes: [{} as DetectedPlane], meshes: [] });
  capture?.update(20, NOTHING);
  expect(asked).toHaveLength(0);
});

test('there is no capture where the page reads no planes, or the browser has none', () => {
  const { session } = sessionWith(async () => {});
  expect(createRoomCapture(session, new Set(['depth']))).toBeNull();
  expect(createRoomCapture({} as XRSession, PLANES)).toBeNull();
});
