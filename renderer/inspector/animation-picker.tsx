import { type ReactNode, useEffect, useState } from 'react';
import { getOwn } from '../../export/graph/record.ts';
import { nodeOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { readAnimations } from '../state/files/model-animations.ts';
import { SelectField, type SelectOption } from '../ui/select-field.tsx';

interface AnimationPickerProps {
  readonly id: string;
  readonly label: string;
  readonly node: string;
  /** The asset param of the node that has the model. */
  readonly modelParam: string;
  readonly value: string;
  readonly onChoose: (name: string) => void;
  /** Called with the animation that the pointer or a key rests on; null for the chosen one, and when the list closes. */
  readonly onPoint: (name: string | null) => void;
  /** The field for a name, while there is no model that can be read. */
  readonly children: ReactNode;
}

/** Chooses an animation of the node's model. */
export function AnimationPicker({ id, label, node, modelParam, value, onChoose, onPoint, children }: AnimationPickerProps) {
  const names = useAnimations(node, modelParam);
  if (names === null) return children;
  return <SelectField {...{ id, label, value, onChoose, onPoint }} options={optionsOf(names, value)} />;
}

function optionsOf(names: readonly string[], value: string): readonly SelectOption<string>[] {
  const [first] = names;
  const known = first === undefined ? [] : ['none', ...names.filter((name) => name !== 'none')];
  const missing = value !== '' && !known.includes(value);
  return [
    { value: '', label: first === undefined ? 'No animations' : `First: ${first}` },
    ...(missing ? [{ value, label: `${value} (missing)` }] : []),
    ...known.map((name) => ({ value: name, label: name === 'none' ? 'None' : name })),
  ];
}

/** Reads the names of the animations of the model, again when its file has another size. */
function useAnimations(node: string, modelParam: string): readonly string[] | null {
  const editor = useEditor();
  const handle = useDocument(({ open }) => open?.handle);
  const path = useDocument((state) => {
    const binding = getOwn(nodeOf(state, node)?.params ?? {}, modelParam);
    return binding && 'value' in binding ? getOwn(state.project.assets, String(binding.value))?.path : undefined;
  });
  const bytes = useDocument(({ open }) => open?.assetFiles.find((file) => file.path === path)?.bytes);
  const [names, setNames] = useState<readonly string[] | null>(null);
  useEffect(() => {
    setNames(null);
    if (handle === undefined || path === undefined) return;
    let wanted = true;
    void readAnimations(editor, { handle, path, bytes }).then((read) => {
      if (wanted) setNames(read);
    });
    return () => {
      wanted = false;
    };
  }, [editor, handle, path, bytes]);
  return names;
}
