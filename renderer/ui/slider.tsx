import { useRef } from 'react';
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

/** The browser's own, whose drag Escape gives up. */
export function Slider({ value, min, max, step, label, valueText, onEdit, onEnd, onCancel }: SliderProps) {
  const filled = max > min ? Math.min(Math.max((value - min) / (max - min), 0), 1) : 0;
  /** The browser goes on dragging until the pointer is let go. */
  const givenUp = useRef(false);
  const givingUp = useEscape();
  const begin = () => {
    givenUp.current = false;
    if (!onCancel) return;
    givingUp.listen(() => {
      givenUp.current = true;
      onCancel();
    });
  };
  const end = () => {
    givingUp.stop();
    givenUp.current = false;
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
        if (!givenUp.current) onEdit(event.target.valueAsNumber);
      }}
      onPointerDown={begin}
      onPointerUp={end}
      // The browser moves it for a finger, of which no more is heard.
      onPointerCancel={givingUp.stop}
      onKeyUp={onEnd}
      onBlur={end}
    />
  );
}
