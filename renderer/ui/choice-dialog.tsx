import type { ReactNode } from 'react';
import { Button, type ButtonLook } from './button.tsx';
import { Dialog } from './dialog.tsx';

interface Choice {
  readonly label: string;
  readonly look: ButtonLook;
  readonly run: () => void;
}

interface ChoiceDialogProps {
  readonly title: string;
  /** The default choice is last and has the focus. */
  readonly choices: readonly Choice[];
  readonly onClose: () => void;
  readonly children: ReactNode;
}

/** A dialog that asks for a decision, with a button for each choice. */
export function ChoiceDialog({ title, choices, onClose, children }: ChoiceDialogProps) {
  const buttons = choices.map(({ label, look, run }, index) => (
    <Button key={label} look={look} autoFocus={index === choices.length - 1} onPress={run}>
      {label}
    </Button>
  ));
  return (
    <Dialog title={title} onClose={onClose} actions={buttons}>
      {children}
    </Dialog>
  );
}
