import { useRef } from 'react';
import { oneAsset } from '../../nodes/kit/asset-words.ts';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { acceptedNames, type FileKind, importAsset } from '../state/files/add-files.ts';
import { nameOf } from '../state/files/edit-assets.ts';
import { IconButton } from '../ui/button.tsx';
import { SelectField } from '../ui/select-field.tsx';

interface AssetPickerProps {
  readonly id: string;
  readonly label: string;
  readonly kind: AssetKind;
  /** Id of an asset; empty if there is none. */
  readonly value: string;
  readonly onChoose: (asset: string) => void;
  /** Called with the asset that the pointer or a key rests on; null for the chosen one, and when the list closes. */
  readonly onPoint: (asset: string | null) => void;
}

/** Chooses an asset of one kind, or imports one. */
export function AssetPicker({ id, label, kind, value, onChoose, onPoint }: AssetPickerProps) {
  const assets = useDocument((state) => state.project.assets);
  const choices = Object.entries(assets).filter(([, asset]) => asset.kind === kind);
  const missing = value !== '' && !choices.some(([asset]) => asset === value);
  const options = [
    { value: '', label: 'None' },
    ...(missing ? [{ value, label: `${value} (missing)` }] : []),
    ...choices.map(([asset, { path }]) => ({ value: asset, label: nameOf(path) })),
  ];
  return (
    <div className="asset-picker">
      <SelectField {...{ id, label, value, options, onChoose, onPoint }} />
      {kind !== 'capture' && <FileButton kind={kind} label={label} onChoose={onChoose} />}
    </div>
  );
}

interface FileButtonProps extends Pick<AssetPickerProps, 'label' | 'onChoose'> {
  readonly kind: FileKind;
}

/** Imports files. */
function FileButton({ kind, label, onChoose }: FileButtonProps) {
  const editor = useEditor();
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <IconButton icon="folder" label={`Import ${oneAsset(kind)}`} onPress={() => input.current?.click()} />
      <input
        ref={input}
        type="file"
        hidden
        accept={acceptedNames(kind)}
        // A glTF model and splats may consist of several files.
        multiple={kind === 'model' || kind === 'splats'}
        aria-label={`Import for ${label}`}
        onChange={async (event) => {
          const files = [...(event.target.files ?? [])];
          event.target.value = '';
          if (files.length === 0) return;
          const asset = await importAsset(editor, files, kind);
          if (asset !== null) onChoose(asset);
        }}
      />
    </>
  );
}
