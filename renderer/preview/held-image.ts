import type { FrameClock } from '../../export/runtime/clock.ts';

/** Keeps the last image of the preview visible while its session or its canvas is replaced. */
export interface HeldImage {
  /** Copies the image of the emulated device, which disappears with its session. */
  keepScreen(): void;
  /** Keeps a canvas of the page, with its image, until `remove`. */
  keepCanvas(remove: () => void): void;
  /** Shows the next image, which this frame has drawn, instead of what is kept. */
  release(): void;
}

/** @param screen The element in which an emulated device shows its image. */
export function createHeldImage(screen: HTMLElement, clock: FrameClock): HeldImage {
  let removals: (() => void)[] = [];
  return {
    keepScreen: () => {
      const canvas = screen.querySelector('canvas');
      if (!canvas) return;
      const copy = screen.ownerDocument.createElement('canvas');
      copy.className = 'held';
      copy.width = canvas.width;
      copy.height = canvas.height;
      copy.getContext('2d')?.drawImage(canvas, 0, 0);
      screen.after(copy);
      removals.push(() => copy.remove());
    },
    keepCanvas: (remove) => void removals.push(remove),
    release: () => {
      if (removals.length === 0) return;
      const due = removals;
      removals = [];
      // An emulated device composites its image after the frame.
      clock.requestFrame(() => {
        for (const remove of due) remove();
      });
    },
  };
}
