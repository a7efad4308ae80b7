import { Matrix4 } from 'three';
import type { Anchor } from '../../kit/anchors.ts';
import type { Diagnostic } from '../../kit/diagnostics.ts';
import type { PhysicsRoom, RoomEdit } from '../../kit/physics.ts';
import type { SessionService } from '../../kit/runtime.ts';
import { readVoxelFile } from '../../kit/voxel-file.ts';

/** Seconds between two times that the room is stored. */
const EVERY_S = 5;
/** The kept bytes begin with the pose of world space in the space of the anchor: 16 32-bit floats, little-endian. */
const POSE_BYTES = 64;

type Report = Omit<Diagnostic, 'nodeId'>;

/** Keeps the voxels of a room over visits, in the space of an anchor that the device keeps. */
export interface KeptRoom {
  /**
   * Asks for the anchor, loads the room when the device has found it, and stores the room from time to time.
   *
   * @param worldFromView The newest view with depth; null while there is none.
   */
  update(timeS: number, worldFromView: ArrayLike<number> | null): void;
  /** Deletes the room for later visits too; the next depth begins another. */
  forget(): void;
  /** Begins with the anchors of another session. What is kept stays. */
  leave(): void;
}

/** @param name Unique within the page. */
export function createKeptRoom(
  name: string,
  session: Pick<SessionService, 'anchors' | 'keptFiles'>,
  room: PhysicsRoom,
  report: (diagnostic: Report) => void,
): KeptRoom {
  let anchor: Anchor | null = null;
  let isRecalled = false;
  /** Whether the anchor of an earlier visit has no pose yet. Until then nothing is stored, because it would replace the former room. */
  let isAwaited = false;
  let isTold = false;
  let storedS = 0;
  /** The newest file when the room was last asked for one to store; undefined while none is awaited. Rays ask for files too. */
  let lastFile: Uint8Array | null | undefined;

  function tell(message: string, severity: Report['severity'], fix?: string): void {
    if (!isTold) report({ code: 'SCR057', severity, message, ...(fix === undefined ? {} : { fix }) });
    isTold = true;
  }
  function load(worldFromAnchor: ArrayLike<number>): void {
    const kept = session.keptFiles.read(name);
    if (!kept) return;
    const { problem, edit } = readKept(kept, worldFromAnchor, room.settings.edgeM);
    if (edit) {
      room.edits.push(edit);
      room.changes++;
    } else tell(`The room of an earlier visit cannot be used: ${problem} It is measured anew.`, 'warning', 'Look around the room once.');
  }
  function store(file: Uint8Array, worldFromAnchor: ArrayLike<number>): void {
    const kept = new Uint8Array(POSE_BYTES + file.length);
    kept.set(new Uint8Array(Float32Array.from(new Matrix4().fromArray(worldFromAnchor).invert().elements).buffer));
    kept.set(file, POSE_BYTES);
    if (!session.keptFiles.write(name, kept)) {
      tell('The browser does not store the room for later visits: its storage is full or refused.', 'warning', 'Choose larger voxels.');
    }
  }
  function begin(worldFromView: ArrayLike<number>): void {
    const at = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, worldFromView[12] ?? 0, 0, worldFromView[14] ?? 0, 1];
    anchor = session.anchors.create(at, name);
  }
  function leave(): void {
    anchor?.delete();
    anchor = null;
    isRecalled = false;
    isAwaited = false;
    lastFile = undefined;
  }
  return {
    update: (timeS, worldFromView) => {
      if (!isRecalled) {
        isRecalled = true;
        anchor = session.anchors.restore(name);
        isAwaited = anchor !== null;
      }
      if (isAwaited && anchor?.state === 'tracked') {
        isAwaited = false;
        load(anchor.worldFromAnchor);
      } else if (anchor?.state === 'deleted') {
        anchor = null;
        isAwaited = false;
      }
      if (!anchor && worldFromView) begin(worldFromView);
      if (!anchor || isAwaited) return;
      if (anchor.keeping === 'refused') tell('The device does not keep the room for later visits.', 'info');
      if (anchor.keeping !== 'kept' || anchor.state !== 'tracked') return;
      if (lastFile !== undefined && room.file && room.file !== lastFile) {
        // After a change of the grid, the file may still be that of the former world space.
        if (room.fileChanges === room.changes) store(room.file, anchor.worldFromAnchor);
        lastFile = undefined;
      }
      if (timeS - storedS < EVERY_S && timeS >= storedS) return;
      storedS = timeS;
      lastFile = room.file;
      room.wantsFile = true;
    },
    forget: () => {
      leave();
      // Nothing is recalled, so the next depth asks for another anchor.
      isRecalled = true;
      session.anchors.forget(name);
      session.keptFiles.remove(name);
    },
    leave,
  };
}

/** Checks kept bytes, and makes of them a change of the grid; otherwise tells why they cannot be used. */
function readKept(
  kept: Uint8Array,
  worldFromAnchor: ArrayLike<number>,
  edgeM: number,
): { readonly problem: string; readonly edit: RoomEdit | null } {
  const view = new DataView(kept.buffer, kept.byteOffset, kept.byteLength);
  const no = (problem: string) => ({ problem, edit: null });
  if (kept.length < POSE_BYTES) return no('It is truncated.');
  const anchorFromWorld = new Matrix4().fromArray(Array.from({ length: 16 }, (_, i) => view.getFloat32(4 * i, true)));
  if (!anchorFromWorld.elements.every(Number.isFinite)) return no('Its pose is damaged.');
  const file = kept.slice(POSE_BYTES);
  const { voxels, problem } = readVoxelFile(file);
  if (!voxels) return no(problem);
  if (Math.abs(voxels.edgeM - edgeM) > 1e-4) {
    return no(`Its voxels have edges of ${Math.round(1000 * voxels.edgeM)} mm instead of ${Math.round(1000 * edgeM)} mm.`);
  }
  const worldFromFile = anchorFromWorld.premultiply(new Matrix4().fromArray(worldFromAnchor)).elements;
  return { problem: '', edit: { kind: 'load', file, worldFromFile } };
}
