import { type RefObject, useMemo } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import type { Place } from '../state/canvas.ts';
import { addNodeFromPalette } from '../state/edit-graph.ts';
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
  const definitions = useMemo(() => [...library.types()].flatMap((type) => library.definition(type) ?? []), [library]);
  if (request === null) return null;
  const close = (added: string | null) => {
    editor.ui.setState({ palette: null });
    // Keys go on where the person is: at the new node, or on the canvas.
    editor.clock.nextFrame(() => {
      const node = added === null ? null : canvas.current?.querySelector<HTMLElement>(`.react-flow__node[data-id="${added}"]`);
      (node ?? canvas.current)?.focus();
    });
  };
  return (
    <Palette
      definitions={definitions}
      end={request.end}
      at={request.at}
      onClose={() => close(null)}
      onChoose={(entry) => {
        const { end } = request;
        const place = request.place ?? toCanvas(middleOf(canvas.current));
        // Dropped wires end at the new node's first port, so the node stands beside the place, not on it.
        const x = end === null ? place.x - NODE_WIDTH / 2 : end.side === 'output' ? place.x : place.x - NODE_WIDTH;
        const y = end === null ? place.y : place.y - FIRST_PORT_Y;
        close(addNodeFromPalette(editor, entry, { x, y }, end));
      }}
    />
  );
}

function middleOf(element: HTMLElement | null): Place {
  const box = element?.getBoundingClientRect();
  return box ? { x: box.left + box.width / 2, y: box.top + box.height / 2 } : { x: 0, y: 0 };
}
