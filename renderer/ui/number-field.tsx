import { type KeyboardEvent, type PointerEvent, useRef, useState } from 'react';
import { useEscape } from './escape.ts';
import './fields.css';

/** How edits are told apart: those of one gesture become one undo step, which `end` closes. */
export interface EditHandlers<T> {
  readonly onEdit: (value: T) => void;
  readonly onEnd: () => void;
  /** The gesture is given up: all is to be as it was before it. */
  readonly onCancel?: () => void;
}

interface NumberFieldProps extends EditHandlers<number> {
  readonly value: number;
  readonly label: string;
  readonly id?: string;
  readonly step: number;
  readonly suffix: string;
  readonly format: (value: number) => string;
  /** Null where the text is no number. */
  readonly parse: (text: string) => number | null;
  readonly clamp: (value: number) => number;
  /** `=` and something that is no number was typed; false where it will not do, and the text stays to be mended. */
  readonly onExpression?: (text: string) => boolean;
}

const SCRUB_START_PX = 3;
const PX_PER_STEP = 2;

/** A number as text. Dragging it sideways, or the arrow keys, change it by steps; Shift makes ten of them, Alt a tenth; Escape gives a drag up. Sums are worked out; `=` begins an expression. */
export function NumberField(props: NumberFieldProps) {
  const { value, label, id, step, suffix, format, parse, clamp, onExpression, onEdit, onEnd, onCancel } = props;
  const [typed, setTyped] = useState<string | null>(null);
  const [refused, setRefused] = useState(false);
  const field = useRef<HTMLInputElement>(null);
  const scrub = useRef<{ x: number; value: number; moving: boolean } | null>(null);
  const edited = useRef(false);
  const givingUp = useEscape();

  /** What cannot be read stays to be mended, until the field is left. */
  const finish = (leaving: boolean) => {
    if (typed !== null) {
      const parsed = parse(typed);
      const expression = /^\s*=(.*)/s.exec(typed)?.[1]?.trim() ?? '';
      if (parsed === null && expression !== '' && onExpression && !onExpression(expression)) return;
      if (parsed === null && expression === '' && !leaving) return setRefused(true);
      if (parsed !== null && clamp(parsed) !== value) onEdit(clamp(parsed));
      changeTyped(null);
    }
    onEnd();
  };
  const changeTyped = (text: string | null) => {
    setTyped(text);
    setRefused(false);
  };

  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key === 'Enter') {
      finish(false);
      field.current?.select();
    } else if (event.key === 'Escape' && typed !== null) {
      event.stopPropagation();
      changeTyped(null);
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      const from = (typed === null ? null : parse(typed)) ?? value;
      changeTyped(null);
      edited.current = true;
      onEdit(clamp(round(from + stepOf(step, event) * (event.key === 'ArrowUp' ? 1 : -1))));
    }
  };
  const onKeyUp = () => {
    if (edited.current) onEnd();
    edited.current = false;
  };
  const onPointerDown = (event: PointerEvent<HTMLInputElement>) => {
    if (document.activeElement === field.current || event.button !== 0) return;
    // The focus, and with it the keyboard, comes only when this turns out to be a click.
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    scrub.current = { x: event.clientX, value, moving: false };
    if (onCancel) givingUp.listen(() => giveUp(onCancel));
  };
  const giveUp = (cancel: () => void) => {
    if (scrub.current?.moving) cancel();
    scrub.current = null;
  };
  const onPointerMove = (event: PointerEvent<HTMLInputElement>) => {
    const from = scrub.current;
    if (!from) return;
    const byPx = event.clientX - from.x;
    if (!from.moving && Math.abs(byPx) < SCRUB_START_PX) return;
    from.moving = true;
    onEdit(clamp(round(from.value + Math.round(byPx / PX_PER_STEP) * stepOf(step, event))));
  };
  /** The browser took the finger for something else. */
  const onPointerCancel = () => {
    givingUp.stop();
    if (scrub.current?.moving) onEnd();
    scrub.current = null;
  };
  const onPointerUp = () => {
    const from = scrub.current;
    scrub.current = null;
    givingUp.stop();
    if (from?.moving) onEnd();
    else if (from) field.current?.focus();
  };

  return (
    <span className="number-field">
      <input
        ref={field}
        id={id}
        className="field"
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        aria-label={label}
        aria-invalid={refused}
        data-clean={typed === null ? '' : undefined}
        data-tip={refused ? 'That is no number.' : undefined}
        value={typed ?? format(value)}
        onChange={(event) => changeTyped(event.target.value)}
        onFocus={(event) => event.target.select()}
        onBlur={() => finish(true)}
        onKeyDown={onKeyDown}
        onKeyUp={onKeyUp}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={onPointerCancel}
      />
      {suffix !== '' && (
        <span className="number-suffix" aria-hidden="true">
          {suffix}
        </span>
      )}
    </span>
  );
}

function stepOf(step: number, event: { readonly shiftKey: boolean; readonly altKey: boolean }): number {
  return event.shiftKey ? step * 10 : event.altKey ? step / 10 : step;
}

/** Takes the noise of binary fractions off sums of decimal steps. */
function round(value: number): number {
  return Number(value.toPrecision(12));
}
