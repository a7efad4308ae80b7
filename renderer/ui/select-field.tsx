import { type KeyboardEvent, useEffect, useId, useLayoutEffect, useRef, useState } from 'react';
import { zoomOf } from './appearance.ts';
import { Icon } from './icon.tsx';
import './select-field.css';

export interface SelectOption<T> {
  readonly value: T;
  readonly label: string;
  /** Heading above the first of the adjacent options of this group. */
  readonly group?: string;
}

interface SelectFieldProps<T> {
  readonly id?: string;
  readonly label: string;
  readonly value: T;
  readonly options: readonly SelectOption<T>[];
  /** Shown if no option has the value. Default: the value. */
  readonly placeholder?: string;
  /** Whether the choice is missing and required. Default: false. */
  readonly needed?: boolean;
  /** Element that says what is wrong with the choice; absent if nothing is. */
  readonly errorId?: string | undefined;
  /** Default: false. */
  readonly disabled?: boolean;
  readonly onChoose: (value: T) => void;
  /** Called with the option that the pointer or a key rests on; null for the chosen one, and when the list closes. */
  readonly onPoint?: (value: T | null) => void;
}

const EDGE_PX = 8;
const GAP_PX = 3;
/** After this pause, a letter begins another search. */
const TYPING_MS = 700;

/**
 * A drop-down list that tells which option is pointed at, which a native one does not. The keys are those of the WAI-ARIA pattern of a
 * select-only combobox: arrows, Home, End, letters; Enter, Space or Tab choose, Escape closes.
 */
export function SelectField<T extends string | number>(props: SelectFieldProps<T>) {
  const { id, label, value, options, placeholder = String(value), needed = false, errorId, disabled = false, onChoose, onPoint } = props;
  const chosen = options.findIndex((option) => option.value === value);
  /** The option that is pointed at; null: the list is closed. */
  const [active, setActive] = useState<number | null>(null);
  const list = useId();
  const button = useRef<HTMLButtonElement>(null);
  const typed = useRef({ text: '', timeMs: 0 });
  const pointed = useRef(onPoint);
  pointed.current = onPoint;

  const point = (index: number) => {
    setActive(index);
    pointed.current?.(index === chosen ? null : (options[index]?.value ?? null));
  };
  const close = () => {
    setActive(null);
    pointed.current?.(null);
  };
  const choose = (index: number | null) => {
    close();
    const option = index === null ? undefined : options[index];
    if (option && option.value !== value) onChoose(option.value);
  };
  // The list may go with the node while it is open.
  const isOpen = active !== null;
  useEffect(() => (isOpen ? () => pointed.current?.(null) : undefined), [isOpen]);

  const found = (key: string, timeMs: number): number => {
    const { text, timeMs: lastMs } = typed.current;
    const search = (timeMs - lastMs < TYPING_MS ? text : '') + key.toLowerCase();
    typed.current = { text: search, timeMs };
    // The same letter again goes to the next option with it.
    const isRepeated = [...search].every((letter) => letter === search[0]);
    const sought = isRepeated ? (search[0] ?? '') : search;
    const from = (active ?? chosen) + (isRepeated ? 1 : 0);
    const order = options.map((_, i) => (from + i + options.length) % options.length);
    return order.find((index) => options[index]?.label.toLowerCase().startsWith(sought)) ?? -1;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const { key } = event;
    if (event.ctrlKey || event.metaKey || (key === 'Escape' && active === null)) return;
    if (key === 'Tab') return choose(active);
    const at = active ?? Math.max(chosen, 0);
    const last = options.length - 1;
    const moves: Readonly<Record<string, number>> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      Home: 0,
      End: last,
      PageDown: at + 8,
      PageUp: at - 8,
    };
    const move = moves[key];
    const isLetter = key.length === 1 && (key !== ' ' || event.timeStamp - typed.current.timeMs < TYPING_MS);
    if (key === 'Escape') close();
    else if (active === null && (key === 'Enter' || key === ' ' || key === 'ArrowDown' || key === 'ArrowUp')) point(at);
    else if (isLetter) {
      const index = found(key, event.timeStamp);
      if (index !== -1) point(index);
    } else if (key === 'Enter' || key === ' ') choose(active);
    else if (move !== undefined) point(Math.min(Math.max(move, 0), last));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <span className="select-field">
      <button
        ref={button}
        id={id}
        type="button"
        role="combobox"
        className={needed ? 'select select-needed' : 'select'}
        data-value={value}
        disabled={disabled}
        aria-label={label}
        aria-invalid={errorId !== undefined}
        aria-describedby={errorId}
        aria-haspopup="listbox"
        aria-expanded={isOpen}
        aria-controls={list}
        aria-activedescendant={isOpen ? `${list}-${active}` : undefined}
        onClick={() => (isOpen ? close() : point(Math.max(chosen, 0)))}
        onKeyDown={onKeyDown}
        onBlur={close}
      >
        {options[chosen]?.label ?? placeholder}
      </button>
      {isOpen && <OptionList {...{ id: list, label, options, active, chosen, button }} onPoint={point} onChoose={choose} />}
    </span>
  );
}

