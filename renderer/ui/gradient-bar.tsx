import { type KeyboardEvent, type PointerEvent, useRef } from 'react';
import { type Gradient, STOP_INTERPOLATIONS } from '../../nodes/kit/gradient.ts';
import { hexFromColor } from './color-text.ts';
import { useEscape } from './escape.ts';
import './gradient.css';
import { canLoseStop, gradientCss, stopsOf, type WithStop, withoutStop, withStop, withStopAt } from './gradient-stops.ts';
import type { EditHandlers } from './number-field.tsx';

interface GradientBarProps extends EditHandlers<Gradient> {
  readonly label: string;
  readonly value: Gradient;
  readonly chosen: number;
  readonly onChoose: (index: number) => void;
  readonly onRemove: (index: number) => void;
}

/** A drag of a stop. `gradient` is the gradient at its start, so that a stop dragged off and back keeps its color. */
interface Drag {
  readonly gradient: Gradient;
  readonly index: number;
  /** From the pointer to the stop, as a fraction of the bar. */
  readonly by: number;
  changed: boolean;
}

/** A stop dragged this far above or below the bar is removed. */
const OFF_PX = 28;

/** The interpolations as the editor of keyframes names them. */
export const INTERPOLATION_LABELS: Readonly<Record<(typeof STOP_INTERPOLATIONS)[number], string>> = {
  linear: 'Linear',
  'ease-in-out': 'Ease in-out',
  hold: 'Hold',
};

/** A bar of colors with its stops. A press beside a stop adds one, a drag moves it, a drag off the bar removes it; Escape cancels. */
export function GradientBar({ label, value, chosen, onChoose, onRemove, onEdit, onEnd, onCancel }: GradientBarProps) {
  const bar = useRef<HTMLFieldSetElement>(null);
  const drag = useRef<Drag | null>(null);
  const escapeKey = useEscape();
  const stops = stopsOf(value);

  const focus = (index: number) => {
    onChoose(index);
    // React has mounted a new stop by then.
    queueMicrotask(() => bar.current?.querySelectorAll<HTMLElement>('.gradient-stop')[index]?.focus());
  };
  const move = ({ gradient, index }: WithStop) => {
    onEdit(gradient);
    focus(index);
  };
  const nearest = (event: PointerEvent<HTMLElement>): number => {
    const { left, width } = event.currentTarget.getBoundingClientRect();
    const far = stops.map(({ position }) => Math.abs(event.clientX - left - position * width));
    const least = Math.min(...far);
    return least <= (event.pointerType === 'mouse' ? 7 : 18) ? far.indexOf(least) : -1;
  };

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    // Keeps the focus for the stop.
    event.preventDefault();
    const at = positionIn(event.currentTarget, event);
    const index = nearest(event);
    const added = index === -1 ? withStop(value, at) : null;
    const taken = added ?? (index === -1 ? null : { gradient: value, index });
    if (!taken) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const position = stopsOf(taken.gradient)[taken.index]?.position ?? at;
    drag.current = { ...taken, by: position - at, changed: added !== null };
    escapeKey.listen(() => {
      if (drag.current?.changed) onCancel?.();
      drag.current = null;
    });
    if (added) onEdit(added.gradient);
    focus(taken.index);
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const held = drag.current;
    if (!held) return;
    const { top, bottom } = event.currentTarget.getBoundingClientRect();
    held.changed = true;
    if (Math.max(top - event.clientY, event.clientY - bottom) > OFF_PX && canLoseStop(held.gradient)) {
      onEdit(withoutStop(held.gradient, held.index));
      onChoose(Math.max(0, held.index - 1));
    } else {
      move(withStopAt(held.gradient, held.index, positionIn(event.currentTarget, event) + held.by));
    }
  };
  const onPointerUp = () => {
    escapeKey.stop();
    if (drag.current?.changed) onEnd();
    drag.current = null;
  };
  const onKeyDown = (event: KeyboardEvent, index: number) => {
    const { position } = stops[index] ?? { position: 0 };
    const by = KEYS[event.key];
    const step = event.shiftKey ? 0.1 : event.altKey ? 0.001 : 0.01;
    if (by !== undefined) move(withStopAt(value, index, position + by * step));
    else if (event.key === 'Home') move(withStopAt(value, index, 0));
    else if (event.key === 'End') move(withStopAt(value, index, 1));
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      if (canLoseStop(value)) {
        onRemove(index);
        focus(Math.max(0, index - 1));
      }
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <fieldset
      ref={bar}
      className="gradient-bar"
      aria-label={`Stops of ${label}`}
      data-tip="Press the bar to add a stop, drag a stop off the bar to remove it"
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onPointerUp={onPointerUp}
      onPointerCancel={onPointerUp}
    >
      <span className="gradient-colors" style={{ ['--gradient' as string]: gradientCss(value) }} />
      {[...stops.entries()].map(([index, { position, color, interpolation }]) => (
        <div
          // Stops are in order of their positions, and the focus moves with a stop that passes another.
          key={index}
          className="gradient-stop"
          role="slider"
          tabIndex={0}
          aria-label={`${label}, stop ${index + 1} of ${stops.length}`}
          aria-valuemin={0}
          aria-valuemax={1}
          aria-valuenow={position}
          aria-valuetext={`${position}, ${hexFromColor(color)}, ${INTERPOLATION_LABELS[STOP_INTERPOLATIONS[interpolation] ?? 'linear']}`}
          data-chosen={index === chosen}
          style={{ left: `${position * 100}%`, ['--stop' as string]: hexFromColor(color) }}
          onFocus={() => onChoose(index)}
          onKeyDown={(event) => onKeyDown(event, index)}
          onKeyUp={(event) => {
            if (KEYS[event.key] !== undefined || event.key === 'Home' || event.key === 'End') onEnd();
          }}
        />
      ))}
    </fieldset>
  );
}

const KEYS: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

function positionIn(bar: HTMLElement, { clientX }: { readonly clientX: number }): number {
  const { left, width } = bar.getBoundingClientRect();
  return Math.min(Math.max((clientX - left) / width, 0), 1);
}
