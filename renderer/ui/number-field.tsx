import { type KeyboardEvent, type PointerEvent, useRef, useState } from 'react';
import { dragKeysOf } from '../drag-keys.ts';
import { keyedValue, scrubbedValue } from './drag-steps.ts';
import { useEscape } from './escape.ts';
import './fields.css';

/** Callbacks of an edit. All edits until `onEnd` form one undo step. */
export interface EditHandlers<T> {
  readonly onEdit: (value: T) => void;
  readonly onEnd: () => void;
  /** Called when the gesture is canceled: restores the state before it. */
  readonly onCancel?: () => void;
}

interface NumberFieldProps extends EditHandlers<number> {
  readonly value: number;
  readonly label: string;
  readonly id?: string;
  readonly step: number;
  readonly suffix: string;
  readonly format: (value: number) => string;
  /** Returns null if the text is not a number. */
  readonly parse: (text: string) => number | null;
  readonly clamp: (value: number) => number;
  /** Called with the text after `=` if it is not a number. Returns false if it is invalid; the text then stays to be fixed. */
  readonly onExpression?: (text: string) => boolean;
}

const SCRUB_START_PX = 3;
const PX_PER_STEP = 2;

/**
 * Number field. A sideways drag and arrow keys change the value by steps: a tenth with Shift, to whole tens with Ctrl. Escape cancels a
 * drag. Evaluates typed arithmetic; `=` begins an expression.
 */
export function NumberField(props: NumberFieldProps) {
  const { value, label, id, step, suffix, format, parse, clamp, onExpression, onEdit, onEnd, onCancel } = props;
  const [typed, setTyped] = useState<string | null>(null);
  const [refused, setRefused] = useState(false);
  const field = useRef<HTMLInputElement>(null);
  const scrub = useRef<{ x: number; value: number; moving: boolean } | null>(null);
  const edited = useRef(false);
  const escapeKey = useEscape();

  /** Applies the typed text. Invalid text stays until the field loses focus. */
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
      onEdit(clamp(keyedValue(from, event.key === 'ArrowUp' ? 1 : -1, step, dragKeysOf(event))));
    }
  };
  const onKeyUp = () => {
    if (edited.current) onEnd();
    edited.current = false;
  };
  const onPointerDown = (event: PointerEvent<HTMLInputElement>) => {
    if (document.activeElement === field.current || event.button !== 0) return;
    // Focuses on a click only, not on a drag, so that no on-screen keyboard opens.
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    scrub.current = { x: event.clientX, value, moving: false };
    if (onCancel) escapeKey.listen(() => cancelScrub(onCancel));
  };
  const cancelScrub = (cancel: () => void) => {
    if (scrub.current?.moving) cancel();
    scrub.current = null;
  };
  const onPointerMove = (event: PointerEvent<HTMLInputElement>) => {
    const from = scrub.current;
    if (!from) return;
    const byPx = event.clientX - from.x;
    if (!from.moving && Math.abs(byPx) < SCRUB_START_PX) return;
    from.moving = true;
    onEdit(clamp(scrubbedValue(from.value, Math.round(byPx / PX_PER_STEP), step, dragKeysOf(event))));
  };
  /** The browser took over the gesture, such as for scrolling. */
  const onPointerCancel = () => {
    escapeKey.stop();
    if (scrub.current?.moving) onEnd();
    scrub.current = null;
  };
  const onPointerUp = () => {
    const from = scrub.current;
    scrub.current = null;
    escapeKey.stop();
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
        data-tip={refused ? 'Not a number' : undefined}
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
