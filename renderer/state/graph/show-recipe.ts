import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import { routeOf } from '../../../export/graph/routes.ts';
import { printWire, sameAddress } from '../../../export/graph/wires.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';
import { apply } from '../document/apply.ts';
import type { DraggedWire, Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import type { AddedRecipe } from './add-recipe.ts';
import { continuationOf } from './continue-after.ts';
import { additionOf } from './edit-graph.ts';
import { placeFreely } from './free-places.ts';
import { portsThrough, replaceSource, wireTypes } from './insert-on-wire.ts';
import type { Recipe } from './recipes.ts';
import { COLUMN_PX, showLayer, showShadows } from './show-layer.ts';
import { showObjects } from './show-objects.ts';

const SCENE = 'layer/scene';
/** What a recipe works on if the graph has nothing for it. */
const SOURCES: Partial<Record<WireType, { readonly type: string; readonly port: string; readonly params?: object }>> = {
  objects: { type: 'objects/primitive', port: 'objects', params: { sizeM: [0.4, 0.4, 0.4] } },
  layer: { type: 'source/camera-video', port: 'layer' },
  pose: { type: 'world/hit-test', port: 'pose' },
};

/**
 * Adds a recipe after a node, or without one on what the output shows, so that the output shows it. One undo step. Returns the node that it
 * selects, or null after an error, which is shown.
 */
export function addRecipeShown(editor: Editor, recipe: Recipe, after: string | undefined, place: Place): string | null {
  const { id, change } = recipeAddition(editor, recipe, after, place);
  if (!apply(editor, `Add ${recipe.definition.title}`, change)) return null;
  selectOnly(editor.selection, [id]);
  return id;
}

/** What `addRecipeShown` applies, and the node that it selects. */
export function recipeAddition(
  editor: Editor,
  recipe: Recipe,
  after: string | undefined,
  free: Place,
): { readonly id: string; readonly change: Change } {
  const { project, library, graph } = editor.document.getState();
  const { definition } = recipe;
  const next = after === undefined ? null : continuationOf(editor, after, definition);
  const place = next?.place ?? free;
  const [source, port] = next && 'end' in next ? [givenTo(editor, recipe, next.end), next.port] : [null, null];
  const through = next === null ? wireFor(editor, recipe) : 'wire' in next ? next.wire : null;
  const { id, change, recipe: added } = additionOf(editor, { definition, port }, place, source, through);
  if (added === null || graph !== MAIN_GRAPH) return { id, change };
  const shown = sequence(
    project,
    () => change,
    bringInputs(editor, recipe, added, place),
    showOutputs(editor, recipe, added, { source, place }),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  return { id, change: shown };
}

/** The wire that a recipe goes into without a node to continue: to a scene, from a scene, or to the output. */
function wireFor(editor: Editor, { definition }: Recipe): string | null {
  const state = editor.document.getState();
  if (state.graph !== MAIN_GRAPH) return null;
  const { wires } = graphOf(state);
  const isType = (node: string, type: string) => nodeOf(state, node)?.type === type;
  const preferred = [
    ...wires.filter(({ to }) => isType(to.node, SCENE)),
    ...wires.filter(({ from }) => isType(from.node, SCENE)),
    ...wires.filter(({ to }) => isType(to.node, 'output/screen')),
  ].map(printWire);
  const fits = (wire: string) => {
    const types = wireTypes(editor, wire);
    return types !== null && portsThrough(definition, types) !== null;
  };
  return preferred.find(fits) ?? null;
}

/** What a recipe takes from a node: the shadow of objects that a scene shows elsewhere, such as after a Transform, falls from there. */
function givenTo({ document }: Editor, { isShadow }: Recipe, end: DraggedWire): DraggedWire {
  if (end.type !== 'objects' || !isShadow) return end;
  const state = document.getState();
  const { wires } = graphOf(state);
  const seen = new Set<string>();
  const reached = (from: PortAddress): PortAddress | null => {
    if (seen.has(from.node)) return null;
    seen.add(from.node);
    const onward = wires.filter((wire) => sameAddress(wire.from, from));
    if (onward.some(({ to }) => nodeOf(state, to.node)?.type === SCENE && to.port === 'objects')) return from;
    for (const { to } of onward) {
      const outputs = state.library.definition(nodeOf(state, to.node)?.type ?? '')?.outputs ?? {};
      const port = Object.keys(outputs).find((name) => outputs[name]?.type === 'objects');
      const found = port === undefined ? null : reached({ node: to.node, port });
      if (found) return found;
    }
    return null;
  };
  return { ...end, ...reached({ node: end.node, port: end.port }) };
}

/** Connects required inputs that have no wire yet: to the objects of the scenes, or to a new source. */
function bringInputs(editor: Editor, recipe: Recipe, added: AddedRecipe, place: Place): (project: Project) => Change {
  const { library } = editor.document.getState();
  const { random } = editor;
  const graph = MAIN_GRAPH;
  const inputs = Object.entries(recipe.definition.inputs).filter(([, { required }]) => required);
  return (project) =>
    sequence(
      project,
      ...inputs.map(([name, { type }]) => (before: Project): Change => {
        const to = added.portOf(name);
        const source = SOURCES[type];
        const { nodes = {}, wires = [] } = before.graphs[graph] ?? {};
        if (to === null || source === undefined || wires.some((wire) => sameAddress(wire.to, to))) return unchanged(before);
        const connectFrom = (from: PortAddress) => (p: Project) => connect(p, { library, graph, from, to });
        const inScenes = wires.filter((wire) => nodes[wire.to.node]?.type === SCENE && wire.to.port === 'objects').map(({ from }) => from);
        const isShadow = type === 'objects' && recipe.isShadow;
        if (isShadow && inScenes.length > 0) return sequence(before, ...inScenes.map(connectFrom));
        const id = makeNodeId(before, source.type, random);
        const at = { x: place.x - 2 * COLUMN_PX, y: place.y };
        const bring = (p: Project) => addNode(p, { library, graph, id, type: source.type, ...at, params: { ...source.params } });
        const from = { node: id, port: source.port };
        // A shadow alone does not show what casts it.
        return isShadow
          ? sequence(before, bring, showObjects(from, at, { library, random }), connectShown(from, connectFrom))
          : sequence(before, bring, connectFrom(from));
      }),
    );
}

/** Connects the Transform that `showObjects` has added after a node. */
function connectShown(from: PortAddress, connectFrom: (from: PortAddress) => (project: Project) => Change): (project: Project) => Change {
  return (project) => {
    const shown = project.graphs[MAIN_GRAPH]?.wires.find((wire) => sameAddress(wire.from, from))?.to.node;
    return connectFrom(shown === undefined ? from : { node: shown, port: 'objects' })(project);
  };
}

interface ShowOutputs {
  /** What the recipe continues by a wire of its own; null: nothing, or it lies in a wire. */
  readonly source: PortAddress | null;
  readonly place: Place;
}

/** Shows the outputs that have no wire yet: in place of what the recipe continues, else in the scene or over the image of the output. */
function showOutputs(editor: Editor, recipe: Recipe, added: AddedRecipe, { source, place }: ShowOutputs): (project: Project) => Change {
  const state = editor.document.getState();
  const context = { library: state.library, random: editor.random };
  const outputs = Object.entries(recipe.definition.outputs);
  return (project) =>
    sequence(
      project,
      ...outputs.map(([name, { type }]) => (before: Project): Change => {
        const from = added.portOf(name);
        const { wires = [] } = before.graphs[MAIN_GRAPH] ?? {};
        if (from === null || wires.some((wire) => sameAddress(wire.from, from))) return unchanged(before);
        if (type === 'layer') return (recipe.isShadow ? showShadows : showLayer)(from, place, context)(before);
        if (type !== 'objects') return unchanged(before);
        const taken = wires.filter((wire) => source !== null && sameAddress(wire.from, source) && !added.ids.includes(wire.to.node));
        if (taken.length === 0) return showObjects(from, place, context, recipe.isPlaced ? null : undefined)(before);
        const layout = layoutOf(state);
        return sequence(before, ...taken.map((wire) => replaceSource(editor, wire, { from, to: wire.to, route: routeOf(layout, wire) })));
      }),
    );
}
