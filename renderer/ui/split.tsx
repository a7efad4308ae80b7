import { type KeyboardEvent, type PointerEvent, type ReactNode, useRef } from 'react';
import './split.css';

export interface SplitProps {
  /** How the panes are arranged. `columns`: side by side. `rows`: one above the other. */
  readonly direction: 'columns' | 'rows';
  readonly first: ReactNode;
  /** Content of the second pane. Null gives all space to the first. */
  readonly second: ReactNode;
  /** Which pane keeps its size when the window changes. */
  readonly fixed: 'first' | 'second';
  /** Draws the second pane before the first. */
  readonly reversed?: boolean;
  /** Size of the fixed side in CSS pixels. */
  readonly sizePx: number;
  readonly minPx: number;
  /** Minimum size of the other side in CSS pixels. */
  readonly otherMinPx: number;
  readonly onResize: (sizePx: number) => void;
  /** Accessible name of the handle. */
  readonly label: string;
}

const KEY_STEP_PX = 24;

/** Two panes with a handle between them, moved by pointer or arrow keys. */
export function Split(props: SplitProps) {
  const { direction, first, second, fixed, reversed = false, sizePx, minPx, otherMinPx, onResize, label } = props;
  const frame = useRef<HTMLDivElement>(null);
  const drag = useRef<{ from: number; sizePx: number } | null>(null);
  const columns = direction === 'columns';
  const isFixedBefore = (fixed === 'first') !== reversed;
  /** Sign of the size change: a drag toward the end grows a fixed pane before the handle and shrinks one after it. */
  const sign = isFixedBefore ? 1 : -1;

  const resize = (wanted: number) => {
    const box = frame.current?.getBoundingClientRect();
    if (!box) return;
    const whole = columns ? box.width : box.height;
    onResize(Math.round(Math.max(minPx, Math.min(wanted, whole - otherMinPx))));
  };
  const at = (event: PointerEvent) => (columns ? event.clientX : event.clientY);
  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    event.currentTarget.setPointerCapture(event.pointerId);
    drag.current = { from: at(event), sizePx };
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    if (drag.current) resize(drag.current.sizePx + sign * (at(event) - drag.current.from));
  };
  const onKeyDown = (event: KeyboardEvent<HTMLElement>) => {
    const back = columns ? 'ArrowLeft' : 'ArrowUp';
    const forth = columns ? 'ArrowRight' : 'ArrowDown';
    if (event.key !== back && event.key !== forth) return;
    event.preventDefault();
    resize(sizePx + sign * (event.key === forth ? KEY_STEP_PX : -KEY_STEP_PX));
  };

  if (second === null) {
    return (
      <div ref={frame} className="split">
        <div className="split-pane">{first}</div>
      </div>
    );
  }
  const limit = `max(${minPx}px, min(${sizePx}px, 100% - ${otherMinPx}px))`;
  const tracks = isFixedBefore ? `${limit} 1px minmax(0, 1fr)` : `minmax(0, 1fr) 1px ${limit}`;
  return (
    <div
      ref={frame}
      className={`split split-${direction}${reversed ? ' split-reversed' : ''}`}
      style={columns ? { gridTemplateColumns: tracks } : { gridTemplateRows: tracks }}
    >
      <div className="split-pane">{first}</div>
      <hr
        className="split-handle"
        tabIndex={0}
        aria-label={label}
        aria-orientation={columns ? 'vertical' : 'horizontal'}
        aria-valuenow={sizePx}
        aria-valuemin={minPx}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onLostPointerCapture={() => {
          drag.current = null;
        }}
        onKeyDown={onKeyDown}
      />
      <div className="split-pane">{second}</div>
    </div>
  );
}
