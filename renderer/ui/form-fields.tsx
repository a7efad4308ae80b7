import { useId } from 'react';
import { SelectField, type SelectOption } from './select-field.tsx';
import './form-fields.css';

interface ChoiceFieldProps<T> {
  readonly label: string;
  readonly value: T;
  readonly options: readonly SelectOption<T>[];
  /** What is wrong with the choice; absent if nothing is. */
  readonly error?: string | undefined;
  readonly onChoose: (value: T) => void;
}

/** A labeled list of choices in a form. */
export function ChoiceField<T extends string>({ error, ...select }: ChoiceFieldProps<T>) {
  const id = useId();
  return (
    <div className="form-field">
      <label htmlFor={id}>{select.label}</label>
      <SelectField id={id} {...select} errorId={error === undefined ? undefined : `${id}-error`} />
      <FieldError id={`${id}-error`} error={error} />
    </div>
  );
}

interface TextFieldProps {
  readonly label: string;
  readonly text: string;
  /** Marks the text as wrong; `error` also says why. */
  readonly wrong?: boolean;
  readonly error?: string | undefined;
  /** Absent: a number. */
  readonly plain?: boolean;
  /** Whether the field has the focus when its dialog opens. */
  readonly autoFocus?: boolean;
  readonly onChange: (text: string) => void;
}

/** A labeled field for a number, or a plain text, in a form. */
export function TextField({ label, text, error, wrong = error !== undefined, plain = false, autoFocus = false, onChange }: TextFieldProps) {
  const id = useId();
  return (
    <div className="form-field">
      <label htmlFor={id}>{label}</label>
      <input
        id={id}
        className="field"
        inputMode={plain ? 'text' : 'decimal'}
        spellCheck={false}
        data-autofocus={autoFocus ? '' : undefined}
        value={text}
        aria-invalid={wrong}
        aria-describedby={error === undefined ? undefined : `${id}-error`}
        onChange={(event) => onChange(event.target.value)}
      />
      <FieldError id={`${id}-error`} error={error} />
    </div>
  );
}

interface FieldGroupProps {
  readonly legend: string;
  /** Labels of the fields, after the legend for screen readers. */
  readonly names: readonly string[];
  readonly texts: readonly string[];
  readonly error?: string | undefined;
  /** Called with the texts of all fields. */
  readonly onChange: (texts: readonly string[]) => void;
}

/** Numbers that belong together, such as those along three axes. */
export function FieldGroup({ legend, names, texts, error, onChange }: FieldGroupProps) {
  const id = useId();
  return (
    <fieldset className="form-field form-group">
      <legend>{legend}</legend>
      <div className="form-row">
        {names.map((name, i) => (
          <input
            key={name}
            className="field"
            inputMode="decimal"
            aria-label={`${legend} ${name}`}
            placeholder={name}
            value={texts[i] ?? ''}
            aria-invalid={error !== undefined}
            aria-describedby={error === undefined ? undefined : `${id}-error`}
            onChange={(event) => onChange(texts.map((text, other) => (other === i ? event.target.value : text)))}
          />
        ))}
      </div>
      <FieldError id={`${id}-error`} error={error} />
    </fieldset>
  );
}

function FieldError({ id, error }: { readonly id: string; readonly error: string | undefined }) {
  if (error === undefined) return null;
  return (
    <span id={id} className="form-error">
      {error}
    </span>
  );
}
