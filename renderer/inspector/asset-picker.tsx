import { useRef } from 'react';
import { oneAsset } from '../../nodes/kit/asset-words.ts';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { acceptedNames, type FileKind, importAsset } from '../state/files/add-files.ts';
import { IconButton } from '../ui/button.tsx';

interface AssetPickerProps {
  readonly id: string;
  readonly label: string;
  readonly kind: AssetKind;
  /** Id of an asset; empty if there is none. */
  readonly value: string;
  readonly onChoose: (asset: string) => void;
}

/** Chooses an asset of one kind, or imports one. */
export function AssetPicker({ id, label, kind, value, onChoose }: AssetPickerProps) {
  const assets = useDocument((state) => state.project.assets);
  const choices = Object.entries(assets).filter(([, asset]) => asset.kind === kind);
  const missing = value !== '' && !choices.some(([asset]) => asset === value);
  return (
    <div className="asset-picker">
      <select id={id} className="select" aria-label={label} value={value} onChange={(event) => onChoose(event.target.value)}>
        <option value="">None</option>
        {missing && <option value={value}>{value} (missing)</option>}
        {choices.map(([asset, { path }]) => (
          <option key={asset} value={asset}>
            {path.replace(/^assets\//, '')}
          </option>
        ))}
      </select>
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
        // A glTF model may consist of several files.
        multiple={kind === 'model'}
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
