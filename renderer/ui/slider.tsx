import { useRef } from 'react';
import { createSliderDrag, dragKeysOf, NO_DRAG_KEYS, type SliderDrag } from './drag-steps.ts';
import { useEscape } from './escape.ts';
import './fields.css';
import type { EditHandlers } from './number-field.tsx';

interface SliderProps extends EditHandlers<number> {
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly label: string;
  readonly valueText: string;
}

/**
 * A range input. In a drag, Shift is finer, Ctrl snaps, and Escape cancels. After a drag it gives up the focus, so that keys mean what
 * they did before.
 */
export function Slider({ value, min, max, step, label, valueText, onEdit, onEnd, onCancel }: SliderProps) {
  const filled = max > min ? Math.min(Math.max((value - min) / (max - min), 0), 1) : 0;
  /** The browser continues the drag after Escape; its edits are ignored until the pointer is released. */
  const canceled = useRef(false);
  const escapeKey = useEscape();
  const drag = useRef<SliderDrag | null>(null);
  const keys = useRef(NO_DRAG_KEYS);
  const begin = () => {
    canceled.current = false;
    drag.current = createSliderDrag(step);
    if (!onCancel) return;
    escapeKey.listen(() => {
      canceled.current = true;
      onCancel();
    });
  };
  const end = () => {
    escapeKey.stop();
    canceled.current = false;
    drag.current = null;
    onEnd();
  };
  return (
    <input
      type="range"
      className="slider"
      aria-label={label}
      aria-valuetext={valueText}
      min={min}
      max={max}
      step={step}
      value={value}
      style={{ ['--filled' as string]: `${filled * 100}%` }}
      onChange={(event) => {
        const pointed = event.target.valueAsNumber;
        if (!canceled.current) onEdit(drag.current?.move(pointed, value, keys.current) ?? pointed);
      }}
      onPointerDown={(event) => {
        keys.current = dragKeysOf(event);
        begin();
      }}
      // Comes before the `input` event of the same movement, which does not tell the keys.
      onPointerMove={(event) => {
        keys.current = dragKeysOf(event);
      }}
      onPointerUp={({ currentTarget }) => {
        end();
        currentTarget.blur();
      }}
      // The browser takes over a touch without a `pointerup`.
      onPointerCancel={escapeKey.stop}
      onKeyUp={onEnd}
      onBlur={end}
    />
  );
}
