import { useId, useState } from 'react';

interface HeaderFieldProps {
  readonly label: string;
  readonly value: string;
  readonly placeholder?: string;
  /** Shows a text area instead of a field. */
  readonly long?: boolean;
  readonly disabled?: boolean;
  readonly onSet: (text: string) => void;
}

/** One text of the header. Enter or a loss of focus applies it, Escape cancels. */
export function HeaderField({ label, value, placeholder = '', long = false, disabled = false, onSet }: HeaderFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const id = useId();
  const finish = () => {
    if (typed !== null && typed !== value) onSet(typed);
    setTyped(null);
  };
  const shared = {
    id,
    className: 'field',
    placeholder,
    disabled,
    spellCheck: long,
    value: typed ?? value,
    'data-clean': typed === null ? '' : undefined,
    onBlur: finish,
    onKeyDown: (event: React.KeyboardEvent) => {
      if (event.key === 'Enter' && !(long && event.shiftKey)) {
        event.preventDefault();
        finish();
      }
      if (event.key === 'Escape' && typed !== null) {
        event.stopPropagation();
        setTyped(null);
      }
    },
  };
  return (
    <div className={long ? 'header-field header-field-long' : 'header-field'}>
      <label htmlFor={id}>{label}</label>
      {long ? (
        <textarea {...shared} rows={2} onChange={(event) => setTyped(event.target.value)} />
      ) : (
        <input {...shared} autoComplete="off" onChange={(event) => setTyped(event.target.value)} />
      )}
    </div>
  );
}
