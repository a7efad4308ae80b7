import { type PointerEvent, useRef } from 'react';
import { type Easing, type Handles, handlesOf, OVERSHOOT } from '../../nodes/kit/ease.ts';
import type { CurvePoint } from '../ui/curve-points.ts';
import { CurveDrawing, CurveHandle, pixelsFrom, placeIn } from '../ui/curve-square.tsx';
import { useEscape } from '../ui/escape.ts';
import { type EditHandlers, NumberField } from '../ui/number-field.tsx';

interface EasingEditorProps extends EditHandlers<Handles> {
  readonly value: Handles;
}

const SIDES = ['Start control point', 'End control point'] as const;

/** Edits the Bézier control points of an easing by dragging, arrow keys or numbers. */
export function EasingEditor({ value, ...gesture }: EasingEditorProps) {
  const { onEdit, onEnd, onCancel } = gesture;
  const square = useRef<HTMLDivElement>(null);
  const held = useRef<{ readonly side: 0 | 1; readonly by: CurvePoint } | null>(null);
  const escapeKey = useEscape();
  const move = (side: 0 | 1, to: CurvePoint) => onEdit(withHandle(value, side, to));

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    const box = square.current;
    if (event.button !== 0 || !box) return;
    event.preventDefault();
    // A press anywhere drags the nearer control point.
    const [out, into] = [handleOf(value, 0), handleOf(value, 1)];
    const side = pixelsFrom(box, out, event) <= pixelsFrom(box, into, event) ? 0 : 1;
    const [at, from] = [placeIn(box, event), side === 0 ? out : into];
    event.currentTarget.setPointerCapture(event.pointerId);
    held.current = { side, by: { x: from.x - at.x, y: from.y - at.y } };
    escapeKey.listen(() => {
      held.current = null;
      onCancel?.();
    });
    box.querySelectorAll<HTMLElement>('.curve-handle')[side]?.focus();
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    if (!held.current || !square.current) return;
    const at = placeIn(square.current, event);
    move(held.current.side, { x: at.x + held.current.by.x, y: at.y + held.current.by.y });
  };
  const onPointerUp = () => {
    escapeKey.stop();
    if (held.current) onEnd();
    held.current = null;
  };
  return (
    <div className="easing-editor">
      <div
        className="easing-room"
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={onPointerUp}
      >
        <div ref={square} className="curve-square">
          <CurveDrawing path={handlesPath(value)}>
            <path className="curve-arm" d={armsPath(value)} />
          </CurveDrawing>
          {([0, 1] as const).map((side) => (
            <CurveHandle
              key={side}
              at={handleOf(value, side)}
              label={SIDES[side]}
              beyond={OVERSHOOT}
              first={side === 0}
              onMove={(to) => move(side, to)}
              onEnd={onEnd}
            />
          ))}
        </div>
      </div>
      {([0, 1] as const).map((side) => (
        <fieldset key={side} className="easing-numbers" aria-label={SIDES[side]}>
          <span aria-hidden="true">{SIDES[side]}</span>
          {(['x', 'y'] as const).map((axis) => (
            <NumberField
              key={axis}
              label={`${SIDES[side]}, ${axis === 'x' ? 'across' : 'up'}`}
              value={handleOf(value, side)[axis]}
              step={0.01}
              suffix=""
              format={(number) => String(number)}
              parse={(text) => (text.trim() === '' || !Number.isFinite(Number(text)) ? null : Number(text))}
              clamp={(number) => handleOf(withHandle(value, side, { ...handleOf(value, side), [axis]: number }), side)[axis]}
              {...gesture}
              onEdit={(number) => move(side, { ...handleOf(value, side), [axis]: number })}
            />
          ))}
        </fieldset>
      ))}
    </div>
  );
}

function handleOf([x1, y1, x2, y2]: Handles, side: 0 | 1): CurvePoint {
  return side === 0 ? { x: round(x1), y: round(y1) } : { x: round(x2), y: round(y2) };
}

/** Moves a control point, clamped to its range. */
function withHandle([x1, y1, x2, y2]: Handles, side: 0 | 1, { x, y }: CurvePoint): Handles {
  const at = [round(clamp(x, 0, 1)), round(clamp(y, -OVERSHOOT, 1 + OVERSHOOT))] as const;
  return side === 0 ? [...at, x2, y2] : [x1, y1, ...at];
}

function armsPath([x1, y1, x2, y2]: Handles): string {
  return `M0 1L${x1} ${1 - y1}M1 0L${x2} ${1 - y2}`;
}

/** Rounds to a thousandth, the precision of the file. `+ 0` turns -0 into 0. */
function round(number: number): number {
  return Math.round(number * 1000) / 1000 + 0;
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}

/** SVG path data of a Bézier easing in a unit square, y down. */
export function handlesPath([x1, y1, x2, y2]: Handles): string {
  return `M0 1C${x1} ${1 - y1} ${x2} ${1 - y2} 1 0`;
}

export function easingPath(easing: Easing): string {
  const handles = handlesOf(easing);
  return handles === null ? 'M0 1H1V0' : handlesPath(handles);
}
