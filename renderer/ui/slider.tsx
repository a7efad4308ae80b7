import { type KeyboardEvent, useRef } from 'react';
import { dragKeysOf, NO_DRAG_KEYS } from '../drag-keys.ts';
import { createSliderDrag, keyedValue, type SliderDrag } from './drag-steps.ts';
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

const DIRECTIONS: Readonly<Record<string, 1 | -1>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };

/**
 * A range input. In a drag and with arrow keys, Shift is finer and Ctrl snaps; Escape cancels a drag. After a drag, the focus goes back to
 * the graph if it was there, so that keys mean what they did before.
 */
export function Slider({ value, min, max, step, label, valueText, onEdit, onEnd, onCancel }: SliderProps) {
  const filled = max > min ? Math.min(Math.max((value - min) / (max - min), 0), 1) : 0;
  /** The browser continues the drag after Escape; its edits are ignored until the pointer is released. */
  const canceled = useRef(false);
  const escapeKey = useEscape();
  const drag = useRef<SliderDrag | null>(null);
  const keys = useRef(NO_DRAG_KEYS);
  /** What had the focus before the slider. */
  const before = useRef<EventTarget | null>(null);
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
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    const direction = DIRECTIONS[event.key];
    if (direction === undefined || drag.current) return;
    event.preventDefault();
    onEdit(Math.min(Math.max(keyedValue(value, direction, step, dragKeysOf(event)), min), max));
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
        if (before.current instanceof HTMLElement && before.current.closest('.canvas')) before.current.focus({ preventScroll: true });
      }}
      // The browser takes over a touch without a `pointerup`.
      onPointerCancel={escapeKey.stop}
      onFocus={({ relatedTarget }) => {
        before.current = relatedTarget;
      }}
      onKeyDown={onKeyDown}
      // A key released in a drag, such as Shift, ends only the fine part of it.
      onKeyUp={() => {
        if (!drag.current) onEnd();
      }}
      onBlur={end}
    />
  );
}
