import { copyPicked, createPicked, type Picked } from './picked.ts';

/** The presses that started on an object and have not ended. */
export interface Presses {
  readonly all: readonly Press[];
  begin(picked: Picked, worldFromRay: Float32Array): void;
  /** Whether a pointer has a press on an object, `held` or still `asked`. */
  has(pointer: number): boolean;
  isHeld(): boolean;
  clear(): void;
}

export interface Press {
  /** `asked`: the press started in the last frame. It becomes `held` in the next, unless another node has claimed it. */
  state: 'none' | 'asked' | 'held';
  /** What the ray met when the press started. */
  readonly picked: Picked;
  /** The ray when it started. */
  readonly startRay: Float32Array;
  /** Whether the ray has turned too far since the start for a tap. */
  isDrag: boolean;
}

/** The most presses at a time: as many as a frame has pointers. */
const MOST = 8;

export function createPresses(): Presses {
  const isUsed = (pointer: number): boolean => {
    for (let i = 0; i < all.length; i++) if (all[i]?.state !== 'none' && all[i]?.picked.pointer === pointer) return true;
    return false;
  };
  const all = Array.from(
    { length: MOST },
    (): Press => ({ state: 'none', picked: createPicked(), startRay: new Float32Array(16), isDrag: false }),
  );
  return {
    all,
    begin: (picked, worldFromRay) => {
      // A frame that is drawn again starts no other press.
      if (isUsed(picked.pointer)) return;
      for (let i = 0; i < all.length; i++) {
        const press = all[i];
        if (press?.state !== 'none') continue;
        copyPicked(press.picked, picked);
        press.startRay.set(worldFromRay);
        press.isDrag = false;
        press.state = 'asked';
        return;
      }
    },
    has: isUsed,
    isHeld: () => {
      for (let i = 0; i < all.length; i++) if (all[i]?.state === 'held') return true;
      return false;
    },
    clear: () => {
      for (const press of all) press.state = 'none';
    },
  };
}
