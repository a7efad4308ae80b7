import { type RefObject, useCallback, useEffect, useMemo } from 'react';
import { useStore } from 'zustand';
import { usesGraph } from '../../export/graph/commands/node-commands.ts';
import { subgraphName } from '../../export/graph/document-names.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { endCandidate } from '../state/editor/candidate-state.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { nodeOf } from '../state/editor/document.ts';
import type { Editor } from '../state/editor/editor.ts';
import { useEditor, useNodeTypes } from '../state/editor/editor-context.ts';
import { rememberType } from '../state/editor/preferences.ts';
import type { PaletteRequest } from '../state/editor/ui.ts';
import { continuationOf } from '../state/graph/continue-after.ts';
import { addNodeFromPalette, swapType } from '../state/graph/edit-graph.ts';
import { portsThrough, wireTypes } from '../state/graph/insert-on-wire.ts';
import { NODE_WIDTH } from '../state/graph/node-shape.ts';
import { candidateOf } from '../state/graph/palette-candidates.ts';
import type { PaletteEntry } from '../state/graph/palette-search.ts';
import { type Recipe, recipeOfEntry, recipesOf } from '../state/graph/recipes.ts';
import { addRecipeShown } from '../state/graph/show-recipe.ts';
import { listRecipes } from '../state/recipes/list-recipes.ts';
import { Palette } from './palette.tsx';

interface PaletteHostProps {
  readonly toCanvas: (client: Place) => Place;
  readonly canvas: RefObject<HTMLElement | null>;
}

const FIRST_PORT_Y = 48;

/** Shows the palette on request and adds, inserts or swaps the chosen node. */
export function PaletteHost({ toCanvas, canvas }: PaletteHostProps) {
  const editor = useEditor();
  const request = useStore(editor.ui, (state) => state.palette);
  const library = useNodeTypes();
  const own = useStore(editor.recipes, (state) => state.own);
  const definitions = useMemo(() => {
    const all = [...library.types()].flatMap((type) => library.definition(type) ?? []);
    return request === null ? all : offered(editor, request, all, recipesOf(library, own));
  }, [editor, library, request, own]);
  const isOpen = request !== null;
  useEffect(() => {
    // A recipe may have been changed, renamed or added since, also by another window.
    if (isOpen) void listRecipes(editor);
  }, [editor, isOpen]);
  const showCandidate = useCallback(
    (entry: PaletteEntry | null) => {
      const project = entry && request && candidateOf(editor, entry, request);
      if (project !== editor.candidate.getState().project) editor.candidate.setState({ project });
    },
    [editor, request],
  );
  useEffect(() => () => endCandidate(editor), [editor]);
  if (request === null) return null;
  const close = (added: string | null) => {
    endCandidate(editor);
    editor.ui.setState({ palette: null });
    // The focus moves to the new node or to the canvas, unless another element has taken it by then.
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
      query={request.query ?? ''}
      first={request.first ?? null}
      at={request.at}
      purpose={purposeOf(request)}
      onPoint={showCandidate}
      onClose={() => close(null)}
      onChoose={(entry) => {
        rememberType(editor, entry.definition.type);
        const { end, wire, swap } = request;
        if (swap !== undefined) {
          swapType(editor, swap, entry.definition.type);
          close(swap);
          return;
        }
        const recipe = recipeOfEntry(editor, entry.definition.type);
        if (recipe && end === null && wire === undefined) {
          close(addRecipeShown(editor, recipe, request.after, request.place ?? toCanvas(middleOf(canvas.current))));
          return;
        }
        const next = request.after === undefined ? null : continuationOf(editor, request.after, entry.definition);
        if (next) {
          const [chosen, dragged, through] = 'wire' in next ? [entry, null, next.wire] : [{ ...entry, port: next.port }, next.end, null];
          close(addNodeFromPalette(editor, chosen, next.place, dragged, through));
          return;
        }
        const place = request.place ?? toCanvas(middleOf(canvas.current));
        // A dropped wire ends at the first port of the new node, so the node lies beside the place.
        const x = end === null ? place.x - NODE_WIDTH / 2 : end.side === 'output' ? place.x : place.x - NODE_WIDTH;
        const y = end === null ? place.y : place.y - FIRST_PORT_Y;
        close(addNodeFromPalette(editor, entry, { x, y }, end, wire ?? null));
      }}
    />
  );
}

/** The node types that the palette offers: no subgraph that would contain itself; for a wire or a swap, only types with matching ports. */
function offered(
  editor: Editor,
  { wire, swap }: PaletteRequest,
  all: readonly NodeDefinition[],
  recipes: readonly Recipe[],
): readonly NodeDefinition[] {
  const state = editor.document.getState();
  const possible = all.filter(({ type }) => {
    const name = subgraphName(type);
    return name === null || !usesGraph(state.project, name, state.graph);
  });
  const types = wire === undefined ? null : wireTypes(editor, wire);
  const withRecipes = [...possible, ...recipes.map(({ definition }) => definition)];
  if (types) return withRecipes.filter((definition) => portsThrough(definition, types) !== null);
  const swapped = swap === undefined ? undefined : state.library.definition(nodeOf(state, swap)?.type ?? '');
  if (swapped) return possible.filter((definition) => definition.type !== swapped.type && givesSame(definition, swapped));
  return withRecipes;
}

function givesSame(a: NodeDefinition, b: NodeDefinition): boolean {
  const given = (definition: NodeDefinition) => Object.values(definition.outputs).map(({ type }) => type);
  return given(b).length === 0 ? given(a).length === 0 : given(a).some((type) => given(b).includes(type));
}

function purposeOf({ wire, swap }: PaletteRequest): string | null {
  if (swap !== undefined) return 'Change type to…';
  return wire === undefined ? null : 'Nodes to insert into this wire';
}

function middleOf(element: HTMLElement | null): Place {
  const box = element?.getBoundingClientRect();
  return box ? { x: box.left + box.width / 2, y: box.top + box.height / 2 } : { x: 0, y: 0 };
}
