import { type KeyboardEvent, type MouseEvent, useId, useState } from 'react';

interface NameInPlaceProps {
  readonly label: string;
  /** The current name. */
  readonly title: string;
  /** Why a text cannot be the name; null if it can. */
  readonly problemOf: (typed: string) => string | null;
  readonly onName: (typed: string) => void;
  /** Called when the field is done, with or without a new name. */
  readonly onLeave: () => void;
}

/**
 * A field in the place of a name. Enter or a loss of focus renames, Escape cancels. A text that cannot be the name is said below; it cannot
 * be entered, and a loss of focus drops it.
 */
export function NameInPlace({ label, title, problemOf, onName, onLeave }: NameInPlaceProps) {
  const id = useId();
  const [typed, setTyped] = useState(title);
  const problem = problemOf(typed);
  const finish = () => {
    if (problem === null && typed !== title) onName(typed);
    onLeave();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    // Keys of the canvas, such as Delete, do not reach it.
    event.stopPropagation();
    if (event.key === 'Enter' && problem === null) finish();
    else if (event.key === 'Escape') onLeave();
  };
  return (
    <span className="name-in-place nodrag">
      <input
        ref={selectAll}
        aria-label={label}
        aria-invalid={problem !== null}
        aria-describedby={problem === null ? undefined : id}
        autoComplete="off"
        spellCheck={false}
        value={typed}
        onChange={(event) => setTyped(event.target.value)}
        onBlur={finish}
        onKeyDown={onKeyDown}
        onDoubleClick={(event) => event.stopPropagation()}
      />
      {problem !== null && (
        <span id={id} className="name-problem" role="alert">
          {problem}
        </span>
      )}
    </span>
  );
}

/** Handlers of a button whose double-click, or Enter, begins to edit its name. */
export function renameHandlers(begin: () => void) {
  return {
    onClick: ({ detail }: MouseEvent) => {
      // A click by the keyboard has no count.
      if (detail === 0) begin();
    },
    onDoubleClick: (event: MouseEvent) => {
      event.stopPropagation();
      begin();
    },
  };
}

function selectAll(input: HTMLInputElement | null): void {
  input?.focus({ preventScroll: true });
  input?.select();
}
