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

export function Slider({ value, min, max, step, label, valueText, onEdit, onEnd }: SliderProps) {
  const filled = max > min ? Math.min(Math.max((value - min) / (max - min), 0), 1) : 0;
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
      onChange={(event) => onEdit(event.target.valueAsNumber)}
      onPointerUp={onEnd}
      onKeyUp={onEnd}
      onBlur={onEnd}
    />
  );
}
