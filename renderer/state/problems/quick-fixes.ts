import { convertLayers, misfittingWires } from '../../../export/graph/commands/convert-layers.ts';
import { removeNodes } from '../../../export/graph/commands/node-commands.ts';
import { disconnect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { createEncodingLookup } from '../../../export/graph/encoding-lookup.ts';
import { CONVERSIONS } from '../../../export/graph/layer-encoding.ts';
import type { Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply } from '../document/apply.ts';
import { graphOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { middleOfWindow } from '../editor/ui.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { resetParam } from '../params/edit-params.ts';
import { goToProblem } from './problems.ts';

/** A fix for a problem, as one undo step. */
export interface QuickFix {
  readonly label: string;
  readonly run: (editor: Editor) => void;
}

const SCREEN = 'output/screen';

/** The fix for a problem of the open graph; null if there is no automatic one. */
export function quickFixOf(editor: Editor, problem: Diagnostic): QuickFix | null {
  const { nodeId = '', port = '' } = problem;
  const state = editor.document.getState();
  const node = nodeOf(state, nodeId);
  const definition = state.library.definition(node?.type ?? '');
  switch (problem.code) {
    case 'SCR015':
      return definition && getOwn(definition.inputs, port) ? { label: 'Find a node', run: () => openPaletteFor(editor, problem) } : null;
    case 'SCR017': {
      const hasScreen = Object.values(graphOf(state).nodes).some(({ type }) => type === SCREEN);
      return hasScreen || state.trail.length > 0 ? null : { label: 'Add an output node', run: addScreen };
    }
    case 'SCR018':
    case 'SCR019':
    case 'SCR022':
      return definition && getOwn(definition.params, port)
        ? { label: 'Reset parameter', run: () => void resetParam(editor, nodeId, port) }
        : null;
    case 'SCR010':
    case 'SCR021':
      return node ? { label: `Delete ${titleOf(state, nodeId)}`, run: () => deleteNode(editor, nodeId) } : null;
    case 'SCR012':
      return node && port !== '' ? { label: 'Delete wire', run: () => deleteWires(editor, nodeId, port) } : null;
    case 'SCR048':
      return conversionFix(editor, nodeId, port);
    default:
      return null;
  }
}

/** Inserts the node that converts the layer of a wire. */
function conversionFix(editor: Editor, node: string, port: string): QuickFix | null {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const wire = graphOf(state).wires.find(({ to }) => to.node === node && to.port === port);
  const encoding = wire && createEncodingLookup(project, library, graph).conversionOf(wire, 'earlier');
  if (!wire || !encoding) return null;
  const label = `Insert ${CONVERSIONS[encoding].title}`;
  const except = misfittingWires(project, library, graph).filter((other) => other !== wire);
  const makeId = (before: Project, type: string): string => makeNodeId(before, type, editor.random);
  const run = (): void => void apply(editor, label, convertLayers(project, { library, graph, first: [wire], except, makeId }));
  return { label, run };
}

/** Opens the palette for the unconnected port, as if a wire had been dragged from it. */
function openPaletteFor(editor: Editor, problem: Diagnostic): void {
  const { nodeId = '', port = '' } = problem;
  const state = editor.document.getState();
  const input = getOwn(state.library.definition(nodeOf(state, nodeId)?.type ?? '')?.inputs ?? {}, port);
  if (!input) return;
  goToProblem(editor, problem);
  const { x, y } = getOwn(state.project.layout[state.graph]?.nodes ?? {}, nodeId) ?? editor.canvas.getState().middle();
  editor.ui.setState({
    palette: {
      at: middleOfWindow(),
      place: { x: x - 60, y: y + 60 },
      end: { node: nodeId, port, side: 'input', type: input.type },
    },
  });
}

function addScreen(editor: Editor): void {
  const definition = editor.document.getState().library.definition(SCREEN);
  if (definition) addNodeFromPalette(editor, { definition, port: null }, editor.canvas.getState().middle(), null);
}

function deleteNode(editor: Editor, node: string): void {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  apply(editor, `Delete ${titleOf(state, node)}`, removeNodes(project, { library, graph, nodes: [node] }));
}

function deleteWires(editor: Editor, node: string, port: string): void {
  const state = editor.document.getState();
  const wires = graphOf(state).wires.filter(({ from, to }) => [from, to].some((end) => end.node === node && end.port === port));
  apply(editor, 'Disconnect', disconnect(state.project, { graph: state.graph, wires }));
}
