import type { FormEvent, ReactNode } from 'react';
import { Button } from './button.tsx';
import { Dialog } from './dialog.tsx';

interface FormDialogProps {
  readonly title: string;
  /** What the button says that does it. */
  readonly action: string;
  /** Whether there is enough to do it; Enter asks, too. */
  readonly ready: boolean;
  readonly onGo: () => void;
  readonly onClose: () => void;
  readonly wide?: boolean;
  /** Labels and fields. */
  readonly children: ReactNode;
}

/** A question that is answered by filling in fields. */
export function FormDialog({ title, action, ready, onGo, onClose, wide = false, children }: FormDialogProps) {
  const go = () => {
    if (ready) onGo();
  };
  return (
    <Dialog
      title={title}
      wide={wide}
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
        {/* Without one, Enter asks only in forms of a single field. */}
        <button type="submit" hidden aria-label={action} />
      </form>
    </Dialog>
  );
}
