import type { FormEvent, ReactNode } from 'react';
import { Button } from './button.tsx';
import { Dialog } from './dialog.tsx';

interface FormDialogProps {
  readonly title: string;
  /** Label of the default button. */
  readonly action: string;
  /** Enables the default button and Enter. */
  readonly ready: boolean;
  readonly onGo: () => void;
  readonly onClose: () => void;
  readonly wide?: boolean;
  /** `large` makes the dialog larger than other dialogs. */
  readonly size?: 'large';
  /** Labels and fields. */
  readonly children: ReactNode;
}

/** A dialog with a form. */
export function FormDialog({ title, action, ready, onGo, onClose, wide = false, size, children }: FormDialogProps) {
  const go = () => {
    if (ready) onGo();
  };
  return (
    <Dialog
      title={title}
      wide={wide}
      {...(size && { size })}
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button look="primary" disabled={!ready} onPress={go}>
            {action}
          </Button>
        </>
      }
    >
      <form
        className="dialog-form"
        onSubmit={(event: FormEvent) => {
          event.preventDefault();
          go();
        }}
      >
        {children}
        {/* Without a submit button, Enter submits only forms with a single field. */}
        <button type="submit" hidden aria-label={action} />
      </form>
    </Dialog>
  );
}
