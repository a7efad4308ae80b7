import { createStore, type StoreApi } from 'zustand/vanilla';
import { subgraphType } from '../../export/graph/names.ts';
import { own } from '../../export/graph/own.ts';
import { MAIN_GRAPH, type PortAddress } from '../../export/graph/project.ts';
import { sameAddress } from '../../export/graph/wires.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { PreviewProbe } from '../preview-protocol.ts';
import { type DocumentState, graphOf, nodeOf } from './document.ts';
import type { Editor } from './editor.ts';
import { soleNode } from './selection.ts';
import { addToast } from './ui.ts';

/** What is looked at besides the screen. Layers are named as the compiler names them: `outer/inner.port`. */
export interface LookState {
  /** Nodes that give layers show them. */
  readonly thumbnails: boolean;
  /** What the preview shows left of `split` instead of the screen; null: the screen. */
  readonly left: string | null;
  readonly right: string | null;
  /** Part of the preview's width; null: the left one is everywhere. */
  readonly split: number | null;
  /** The pointer over the preview asks what is under it. */
  readonly probing: boolean;
  readonly probed: PreviewProbe | null;
  /** Somebody waits for a colour of the picture. */
  readonly picking: ColorWish | null;
}

/** The eyedropper is over the preview for it. */
export interface ColorWish {
  /** What the colour is for. */
  readonly label: string;
  /** Display-referred sRGB, each in [0, 1]. */
  readonly take: (color: readonly [number, number, number]) => void;
  /** It has ended by itself, with a colour or without. */
  readonly onEnd: () => void;
}

export type LookStore = StoreApi<LookState>;

const NOTHING: LookState = { thumbnails: false, left: null, right: null, split: null, probing: false, probed: null, picking: null };

export function createLookState(): LookStore {
  return createStore<LookState>(() => NOTHING);
}

export function lookAtNothing(store: LookStore): void {
  const { thumbnails, picking } = store.getState();
  store.setState({ ...NOTHING, thumbnails, picking });
}

/** Who wants small pictures of which layers. They come here and not through a store: nothing else of the page is drawn for them. */
export interface Pictures {
  /** Until the returned function is called. Whoever watches closes the pictures. */
  watch(layer: string, onPicture: (picture: ImageBitmap) => void): () => void;
  wanted(): readonly string[];
  onChange: { run: (() => void) | null };
  deliver(layer: string, picture: ImageBitmap): void;
}

export function createLayerPictures(): Pictures {
  const watchers = new Map<string, Set<(picture: ImageBitmap) => void>>();
  const onChange: Pictures['onChange'] = { run: null };
  return {
    onChange,
    watch: (layer, onPicture) => {
      const all = watchers.get(layer) ?? new Set();
      all.add(onPicture);
      watchers.set(layer, all);
      onChange.run?.();
      return () => {
        all.delete(onPicture);
        if (all.size === 0 && watchers.get(layer) === all) watchers.delete(layer);
        onChange.run?.();
      };
    },
    wanted: () => [...watchers.keys()].sort(),
    deliver: (layer, picture) => {
      const [first] = watchers.get(layer) ?? [];
      if (first) first(picture);
      else picture.close();
    },
  };
}

/** The first layer that nodes of a type give. */
export function layerPortOf(definition: NodeDefinition | undefined): string | null {
  return Object.entries(definition?.outputs ?? {}).find(([, { type }]) => type === 'layer')?.[0] ?? null;
}

/** What the compiler calls a port of the open graph: of a subgraph that several nodes stand for, in the first of them. */
export function layerName(state: Pick<DocumentState, 'project' | 'graph' | 'trail'>, node: string, port: string): string {
  return `${nodePath(state, node)}.${port}`;
}

