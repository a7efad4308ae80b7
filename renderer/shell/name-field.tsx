import { TextField } from '../ui/form-fields.tsx';

interface NameFieldProps {
  readonly name: string;
  readonly onChange: (name: string) => void;
}

/** Field for the title of a project. */
export function NameField({ name, onChange }: NameFieldProps) {
  return (
    <TextField label="Name" text={name} plain autoFocus error={name.trim() === '' ? 'Enter a name.' : undefined} onChange={onChange} />
  );
}
