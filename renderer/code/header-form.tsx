import { useMemo, useRef, useState } from 'react';
import { type HeaderForm as Form, type HeaderFields, type HeaderValue, readHeaderForm } from '../../export/glsl/language/header-edits.ts';
import { isTechnique } from '../../export/glsl/technique/technique-shader.ts';
import { editHeader } from '../state/document/edit-header.ts';
import { shaderOf } from '../state/document/edit-shader.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { HeaderField } from './header-field.tsx';
import './header-form.css';
import { HeaderInput, INPUT_TYPES, TECHNIQUE_TYPES } from './header-input.tsx';
import { freeInputName, newInput, sizeOf, textOfField, wordsOf } from './header-text.ts';

/** The JSON header of a shader as a form. Form and text show the same document, so edits of one appear in the other. */
export function HeaderForm({ node, readOnly }: { readonly node: string; readonly readOnly: boolean }) {
  const text = useDocument((state) => shaderOf(state, node)?.text ?? '');
  const name = useDocument((state) => shaderOf(state, node)?.name ?? '');
  const form = useMemo(() => readHeaderForm(text), [text]);
  // While the JSON is being typed it may be invalid; the form then shows its last valid state.
  const last = useRef<{ readonly node: string; readonly form: Form } | null>(null);
  if (form !== null) last.current = { node, form };
  const shown = form ?? (last.current?.node === node ? last.current.form : null);
  const disabled = form === null || readOnly;
  return (
    <section className="header-form scroll" aria-label="Header">
      {form === null && <p className="header-broken">The JSON of the header is invalid. Fix it in the text, where it is marked.</p>}
      {shown && (
        <>
          <Inputs node={node} form={shown} technique={isTechnique(text, name)} disabled={disabled} />
          <Passes node={node} form={shown} technique={isTechnique(text, name)} disabled={disabled} />
          <About node={node} form={shown} disabled={disabled} />
        </>
      )}
    </section>
  );
}

interface PartProps {
  readonly node: string;
  readonly form: Form;
  readonly disabled: boolean;
}

function Inputs({ node, form, technique, disabled }: PartProps & { readonly technique: boolean }) {
  const editor = useEditor();
  const types = technique ? TECHNIQUE_TYPES : INPUT_TYPES;
  const [type, setType] = useState<string>('float');
  const [opened, setOpened] = useState<string | null>(null);
  const taken = form.inputs.map((input) => textOfField(input, 'NAME'));
  return (
    <>
      <h3>Inputs</h3>
      <ul className="header-list">
        {placed(form.inputs).map(({ key, index, fields }) => (
          <HeaderInput
            key={key}
            {...{ node, index, fields, types, disabled }}
            isLast={index === form.inputs.length - 1}
            open={opened !== null && opened === fields.NAME}
            onOpen={setOpened}
          />
        ))}
      </ul>
      <div className="header-add">
        <SelectField
          label="Type of a new input"
          value={type}
          options={types.map((value) => ({ value, label: value }))}
          disabled={disabled}
          onChoose={setType}
        />
        <Button
          icon="add"
          disabled={disabled}
          onPress={() => {
            const added = newInput(type, taken);
            if (editHeader(editor, node, ['INPUTS', form.inputs.length], added)) setOpened(textOfField(added, 'NAME'));
          }}
        >
          Add input
        </Button>
      </div>
    </>
  );
}

/** Gives each entry of a list its index, which is also its React key, because names may be missing or duplicate. */
function placed(list: readonly HeaderFields[]) {
  return list.map((fields, index) => ({ key: String(index), index, fields }));
}

function Passes({ node, form, technique, disabled }: PartProps & { readonly technique: boolean }) {
  const editor = useEditor();
  const taken = form.passes.map((pass) => textOfField(pass, 'TARGET'));
  const fresh: HeaderFields = technique ? { SIDE: 'back' } : { TARGET: freeInputName('buffer', taken) };
  return (
    <>
      <h3>Passes</h3>
      <ul className="header-list">
        {placed(form.passes).map(({ key, index, fields }) => (
          <HeaderPass key={key} {...{ node, index, fields, technique, disabled }} />
        ))}
      </ul>
      <div className="header-add">
        <span className="header-note">{form.passes.length === 0 ? 'One pass, drawn to the output.' : ''}</span>
        <Button icon="add" disabled={disabled} onPress={() => void editHeader(editor, node, ['PASSES', form.passes.length], fresh)}>
          Add pass
        </Button>
      </div>
    </>
  );
}

interface HeaderPassProps {
  readonly node: string;
  readonly index: number;
  readonly fields: HeaderFields;
  readonly technique: boolean;
  readonly disabled: boolean;
}

function HeaderPass({ node, index, fields, technique, disabled }: HeaderPassProps) {
  const editor = useEditor();
  const set = (key: string, value: HeaderValue | undefined) => void editHeader(editor, node, ['PASSES', index, key], value);
  const text = (
    label: string,
    key: string,
    placeholder: string,
    read = (typed: string): HeaderValue | undefined => typed.trim() || undefined,
  ) => (
    <HeaderField
      label={label}
      value={textOfField(fields, key)}
      placeholder={placeholder}
      disabled={disabled}
      onSet={(typed) => set(key, read(typed))}
    />
  );
  const toggle = (label: string, key: string) => (
    <label className="header-toggle">
      <input
        type="checkbox"
        className="switch"
        disabled={disabled}
        checked={['true', '1'].includes(textOfField(fields, key))}
        onChange={(event) => set(key, event.target.checked || undefined)}
      />
      {label}
    </label>
  );
  return (
    <li className="header-input">
      <div className="header-input-head">
        <span className="header-pass-title">Pass {index}</span>
        <IconButton
          icon="trash"
          label={`Remove pass ${index}`}
          small
          disabled={disabled}
          onPress={() => void editHeader(editor, node, ['PASSES', index], undefined)}
        />
      </div>
      <div className="header-input-fields">
        {technique ? (
          text('Side', 'SIDE', 'object')
        ) : (
          <>
            {text('Render target', 'TARGET', 'output')}
            {text('Width', 'WIDTH', '$WIDTH', sizeOf)}
            {text('Height', 'HEIGHT', '$HEIGHT', sizeOf)}
            {toggle('Persistent', 'PERSISTENT')}
            {toggle('Float', 'FLOAT')}
          </>
        )}
      </div>
    </li>
  );
}

function About({ node, form, disabled }: PartProps) {
  const editor = useEditor();
  const set = (key: string, value: HeaderValue | undefined) => void editHeader(editor, node, [key], value);
  return (
    <>
      <h3>About</h3>
      <div className="header-about">
        <HeaderField
          label="Description"
          value={form.description}
          long
          disabled={disabled}
          onSet={(text) => set('DESCRIPTION', text.trim() || undefined)}
        />
        <HeaderField
          label="Credit"
          value={form.credit}
          long
          disabled={disabled}
          onSet={(text) => set('CREDIT', text.trim() || undefined)}
        />
        <HeaderField
          label="Categories"
          value={form.categories.join(', ')}
          placeholder="Blur, Soft"
          disabled={disabled}
          onSet={(text) => set('CATEGORIES', wordsOf(text))}
        />
      </div>
    </>
  );
}
