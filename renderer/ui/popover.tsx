import { type ReactNode, type RefObject, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { zoomOf } from './appearance.ts';
import './popover.css';

interface PopoverProps {
  readonly label: string;
  /** Element that opened it. The popover lies below it if it fits, else above, and returns the focus to it. */
  readonly from: RefObject<HTMLElement | null>;
  readonly onClose: () => void;
  readonly children: ReactNode;
}

const GAP_PX = 6;
const EDGE_PX = 8;

/** A small panel beside the element that opened it. Escape and a press elsewhere close it. */
export function Popover({ label, from, onClose, children }: PopoverProps) {
  const element = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState<{ left: number; top: number } | null>(null);
  useLayoutEffect(() => {
    const box = element.current?.getBoundingClientRect();
    const button = from.current?.getBoundingClientRect();
    if (!box || !button || !element.current) return;
    const zoom = zoomOf(element.current);
    const left = Math.min(button.left + button.width / 2 - box.width / 2, window.innerWidth - box.width - EDGE_PX);
    const below = button.bottom + GAP_PX;
    const fits = below + box.height < window.innerHeight - EDGE_PX;
    const top = fits ? below : Math.max(EDGE_PX, button.top - box.height - GAP_PX);
    setPlace({ left: Math.max(EDGE_PX, left) / zoom, top: top / zoom });
  }, [from]);
  const placed = place !== null;
  useLayoutEffect(() => {
    // A hidden element cannot take the focus.
    if (placed) element.current?.querySelector<HTMLElement>('[data-autofocus], input')?.focus();
  }, [placed]);
  useEffect(() => {
    const onDown = (event: PointerEvent) => {
      const target = event.target as Node;
      if (!element.current?.contains(target) && !from.current?.contains(target)) onClose();
    };
    // Listens on the window, because a pressed button may become disabled and lose the focus.
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      onClose();
      from.current?.querySelector('button')?.focus();
    };
    window.addEventListener('keydown', onKey, true);
    window.addEventListener('pointerdown', onDown, true);
    // The preview is an iframe: a press in it only blurs the window.
    window.addEventListener('blur', onClose);
    return () => {
      window.removeEventListener('keydown', onKey, true);
      window.removeEventListener('pointerdown', onDown, true);
      window.removeEventListener('blur', onClose);
    };
  }, [from, onClose]);
  return (
    <div
      ref={element}
      className="popover"
      role="dialog"
      aria-label={label}
      style={place ?? { visibility: 'hidden' }}
      // Keys with modifiers go on to the window, so that undo works in here.
      onKeyDown={(event) => {
        if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
      }}
    >
      {children}
    </div>
  );
}
