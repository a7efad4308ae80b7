import { Matrix4, Sphere, Vector3 } from 'three';
import type { Hit } from '../../kit/hit-test.ts';
import { claimPointer, freeKeys, ownKeys } from '../../kit/pointers.ts';
import { isPose, writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import { surfaceOrientation } from '../../kit/surface-pose.ts';
import type { definition } from './definition.ts';
import { createGrip, type GripEnd } from './grip.ts';
import { createHistory } from './history.ts';
import { applyKey } from './keyboard.ts';
import { distanceToBounds, writeBounds } from './reach.ts';
import { createReticle } from './reticle.ts';
import { createShownObjects } from './shown-objects.ts';
import { createSpot, restorePose, type Spot, stateOf, vacate, writeOrigin, writeSpot } from './spot.ts';

const IDENTITY = new Matrix4();
/** Greatest distance of the ring: farther away, a ring on a floor is too flat to see, and often behind a wall. */
const RETICLE_REACH_M = 8;

// Filled and read within one call.
const scratchPoint = new Vector3();
const scratchBounds = new Sphere();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { mode, surfaces, gestures, showBefore, nextSession, maxCopies, reticle: hasReticle } = ctx.config;
  const { nearM, minScale, maxScale, snapRad, gridM } = ctx.params;
  const { inputs, outputs, session } = ctx;
  const hitTest = session.openHitTest({ from: 'pointers' });
  const viewTest = hasReticle ? session.openHitTest({ from: 'viewer' }) : null;
  const copies = mode === 'add' ? Math.max(1, Math.floor(maxCopies)) : 1;
  const spots = Array.from({ length: copies }, (_, i) => createSpot(i, () => session.anchors));
  const [firstSpot] = spots as [Spot, ...Spot[]];
  const places: (Matrix4 | null)[] = spots.map(() => null);
  const grip = createGrip(ctx);
  const history = createHistory();
  const reticle = hasReticle ? createReticle() : null;
  const shown = createShownObjects(outputs.objects, reticle?.items ?? [], gestures ? ctx : null);
  const standsBefore = showBefore && mode !== 'add';
  const originFromGraph = new Matrix4();
  const steps = { minScale: 1, maxScale: 1, snapRad: 0, gridM: 0 };
  /** The copy that was placed or touched last. */
  let newest = firstSpot;
  let taps = 0;
  let jumps = 0;
  let frameJumps = 0;
  let lastSession = session.sessions;

  const hitOf = ({ id }: Pointer): Hit | null => {
    const hits = hitTest.read();
    for (let i = 0; i < hits.count; i++) {
      const hit = hits.at(i);
      if (hit.pointer === id) return suits(hit) ? hit : null;
    }
    return null;
  };
  function suits({ worldFromHit }: Hit): boolean {
    return isPose(worldFromHit) && (surfaces === 'any' || surfaceOrientation(worldFromHit) === surfaces);
  }

  function write(spot: Spot): void {
    if (spot.isPlaced) writeSpot(spot, steps.snapRad, steps.gridM, originFromGraph);
  }
  function writeAll(): void {
    for (let i = 0; i < spots.length; i++) write(spots[i] as Spot);
  }
  function countPlaced(): number {
    let count = 0;
    for (let i = 0; i < spots.length; i++) if (spots[i]?.isPlaced) count++;
    return count;
  }
  function turnTo(spot: Spot): void {
    if (spot !== newest) jumps++;
    newest = spot;
  }
  function emit(output: 'placed' | 'moved' | 'removed', spot: Spot): void {
    const pulse = outputs[output].emit();
    pulse.number = output === 'moved' ? spot.placement.scale : output === 'placed' ? taps : 0;
    pulse.bodyKey = `${ctx.node}/${spot.index}`;
    pulse.setPose(spot.worldFromPose.elements);
  }

  function remove(spot: Spot): void {
    if (!spot.isPlaced) return;
    if (grip.held === spot) grip.letGo();
    vacate(spot);
    emit('removed', spot);
    spot.isPlaced = false;
    if (newest !== spot) return;
    for (let i = 0; i < spots.length; i++) {
      const other = spots[i];
      if (other?.isPlaced) turnTo(other);
    }
  }
  function removeAll(): void {
    history.remember(spots.filter(({ isPlaced }) => isPlaced).map(stateOf));
    for (const spot of spots) remove(spot);
  }
  function undo(frame: SessionFrame): void {
    const ended = grip.cancel();
    if (ended) {
      finish(ended, frame);
      return;
    }
    for (const state of history.undo() ?? []) {
      const { spot } = state;
      const wasPlaced = spot.isPlaced;
      if (!state.isPlaced) {
        remove(spot);
        continue;
      }
      restorePose(state);
      spot.isPlaced = true;
      spot.placement.fasten(frame, 0);
      write(spot);
      turnTo(spot);
      jumps++;
      emit(wasPlaced ? 'moved' : 'placed', spot);
    }
  }
  function enterSession(frame: SessionFrame): void {
    lastSession = session.sessions;
    jumps++;
    grip.letGo();
    history.clear();
    if (nextSession === 'unplaced') freeKeys(frame.input, ctx);
    for (const spot of spots) {
      if (!spot.isPlaced) continue;
      if (nextSession === 'unplaced') remove(spot);
      else {
        spot.placement.recall(frame);
        spot.placement.fasten(frame, 0);
      }
    }
  }

  /** Chooses the copy that a tap places; null if it places none. */
  function spotForTap(): Spot | null {
    if (mode === 'add') return spots.find(({ isPlaced }) => !isPlaced) ?? null;
    return mode === 'once' && firstSpot.isPlaced ? null : firstSpot;
  }
  function place(hit: Hit, frame: SessionFrame): void {
    const spot = spotForTap();
    if (!spot) return;
    const wasPlaced = spot.isPlaced;
    const { placement } = spot;
    if (grip.held === spot) grip.letGo();
    history.remember([stateOf(spot)]);
    placement.stand(hit);
    placement.fasten(frame, steps.gridM, hit);
    if (!wasPlaced || mode === 'replace') {
      placement.turnRad = 0;
      placement.scale = Math.min(Math.max(1, steps.minScale), Math.max(steps.minScale, steps.maxScale));
    }
    spot.isPlaced = true;
    taps++;
    jumps++;
    newest = spot;
    ownKeys(frame.input, ctx);
    write(spot);
    emit(wasPlaced && mode === 'move' ? 'moved' : 'placed', spot);
  }

  /** Distance along the ray to the copy that `spotUnder` has found, meters. */
  let foundM = 0;
  /** Finds the placed copy that a press belongs to when it starts: the held one, otherwise the nearest; null if there is none. */
  function spotUnder(pointer: Pointer, frame: SessionFrame): Spot | null {
    if (!grip.accepts(pointer, frame)) return null;
    foundM = 0;
    // The second finger or hand presses anywhere.
    if (grip.held) return grip.held;
    if (!isPose(pointer.worldFromRay)) return null;
    const hit = hitOf(pointer);
    const hasBounds = writeBounds(scratchBounds, inputs.objects);
    let found: Spot | null = null;
    foundM = Number.POSITIVE_INFINITY;
    for (const spot of spots) {
      if (!spot.isPlaced) continue;
      const isNear = hit && scratchPoint.fromArray(hit.worldFromHit, 12).distanceTo(spot.placement.positionM) <= nearM.value;
      const metM = hasBounds ? distanceToBounds(pointer.worldFromRay, scratchBounds, spot.worldFromPlaced) : Number.POSITIVE_INFINITY;
      const distanceM = Math.min(metM, isNear ? hit.distanceM : Number.POSITIVE_INFINITY);
      if (distanceM >= foundM) continue;
      foundM = distanceM;
      found = spot;
    }
    return found;
  }
  function takePointers(frame: SessionFrame): void {
    const { input } = frame;
    for (let i = 0; i < input.pointerCount; i++) {
      const pointer = input.pointers[i];
      if (!pointer) continue;
      if (pointer.phase === 'start' && gestures) {
        const spot = spotUnder(pointer, frame);
        if (!spot || !claimPointer(pointer, ctx, foundM)) continue;
        grip.begin(pointer, spot);
        turnTo(spot);
        ownKeys(input, ctx);
      } else if (pointer.phase === 'end' && pointer.tapped && pointer.owner === null) {
        const hit = hitOf(pointer);
        if (hit) place(hit, frame);
      }
    }
  }
  function takeKeys(frame: SessionFrame): void {
    const { input } = frame;
    for (let i = 0; i < input.keyCount && input.keyOwner === ctx; i++) {
      const press = input.keys[i];
      if (!press) continue;
      const before = stateOf(newest);
      const action = applyKey(press, newest.placement, frame, steps);
      if (action === 'undo') undo(frame);
      else if (action === 'leave') {
        const ended = grip.cancel();
        if (ended) finish(ended, frame);
        else freeKeys(input, ctx);
      } else if (newest.isPlaced && (action === 'changed' || action === 'remove')) {
        history.remember([before]);
        if (action === 'remove') remove(newest);
        else {
          grip.letGo();
          newest.placement.fasten(frame, steps.gridM);
          write(newest);
          emit('moved', newest);
        }
      }
    }
  }
  function finish({ outcome, before }: GripEnd, frame: SessionFrame): void {
    const { spot } = before;
    spot.placement.fasten(frame, outcome === 'changed' ? steps.gridM : 0);
    write(spot);
    if (outcome === 'undone') return;
    history.remember([before]);
    emit('moved', spot);
  }

  function showReticle(frame: SessionFrame): void {
    if (!reticle || !viewTest) return;
    const seen = viewTest.read();
    let hit: Hit | null = null;
    for (let i = 0; i < frame.input.pointerCount && !hit; i++) {
      const pointer = frame.input.pointers[i];
      if (pointer?.phase === 'hover') hit = hitOf(pointer);
    }
    for (let i = 0; i < seen.count && !hit; i++) if (suits(seen.at(i))) hit = seen.at(i);
    if (hit && hit.distanceM > RETICLE_REACH_M) hit = null;
    const wants = mode === 'add' ? countPlaced() < copies : !firstSpot.isPlaced;
    reticle.update(wants, hit?.worldFromHit ?? null, frame, ctx.clock.timeS);
  }
  function show(): void {
    for (let i = 0; i < spots.length; i++) {
      const spot = spots[i];
      places[i] = spot?.isPlaced ? spot.worldFromPlaced : standsBefore ? IDENTITY : null;
    }
    shown.update(inputs.objects, places);
  }

  return {
    update: (frame) => {
      // Every frame, because the device starts to follow pointers when it is asked.
      hitTest.read();
      steps.minScale = minScale.value;
      steps.maxScale = maxScale.value;
      steps.snapRad = snapRad.value;
      steps.gridM = gridM.value;
      if (frame.jumps !== frameJumps) {
        jumps++;
        history.clear();
      }
      frameJumps = frame.jumps;
      if (session.sessions !== lastSession) enterSession(frame);
      if (standsBefore) writeOrigin(originFromGraph, inputs.objects);
      for (let i = 0; i < spots.length; i++) spots[i]?.placement.follow();
      writeAll();
      if (inputs.remove.count > 0) removeAll();
      for (let i = 0; i < inputs.undo.count; i++) undo(frame);
      takeKeys(frame);
      takePointers(frame);
      const ended = grip.update(frame, hitOf, steps);
      writeAll();
      if (ended) finish(ended, frame);
      writePose(outputs.pose, newest.isPlaced ? newest.worldFromPose.elements : null, jumps);
      outputs.isPlaced.value = newest.isPlaced;
      outputs.count.value = countPlaced();
      outputs.scale.value = newest.placement.scale;
      showReticle(frame);
      show();
    },
    prepare: show,
    staysOnRepeat: true,
    reset: () => {
      grip.letGo();
      history.clear();
      freeKeys(session.frame.input, ctx);
      for (const spot of spots) {
        vacate(spot);
        spot.isPlaced = false;
      }
      newest = firstSpot;
      taps = 0;
      jumps = 0;
      frameJumps = 0;
    },
    dispose: () => {
      freeKeys(session.frame.input, ctx);
      for (const { placement } of spots) placement.release();
      hitTest.close();
      viewTest?.close();
      shown.dispose();
      reticle?.dispose();
    },
  };
}
