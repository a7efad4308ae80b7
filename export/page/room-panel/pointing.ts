import { claimPointer, handOf } from '../../../nodes/kit/pointers.ts';
import type { Controller, SessionFrame, SessionInput, Pointer as SessionPointer, Tap } from '../../../nodes/kit/session.ts';
import type { Control } from '../../program/program.ts';
import { createSessionInput } from '../../runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../runtime/sessions/session-frame.ts';
import type { ControlValues } from '../control-values.ts';
import { isOnPanel, type PanelLayout, type Part, partAt, sliderValueAt } from './panel-layout.ts';
import { castRay, createRayHit, type RayHit } from './ray-hit.ts';

/** Trigger value that starts a press. The value that ends it is lower, so that a trembling finger presses once. */
const PULLED = 0.5;
const LET_GO = 0.35;

/** A hand or controller and its interaction with the panel. */
export interface Pointer {
  readonly by: 'left' | 'right';
  /** Whether its ray hits the card. */
  pointing: boolean;
  readonly hit: RayHit;
  /** Index of the part that it points at, or −1. */
  part: number;
  /** Index of the part that it holds, or −1. */
  held: number;
}

/** Handles the interaction of rays and taps with the panel. */
export interface Pointing {
  readonly pointers: readonly Pointer[];
  readonly isHeld: boolean;
  /**
   * Sets controls by the input of a frame. Returns the frame for the program, without the pointers and taps on the panel; it is valid as
   * long as `frame`.
   */
  take(frame: SessionFrame, worldFromPanel: Float32Array): SessionFrame;
}

/**
 * Creates the interaction with a panel. A tap (the device's select action) sets a toggle, button or choice. A slider follows the ray while
 * the trigger is held, also beyond its ends. A tap that ends a press on the panel belongs to the panel wherever it points; a press that
 * started elsewhere sets nothing.
 */
export function createPointing(layout: PanelLayout, values: ControlValues): Pointing {
  const hands = [createHand('left'), createHand('right')];
  const tapHit = createRayHit();
  const passed = createPassedFrame();

  function press(part: number, hit: RayHit): void {
    const found = layout.parts[part];
    const control = found && values.controls[found.control];
    if (!found || !control) return;
    values.set(found.control, valueBy(control, found, hit));
  }

  function valueBy(control: Control, part: Part, hit: RayHit): number {
    const value = values.get(part.control);
    switch (control.kind) {
      case 'slider':
        return sliderValueAt(control, part, hit.x);
      case 'toggle':
        return value === 0 ? 1 : 0;
      case 'button':
        return value + 1;
      case 'choice':
        return part.option;
    }
  }

  function follow(hand: Hand, controller: Controller, worldFromPanel: Float32Array): void {
    const { hit } = hand;
    const ray = controller.worldFromRay;
    if (ray) castRay(hit, ray, worldFromPanel, layout);
    else hit.hits = false;
    hand.pointing = hit.hits && isOnPanel(layout, hit.x, hit.y);
    hand.part = hand.pointing ? partAt(layout, hit.x, hit.y) : -1;
    const wasPulled = hand.pulled;
    hand.pulled = controller.trigger >= (wasPulled ? LET_GO : PULLED);
    if (hand.pulled && !wasPulled) {
      hand.began = hand.pointing ? 'panel' : 'elsewhere';
      hand.beganPart = hand.part;
    }
    hand.held = hand.pulled && hand.began === 'panel' ? hand.beganPart : -1;
    if (hit.hits && layout.parts[hand.held]?.kind === 'slider') press(hand.held, hit);
  }

  /** Sets a control if the tap presses it. Returns whether the tap belongs to the panel. */
  function takeTap(tap: Tap, worldFromPanel: Float32Array): boolean {
    castRay(tapHit, tap.worldFromRay, worldFromPanel, layout);
    const onPanel = tapHit.hits && isOnPanel(layout, tapHit.x, tapHit.y);
    const part = onPanel ? partAt(layout, tapHit.x, tapHit.y) : -1;
    const hand = hands.find(({ by }) => by === tap.by);
    const began = hand?.began ?? null;
    // A press shorter than a frame, or of an input without trigger, started where it ends.
    const presses = began === null || (began === 'panel' && hand?.beganPart === part && layout.parts[part]?.kind !== 'slider');
    if (hand) hand.began = null;
    if (onPanel && presses) press(part, tapHit);
    return onPanel || began === 'panel';
  }

  /**
   * Claims a press that begins on the panel. Returns whether the pointer belongs to the panel: it hovers over the panel, or its press began
   * there.
   */
  function takePointer(pointer: SessionPointer, worldFromPanel: Float32Array): boolean {
    if (pointer.phase !== 'hover' && pointer.phase !== 'start') return pointer.owner === hands;
    const side = handOf(pointer.by);
    castRay(tapHit, pointer.worldFromRay, worldFromPanel, layout);
    const holds = hands.some((hand) => hand.by === side && holdsPanel(hand));
    if (!holds && !(tapHit.hits && isOnPanel(layout, tapHit.x, tapHit.y))) return false;
    return pointer.phase === 'hover' || claimPointer(pointer, hands);
  }

  return {
    pointers: hands,
    get isHeld() {
      return hands.some(holdsPanel);
    },
    take: (frame, worldFromPanel) => {
      const { input } = frame;
      for (const hand of hands) follow(hand, input[hand.by], worldFromPanel);
      passed.begin(frame);
      for (let i = 0; i < input.pointerCount; i++) {
        const pointer = input.pointers[i];
        if (pointer && !takePointer(pointer, worldFromPanel)) passed.addPointer(pointer);
      }
      for (let i = 0; i < input.tapCount; i++) {
        const tap = input.taps[i];
        if (tap && !takeTap(tap, worldFromPanel)) passed.addTap(tap);
      }
      return passed.frame;
    },
  };
}

interface Hand extends Pointer {
  pulled: boolean;
  /** Where the press began that no tap has ended yet; null if there is none. */
  began: 'panel' | 'elsewhere' | null;
  beganPart: number;
}

function createHand(by: Hand['by']): Hand {
  return { by, pointing: false, hit: createRayHit(), part: -1, held: -1, pulled: false, began: null, beganPart: -1 };
}

function holdsPanel({ pulled, began }: Hand): boolean {
  return pulled && began === 'panel';
}

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/**
 * Creates the frame that the program gets: a copy without the pointers and taps of the panel. The session's frame is not changed, because
 * the session owns it.
 */
function createPassedFrame() {
  const taps: Tap[] = [];
  const pointers: SessionPointer[] = [];
  const input: Mutable<SessionInput> = { ...createSessionInput(), taps, pointers };
  const frame: Mutable<SessionFrame> = { ...createSessionFrame(), input };
  return {
    frame,
    begin: (from: SessionFrame): void => {
      Object.assign(frame, from);
      frame.input = input;
      input.left = from.input.left;
      input.right = from.input.right;
      input.tapCount = 0;
      input.pointerCount = 0;
    },
    addPointer: (pointer: SessionPointer): void => {
      pointers[input.pointerCount++] = pointer;
    },
    addTap: (tap: Tap): void => {
      taps[input.tapCount++] = tap;
    },
  };
}
