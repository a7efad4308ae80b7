import { type ReactNode, useState } from 'react';
import './fields.css';
import { colorFromHex, hexFromColor, type Rgba } from './color-text.ts';
import type { EditHandlers } from './number-field.tsx';
import { Slider } from './slider.tsx';

interface ColorFieldProps extends EditHandlers<Rgba> {
  readonly value: Rgba;
  readonly label: string;
  /** Button that picks a color from elsewhere. */
  readonly eyedropper?: ReactNode;
}

/** Color picker of the browser, hexadecimal text, and a slider for alpha. */
export function ColorField({ value, label, eyedropper, onEdit, onEnd, onCancel }: ColorFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const [r, g, b, a] = value;
  const hex = hexFromColor(value);
  const finish = () => {
    const parsed = typed === null ? null : colorFromHex(typed, a);
    if (parsed) onEdit(parsed);
    setTyped(null);
    onEnd();
  };
  return (
    <div className="color-field" data-eyedropper={eyedropper !== undefined}>
      <span className="swatch" style={{ ['--swatch' as string]: `rgb(${r * 255} ${g * 255} ${b * 255} / ${a})` }}>
        <input
          type="color"
          aria-label={label}
          value={hex}
          onChange={(event) => {
            const picked = colorFromHex(event.target.value, a);
            if (picked) onEdit(picked);
          }}
          onBlur={onEnd}
        />
      </span>
      <input
        className="field color-hex"
        aria-label={`${label}, hexadecimal`}
        spellCheck={false}
        value={typed ?? hex}
        onChange={(event) => setTyped(event.target.value)}
        onBlur={finish}
        onKeyDown={(event) => {
          if (event.key === 'Enter') finish();
        }}
      />
      {eyedropper}
      <Slider
        label={`${label}, opacity`}
        min={0}
        max={1}
        step={0.01}
        value={a}
        valueText={`${Math.round(a * 100)} %`}
        onEdit={(alpha) => onEdit([r, g, b, alpha])}
        onEnd={onEnd}
        {...(onCancel ? { onCancel } : {})}
      />
      <span className="color-alpha" aria-hidden="true">
        {Math.round(a * 100)}%
      </span>
    </div>
  );
}
