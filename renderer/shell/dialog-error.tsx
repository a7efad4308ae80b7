import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { type DialogRequest, removeToast } from '../state/editor/ui.ts';
import { Icon } from '../ui/icon.tsx';
import './dialog-error.css';

/** The dialogs that contain `DialogError`. */
const WITH_ERROR: ReadonlySet<DialogRequest['kind']> = new Set(['new', 'open', 'save-as', 'render']);

/** Whether the open dialog shows errors itself, which are then no toasts. */
export function saysErrors(dialog: DialogRequest | null): boolean {
  return dialog !== null && WITH_ERROR.has(dialog.kind);
}

/** The last error since the dialog opened, inside the dialog, which covers toasts. It goes with the dialog. */
export function DialogError() {
  const { ui } = useEditor();
  const [earlier] = useState(() => new Set(ui.getState().toasts));
  const error = useStore(ui, ({ toasts }) => [...toasts].reverse().find((toast) => toast.tone === 'error' && !earlier.has(toast)) ?? null);
  const id = error?.id ?? null;
  useEffect(() => (id === null ? undefined : () => removeToast(ui, id)), [ui, id]);
  return <div role="alert">{error !== null && <ErrorText text={error.text} detail={error.detail} />}</div>;
}

/** An error inside a dialog, with what to do. */
export function ErrorText({ text, detail }: { readonly text: string; readonly detail: string | undefined }) {
  return (
    <div className="dialog-error">
      <Icon name="error" />
      <p>
        {text}
        {detail !== undefined && <span> {detail}</span>}
      </p>
    </div>
  );
}
