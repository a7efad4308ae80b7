import { describe, expect, test } from '@jest/globals';
import { compile } from '../../../export/compiler/compile.ts';
import { type Graph, MAIN_GRAPH } from '../../../export/graph/project.ts';
import { LIBRARY } from '../../../tests/support/library.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import type { DraggedWire } from '../editor/canvas-state.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { soleNode } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from './edit-graph.ts';
import { startObject } from './first-steps.ts';
import { canCompositeOver, compositeOver } from './insert-on-wire.ts';
import { candidateOf } from './palette-candidates.ts';
import { searchPalette } from './palette-search.ts';
import { recipesOf } from './recipes.ts';
import { addRecipeShown } from './show-recipe.ts';

const AT = { x: 300, y: 200 };
const ALL_RECIPES = recipesOf(LIBRARY);
/** Searches for a node that gives such a wire. */
const SOURCES: Readonly<Record<string, string>> = { objects: 'primitive', layer: 'camera video', pose: 'hit test', lights: 'directional' };

/** As the palette does: what is first for a query, with a wire in hand. */
function choose(editor: Editor, query: string, draggedWire: DraggedWire | null = null): string {
  const { library } = editor.document.getState();
  const all = [...library.types()].flatMap((type) => library.definition(type) ?? []);
  const combined = recipesOf(library).map(({ definition }) => definition);
  const [first] = searchPalette([...all, ...combined], query, draggedWire);
  const id = first ? addNodeFromPalette(editor, first, AT, draggedWire) : null;
  if (id === null) throw new Error(`“${query}” added nothing.`);
  return id;
}

const outOf = (node: string, type: DraggedWire['type'], port: string = type): DraggedWire => ({ node, port, type, side: 'output' });
const wiresOf = (editor: Editor) => {
  const typeOf = (id: string) => nodeOf(editor.document.getState(), id)?.type.split('/')[1];
  return graphOf(editor.document.getState())
    .wires.map(({ from, to }) => `${typeOf(from.node)} > ${typeOf(to.node)}.${to.port}`)
    .sort();
};

