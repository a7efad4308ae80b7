import { useState } from 'react';
import type { Color } from '../../export/glsl/language/literals.ts';
import { colorFromHex, hexFromColor } from '../ui/color-text.ts';
import { NumberField } from '../ui/number-field.tsx';
import { Slider } from '../ui/slider.tsx';
import './literal-tuner.css';

interface TunerProps {
  readonly onEnd: () => void;
  readonly onClose: () => void;
}

interface NumberTunerProps extends TunerProps {
  readonly start: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly print: (value: number) => string;
  readonly onEdit: (value: number) => void;
}

/** Slider and field for a number literal. */
export function NumberTuner({ start, min, max, step, print, onEdit, onEnd, onClose }: NumberTunerProps) {
  const [value, setValue] = useState(start);
  const edit = (next: number) => {
    setValue(next);
    onEdit(next);
  };
  return (
    <fieldset className="tuner" aria-label="Number" onKeyDown={(event) => closeOnEscape(event, onClose)}>
      <Slider
        label="Value"
        min={min}
        max={max}
        step={step}
        value={Math.min(Math.max(value, min), max)}
        valueText={print(value)}
        onEdit={edit}
        onEnd={onEnd}
      />
      <NumberField
        label="Exact value"
        value={value}
        step={step}
        suffix=""
        format={print}
        parse={(text) => (text.trim() === '' || Number.isNaN(Number(text)) ? null : Number(text))}
        clamp={(next) => next}
        onEdit={edit}
        onEnd={onEnd}
      />
    </fieldset>
  );
}

interface ColorTunerProps extends TunerProps {
  readonly start: Color;
  readonly hasAlpha: boolean;
  readonly onEdit: (color: Color) => void;
}

const CHANNELS = ['Red', 'Green', 'Blue', 'Alpha'] as const;

/** Color picker, hexadecimal text and a slider per component for a color literal. */
export function ColorTuner({ start, hasAlpha, onEdit, onEnd, onClose }: ColorTunerProps) {
  const [color, setColor] = useState(start);
  const edit = (next: Color) => {
    setColor(next);
    onEdit(next);
  };
  const [red, green, blue, alpha] = color;
  const css = `rgb(${red * 255} ${green * 255} ${blue * 255} / ${alpha})`;
  return (
    <fieldset className="tuner tuner-colour" aria-label="Color" onKeyDown={(event) => closeOnEscape(event, onClose)}>
      <span className="swatch" style={{ ['--swatch' as string]: css }}>
        <input
          type="color"
          aria-label="Color"
          value={hexFromColor(color)}
          onChange={(event) => {
            const picked = colorFromHex(event.target.value, alpha);
            if (picked) edit(picked);
          }}
          onBlur={onEnd}
        />
      </span>
      <div className="tuner-channels">
        {CHANNELS.slice(0, hasAlpha ? 4 : 3).map((label, i) => (
          <div key={label} className="tuner-channel">
            <span aria-hidden="true">{label[0]}</span>
            <Slider
              label={label}
              min={0}
              max={1}
              step={0.005}
              value={color[i] ?? 0}
              valueText={(color[i] ?? 0).toFixed(3)}
              onEdit={(value) => edit(withChannel(color, i, value))}
              onEnd={onEnd}
            />
            <span className="tuner-value" aria-hidden="true">
              {(color[i] ?? 0).toFixed(2)}
            </span>
          </div>
        ))}
      </div>
    </fieldset>
  );
}

function withChannel([red, green, blue, alpha]: Color, index: number, value: number): Color {
  return [index === 0 ? value : red, index === 1 ? value : green, index === 2 ? value : blue, index === 3 ? value : alpha];
}

function closeOnEscape(event: React.KeyboardEvent, onClose: () => void): void {
  if (event.key !== 'Escape' || event.defaultPrevented) return;
  event.stopPropagation();
  onClose();
}
