import { useStoreApi } from '@xyflow/react';
import { type RefObject, useEffect } from 'react';
import { HEADS_ZOOM } from './detail.ts';

/** Below this zoom a node shows only its title. */
export const FAR_ZOOM = 0.6;
/** Least height of text on the screen, in CSS pixels. */
const LEGIBLE_PX = 11;
/** Height of labels at zoom 1, in CSS pixels. */
const LABEL_PX = 12;
/** Number of steps per unit of the label scale. Labels grow in steps, so that a zoom lays out the nodes only a few times. */
const STEPS_PER_UNIT = 10;
/** Maximum label scale: titles are legible as long as they are drawn. */
const MAX_SCALE = Math.ceil((LEGIBLE_PX / (LABEL_PX * HEADS_ZOOM)) * STEPS_PER_UNIT) / STEPS_PER_UNIT;

/** Enlarges the texts of nodes while the canvas is zoomed out, so that they stay legible: sets `--label-scale` on the canvas. */
export function useLegibleLabels(root: RefObject<HTMLElement | null>): void {
  const store = useStoreApi();
  useEffect(() => {
    let applied = 0;
    const apply = (): void => {
      const scale = labelScale(store.getState().transform[2]);
      if (scale === applied) return;
      applied = scale;
      root.current?.style.setProperty('--label-scale', String(scale));
    };
    apply();
    return store.subscribe(apply);
  }, [root, store]);
}

/** Factor by which labels grow at a zoom. */
export function labelScale(zoom: number): number {
  const wanted = Math.ceil((LEGIBLE_PX / (LABEL_PX * zoom)) * STEPS_PER_UNIT) / STEPS_PER_UNIT;
  return Math.min(Math.max(1, wanted), MAX_SCALE);
}
