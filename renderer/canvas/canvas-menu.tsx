import { useCallback, useMemo, useState } from 'react';
import type { AppCommandId } from '../state/commands/app-commands.ts';
import { commandItem } from '../state/commands/command-item.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import type { Editor } from '../state/editor/editor.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { borderOf, itemOf } from '../state/editor/item-ids.ts';
import { layerAt, layerTitle } from '../state/editor/layer-names.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { addReroute, wiresOfStretch } from '../state/graph/reroutes.ts';
import { selectedSubgraph } from '../state/graph/subgraphs.ts';
import { compareLayer, pinLayer } from '../state/preview/viewed-layers.ts';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';
import type { CanvasWire } from './project-wires.ts';
import type { AnyNode } from './use-canvas-view.ts';
import { type ToCanvas, UNSNAPPED } from './use-gestures.ts';

interface OpenMenu {
  readonly x: number;
  readonly y: number;
  readonly commands: readonly (AppCommandId | 'line')[];
  /** Id of the pressed stretch of a wire, and the pressed point in canvas units. Present if a wire was pressed. */
  readonly wire?: { readonly stretch: string; readonly place: Place };
  /** Name of the layer at the pressed port. Present if a port with a layer was pressed. */
  readonly layer?: string;
}

interface PointerPlace {
  readonly clientX: number;
  readonly clientY: number;
  readonly target: EventTarget | null;
  preventDefault(): void;
}

const ON_NODE = [
  'edit.duplicate',
  'edit.duplicate-wired',
  'edit.copy',
  'edit.mute',
  'edit.unfuse',
  'line',
  'graph.duplicate-filter',
  'graph.swap',
  'graph.collapse',
  'graph.subgraph',
  'graph.save-recipe',
  'graph.frame',
  'line',
  'view.pin',
  'view.compare',
  'view.code',
  'view.fit-selection',
  'view.help',
  'line',
  'edit.delete',
] as const;
const ON_SUBGRAPH = ['graph.enter', 'graph.save', 'graph.independent', 'graph.unpack', 'line', ...ON_NODE] as const;
const ON_WIRE_OR_ITEM = { wire: ['graph.reroute', 'graph.add', 'line', 'edit.delete'], item: ['edit.delete'] } as const;
const ON_PANE = [
  'graph.add',
  'graph.new-filter',
  'graph.import-shadertoy',
  'graph.frame',
  'graph.note',
  'edit.paste',
  'line',
  'edit.select-all',
  'view.fit',
] as const;

/** State of the context menu: where it is open, its commands, and the wire or layer that was pressed. */
export function useCanvasMenu(toCanvas: ToCanvas) {
  const editor = useEditor();
  const [open, setOpen] = useState<OpenMenu | null>(null);
  const show = useCallback((event: PointerPlace, commands: OpenMenu['commands'], on: Pick<OpenMenu, 'wire' | 'layer'> = {}) => {
    event.preventDefault();
    setOpen({ x: event.clientX, y: event.clientY, commands, ...on });
  }, []);
  return useMemo(
    () => ({
      open,
      close: () => setOpen(null),
      onNode: (event: PointerPlace, node: AnyNode) => {
        if (borderOf(node.id) !== null) return event.preventDefault();
        if (itemOf(node.id) !== null) {
          selectOnly(editor.selection, [], [], [node.id]);
          show(event, ON_WIRE_OR_ITEM.item);
          return;
        }
        if (!editor.selection.getState().nodes.has(node.id)) selectOnly(editor.selection, [node.id]);
        const layer = layerPressed(editor, event.target);
        show(event, selectedSubgraph(editor) === null ? ON_NODE : ON_SUBGRAPH, layer === null ? {} : { layer });
      },
      onWire: (event: PointerPlace, wire: CanvasWire) => {
        if (borderOf(wire.source) !== null || borderOf(wire.target) !== null) return event.preventDefault();
        selectOnly(editor.selection, [], wiresOfStretch(editor.document.getState(), wire.id));
        const place = toCanvas({ x: event.clientX, y: event.clientY }, UNSNAPPED);
        show(event, ON_WIRE_OR_ITEM.wire, { wire: { stretch: wire.id, place } });
      },
      onPane: (event: PointerPlace | MouseEvent) => show(event, ON_PANE),
    }),
    [editor, open, show, toCanvas],
  );
}

/** The layer at the port under the pointer; null if the pointer is not on a port. */
function layerPressed({ document }: Editor, target: EventTarget | null): string | null {
  const handle = target instanceof Element ? target.closest<HTMLElement>('.react-flow__handle') : null;
  const { nodeid: node, handleid: port } = handle?.dataset ?? {};
  if (!handle || node === undefined || port === undefined) return null;
  return layerAt(document.getState(), { node, port }, handle.classList.contains('source') ? 'output' : 'input');
}

/** Labels and actions of commands when a port was pressed: they act on the layer of that port instead of the first layer of the node. */
const ON_PORT: Partial<Record<AppCommandId, { readonly label: (layer: string) => string; readonly run: typeof pinLayer }>> = {
  'view.pin': { label: (layer) => `View “${layer}”`, run: pinLayer },
  'view.compare': { label: (layer) => `Compare with “${layer}”`, run: compareLayer },
};

/** Actions of commands when a wire was pressed: they act at the pressed point. */
const ON_WIRE: Partial<Record<AppCommandId, (editor: Editor, menu: OpenMenu) => void>> = {
  'graph.reroute': (editor, { wire }) => void (wire && addReroute(editor, wire.stretch, wire.place)),
  'graph.add': ({ ui }, { x, y, wire }) => {
    if (wire) ui.setState({ palette: { at: { x, y }, place: wire.place, end: null, wire: wire.stretch } });
  },
};

export function CanvasMenu({ menu, onClose }: { readonly menu: OpenMenu | null; readonly onClose: () => void }) {
  const editor = useEditor();
  if (menu === null) return null;
  const items = menu.commands.map((id): MenuItem => {
    if (id === 'line') return { kind: 'line' };
    const item = commandItem(editor, id);
    const onPort = ON_PORT[id];
    const { layer } = menu;
    if (onPort && layer !== undefined) {
      const label = onPort.label(layerTitle(editor.document.getState(), layer));
      return { ...item, label, disabled: false, run: () => onPort.run(editor.viewer, layer) };
    }
    const onWire = menu.wire && ON_WIRE[id];
    return onWire ? { ...item, disabled: false, run: () => onWire(editor, menu) } : item;
  });
  return <ContextMenu label="Actions" at={menu} items={items} onClose={onClose} />;
}
