import { type KeyboardEvent, type ReactNode, useId, useRef, useState } from 'react';
import { Dialog } from './dialog.tsx';
import './search-dialog.css';

export interface SearchDialogProps<Item> {
  readonly title: string;
  /** Names of the field and of the list, for screen readers. */
  readonly label: string;
  readonly listLabel: string;
  readonly placeholder: string;
  /** Text for an empty result. */
  readonly none: string;
  readonly query: string;
  readonly onQuery: (query: string) => void;
  readonly found: readonly Item[];
  readonly keyOf: (item: Item) => string;
  readonly isEnabled?: (item: Item) => boolean;
  readonly children: (item: Item) => ReactNode;
  /** Called after the dialog has closed. */
  readonly onPick: (item: Item) => void;
  readonly onClose: () => void;
}

/** A dialog with a list that a search field filters. Arrow keys select, Enter chooses. */
export function SearchDialog<Item>(props: SearchDialogProps<Item>) {
  const { found, onClose, onQuery, isEnabled = () => true } = props;
  const [chosen, setChosen] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const listId = useId();

  const pick = (item: Item | undefined) => {
    if (item === undefined || !isEnabled(item)) return;
    onClose();
    props.onPick(item);
  };
  const choose = (index: number) => {
    setChosen(index);
    list.current?.children[index]?.scrollIntoView({ block: 'nearest' });
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const last = found.length - 1;
    if (event.key === 'ArrowDown') choose(chosen >= last ? 0 : chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen <= 0 ? Math.max(last, 0) : chosen - 1);
    else if (event.key === 'Enter') pick(found[chosen]);
    else return;
    event.preventDefault();
  };

  return (
    <Dialog title={props.title} onClose={onClose}>
      <input
        className="field"
        data-autofocus=""
        role="combobox"
        aria-label={props.label}
        aria-expanded="true"
        aria-controls={listId}
        aria-activedescendant={found[chosen] ? `${listId}-${chosen}` : undefined}
        placeholder={props.placeholder}
        autoComplete="off"
        spellCheck={false}
        value={props.query}
        onChange={(event) => {
          onQuery(event.target.value);
          choose(0);
        }}
        onKeyDown={onKeyDown}
      />
      <div ref={list} id={listId} className="search-list scroll" role="listbox" aria-label={props.listLabel}>
        {found.map((item, index) => (
          // The search field handles all keys; rows handle only the pointer.
          <div
            key={props.keyOf(item)}
            id={`${listId}-${index}`}
            className="search-row"
            role="option"
            aria-selected={index === chosen}
            aria-disabled={!isEnabled(item)}
            tabIndex={-1}
            onPointerMove={() => setChosen(index)}
            onPointerUp={() => pick(item)}
          >
            {props.children(item)}
          </div>
        ))}
      </div>
      {found.length === 0 && <p className="search-none">{props.none}</p>}
    </Dialog>
  );
}
