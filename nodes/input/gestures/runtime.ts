import { canPinch, isOnScreen } from '../../kit/pointer-span.ts';
import { claimPointer, pointerById, rayTurnRad } from '../../kit/pointers.ts';
import type { NodeContext, NodeRuntime, PulseOutput } from '../../kit/runtime.ts';
import type { Pointer, SessionFrame, ViewFrame } from '../../kit/session.ts';
import type { definition } from './definition.ts';
import { createPressMotion } from './press-motion.ts';
import { createSpanMotion } from './span-motion.ts';

/**
 * The state of the gesture. `waiting`: a press has started, and “Active” may still turn on. `spent`: the press was a long press or part of
 * a pinch, so it is no tap; it may still become a drag.
 */
type State = 'none' | 'waiting' | 'pressed' | 'spent' | 'dragging' | 'pinching';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { by, presses, after } = ctx.config;
  const { inputs, outputs, params, clock } = ctx;
  const motion = createPressMotion();
  const span = createSpanMotion();
  let state: State = 'none';
  /** Ids of the pointers of the gesture, `first` and `second`; 0 for none. */
  let first = 0;
  let second = 0;
  let startS = 0;
  let jumps = 0;
  const startRay = new Float32Array(16);

  /** Sums of the drags, scales and twists of past gestures. */
  const keptRad = new Float64Array(2);
  const keptM = new Float64Array(3);
  let keptScale = 1;
  let keptTwistRad = 0;
  const dragRad = new Float64Array(2);
  const dragM = new Float64Array(3);

  let hasTap = false;
  let lastTapS = 0;
  const lastTapRay = new Float32Array(16);

  function counts(pointer: Pointer): boolean {
    if (by !== 'any' && isOnScreen(pointer) !== (by === 'screen')) return false;
    return presses === 'all' || pointer.owner === null || pointer.owner === ctx;
  }

  function emit(output: PulseOutput, ray: ArrayLike<number>, number: number): void {
    const pulse = output.emit();
    pulse.number = number;
    pulse.setPose(ray);
  }

  function beginPress(pointer: Pointer, view: ViewFrame): void {
    first = pointer.id;
    second = 0;
    startS = clock.timeS;
    startRay.set(pointer.worldFromRay);
    motion.begin(pointer, view);
  }

  /** Adds the current gesture to the sums; a canceled one adds nothing. */
  function keep(isCanceled: boolean): void {
    if (isCanceled) return;
    if (state === 'dragging') {
      for (let i = 0; i < 2; i++) keptRad[i] = (keptRad[i] ?? 0) + (motion.turnRad[i] ?? 0);
      for (let i = 0; i < 3; i++) keptM[i] = (keptM[i] ?? 0) + (motion.moveM[i] ?? 0);
    } else if (state === 'pinching') {
      keptScale *= span.scale;
      keptTwistRad += span.twistRad;
    }
  }

  function forget(): void {
    keptRad.fill(0);
    keptM.fill(0);
    keptScale = 1;
    keptTwistRad = 0;
  }

  function endDrag(ray: ArrayLike<number>, isCanceled: boolean): void {
    keep(isCanceled);
    emit(outputs.dragEnded, ray, isCanceled ? -1 : 1);
  }

  function tap(pointer: Pointer): void {
    const isSecond =
      hasTap &&
      clock.timeS - lastTapS <= params.doubleTapS.value &&
      rayTurnRad(lastTapRay, pointer.worldFromRay) <= params.doubleTapRad.value;
    emit(outputs.tapped, pointer.worldFromRay, isSecond ? 2 : 1);
    if (isSecond) emit(outputs.doubleTapped, pointer.worldFromRay, 2);
    // A third tap begins another double tap.
    hasTap = !isSecond;
    lastTapS = clock.timeS;
    lastTapRay.set(pointer.worldFromRay);
  }

  function listen(frame: SessionFrame, view: ViewFrame): void {
    const { input } = frame;
    for (let i = 0; i < input.pointerCount; i++) {
      const pointer = input.pointers[i];
      if (pointer?.phase !== 'start' || pointer.id === first || pointer.id === second || !counts(pointer)) continue;
      if (state === 'none') {
        if (presses === 'claim' && params.active.value) claimPointer(pointer, ctx);
        beginPress(pointer, view);
        state = params.active.value ? 'pressed' : 'waiting';
        continue;
      }
      const holder = pointerById(input, first);
      if (second !== 0 || state === 'waiting' || !holder || !canPinch(holder, pointer)) continue;
      if (presses === 'claim') claimPointer(pointer, ctx);
      if (state === 'dragging') endDrag(holder.worldFromRay, false);
      second = pointer.id;
      span.begin();
      span.update(holder, pointer, view, params.pinchFrom.value, params.twistFromRad.value);
      state = 'pinching';
    }
  }

  /** Updates a press or drag of one pointer, and emits its pulses. */
  function follow(pointer: Pointer, view: ViewFrame): void {
    motion.update(pointer, view, params.distanceM.value);
    const isDrag = Math.hypot(motion.turnRad[0] ?? 0, motion.turnRad[1] ?? 0) > params.moveRad.value;
    if (isDrag && (state === 'pressed' || state === 'spent') && pointer.phase !== 'cancel') {
      state = 'dragging';
      emit(outputs.dragStarted, startRay, 1);
    }
    if (state === 'pressed' && pointer.phase === 'hold' && clock.timeS - startS >= params.longPressS.value) {
      state = 'spent';
      emit(outputs.longPressed, pointer.worldFromRay, 1);
    }
    if (pointer.phase !== 'end' && pointer.phase !== 'cancel') return;
    if (state === 'dragging') endDrag(pointer.worldFromRay, pointer.phase === 'cancel');
    else if (state === 'pressed' && pointer.phase === 'end') tap(pointer);
    state = 'none';
    first = 0;
  }

  function pinch(a: Pointer | null, b: Pointer | null, view: ViewFrame): void {
    if (a && b) span.update(a, b, view, params.pinchFrom.value, params.twistFromRad.value);
    const isCanceled = a?.phase === 'cancel' || b?.phase === 'cancel';
    const staysA = a && isDown(a) ? a : null;
    const staysB = b && isDown(b) ? b : null;
    if (staysA && staysB) return;
    keep(isCanceled);
    const stays = staysA ?? staysB;
    state = stays ? 'spent' : 'none';
    first = 0;
    second = 0;
    // The one that stays may drag on.
    if (stays) beginPress(stays, view);
  }

  function restart({ input }: SessionFrame, view: ViewFrame): void {
    const pointer = pointerById(input, first);
    if (!pointer) return;
    // The start was measured in another world space.
    keep(false);
    motion.begin(pointer, view);
    span.begin();
  }

  function writeOutputs(): void {
    const isDragging = state === 'dragging';
    const isPinching = state === 'pinching';
    if (after === 'return' && !isDragging && !isPinching) forget();
    for (let i = 0; i < 2; i++) dragRad[i] = (keptRad[i] ?? 0) + (isDragging ? (motion.turnRad[i] ?? 0) : 0);
    for (let i = 0; i < 3; i++) dragM[i] = (keptM[i] ?? 0) + (isDragging ? (motion.moveM[i] ?? 0) : 0);
    outputs.isDragging.value = isDragging;
    outputs.isPinching.value = isPinching;
    outputs.dragRad.value = dragRad;
    outputs.dragM.value = dragM;
    outputs.scale.value = keptScale * (isPinching ? span.scale : 1);
    outputs.twistRad.value = keptTwistRad + (isPinching ? span.twistRad : 0);
  }

  function letGo(): void {
    state = 'none';
    first = 0;
    second = 0;
  }

  return {
    update: (frame) => {
      const view = frame.viewCount > 0 ? frame.views[0] : null;
      if (inputs.reset.count > 0) forget();
      if (view) {
        if (frame.jumps !== jumps) restart(frame, view);
        jumps = frame.jumps;
        const a = pointerById(frame.input, first);
        const b = pointerById(frame.input, second);
        if (state === 'waiting') state = params.active.value ? 'pressed' : 'none';
        if (state === 'pinching') pinch(a, b, view);
        else if (a && state !== 'none' && counts(a)) follow(a, view);
        // It is gone, or another node has claimed it since.
        else letGo();
        listen(frame, view);
      }
      writeOutputs();
    },
    reset: () => {
      letGo();
      forget();
      hasTap = false;
      jumps = 0;
    },
    dispose: () => {},
  };
}

function isDown({ phase }: Pointer): boolean {
  return phase === 'start' || phase === 'hold';
}