interface OptionListProps<T> {
  readonly id: string;
  readonly label: string;
  readonly options: readonly SelectOption<T>[];
  readonly active: number;
  readonly chosen: number;
  /** The list lies below it if it fits there, else above. */
  readonly button: React.RefObject<HTMLElement | null>;
  readonly onPoint: (index: number) => void;
  readonly onChoose: (index: number) => void;
}

function OptionList<T extends string | number>({ id, label, options, active, chosen, button, onPoint, onChoose }: OptionListProps<T>) {
  const element = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState<{ left: number; top: number; minWidth: number } | null>(null);
  useLayoutEffect(() => {
    const box = element.current?.getBoundingClientRect();
    const from = button.current?.getBoundingClientRect();
    if (!box || !from || !element.current) return;
    const zoom = zoomOf(element.current);
    const below = from.bottom + GAP_PX;
    const fits = below + box.height < window.innerHeight - EDGE_PX;
    const left = Math.max(EDGE_PX, Math.min(from.left, window.innerWidth - box.width - EDGE_PX));
    const top = fits ? below : Math.max(EDGE_PX, from.top - box.height - GAP_PX);
    setPlace({ left: left / zoom, top: top / zoom, minWidth: from.width / zoom });
  }, [button]);
  useLayoutEffect(() => document.getElementById(`${id}-${active}`)?.scrollIntoView({ block: 'nearest' }), [id, active]);
  // The button keeps the focus and handles all keys; options handle only the pointer.
  const optionAt = (option: SelectOption<T>, index: number) => (
    <div
      key={option.value}
      id={`${id}-${index}`}
      role="option"
      tabIndex={-1}
      className="select-option"
      aria-selected={index === chosen}
      data-value={option.value}
      data-active={index === active ? '' : undefined}
      // `pointerenter` would also fire when the list opens or scrolls under a resting pointer.
      onPointerMove={() => {
        if (index !== active) onPoint(index);
      }}
      onPointerUp={({ button: pressed }) => {
        if (pressed === 0) onChoose(index);
      }}
    >
      <span>{option.label}</span>
      {index === chosen && <Icon name="check" size={14} />}
    </div>
  );
  return (
    <div
      ref={element}
      id={id}
      role="listbox"
      aria-label={label}
      className="select-list"
      style={place ?? { visibility: 'hidden' }}
      onPointerLeave={() => onPoint(chosen)}
      // Keeps the focus for the button.
      onPointerDown={(event) => event.preventDefault()}
      onMouseDown={(event) => event.preventDefault()}
    >
      {grouped(options).map(({ name, from, members }) => {
        const shown = members.map((option, i) => optionAt(option, from + i));
        if (name === undefined) return shown;
        return (
          // biome-ignore lint/a11y/useSemanticElements: a group of options, not of form controls.
          <div key={name} role="group" aria-label={name}>
            <div className="select-group" aria-hidden>
              {name}
            </div>
            {shown}
          </div>
        );
      })}
    </div>
  );
}

interface OptionGroup<T> {
  readonly name: string | undefined;
  /** Index of the first member among all options. */
  readonly from: number;
  readonly members: SelectOption<T>[];
}

function grouped<T>(options: readonly SelectOption<T>[]): readonly OptionGroup<T>[] {
  const groups: OptionGroup<T>[] = [];
  for (const [index, option] of options.entries()) {
    const last = groups.at(-1);
    if (last && last.name === option.group) last.members.push(option);
    else groups.push({ name: option.group, from: index, members: [option] });
  }
  return groups;
}
