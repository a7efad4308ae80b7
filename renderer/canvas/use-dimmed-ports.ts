import { useMemo } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { refusalOf } from '../state/graph/edit-graph.ts';
import type { PortView } from '../state/graph/node-shape.ts';

/**
 * Ports of a node that cannot take the wire being dragged, as `side name`; `all` if no port can; null while no wire is dragged.
 */
export function useDimmedPorts(node: string, ports: readonly PortView[]): ReadonlySet<string> | 'all' | null {
  const editor = useEditor();
  const draggedWire = useStore(editor.canvas, (state) => state.draggedWire);
  return useMemo(() => {
    if (draggedWire === null) return null;
    const wanted = draggedWire.side === 'output' ? 'input' : 'output';
    const dimmed = ports.filter((port) => {
      const start = node === draggedWire.node && port.name === draggedWire.port && port.side === draggedWire.side;
      return !start && (port.side !== wanted || refusalOf(editor, draggedWire, { node, port: port.name, side: port.side }) !== null);
    });
    return dimmed.length === ports.length ? 'all' : new Set(dimmed.map((port) => `${port.side} ${port.name}`));
  }, [editor, draggedWire, node, ports]);
}
