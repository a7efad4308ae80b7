import { useEffect, useId, useRef, useState } from 'react';
import { type Curve, MAX_CURVE_POINTS } from '../../nodes/kit/curve.ts';
import { IconButton } from './button.tsx';
import { CurveEditor } from './curve-editor.tsx';
import { canLosePoint, curvePath, pointsOf, withoutPoint, withPointAt, withPointInGap } from './curve-points.ts';
import { CurveDrawing } from './curve-square.tsx';
import { type EditHandlers, NumberField } from './number-field.tsx';

interface CurveFieldProps extends EditHandlers<Curve> {
  readonly label: string;
  readonly id: string;
  readonly value: Curve;
}

/** A thumbnail strip of a curve that expands to its editor. */
export function CurveField({ label, id, value, ...gesture }: CurveFieldProps) {
  const [open, setOpen] = useState(false);
  const editor = useId();
  return (
    <>
      <button
        type="button"
        id={id}
        className="curve-strip"
        aria-label={`Edit the curve ${label}`}
        aria-expanded={open}
        aria-controls={editor}
        data-tip={open ? 'Collapse the curve' : 'Edit the curve'}
        onClick={() => setOpen(!open)}
      >
        <CurveDrawing path={curvePath(value)} />
      </button>
      <div id={editor} className="curve-opened" hidden={!open}>
        {open && <OpenCurve label={label} value={value} {...gesture} />}
      </div>
    </>
  );
}

function OpenCurve({ label, value, ...gesture }: Omit<CurveFieldProps, 'id'>) {
  const { onEdit, onEnd } = gesture;
  const [asked, choose] = useState(0);
  const points = pointsOf(value);
  // An undo may remove the last point.
  const chosen = Math.min(asked, points.length - 1);
  const at = points[chosen] ?? { x: 0, y: 0 };
  const remove = (index: number) => {
    onEdit(withoutPoint(value, index));
    onEnd();
    choose(Math.max(0, index - 1));
  };
  const add = () => {
    const added = withPointInGap(value);
    if (!added) return;
    onEdit(added.curve);
    onEnd();
    choose(added.index);
  };
  const number = (axis: 'x' | 'y', name: string) => (
    <span className="vector-part">
      <span aria-hidden="true">{axis.toUpperCase()}</span>
      <NumberField
        label={`${name} of point ${chosen + 1} of ${label}`}
        value={at[axis]}
        step={0.01}
        suffix=""
        format={(value) => String(Number(value.toFixed(3)))}
        parse={(text) => (text.trim() === '' || !Number.isFinite(Number(text)) ? null : Number(text))}
        clamp={(value) => Math.min(Math.max(value, 0), 1)}
        {...gesture}
        onEdit={(to) => onEdit(withPointAt(value, chosen, { ...at, [axis]: to }))}
      />
    </span>
  );
  const opened = useRef<HTMLDivElement>(null);
  useEffect(() => opened.current?.scrollIntoView({ block: 'nearest' }), []);
  return (
    <div ref={opened}>
      <CurveEditor {...{ label, value, chosen }} onChoose={choose} onRemove={remove} {...gesture} />
      <div className="curve-numbers">
        {number('x', 'Place')}
        {number('y', 'Height')}
        <IconButton icon="add" label="Add a point" small disabled={points.length >= MAX_CURVE_POINTS} onPress={add} />
        <IconButton icon="trash" label="Remove the point" small disabled={!canLosePoint(value)} onPress={() => remove(chosen)} />
      </div>
    </div>
  );
}
