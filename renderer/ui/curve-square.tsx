import type { PointerEvent, ReactNode } from 'react';
import './curve.css';
import type { CurvePoint } from './curve-points.ts';

/** Lines of the grid, a quarter apart. */
const GRID = 'M.25 0V1M.5 0V1M.75 0V1M0 .25H1M0 .5H1M0 .75H1';

interface CurveDrawingProps {
  /** SVG path data in a unit square, y down. */
  readonly path: string;
  /** More SVG, drawn under the curve. */
  readonly children?: ReactNode;
}

/** A curve over a grid with the diagonal. Fills its parent. */
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

/** Position of the pointer in the unit square. */
export function placeIn(square: HTMLElement, event: { readonly clientX: number; readonly clientY: number }): CurvePoint {
  const box = square.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width, y: (box.bottom - event.clientY) / box.height };
}

/** Distance from the pointer to a point of the square, in CSS pixels. */
export function pixelsFrom(
  square: HTMLElement,
  { x, y }: CurvePoint,
  event: { readonly clientX: number; readonly clientY: number },
): number {
  const box = square.getBoundingClientRect();
  return Math.hypot(event.clientX - box.left - x * box.width, event.clientY - box.bottom + y * box.height);
}

/** Hit radius in CSS pixels: larger for a finger than for a mouse. */
export function hitRadiusPx({ pointerType }: PointerEvent): number {
  return pointerType === 'mouse' ? 10 : 22;
}

interface CurveHandleProps {
  readonly at: CurvePoint;
  readonly label: string;
  /** How far the point may lie below 0 and above 1 in y. */
  readonly beyond?: number;
  readonly chosen?: boolean;
  /** Takes the focus first in a popover. */
  readonly first?: boolean;
  readonly onChoose?: () => void;
  /** Called on arrow keys. The point may lie outside the square. */
  readonly onMove: (to: CurvePoint) => void;
  readonly onEnd: () => void;
  /** Called on Delete. */
  readonly onRemove?: () => void;
}

const ARROWS: Readonly<Record<string, CurvePoint>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
};

/** A point or control point in a square. Handles keys; the square handles the pointer. */
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
