import type { ReactNode } from 'react';
import './button.css';
import { Icon, type IconName } from './icon.tsx';

export type ButtonLook = 'plain' | 'primary' | 'quiet' | 'danger';

interface ButtonProps {
  readonly children: ReactNode;
  readonly onPress: () => void;
  readonly icon?: IconName;
  readonly look?: ButtonLook;
  readonly disabled?: boolean;
  /** State of a toggle button. */
  readonly pressed?: boolean;
  /** Whether what the button shows below is open. */
  readonly expanded?: boolean;
  readonly tip?: string;
  readonly autoFocus?: boolean;
}

export function Button({
  children,
  onPress,
  icon,
  look = 'plain',
  disabled = false,
  pressed,
  expanded,
  tip,
  autoFocus = false,
}: ButtonProps) {
  return (
    <button
      type="button"
      className={`button button-${look}`}
      onClick={onPress}
      disabled={disabled}
      aria-pressed={pressed}
      aria-expanded={expanded}
      data-tip={tip}
      data-autofocus={autoFocus ? '' : undefined}
    >
      {icon && <Icon name={icon} />}
      <span>{children}</span>
    </button>
  );
}

interface IconButtonProps {
  readonly icon: IconName;
  /** Accessible name and tooltip. */
  readonly label: string;
  readonly onPress: () => void;
  /** Keybinding, shown after the label in the tooltip. */
  readonly keys?: string | undefined;
  readonly disabled?: boolean;
  /** State of a toggle button. */
  readonly pressed?: boolean | undefined;
  readonly small?: boolean;
}

export function IconButton({ icon, label, onPress, keys, disabled = false, pressed, small = false }: IconButtonProps) {
  return (
    <button
      type="button"
      className={small ? 'icon-button icon-button-small' : 'icon-button'}
      aria-label={label}
      aria-pressed={pressed}
      data-tip={label}
      data-tip-keys={keys}
      disabled={disabled}
      onClick={onPress}
    >
      <Icon name={icon} size={small ? 14 : 16} />
    </button>
  );
}
