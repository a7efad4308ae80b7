import type { HitTest, MeasuredRoom } from '../../../nodes/kit/hit-test.ts';
import { EMPTY_FRAME } from '../play-state.ts';
import { createAnchorMemory } from './anchor-memory.ts';
import { createAnchorStore } from './anchor-store.ts';
import { castAtRoom, HIT_SOURCES, type RoomSources } from './cast/cast-room.ts';
import { createDepthImages } from './depth-images.ts';
import { createKeptFiles } from './kept-files.ts';
import { createHitTest } from './open-hit-test.ts';
import { createRay, setRay } from './ray.ts';
import type { CreateSpatial } from './spatial.ts';
import type { WebXrLedger } from './webxr-hits.ts';

/**
 * Maximum number of turns of the microtask queue that `settle` waits for. It is limited, because a device may answer only with its next
 * frame.
 */
const PATIENCE = 64;

// Filled and read within one call.
const scratchRay = createRay();

/**
 * Creates hit tests from the device, detected surfaces, room depth, measured rooms and the floor; anchors from the device, or ideal ones without a device.
 */
export const createSpatial: CreateSpatial = ({ gl, held, keptAnchors }) => {
  const depth = createDepthImages(gl, held);
  const ledger: WebXrLedger = { sources: 0, pending: 0 };
  const open = new Set<HitTest>();
  const measured = new Set<MeasuredRoom>();
  const room: RoomSources = { depth, measured };
  let frame = EMPTY_FRAME;
  let round = 0;
  /** The round in which a ray was last cast that measured rooms may answer. */
  let castRound = Number.NEGATIVE_INFINITY;
  const memory = createAnchorMemory(keptAnchors?.storage ?? null, keptAnchors?.page ?? '');
  const anchors = createAnchorStore(() => frame, ledger, memory);
  const waitForDevice = async (): Promise<void> => {
    for (let i = 0; i < PATIENCE && ledger.pending > 0; i++) await null;
  };
  return {
    openHitTest: (options) => {
      const hitTest = createHitTest({
        options,
        frame: () => frame,
        round: () => round,
        room,
        ledger,
        onClose: () => void open.delete(hitTest),
      });
      open.add(hitTest);
      return hitTest;
    },
    castRay: (worldFromRay, out, sources = HIT_SOURCES) => {
      if (sources.includes('voxels')) castRound = round;
      return setRay(scratchRay, worldFromRay) && castAtRoom(out, scratchRay, frame, room, sources);
    },
    answerRays: (by) => {
      measured.add(by);
      return () => void measured.delete(by);
    },
    depthImage: (viewIndex) => depth.image(frame, viewIndex),
    anchors,
    keptFiles: createKeptFiles(keptAnchors?.storage ?? null, keptAnchors?.page ?? ''),
    enterFrame: (next) => {
      frame = next;
      for (const each of measured) each.isAsked = open.size > 0 || castRound === round;
      round++;
      anchors.update(next);
    },
    leaveSession: () => {
      anchors.leave();
      frame = EMPTY_FRAME;
      round++;
    },
    settle: () => (ledger.pending > 0 ? waitForDevice() : null),
    contextLost: depth.contextLost,
    counts: () => ({ hitTests: open.size, deviceSources: ledger.sources, anchors: anchors.count }),
    dispose: () => {
      for (const hitTest of [...open]) hitTest.close();
      anchors.leave();
      depth.dispose();
    },
  };
};
