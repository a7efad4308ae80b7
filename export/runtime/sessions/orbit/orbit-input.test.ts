import { expect, test } from '@jest/globals';
import type { PressClaim } from '../input/page-pointers.ts';
import { listenForOrbit } from './orbit-input.ts';

/** A canvas of 100 × 100 CSS pixels, as far as gestures use it. */
class Canvas extends EventTarget {
  readonly style = { touchAction: '' };
  readonly clientHeight = 100;
  tabIndex = 0;
  getAttribute(): string {
    return '0';
  }
  setPointerCapture(): void {}

  send(type: string, x: number): void {
    this.dispatchEvent(Object.assign(new Event(type), { pointerId: 1, clientX: x, clientY: 0, shiftKey: false, buttons: 1 }));
  }
}

function start() {
  const canvas = new Canvas();
  let claim: PressClaim = 'free';
  let turnedRad = 0;
  const orbit = {
    distanceM: 1,
    rotate: (yawRad: number) => {
      turnedRad += yawRad;
    },
    zoom: () => {},
    pan: () => {},
    reset: () => {},
  };
  const owned = { claimOf: () => claim, ownsKeys: () => false };
  const gestures = listenForOrbit(canvas as unknown as HTMLCanvasElement, orbit, () => 1, owned);
  return {
    press: () => {
      claim = 'undecided';
      canvas.send('pointerdown', 10);
    },
    move: () => canvas.send('pointermove', 60),
    release: () => canvas.send('pointerup', 60),
    /** A frame, after which nodes have or have not claimed the press. */
    frame: (decided: PressClaim) => {
      gestures.settle();
      claim = decided;
    },
    get turnedRad() {
      return turnedRad;
    },
  };
}

// Half the height of the canvas.
const TURN_RAD = -Math.PI / 2;

type Stage = ReturnType<typeof start>;
const DRAGS: readonly (readonly [string, (stage: Stage, claim: PressClaim) => void])[] = [
  [
    'within one frame',
    ({ press, move, release, frame }, claim) => {
      press();
      move();
      release();
      frame(claim);
      frame(claim);
    },
  ],
  [
    'released in the frame after its moves',
    ({ press, move, release, frame }, claim) => {
      press();
      move();
      frame(claim);
      release();
      frame(claim);
    },
  ],
  [
    'over several frames',
    ({ press, move, release, frame }, claim) => {
      press();
      frame(claim);
      move();
      frame(claim);
      release();
      frame(claim);
    },
  ],
];

test.each(DRAGS)('a drag %s turns the view by all of it, and not at all where a node claims it', (_, drag) => {
  const free = start();
  drag(free, 'free');
  expect(free.turnedRad).toBeCloseTo(TURN_RAD, 9);
  const claimed = start();
  drag(claimed, 'claimed');
  expect(claimed.turnedRad).toBe(0);
});
