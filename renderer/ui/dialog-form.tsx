import type { FormEvent, ReactNode } from 'react';

interface DialogFormProps {
  /** Label of the action, for screen readers. */
  readonly action: string;
  /** Called on Enter in a field. */
  readonly onGo: () => void;
  /** Labels and fields. */
  readonly children: ReactNode;
}

/** The form in a dialog, whose buttons stand outside of it. */
export function DialogForm({ action, onGo, children }: DialogFormProps) {
  return (
    <form
      className="dialog-form"
      onSubmit={(event: FormEvent) => {
        event.preventDefault();
        onGo();
      }}
    >
      {children}
      {/* Without a submit button, Enter submits only forms with a single field. */}
      <button type="submit" hidden aria-label={action} />
    </form>
  );
}
