import { copyPicked, createPicked, type Picked } from './picked.ts';

/** Presses that started on an object. */
export interface Presses {
  readonly all: readonly Press[];
  begin(picked: Picked, worldFromRay: Float32Array): void;
  /** Whether a pointer presses an object, or may. */
  has(pointer: number): boolean;
  isHeld(): boolean;
  clear(): void;
}

export interface Press {
  /** `asked`: it started in the last frame, and another node may have claimed it since. */
  state: 'none' | 'asked' | 'held';
  /** What was met when it started. */
  readonly picked: Picked;
  /** The ray when it started. */
  readonly startRay: Float32Array;
  /** It has turned too far for a tap. */
  isDrag: boolean;
}

/** As many as there are pointers in a frame. */
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
