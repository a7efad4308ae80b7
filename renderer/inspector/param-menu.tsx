import type { Binding } from '../../export/graph/project.ts';
import { type ParamDefinition, paramWireType } from '../../nodes/kit/definition.ts';
import { graphOf } from '../state/editor/document.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { exposedName, setPortExposed } from '../state/graph/subgraphs.ts';
import { copyParam, pasteParam, startExpression, unbind } from '../state/params/bind-params.ts';
import { resetParam, setExposed } from '../state/params/edit-params.ts';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';

interface ParamMenuProps {
  readonly node: string;
  readonly name: string;
  readonly param: ParamDefinition;
  readonly binding: Binding | undefined;
  readonly wired: boolean;
  readonly at: { readonly x: number; readonly y: number };
  readonly onClose: () => void;
  /** Called after an expression has replaced the value, to focus its field. */
  readonly onFollow: () => void;
}

/** Context menu of a param: copy, paste, expression, port, reset, and inside a subgraph whether its instances have the param. */
export function ParamMenu({ node, name, param, binding, wired, at, onClose, onFollow }: ParamMenuProps) {
  const editor = useEditor();
  const type = paramWireType(param);
  const isPort = binding !== undefined && 'port' in binding;
  const follows = binding !== undefined && ('expression' in binding || 'track' in binding);
  const items: MenuItem[] = [
    { kind: 'action', label: 'Copy value', disabled: wired, run: () => void copyParam(editor, node, name) },
    { kind: 'action', label: 'Paste value', disabled: wired, run: () => void pasteParam(editor, node, name) },
    { kind: 'line' },
  ];
  if (type !== undefined && type !== 'text') {
    items.push(
      follows
        ? { kind: 'action', label: 'Use a value', run: () => void unbind(editor, node, name) }
        : {
            kind: 'action',
            label: 'Use an expression',
            disabled: wired,
            run: () => {
              if (startExpression(editor, node, name)) onFollow();
            },
          },
    );
  }
  if (type !== undefined) {
    items.push({
      kind: 'action',
      label: isPort ? 'Hide the port' : 'Show as a port',
      disabled: wired || follows,
      run: () => void setExposed(editor, node, name, !isPort),
    });
  }
  if (editor.document.getState().trail.length > 0) {
    const address = { node, port: name };
    const exposed = exposedName(graphOf(editor.document.getState()).exposed, 'inputs', address) !== null;
    items.push({
      kind: 'action',
      label: 'Expose on the subgraph',
      checked: exposed,
      run: () => void setPortExposed(editor, 'inputs', address, !exposed),
    });
  }
  items.push(
    { kind: 'line' },
    { kind: 'action', label: 'Reset', disabled: binding === undefined && !wired, run: () => void resetParam(editor, node, name) },
  );
  return <ContextMenu label={`Actions for ${param.label}`} at={at} items={items} onClose={onClose} />;
}
