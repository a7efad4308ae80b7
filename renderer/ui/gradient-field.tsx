import { type ReactNode, useState } from 'react';
import { type Gradient, MAX_STOPS, STOP_INTERPOLATIONS } from '../../nodes/kit/gradient.ts';
import { IconButton } from './button.tsx';
import { ColorField } from './color-field.tsx';
import { GradientBar, INTERPOLATION_LABELS } from './gradient-bar.tsx';
import { canLoseStop, flipped, stopsOf, withoutStop, withStopAt, withStopChanged, withStopInGap } from './gradient-stops.ts';
import { type EditHandlers, NumberField } from './number-field.tsx';
import { SelectField } from './select-field.tsx';

interface GradientFieldProps extends EditHandlers<Gradient> {
  readonly label: string;
  readonly value: Gradient;
  /** A button that picks the color of the chosen stop from elsewhere. */
  readonly eyedropper: (take: (rgb: readonly [number, number, number]) => void) => ReactNode;
}

/** Editor of a gradient: the bar with its stops, and the color, position and interpolation of the chosen one. */
export function GradientField({ label, value, eyedropper, ...gesture }: GradientFieldProps) {
  const { onEdit, onEnd } = gesture;
  const [asked, choose] = useState(0);
  const stops = stopsOf(value);
  // An undo may remove the last stop.
  const chosen = Math.min(asked, stops.length - 1);
  const { position, color, interpolation } = stops[chosen] ?? { position: 0, color: [0, 0, 0, 1] as const, interpolation: 0 };
  const stop = `stop ${chosen + 1} of ${label}`;
  const change = (gradient: Gradient, index = chosen) => {
    onEdit(gradient);
    onEnd();
    choose(index);
  };
  const remove = (index: number) => change(withoutStop(value, index), Math.max(0, index - 1));
  const add = () => {
    const added = withStopInGap(value);
    if (added) change(added.gradient, added.index);
  };
  return (
    <div className="gradient-field">
      <GradientBar {...{ label, value, chosen }} onChoose={choose} onRemove={remove} {...gesture} />
      <ColorField
        label={`Color of ${stop}`}
        value={color}
        eyedropper={eyedropper(([r, g, b]) => change(withStopChanged(value, chosen, { color: [r, g, b, color[3]] })))}
        {...gesture}
        onEdit={(next) => onEdit(withStopChanged(value, chosen, { color: next }))}
      />
      <div className="gradient-numbers">
        <span aria-hidden="true">Position</span>
        <NumberField
          label={`Position of ${stop}`}
          value={position}
          step={0.01}
          suffix=""
          format={(number) => String(Number(number.toFixed(3)))}
          parse={(text) => (text.trim() === '' || !Number.isFinite(Number(text)) ? null : Number(text))}
          clamp={(number) => Math.min(Math.max(number, 0), 1)}
          {...gesture}
          onEdit={(to) => {
            const moved = withStopAt(value, chosen, to);
            onEdit(moved.gradient);
            choose(moved.index);
          }}
        />
        <SelectField
          label={`Interpolation after ${stop}`}
          value={interpolation}
          options={STOP_INTERPOLATIONS.map((name, index) => ({ value: index, label: INTERPOLATION_LABELS[name] }))}
          onChoose={(index) => change(withStopChanged(value, chosen, { interpolation: index }))}
        />
        <IconButton icon="flip" label="Flip the gradient" small onPress={() => change(flipped(value), stops.length - 1 - chosen)} />
        <IconButton icon="add" label="Add a stop" small disabled={stops.length >= MAX_STOPS} onPress={add} />
        <IconButton icon="trash" label="Remove the stop" small disabled={!canLoseStop(value)} onPress={() => remove(chosen)} />
      </div>
    </div>
  );
}
