import { useEffect, useRef, useState } from 'react';
import type { EditorClock } from '../clock.ts';
import { zoomOf } from './appearance.ts';
import './tooltip.css';

/** Delay before a tooltip opens: so long that none opens while the pointer crosses a toolbar. */
const DELAY_MS = 450;
const GAP_PX = 8;
const EDGE_PX = 6;

interface Tip {
  readonly text: string;
  readonly keys: string | null;
  readonly anchor: DOMRect;
}

/**
 * The tooltip of the page, shown for elements with `data-tip`, so that ports and buttons need no element of their own. It is hidden from
 * assistive technology, which gets the same names and docs elsewhere.
 */
export function TooltipLayer({ clock }: { readonly clock: EditorClock }) {
  const [tip, setTip] = useState<Tip | null>(null);

  useEffect(() => {
    let target: Element | null = null;
    let stopWaiting: (() => void) | null = null;
    const hide = () => {
      stopWaiting?.();
      target = null;
      setTip(null);
    };
    const consider = (event: Event) => {
      // No tooltip covers the feedback of a drag.
      const isDrag = event instanceof PointerEvent && event.buttons !== 0;
      const next = event.target instanceof Element && !isDrag ? event.target.closest('[data-tip]') : null;
      if (next === target) return;
      hide();
      if (next === null || (event.type === 'focusin' && !next.matches(':focus-visible'))) return;
      target = next;
      stopWaiting = clock.after(DELAY_MS, () => {
        const text = next.getAttribute('data-tip');
        if (text && next.isConnected) setTip({ text, keys: next.getAttribute('data-tip-keys'), anchor: next.getBoundingClientRect() });
      });
    };
    const hideOn = ['pointerdown', 'wheel', 'keydown', 'focusout', 'blur'] as const;
    document.addEventListener('pointerover', consider);
    document.addEventListener('focusin', consider);
    for (const kind of hideOn) window.addEventListener(kind, hide, { capture: true, passive: true });
    return () => {
      stopWaiting?.();
      document.removeEventListener('pointerover', consider);
      document.removeEventListener('focusin', consider);
      for (const kind of hideOn) window.removeEventListener(kind, hide, { capture: true });
    };
  }, [clock]);

  return tip && <Bubble tip={tip} />;
}

function Bubble({ tip }: { readonly tip: Tip }) {
  const element = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState<{ left: number; top: number } | null>(null);

  useEffect(() => {
    const box = element.current?.getBoundingClientRect();
    if (!box || !element.current) return;
    const zoom = zoomOf(element.current);
    const { anchor } = tip;
    const below = anchor.bottom + GAP_PX + box.height < window.innerHeight;
    const centered = anchor.left + anchor.width / 2 - box.width / 2;
    setPlace({
      left: Math.min(Math.max(centered, EDGE_PX), window.innerWidth - box.width - EDGE_PX) / zoom,
      top: (below ? anchor.bottom + GAP_PX : anchor.top - GAP_PX - box.height) / zoom,
    });
  }, [tip]);

  return (
    <div ref={element} className="tooltip" aria-hidden="true" style={place ?? { left: 0, top: 0, visibility: 'hidden' }}>
      {tip.text}
      {tip.keys && <kbd>{tip.keys}</kbd>}
    </div>
  );
}
