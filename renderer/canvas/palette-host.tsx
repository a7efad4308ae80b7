import { type RefObject, useMemo } from 'react';
import { useStore } from 'zustand';
import { usesGraph } from '../../export/graph/commands/nodes.ts';
import { subgraphName } from '../../export/graph/names.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import type { Place } from '../state/canvas.ts';
import { combinationsOf } from '../state/combinations.ts';
import { nodeOf } from '../state/document.ts';
import { addNodeFromPalette, swapType } from '../state/edit-graph.ts';
import type { Editor } from '../state/editor.ts';
import { portsThrough, wireTypes } from '../state/insert-on-wire.ts';
import type { PaletteRequest } from '../state/ui.ts';
import { NODE_WIDTH } from './node-shape.ts';
import { Palette } from './palette.tsx';

interface PaletteHostProps {
  readonly toCanvas: (client: Place) => Place;
  readonly canvas: RefObject<HTMLElement | null>;
}

const FIRST_PORT_Y = 48;

/** The palette while it is asked for, and what becomes of the choice. */
export function PaletteHost({ toCanvas, canvas }: PaletteHostProps) {
  const editor = useEditor();
  const request = useStore(editor.ui, (state) => state.palette);
  const library = useDocument((state) => state.library);
  const definitions = useMemo(() => {
    const all = [...library.types()].flatMap((type) => library.definition(type) ?? []);
    return request === null ? all : offered(editor, request, all);
  }, [editor, library, request]);
  if (request === null) return null;
  const close = (added: string | null) => {
    editor.ui.setState({ palette: null });
    // Keys go on where the person is: at the new node, or on the canvas. Whoever is elsewhere by then stays there.
    editor.clock.nextFrame(() => {
      if (document.activeElement !== document.body) return;
      const node = added === null ? null : canvas.current?.querySelector<HTMLElement>(`.react-flow__node[data-id="${added}"]`);
      (node ?? canvas.current)?.focus();
    });
  };
  return (
    <Palette
      definitions={definitions}
      end={request.end}
      at={request.at}
      purpose={purposeOf(request)}
      onClose={() => close(null)}
      onChoose={(entry) => {
        const { end, wire, swap } = request;
        if (swap !== undefined) {
          swapType(editor, swap, entry.definition.type);
          close(swap);
          return;
        }
        const place = request.place ?? toCanvas(middleOf(canvas.current));
        // Dropped wires end at the new node's first port, so the node stands beside the place, not on it.
        const x = end === null ? place.x - NODE_WIDTH / 2 : end.side === 'output' ? place.x : place.x - NODE_WIDTH;
        const y = end === null ? place.y : place.y - FIRST_PORT_Y;
        close(addNodeFromPalette(editor, entry, { x, y }, end, wire ?? null));
      }}
    />
  );
}

/** What can be chosen: not the graph itself nor what it is in, and for a wire or another node only what takes their wires. */
function offered(editor: Editor, { wire, swap }: PaletteRequest, all: readonly NodeDefinition[]): readonly NodeDefinition[] {
  const state = editor.document.getState();
  const possible = all.filter(({ type }) => {
    const name = subgraphName(type);
    return name === null || !usesGraph(state.project, name, state.graph);
  });
  const types = wire === undefined ? null : wireTypes(editor, wire);
  if (types) return possible.filter((definition) => portsThrough(definition, types) !== null);
  const swapped = swap === undefined ? undefined : state.library.definition(nodeOf(state, swap)?.type ?? '');
  if (swapped) return possible.filter((definition) => definition.type !== swapped.type && givesSame(definition, swapped));
  return [...possible, ...combinationsOf(state.library).map(({ definition }) => definition)];
}

function givesSame(a: NodeDefinition, b: NodeDefinition): boolean {
  const given = (definition: NodeDefinition) => Object.values(definition.outputs).map(({ type }) => type);
  return given(b).length === 0 ? given(a).length === 0 : given(a).some((type) => given(b).includes(type));
}

function purposeOf({ wire, swap }: PaletteRequest): string | null {
  if (swap !== undefined) return 'Change to';
  return wire === undefined ? null : 'Nodes for this wire to go through';
}

function middleOf(element: HTMLElement | null): Place {
  const box = element?.getBoundingClientRect();
  return box ? { x: box.left + box.width / 2, y: box.top + box.height / 2 } : { x: 0, y: 0 };
}
