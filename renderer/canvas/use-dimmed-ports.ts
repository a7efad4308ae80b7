import { useMemo } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';
import { refusalOf } from '../state/edit-graph.ts';
import type { PortView } from './node-shape.ts';

/**
 * While a wire is in hand: which ports of a node cannot take it, as `side name`; `all` where none can; null while no wire is in
 * hand. Only nodes on screen ask.
 */
export function useDimmedPorts(node: string, ports: readonly PortView[]): ReadonlySet<string> | 'all' | null {
  const editor = useEditor();
  const inHand = useStore(editor.canvas, (state) => state.inHand);
  return useMemo(() => {
    if (inHand === null) return null;
    const wanted = inHand.side === 'output' ? 'input' : 'output';
    const dimmed = ports.filter((port) => {
      const start = node === inHand.node && port.name === inHand.port && port.side === inHand.side;
      return !start && (port.side !== wanted || refusalOf(editor, inHand, { node, port: port.name, side: port.side }) !== null);
    });
    return dimmed.length === ports.length ? 'all' : new Set(dimmed.map((port) => `${port.side} ${port.name}`));
  }, [editor, inHand, node, ports]);
}
