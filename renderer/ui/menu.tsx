import { type KeyboardEvent, useEffect, useId, useRef, useState } from 'react';
import { Icon } from './icon.tsx';
import './menu.css';

export type MenuItem =
  | {
      readonly kind: 'action';
      readonly label: string;
      readonly keys?: string;
      readonly disabled?: boolean;
      /** State of a toggle or, with `radio`, of one of several choices. Absent: the item switches nothing. */
      readonly checked?: boolean;
      readonly radio?: true;
      readonly run: () => void;
    }
  | { readonly kind: 'line' }
  | { readonly kind: 'title'; readonly label: string };

interface MenuButtonProps {
  readonly label: string;
  readonly items: readonly MenuItem[];
  /** Label of the open menu in the menu bar; null if none is open. While one is open, hovering another opens that one instead. */
  readonly openInBar?: string | null;
  readonly onOpenInBar?: (label: string | null) => void;
}

/** A button with a drop-down menu, with the keys of the WAI-ARIA menu button pattern: arrows, Home, End, first letters, Escape. */
export function MenuButton({ label, items, openInBar = null, onOpenInBar }: MenuButtonProps) {
  const [openAlone, setOpenAlone] = useState(false);
  const inBar = onOpenInBar !== undefined;
  const open = inBar ? openInBar === label : openAlone;
  const setOpen = (next: boolean) => (inBar ? onOpenInBar(next ? label : null) : setOpenAlone(next));
  const button = useRef<HTMLButtonElement>(null);
  const menuId = useId();
  const close = () => {
    setOpen(false);
    button.current?.focus();
  };

  return (
    <div className="menu-anchor">
      <button
        ref={button}
        type="button"
        className="menu-button"
        aria-haspopup="menu"
        aria-expanded={open}
        aria-controls={open ? menuId : undefined}
        onClick={() => setOpen(!open)}
        // `pointerenter` would also fire when the menu opens under a resting pointer.
        onPointerMove={() => {
          if (inBar && openInBar !== null && !open) setOpen(true);
        }}
        onKeyDown={(event) => {
          if (event.key !== 'ArrowDown') return;
          event.preventDefault();
          setOpen(true);
        }}
      >
        {label}
      </button>
      {open && <Menu id={menuId} label={label} items={items} onClose={close} onLeave={() => setOpen(false)} />}
    </div>
  );
}

interface MenuProps {
  readonly id: string;
  readonly label: string;
  readonly items: readonly MenuItem[];
  readonly onClose: () => void;
  /** Called when the focus leaves the menu. */
  readonly onLeave: () => void;
}

export function Menu({ id, label, items, onClose, onLeave }: MenuProps) {
  const element = useRef<HTMLDivElement>(null);
  const entries = () => [...(element.current?.querySelectorAll<HTMLButtonElement>('[role^=menuitem]:not(:disabled)') ?? [])];

  useEffect(() => {
    element.current?.querySelector<HTMLButtonElement>('[role^=menuitem]:not(:disabled)')?.focus();
  }, []);

  const onKeyDown = (event: KeyboardEvent) => {
    const all = entries();
    const at = all.indexOf(document.activeElement as HTMLButtonElement);
    const target = targetOfKey(event.key, at, all);
    if (event.key === 'Escape') onClose();
    else if (event.key === 'Tab') onLeave();
    else if (target) target.focus();
    else return;
    if (event.key !== 'Tab') event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div
      ref={element}
      id={id}
      className="menu"
      role="menu"
      aria-label={label}
      tabIndex={-1}
      onKeyDown={onKeyDown}
      onBlur={(event) => {
        if (!event.currentTarget.parentElement?.contains(event.relatedTarget)) onLeave();
      }}
    >
      {items.map((item, index) => (
        <MenuEntry key={item.kind === 'line' ? `line-${index}` : item.label} item={item} onDone={onClose} />
      ))}
    </div>
  );
}

function MenuEntry({ item, onDone }: { readonly item: MenuItem; readonly onDone: () => void }) {
  if (item.kind === 'line') return <hr className="menu-line" />;
  if (item.kind === 'title') return <div className="menu-title">{item.label}</div>;
  return (
    <button
      type="button"
      {...roleOf(item)}
      className="menu-item"
      tabIndex={-1}
      disabled={item.disabled ?? false}
      onPointerMove={(event) => event.currentTarget.focus()}
      onClick={() => {
        onDone();
        item.run();
      }}
    >
      {item.checked === true && <Icon name="check" size={14} />}
      <span>{item.label}</span>
      {item.keys && <kbd>{item.keys}</kbd>}
    </button>
  );
}

function roleOf({ checked, radio }: Extract<MenuItem, { kind: 'action' }>) {
  if (checked === undefined) return { role: 'menuitem' };
  return { role: radio ? 'menuitemradio' : 'menuitemcheckbox', 'aria-checked': checked };
}

function targetOfKey(key: string, at: number, all: readonly HTMLButtonElement[]): HTMLButtonElement | undefined {
  if (key === 'ArrowDown') return all[(at + 1) % all.length];
  if (key === 'ArrowUp') return all[(at - 1 + all.length) % all.length];
  if (key === 'Home') return all[0];
  if (key === 'End') return all[all.length - 1];
  if (key.length !== 1 || key === ' ') return undefined;
  const startsWith = (button: HTMLButtonElement) => button.textContent?.toLowerCase().startsWith(key.toLowerCase());
  return [...all.slice(at + 1), ...all.slice(0, at + 1)].find(startsWith);
}
