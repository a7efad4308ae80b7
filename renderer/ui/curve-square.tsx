import type { PointerEvent, ReactNode } from 'react';
import './curve.css';
import type { CurvePoint } from './curve-points.ts';

/** Lines of the grid, a quarter apart. */
const GRID = 'M.25 0V1M.5 0V1M.75 0V1M0 .25H1M0 .5H1M0 .75H1';

interface CurveDrawingProps {
  /** In a square of 1 by 1, y down. */
  readonly path: string;
  /** What else is drawn, under the curve. */
  readonly children?: ReactNode;
}

/** A curve over a grid with the diagonal, as large as what it stands in. */
export function CurveDrawing({ path, children }: CurveDrawingProps) {
  return (
    <svg className="curve-drawing" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true" focusable="false">
      <path className="curve-grid" d={GRID} />
      <path className="curve-diagonal" d="M0 1L1 0" />
      {children}
      <path className="curve-line" d={path} />
    </svg>
  );
}

/** Where in the square the pointer is. */
export function placeIn(square: HTMLElement, event: { readonly clientX: number; readonly clientY: number }): CurvePoint {
  const box = square.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width, y: (box.bottom - event.clientY) / box.height };
}

/** How far the pointer is from a place of the square, in CSS pixels. */
export function pixelsFrom(
  square: HTMLElement,
  { x, y }: CurvePoint,
  event: { readonly clientX: number; readonly clientY: number },
): number {
  const box = square.getBoundingClientRect();
  return Math.hypot(event.clientX - box.left - x * box.width, event.clientY - box.bottom + y * box.height);
}

/** What counts as being on a thing: a finger is broader than a mouse. */
export function reachPx({ pointerType }: PointerEvent): number {
  return pointerType === 'mouse' ? 10 : 22;
}

interface CurveHandleProps {
  readonly at: CurvePoint;
  readonly label: string;
  /** How far below 0 and above 1 it may be. */
  readonly beyond?: number;
  readonly chosen?: boolean;
  /** Has the keyboard first, where it is in a popover. */
  readonly first?: boolean;
  readonly onChoose?: () => void;
  /** By arrow keys; to a place that may be outside. */
  readonly onMove: (to: CurvePoint) => void;
  readonly onEnd: () => void;
  /** By Delete. */
  readonly onRemove?: () => void;
}

const ARROWS: Readonly<Record<string, CurvePoint>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
};

/** What is taken hold of in a square. The square looks after the pointer, this after the keys. */
export function CurveHandle({ at, label, beyond = 0, chosen = true, first = false, onChoose, onMove, onEnd, onRemove }: CurveHandleProps) {
  return (
    <div
      className="curve-handle"
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={-beyond}
      aria-valuemax={1 + beyond}
      aria-valuenow={at.y}
      aria-valuetext={`${at.x} across, ${at.y} up`}
      data-chosen={chosen}
      data-autofocus={first ? '' : undefined}
      style={{ left: `${at.x * 100}%`, bottom: `${at.y * 100}%` }}
      onFocus={onChoose}
      onKeyDown={(event) => {
        const by = ARROWS[event.key];
        const step = event.shiftKey ? 0.1 : event.altKey ? 0.001 : 0.01;
        if (by) onMove({ x: at.x + by.x * step, y: at.y + by.y * step });
        else if (onRemove && (event.key === 'Delete' || event.key === 'Backspace')) onRemove();
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={(event) => {
        if (ARROWS[event.key]) onEnd();
      }}
    />
  );
}
