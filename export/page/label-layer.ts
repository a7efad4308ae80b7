import { element } from './dom.ts';
import type { PageRoot } from './page-root.ts';

/** Creates the element in which labels are shown, over the canvas and below the controls of the page. */
export type CreateLabelLayer = typeof createLabelLayer;

/**
 * Creates the label layer. It is part of the DOM overlay, so AR sessions show it. It covers the canvas; in AR it covers the display, as the
 * overlay does. Presses pass through it except on selectable labels.
 */
export function createLabelLayer({ canvas, overlay }: Pick<PageRoot, 'canvas' | 'overlay'>): HTMLElement {
  const { ownerDocument: document } = canvas;
  const layer = element(document, 'div', { className: 'labels', attributes: { role: 'group', 'aria-label': 'Labels in the room' } });
  const follow = (): void => {
    const box = canvas.getBoundingClientRect();
    const isAr = document.documentElement.dataset.way === 'ar';
    layer.style.inset = isAr ? '0' : 'auto';
    layer.style.left = isAr ? '0' : `${box.left}px`;
    layer.style.top = isAr ? '0' : `${box.top}px`;
    layer.style.width = isAr ? '100%' : `${box.width}px`;
    layer.style.height = isAr ? '100%' : `${box.height}px`;
  };
  Object.assign(layer.style, { position: 'fixed', overflow: 'hidden', pointerEvents: 'none', contain: 'strict' });
  follow();
  // Of the document's element, because the place of the canvas also changes with the window.
  const sizes = new ResizeObserver(follow);
  sizes.observe(canvas);
  sizes.observe(document.documentElement);
  new MutationObserver(follow).observe(document.documentElement, { attributes: true, attributeFilter: ['data-way'] });
  overlay.prepend(layer);
  return layer;
}