/** What the compiler calls a node of the open graph. */
export function nodePath(state: Pick<DocumentState, 'project' | 'graph' | 'trail'>, node: string): string {
  const way = [...state.trail, state.graph];
  const path = way.slice(1).map((inner, depth) => {
    const nodes = own(state.project.graphs, way[depth] ?? '')?.nodes ?? {};
    return Object.keys(nodes).find((id) => nodes[id]?.type === subgraphType(inner)) ?? inner;
  });
  return [...path, node].join('/');
}

/** The layer that the screen shows, in the main graph. */
function screenLayer({ project }: DocumentState): string | null {
  const main = graphOf({ project, graph: MAIN_GRAPH });
  const wire = main.wires.filter(({ to }) => main.nodes[to.node]?.type === 'output/screen').at(-1);
  return wire ? `${wire.from.node}.${wire.from.port}` : null;
}

/** All layers that a program has to keep for looking at them. */
export function lookedAt(editor: Pick<Editor, 'look' | 'pictures' | 'document'>): readonly string[] {
  const { left, right, probing } = editor.look.getState();
  const besides = [left, right, probing ? probedLayer(editor) : null];
  return [...new Set([...editor.pictures.layers.wanted(), ...besides.flatMap((layer) => layer ?? [])])].sort();
}

/** Where a probe finds depth. */
export function probedLayer({ look, document }: Pick<Editor, 'look' | 'document'>): string | null {
  return look.getState().left ?? screenLayer(document.getState());
}

/** As people call a layer: by its node's title, and the port where the node gives several. */
export function layerTitle(state: DocumentState, layer: string | null): string {
  if (layer === null) return 'Screen';
  const id = layer.slice(layer.lastIndexOf('/') + 1, layer.lastIndexOf('.'));
  const port = layer.slice(layer.lastIndexOf('.') + 1);
  for (const graph of Object.values(state.project.graphs)) {
    const node = own(graph.nodes, id);
    if (!node) continue;
    const { title = id, outputs = {} } = state.library.definition(node.type) ?? {};
    const several = Object.values(outputs).filter(({ type }) => type === 'layer').length > 1;
    return several ? `${title} · ${own(outputs, port)?.label ?? port}` : title;
  }
  return id;
}

/** The layer at a port: the one that an output gives, or that is wired to an input; null where there is none. */
export function layerAt(state: DocumentState, { node, port }: PortAddress, side: 'input' | 'output'): string | null {
  const from = side === 'output' ? { node, port } : graphOf(state).wires.find(({ to }) => sameAddress(to, { node, port }))?.from;
  const definition = from && state.library.definition(nodeOf(state, from.node)?.type ?? '');
  return from && own(definition?.outputs ?? {}, from.port)?.type === 'layer' ? layerName(state, from.node, from.port) : null;
}

function selectedLayer({ document, selection }: Editor): string | null {
  const state = document.getState();
  const node = soleNode(selection.getState());
  const port = node === null ? null : layerPortOf(state.library.definition(nodeOf(state, node)?.type ?? ''));
  return node === null || port === null ? null : layerName(state, node, port);
}

/** Shows the selected node's layer in the whole preview, or the screen again where it is shown already. */
export function pinSelected(editor: Editor): void {
  const layer = selectedLayer(editor);
  if (layer !== null) pinLayer(editor.look, layer);
  else addToast(editor.ui, { tone: 'info', text: 'Select one node that gives a layer: the preview can show it.' });
}

export function pinLayer(look: LookStore, layer: string): void {
  if (look.getState().left === layer) lookAtNothing(look);
  else look.setState({ left: layer, right: null, split: null });
}

/** Puts the selected node's layer beside what the preview shows, with a wipe between both. */
export function compareSelected(editor: Editor): void {
  const layer = selectedLayer(editor);
  if (layer !== null) compareLayer(editor.look, layer);
  else addToast(editor.ui, { tone: 'info', text: 'Select one node that gives a layer to compare it.' });
}

export function compareLayer(look: LookStore, layer: string): void {
  const { left } = look.getState();
  if (left === null || left === layer) look.setState({ left: layer, right: null, split: 0.5 });
  else look.setState({ right: layer, split: 0.5 });
}
