import { type PointerEvent, useRef, useState } from 'react';
import { type Curve, curveAt } from '../../nodes/kit/curve.ts';
import { type CurvePoint, canLosePoint, curvePath, pointsOf, withoutPoint, withPoint, withPointAt } from './curve-points.ts';
import { CurveDrawing, CurveHandle, hitRadiusPx, pixelsFrom, placeIn } from './curve-square.tsx';
import { useEscape } from './escape.ts';
import type { EditHandlers } from './number-field.tsx';

interface CurveEditorProps extends EditHandlers<Curve> {
  readonly label: string;
  readonly value: Curve;
  readonly chosen: number;
  readonly onChoose: (index: number) => void;
  readonly onRemove: (index: number) => void;
}

/** A drag of a point. `curve` is the curve at its start, so that a point dragged out and back in keeps its identity. */
interface Drag {
  readonly curve: Curve;
  readonly index: number;
  readonly by: CurvePoint;
  changed: boolean;
}

/** A point dragged this far outside the square is removed. Fraction of the side. */
const OUT = 0.12;

/** Curve in a square. A press on the line adds a point, a drag moves it, a double-click or a drag out of the square removes it; Escape cancels. */
export function CurveEditor({ label, value, chosen, onChoose, onRemove, onEdit, onEnd, onCancel }: CurveEditorProps) {
  const square = useRef<HTMLFieldSetElement>(null);
  const drag = useRef<Drag | null>(null);
  /** Whether each of the last two presses added a point: a double-click removes only a point that existed before it. */
  const made = useRef<readonly boolean[]>([]);
  const [ghost, setGhost] = useState<CurvePoint | null>(null);
  const escapeKey = useEscape();
  const points = pointsOf(value);

  const nearest = (event: PointerEvent<HTMLElement>): number => {
    const far = points.map((point) => pixelsFrom(event.currentTarget, point, event));
    const least = Math.min(...far);
    return least <= hitRadiusPx(event) ? far.indexOf(least) : -1;
  };
  /** The point of the curve at the x of the pointer, if it is near enough to add one. */
  const onLine = (event: PointerEvent<HTMLElement>): CurvePoint | null => {
    const { x } = placeIn(event.currentTarget, event);
    const place = { x, y: curveAt(value, x) };
    return pixelsFrom(event.currentTarget, place, event) <= hitRadiusPx(event) && withPoint(value, x) ? place : null;
  };
  const focus = (index: number) => {
    onChoose(index);
    // React has mounted a new point by then.
    queueMicrotask(() => square.current?.querySelectorAll<HTMLElement>('.curve-handle')[index]?.focus());
  };

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    // Keeps the focus for the point.
    event.preventDefault();
    const at = placeIn(event.currentTarget, event);
    const index = nearest(event);
    const added = index === -1 && onLine(event) ? withPoint(value, at.x) : null;
    made.current = [...made.current.slice(-1), added !== null];
    const taken = added ?? (index === -1 ? null : { curve: value, index });
    if (!taken) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const point = pointsOf(taken.curve)[taken.index] ?? at;
    drag.current = { ...taken, by: { x: point.x - at.x, y: point.y - at.y }, changed: added !== null };
    escapeKey.listen(() => {
      if (drag.current?.changed) onCancel?.();
      drag.current = null;
    });
    if (added) onEdit(added.curve);
    setGhost(null);
    focus(taken.index);
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const held = drag.current;
    if (!held) {
      if (event.pointerType === 'mouse') setGhost(nearest(event) === -1 ? onLine(event) : null);
      return;
    }
    const at = placeIn(event.currentTarget, event);
    const out = Math.max(-at.x, at.x - 1, -at.y, at.y - 1) > OUT;
    held.changed = true;
    if (out && canLosePoint(held.curve)) {
      onEdit(withoutPoint(held.curve, held.index));
      onChoose(Math.max(0, held.index - 1));
    } else {
      onEdit(withPointAt(held.curve, held.index, { x: at.x + held.by.x, y: at.y + held.by.y }));
      onChoose(held.index);
    }
  };
  const onPointerUp = () => {
    escapeKey.stop();
    if (drag.current?.changed) onEnd();
    drag.current = null;
  };
  const onDoubleClick = (event: { readonly clientX: number; readonly clientY: number; readonly currentTarget: HTMLElement }) => {
    const index = points.findIndex((point) => pixelsFrom(event.currentTarget, point, event) <= 10);
    if (index !== -1 && canLosePoint(value) && !made.current.includes(true)) onRemove(index);
  };
  return (
    <fieldset
      ref={square}
      className="curve-square"
      aria-label={`Points of ${label}`}
      data-tip="Press the line to add a point, double-click a point to remove it"
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onPointerUp={onPointerUp}
      onPointerCancel={onPointerUp}
      onPointerLeave={() => setGhost(null)}
      onDoubleClick={onDoubleClick}
    >
      <CurveDrawing path={curvePath(value)} />
      {ghost && <span className="curve-ghost" style={{ left: `${ghost.x * 100}%`, bottom: `${ghost.y * 100}%` }} />}
      {Object.entries(points).map(([key, point]) => (
        <CurveHandle
          // A point keeps its index while it is dragged.
          key={key}
          at={point}
          label={`${label}, point ${Number(key) + 1} of ${points.length}`}
          chosen={Number(key) === chosen}
          onChoose={() => onChoose(Number(key))}
          onMove={(to) => onEdit(withPointAt(value, Number(key), to))}
          onEnd={onEnd}
          onRemove={() => onRemove(Number(key))}
        />
      ))}
    </fieldset>
  );
}