describe('a combination', () => {
  test('is shown on the objects of a scene that the pointer rests over it, those of the selected node first', async () => {
    const { editor } = await openTestEditor();
    const scene = choose(editor, 'scene');
    const models = [choose(editor, 'model'), choose(editor, 'primitive')];
    for (const node of models) connect(editor, { node, port: 'objects' }, { node: scene, port: 'objects' });
    const definition = ALL_RECIPES.find(({ nodes }) => nodes.technique?.type === 'technique/toon')?.definition;
    if (!definition) throw new Error('Nothing draws objects as cartoons.');
    const before = filesOf(editor);
    for (const [after, drawn] of [
      [undefined, models[0]],
      [models[1], models[1]],
    ] as const) {
      const shown: Graph | undefined = candidateOf(editor, { definition, port: null }, after === undefined ? {} : { after })?.graphs[
        MAIN_GRAPH
      ];
      const apply = shown?.wires.find(({ from }) => from.node === drawn)?.to.node ?? '';
      expect(shown?.nodes[apply]?.type).toBe('objects/apply-technique');
      expect(shown?.wires.some(({ from, to }) => from.node === apply && to.node === scene)).toBe(true);
    }
    expect(filesOf(editor)).toEqual(before);
  });

  test('draws objects with a technique, by the technique’s name alone, in one step', async () => {
    const { editor } = await openTestEditor();
    const model = choose(editor, 'model');
    const before = filesOf(editor);
    const apply = choose(editor, 'cartoon', outOf(model, 'objects'));
    expect(nodeOf(editor.document.getState(), apply)?.type).toBe('objects/apply-technique');
    expect(soleNode(editor.selection.getState())).toBe(apply);
    expect(wiresOf(editor)).toEqual(['model > apply-technique.objects', 'toon > apply-technique.technique']);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('of a shadow on the floor takes the only light and the room’s depth along', async () => {
    const { editor } = await openTestEditor();
    const model = choose(editor, 'model');
    const sun = choose(editor, 'directional');
    choose(editor, 'shadow on floor', outOf(model, 'objects'));
    expect(wiresOf(editor)).toEqual([
      'depth > depth-occlusion.depth',
      'directional > shadow.lights',
      'model > shadow.casters',
      'phantom > shadow.receivers',
      'primitive > phantom.objects',
      'shadow > depth-occlusion.layer',
    ]);
    const lights = Object.entries(graphOf(editor.document.getState()).nodes).filter(([, { type }]) => type === 'light/directional');
    expect(lights.map(([id]) => id)).toEqual([sun]);
  });

  test('of a shadow on the floor brings a light where there is none, and takes all that are there', async () => {
    const { editor } = await openTestEditor();
    const model = choose(editor, 'model');
    const before = filesOf(editor);
    choose(editor, 'shadow on floor', outOf(model, 'objects'));
    expect(wiresOf(editor)).toContain('directional > shadow.lights');
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
    choose(editor, 'directional');
    choose(editor, 'point light');
    choose(editor, 'shadow on floor', outOf(model, 'objects'));
    const lights = wiresOf(editor).filter((wire) => wire.endsWith('shadow.lights'));
    expect(lights).toEqual(['directional > shadow.lights', 'point > shadow.lights']);
  });

  test.each(ALL_RECIPES)('$definition.title works once its ports are connected', async ({ definition, nodes, ports }) => {
    const { editor } = await openTestEditor();
    const screen = choose(editor, 'screen');
    const [first, ...others] = Object.entries(definition.inputs).filter(([, { required }]) => required);
    const source = first && choose(editor, SOURCES[first[1].type] ?? '');
    const wire: DraggedWire | null = first && source ? outOf(source, first[1].type) : null;
    addNodeFromPalette(editor, { definition, port: first?.[0] ?? null }, AT, wire);
    /** The node in the graph that a port of the recipe belongs to. */
    const portOf = (name: string) => {
      const [inner = '', port = ''] = (ports[name] ?? '').split('.');
      const { nodes: all } = graphOf(editor.document.getState());
      return {
        node:
          Object.keys(all)
            .filter((id) => all[id]?.type === nodes[inner]?.type)
            .at(-1) ?? '',
        port,
      };
    };
    for (const [name, { type }] of others) {
      const to = portOf(name);
      const isConnected = graphOf(editor.document.getState()).wires.some((wired) => wired.to.node === to.node && wired.to.port === to.port);
      if (!isConnected) expect(connect(editor, { node: choose(editor, SOURCES[type] ?? ''), port: type }, to)).toBe(true);
    }
    const [output = ''] = Object.keys(definition.outputs);
    const from = portOf(output);
    if (definition.outputs[output]?.type === 'layer') connect(editor, from, { node: screen, port: 'layer' });
    else {
      const scene = choose(editor, 'scene');
      connect(editor, from, { node: scene, port: 'objects' });
      connect(editor, { node: scene, port: 'layer' }, { node: screen, port: 'layer' });
    }
    const { project, library } = editor.document.getState();
    const { output: program, diagnostics } = compile({ project, library });
    expect(diagnostics.filter(({ severity }) => severity !== 'info')).toEqual([]);
    const drawn = new Set(program?.operations.flatMap((operation) => ('node' in operation ? [operation.node] : [])));
    const all = graphOf(editor.document.getState()).nodes;
    const own = Object.values(nodes).map(({ type }) => type);
    expect([...drawn].some((id) => own.includes(all[id]?.type ?? ''))).toBe(true);
  });

  test('of an occlusion that is soft where depth is uncertain masks by the confidence of the same depth', async () => {
    const { editor } = await openTestEditor();
    const scene = choose(editor, 'scene');
    choose(editor, 'soft occlusion', outOf(scene, 'layer'));
    expect(wiresOf(editor)).toEqual([
      'depth > choose-by-mask.mask',
      'depth > depth-occlusion.depth',
      'depth-occlusion > choose-by-mask.inside',
      'depth-occlusion > gaussian-blur.inputImage',
      'gaussian-blur > choose-by-mask.outside',
      'scene > depth-occlusion.layer',
    ]);
  });

  test('goes into a wire by its own ports, not by those of one of its nodes', async () => {
    const { editor } = await openTestEditor();
    const [camera, screen] = [choose(editor, 'camera video'), choose(editor, 'screen')];
    connect(editor, { node: camera, port: 'layer' }, { node: screen, port: 'layer' });
    const definition = ALL_RECIPES.find(({ definition: { type } }) => type === 'combination/soft-occlusion')?.definition;
    if (!definition) throw new Error('There is no soft occlusion.');
    addNodeFromPalette(editor, { definition, port: null }, AT, null, `${camera}.layer -> ${screen}.layer`);
    expect(wiresOf(editor)).toEqual([
      'camera-video > depth-occlusion.layer',
      'choose-by-mask > screen.layer',
      'depth > choose-by-mask.mask',
      'depth > depth-occlusion.depth',
      'depth-occlusion > choose-by-mask.inside',
      'depth-occlusion > gaussian-blur.inputImage',
      'gaussian-blur > choose-by-mask.outside',
    ]);
  });

  test.each([
    ['real-floor', [], true, false],
    ['shadow-on-floor', ['lights'], false, true],
    ['soft-occlusion', [], false, false],
    ['attach-to-hand', [], true, false],
    ['billboard', [], true, false],
    ['on-objects-technique-toon', [], false, false],
  ])(
    '%s is known by its nodes: its inputs for lights, whether its objects are placed, whether it is a shadow',
    (name, lit, isPlaced, isShadow) => {
      const recipe = ALL_RECIPES.find(({ definition: { type } }) => type === `combination/${name}`);
      expect(recipe).toMatchObject({ lit, isPlaced, isShadow });
    },
  );

  test.each([
    ['attach to hand', 'hand > follow.pose'],
    ['attach to controller', 'gamepad > follow.pose'],
    ['attach to head', 'head > follow.pose'],
  ])('%s puts the objects of a wire there, with a lag', async (query, source) => {
    const { editor } = await openTestEditor();
    const model = choose(editor, 'model');
    const place = choose(editor, query, outOf(model, 'objects'));
    expect(nodeOf(editor.document.getState(), place)?.type).toBe('objects/at-pose');
    expect(wiresOf(editor)).toEqual([source, 'follow > offset.pose', 'model > at-pose.objects', 'offset > at-pose.pose'].sort());
  });

  test('of a billboard takes a pose and turns the objects there to the visitor', async () => {
    const { editor } = await openTestEditor();
    const hit = choose(editor, 'hit test');
    choose(editor, 'billboard', outOf(hit, 'pose'));
    expect(wiresOf(editor)).toEqual(['head > look-at.target', 'hit-test > look-at.pose', 'look-at > at-pose.pose']);
  });

  test('is not what a search for the node itself finds first', async () => {
    const { editor } = await openTestEditor();
    const [shadow, toon] = [choose(editor, 'shadow'), choose(editor, 'toon')];
    for (const [query, type] of [
      ['hand', 'input/hand'],
      ['controller', 'input/gamepad'],
      ['head', 'input/head'],
      ['follow', 'pose/follow'],
    ] as const) {
      const id = choose(editor, query);
      expect(nodeOf(editor.document.getState(), id)?.type).toBe(type);
    }
    expect(nodeOf(editor.document.getState(), shadow)?.type).toBe('layer/shadow');
    expect(nodeOf(editor.document.getState(), toon)?.type).toBe('technique/toon');
  });
});

describe('what a new node cannot do without', () => {
  test('comes with it where only one node can give it, and is shared by the next', async () => {
    const { editor } = await openTestEditor();
    const scene = choose(editor, 'scene');
    choose(editor, 'depth occlusion', outOf(scene, 'layer'));
    choose(editor, 'depth occlusion', outOf(scene, 'layer'));
    const nodes = Object.values(graphOf(editor.document.getState()).nodes).map(({ type }) => type);
    expect(nodes.filter((type) => type === 'world/depth')).toHaveLength(1);
    expect(wiresOf(editor).filter((wire) => wire === 'depth > depth-occlusion.depth')).toHaveLength(2);
  });

  test('is left to the person where there is a choice', async () => {
    const { editor } = await openTestEditor();
    choose(editor, 'directional');
    choose(editor, 'point light');
    choose(editor, 'shadow');
    expect(wiresOf(editor)).toEqual([]);
  });
});

describe('a layer let go over a layer’s wire', () => {
  async function videoOnScreen() {
    const { editor } = await openTestEditor();
    const [video, screen] = [choose(editor, 'camera video'), choose(editor, 'screen')];
    connect(editor, { node: video, port: 'layer' }, { node: screen, port: 'layer' });
    return { editor, video, wire: `${video}.layer -> ${screen}.layer` };
  }

  test('is laid over it, in one step', async () => {
    const { editor, video, wire } = await videoOnScreen();
    const scene = outOf(choose(editor, 'scene'), 'layer');
    const before = filesOf(editor);
    expect(canCompositeOver(editor, scene, wire)).toBe(true);
    expect(soleNode(editor.selection.getState())).not.toBeNull();
    compositeOver(editor, scene, wire, AT);
    expect(wiresOf(editor)).toEqual(['camera-video > over.bottom', 'over > screen.layer', 'scene > over.top']);
    // Not on the node that is there.
    const { layout } = editor.document.getState().project;
    const places = Object.values(layout[MAIN_GRAPH]?.nodes ?? {}).map(({ x, y }) => `${x} ${y}`);
    expect(places.filter((place, i) => places.indexOf(place) !== i)).toEqual([]);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
    // Over itself there is nothing to lay it.
    expect(canCompositeOver(editor, outOf(video, 'layer'), wire)).toBe(false);
  });

  test('but nothing else is', async () => {
    const { editor, wire } = await videoOnScreen();
    expect(canCompositeOver(editor, outOf(choose(editor, 'model'), 'objects'), wire)).toBe(false);
    const scene = choose(editor, 'scene');
    expect(canCompositeOver(editor, { node: scene, port: 'objects', type: 'objects', side: 'input' }, wire)).toBe(false);
  });
});

describe('a recipe that is chosen without a wire', () => {
  const SELECTIONS = ['nothing', 'an object', 'a transform', 'a layer'] as const;
  const CASES = ALL_RECIPES.flatMap((recipe) => SELECTIONS.map((selected) => [recipe.definition.title, selected, recipe] as const));

  async function blank() {
    const { editor } = await openTestEditor();
    const [camera, screen] = [choose(editor, 'camera video'), choose(editor, 'screen')];
    connect(editor, { node: camera, port: 'layer' }, { node: screen, port: 'layer' });
    return { editor, camera };
  }

  /** Types of the nodes that the output shows, without errors of the graph. */
  function shownTypes(editor: Editor): ReadonlySet<string> {
    const { project, library } = editor.document.getState();
    const { output, diagnostics } = compile({ project, library });
    expect(diagnostics.filter(({ severity }) => severity !== 'info')).toEqual([]);
    expect(output).not.toBeNull();
    const { nodes, wires } = graphOf(editor.document.getState());
    const reached = new Set(Object.keys(nodes).filter((id) => nodes[id]?.type === 'output/screen'));
    for (const id of reached) for (const { from, to } of wires) if (to.node === id) reached.add(from.node);
    return new Set([...reached].map((id) => nodes[id]?.type ?? ''));
  }

  test.each(CASES)('%s with %s selected reaches the output, in one step', async (_, selected, recipe) => {
    const { editor, camera } = await blank();
    const object = startObject(editor) ?? '';
    const { nodes } = graphOf(editor.document.getState());
    const transform = Object.keys(nodes).find((id) => nodes[id]?.type === 'objects/transform');
    const after = { nothing: undefined, 'an object': object, 'a transform': transform, 'a layer': camera }[selected];
    const before = filesOf(editor);
    expect(addRecipeShown(editor, recipe, after, AT)).not.toBeNull();
    const shown = shownTypes(editor);
    expect(Object.values(recipe.nodes).filter(({ type }) => !shown.has(type))).toEqual([]);
    // Nothing is drawn twice.
    const { wires } = graphOf(editor.document.getState());
    expect(
      wires.filter(({ from, to }) => from.node === transform && nodeOf(editor.document.getState(), to.node)?.type === 'layer/scene').length,
    ).toBeLessThan(2);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test.each(ALL_RECIPES)('$definition.title in a graph with nothing but the camera brings what it works on', async (recipe) => {
    const { editor } = await blank();
    addRecipeShown(editor, recipe, undefined, AT);
    const shown = shownTypes(editor);
    expect(Object.values(recipe.nodes).filter(({ type }) => !shown.has(type))).toEqual([]);
  });

  test('draws the shadow of objects that stand where a Transform puts them, below them', async () => {
    for (const from of ['objects/primitive', 'objects/transform']) {
      const { editor } = await blank();
      startObject(editor);
      const { nodes } = graphOf(editor.document.getState());
      const shadow = ALL_RECIPES.find(({ definition }) => definition.type === 'combination/shadow-on-floor');
      if (!shadow) throw new Error('There is no shadow on the floor.');
      addRecipeShown(
        editor,
        shadow,
        Object.keys(nodes).find((id) => nodes[id]?.type === from),
        AT,
      );
      const wires = wiresOf(editor);
      expect(wires).toEqual(expect.arrayContaining(['transform > scene.objects', 'transform > shadow.casters', 'scene > over.top']));
      expect(wires).toEqual(expect.arrayContaining(['depth-occlusion > over.top', 'camera-video > over.bottom', 'over > over.bottom']));
    }
  });

  test('goes into all wires of the node that it continues', async () => {
    const { editor } = await blank();
    startObject(editor);
    const { nodes } = graphOf(editor.document.getState());
    const transform = Object.keys(nodes).find((id) => nodes[id]?.type === 'objects/transform');
    const [shadow, toon] = ['combination/shadow-on-floor', 'combination/on-objects-technique-toon'].map((type) =>
      ALL_RECIPES.find(({ definition }) => definition.type === type),
    );
    if (!shadow || !toon) throw new Error('Recipes are missing.');
    addRecipeShown(editor, shadow, transform, AT);
    addRecipeShown(editor, toon, transform, AT);
    const fromTransform = wiresOf(editor).filter((wire) => wire.startsWith('transform >'));
    expect(fromTransform).toEqual(['transform > apply-technique.objects']);
    expect(wiresOf(editor)).toEqual(expect.arrayContaining(['apply-technique > scene.objects', 'apply-technique > shadow.casters']));
  });
});
