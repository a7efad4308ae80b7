import { type ReactNode, useEffect, useId, useRef } from 'react';
import './dialog.css';

interface DialogProps {
  readonly title: string;
  readonly children: ReactNode;
  readonly onClose: () => void;
  /** Buttons; the default action is last. */
  readonly actions?: ReactNode;
  readonly wide?: boolean;
  /** `large` makes the dialog larger than other dialogs. */
  readonly size?: 'large';
}

/** A modal `<dialog>`. The browser traps the focus, restores it and closes on Escape. */
export function Dialog({ title, children, onClose, actions, wide = false, size }: DialogProps) {
  const element = useRef<HTMLDialogElement>(null);
  const titleId = useId();

  useEffect(() => {
    const dialog = element.current;
    if (!dialog) return;
    dialog.showModal();
    dialog.querySelector<HTMLElement>('[data-autofocus]')?.focus();
    return () => dialog.close();
  }, []);

  return (
    <dialog
      ref={element}
      className={`dialog${wide ? ' dialog-wide' : ''}${size === 'large' ? ' dialog-large' : ''}`}
      aria-labelledby={titleId}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
    >
      <h2 id={titleId}>{title}</h2>
      <div className="dialog-body">{children}</div>
      {actions && <div className="dialog-actions">{actions}</div>}
    </dialog>
  );
}
