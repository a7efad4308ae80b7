import type { HeaderFields, HeaderValue } from '../../export/glsl/language/header-edits.ts';
import { EyedropperButton } from '../preview-panel/eyedropper-button.tsx';
import { endGesture } from '../state/document/apply.ts';
import { editHeader, moveInput, renameInput } from '../state/document/edit-header.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { addToast } from '../state/editor/ui.ts';
import { IconButton } from '../ui/button.tsx';
import { ColorField } from '../ui/color-field.tsx';
import { Icon } from '../ui/icon.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { HeaderField } from './header-field.tsx';
import { numbersOf, textOfField, wordsOf } from './header-text.ts';

/** Input types of ISF files and of techniques, in the order of the menu. */
export const INPUT_TYPES = [
  'float',
  'color',
  'bool',
  'long',
  'point2D',
  'image',
  'event',
  'audio',
  'audioFFT',
  'depth',
  'curve',
  'gradient',
] as const;
export const TECHNIQUE_TYPES = ['float', 'color', 'bool', 'long', 'point2D', 'image'] as const;

interface HeaderInputProps {
  readonly node: string;
  readonly index: number;
  readonly isLast: boolean;
  readonly fields: HeaderFields;
  readonly types: readonly string[];
  readonly disabled: boolean;
  readonly open: boolean;
  /** Expands the input of this name and collapses the others. */
  readonly onOpen: (name: string | null) => void;
}

/** One input of the header: its name and type, and its fields when expanded. */
export function HeaderInput({ node, index, isLast, fields, types, disabled, open, onOpen }: HeaderInputProps) {
  const editor = useEditor();
  const name = textOfField(fields, 'NAME');
  const type = textOfField(fields, 'TYPE');
  const set = (key: string, value: HeaderValue | undefined) => void editHeader(editor, node, ['INPUTS', index, key], value);
  const setNumbers =
    (key: string, asList = false) =>
    (text: string) => {
      const value = numbersOf(text);
      if (value === null)
        addToast(editor.ui, { tone: 'warning', text: `“${text}” is not a number.`, detail: 'Separate several numbers with commas.' });
      else set(key, asList && typeof value === 'number' ? [value] : value);
    };
  const takeDefault = ([red, green, blue]: readonly [number, number, number]) => {
    const [, , , alpha] = colorOf(fields);
    set('DEFAULT', rounded([red, green, blue, alpha]));
    endGesture(editor);
  };
  const offered = types.includes(type) ? types : [type, ...types];
  return (
    <li className="header-input">
      <div className="header-input-head">
        <button type="button" className="header-input-open" aria-expanded={open} onClick={() => onOpen(open ? null : name)}>
          <Icon name="chevron" size={12} />
          <code>{name || 'no name'}</code>
          <span>{type}</span>
        </button>
        <IconButton
          icon="up"
          label={`Move ${name} up`}
          small
          disabled={disabled || index === 0}
          onPress={() => void moveInput(editor, node, index, index - 1)}
        />
        <IconButton
          icon="down"
          label={`Move ${name} down`}
          small
          disabled={disabled || isLast}
          onPress={() => void moveInput(editor, node, index, index + 1)}
        />
        <IconButton
          icon="trash"
          label={`Remove ${name}`}
          small
          disabled={disabled}
          onPress={() => void editHeader(editor, node, ['INPUTS', index], undefined)}
        />
      </div>
      {open && (
        <fieldset className="header-input-fields" disabled={disabled}>
          <HeaderField label="Name" value={name} onSet={(text) => renameInput(editor, node, name, text.trim()) && onOpen(text.trim())} />
          <div className="header-field">
            <label htmlFor={`type-${node}-${index}`}>Type</label>
            <SelectField
              id={`type-${node}-${index}`}
              label="Type"
              value={type}
              options={offered.map((value) => ({ value, label: value }))}
              onChoose={(value) => set('TYPE', value)}
            />
          </div>
          <HeaderField
            label="Label"
            value={textOfField(fields, 'LABEL')}
            placeholder={name}
            onSet={(text) => set('LABEL', text.trim() || undefined)}
          />
          {(type === 'float' || type === 'point2D') && (
            <>
              <HeaderField label="Min" value={textOfField(fields, 'MIN')} onSet={setNumbers('MIN')} />
              <HeaderField label="Max" value={textOfField(fields, 'MAX')} onSet={setNumbers('MAX')} />
            </>
          )}
          {type === 'long' && (
            <>
              <HeaderField label="Values" value={textOfField(fields, 'VALUES')} placeholder="0, 1, 2" onSet={setNumbers('VALUES', true)} />
              <HeaderField
                label="Labels"
                value={textOfField(fields, 'LABELS')}
                placeholder="One, Two, Three"
                onSet={(text) => set('LABELS', wordsOf(text))}
              />
            </>
          )}
          {['float', 'point2D', 'long'].includes(type) && (
            <HeaderField label="Default" value={textOfField(fields, 'DEFAULT')} onSet={setNumbers('DEFAULT')} />
          )}
          {type === 'bool' && (
            <div className="header-field">
              <label htmlFor={`default-${node}-${index}`}>Default</label>
              <input
                id={`default-${node}-${index}`}
                type="checkbox"
                className="switch"
                checked={['true', '1'].includes(textOfField(fields, 'DEFAULT'))}
                onChange={(event) => set('DEFAULT', event.target.checked)}
              />
            </div>
          )}
          {type === 'color' && (
            <div className="header-field header-field-long">
              <span>Default</span>
              <ColorField
                label={`Default of ${name}`}
                value={colorOf(fields)}
                eyedropper={<EyedropperButton label={`Default of ${name}`} onTake={takeDefault} />}
                onEdit={(color) => set('DEFAULT', rounded(color))}
                onEnd={() => endGesture(editor)}
              />
            </div>
          )}
          <HeaderField
            label="What it does"
            value={textOfField(fields, 'DOC')}
            long
            onSet={(text) => set('DOC', text.trim() || undefined)}
          />
        </fieldset>
      )}
    </li>
  );
}

function colorOf({ DEFAULT: list }: HeaderFields): readonly [number, number, number, number] {
  const [red = 0, green = 0, blue = 0, alpha = 1] = Array.isArray(list) ? (list as readonly unknown[]).map(Number) : [];
  return [red, green, blue, alpha];
}

function rounded(color: readonly number[]): readonly number[] {
  return color.map((value) => Number(value.toFixed(4)));
}
