import type { ReactNode } from 'react';
import { Button } from './button.tsx';
import { Dialog } from './dialog.tsx';
import { DialogForm } from './dialog-form.tsx';

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
      <DialogForm action={action} onGo={go}>
        {children}
      </DialogForm>
    </Dialog>
  );
}
