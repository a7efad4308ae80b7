import { useLayoutEffect, useRef, useState } from 'react';
import { zoomOf } from './appearance.ts';
import { Menu, type MenuItem } from './menu.tsx';
import './menu.css';

interface ContextMenuProps {
  readonly label: string;
  /** Position in client pixels, clamped to the window. */
  readonly at: { readonly x: number; readonly y: number };
  readonly items: readonly MenuItem[];
  readonly onClose: () => void;
}

const EDGE_PX = 8;

/** A menu at the pointer or at the button that opened it. */
export function ContextMenu({ label, at, items, onClose }: ContextMenuProps) {
  const element = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState({ left: at.x, top: at.y });
  useLayoutEffect(() => {
    const box = element.current?.querySelector('.menu')?.getBoundingClientRect();
    if (!box || !element.current) return;
    const zoom = zoomOf(element.current);
    setPlace({
      left: Math.max(EDGE_PX, Math.min(at.x, window.innerWidth - box.width - EDGE_PX)) / zoom,
      top: Math.max(EDGE_PX, Math.min(at.y, window.innerHeight - box.height - EDGE_PX)) / zoom,
    });
  }, [at]);
  return (
    <div ref={element} className="context-menu" style={place}>
      <Menu id="context-menu" label={label} items={items} onClose={onClose} onLeave={onClose} />
    </div>
  );
}
