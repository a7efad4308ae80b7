import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { Icon } from '../ui/icon.tsx';
import './dialog-error.css';

/** The errors of the open dialog, inside the dialog, which covers toasts. */
export function DialogErrors({ id }: { readonly id?: string }) {
  const errors = useStore(useEditor().ui, (state) => state.dialogErrors);
  return (
    <div id={id} role="alert">
      {errors.map(({ text, detail }) => (
        <ErrorText key={text} text={text} detail={detail} />
      ))}
    </div>
  );
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
