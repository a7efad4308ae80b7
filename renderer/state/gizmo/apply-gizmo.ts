import { getOwn } from '../../../export/graph/record.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import type { FromPreview, GizmoMode, ToPreview } from '../../preview-protocol.ts';
import { apply, endGesture } from '../document/apply.ts';
import { cancelDrag } from '../document/cancel-drag.ts';
import { nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import type { GizmoDrag } from '../editor/gizmo-state.ts';
import { arrangesCopies, type GizmoTarget, type GizmoTargetResult, gizmoTargetOf, isWithin } from '../editor/gizmo-target.ts';
import { nodePath } from '../editor/layer-names.ts';
import { timeOf } from '../editor/preview-state.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';
import { transformAfter } from '../graph/transform-after.ts';
import { editParams } from '../params/edit-params.ts';
import { editAt } from '../params/keyframes.ts';
import { previewKeybindings, runPreviewKey } from './preview-keys.ts';

export function currentGizmoTarget(
  { document, selection, gizmo }: Pick<Editor, 'document' | 'selection' | 'gizmo'>,
  mode: GizmoMode,
): GizmoTargetResult {
  const { chain, lamp } = gizmo.getState();
  return gizmoTargetOf(document.getState(), soleNode(selection.getState()), chain, mode, lamp);
}

const VERBS: Readonly<Record<GizmoMode, string>> = { move: 'Move', rotate: 'Rotate', scale: 'Scale' };

/** The editor’s end of the gizmo in the preview. */
export interface GizmoSync {
  /** Sends the whole state to a preview page that has just loaded. */
  sendAll(): void;
  receive(message: Extract<FromPreview, { kind: 'gizmo' | 'picked' | 'key' }>): void;
  dispose(): void;
}

export function createGizmoSync(editor: Editor, post: (message: ToPreview) => void): GizmoSync {
  const { document, selection, gizmo, preferences } = editor;
  let sent = '';
  const sendGizmo = () => {
    const { mode, space, snap, chain, drag } = gizmo.getState();
    const target = mode === null ? null : currentGizmoTarget(editor, mode).target;
    if (target === null && drag !== null) gizmo.setState({ drag: null, endedDrag: drag.id });
    const adds = target?.adds ? ({ adds: true } as const) : {};
    const wanted = mode &&
      target && { node: target.program, ...adds, mode, space, snap, handles: target.handles, axes: target.axes, chain };
    const text = JSON.stringify([wanted, mode !== null]);
    if (text === sent) return;
    sent = text;
    post({ kind: 'gizmo', gizmo: wanted });
    post({ kind: 'picking', on: mode !== null });
  };
  const sendKeys = () => {
    post({ kind: 'keys', keybindings: previewKeybindings(editor), mac: editor.mac });
  };
  const stops = [
    document.subscribe((state, before) => {
      if (state.project !== before.project || state.graph !== before.graph) sendGizmo();
    }),
    selection.subscribe(sendGizmo),
    gizmo.subscribe((state, before) => {
      if (before.drag !== null && state.drag === null) sent = '';
      sendGizmo();
    }),
    preferences.subscribe((state, before) => {
      if (state.keybindings !== before.keybindings) sendKeys();
    }),
  ];
  return {
    sendAll: () => {
      sent = '';
      cancelDrag(editor);
      gizmo.setState({ endedDrag: 0 });
      sendGizmo();
      sendKeys();
    },
    receive: (message) => {
      if (message.kind === 'gizmo') receiveDrag(editor, message);
      if (message.kind === 'picked') receivePick(editor, message);
      if (message.kind === 'key') runPreviewKey(editor, message.keybinding);
    },
    dispose: () => {
      for (const stop of stops) stop();
    },
  };
}

function receiveDrag(editor: Editor, { drag: id, state, values }: Extract<FromPreview, { kind: 'gizmo' }>): void {
  const { gizmo, document, preview } = editor;
  const { mode, endedDrag } = gizmo.getState();
  let { drag } = gizmo.getState();
  if (id <= endedDrag) return;
  if (state === 'cancelled') {
    cancelDrag(editor);
    return;
  }
  if (drag === null) {
    const found = mode === null ? null : currentGizmoTarget(editor, mode).target;
    if (mode === null || found === null || state === 'ended') return;
    endGesture(editor);
    const before = document.getState().history.state;
    const target = found.adds ? addTransform(editor, found, mode) : found;
    if (target === null) return;
    drag = { id, target, state: before, timeS: timeOf(preview.getState()) };
    gizmo.setState({ drag });
  }
  setValues(editor, drag, mode ?? 'move', values);
  if (state !== 'ended') return;
  endGesture(editor);
  gizmo.setState({ drag: null, endedDrag: id });
}

/** Adds a Transform after a node and returns it as the target of the drag, whose undo step this begins; null if it could not be added. */
function addTransform(editor: Editor, { node, title }: GizmoTarget, mode: GizmoMode): GizmoTarget | null {
  const { id, change } = transformAfter(editor, node);
  if (!apply(editor, `${VERBS[mode]} ${title}`, change, keyOf(id))) return null;
  const { target } = currentGizmoTarget(editor, mode);
  return target?.node === id ? target : null;
}

/** Key of the undo step of a drag. */
const keyOf = (node: string): string => `gizmo ${node}`;

function setValues(editor: Editor, { target, timeS }: GizmoDrag, mode: GizmoMode, values: Readonly<Record<string, ParamValue>>): void {
  const state = editor.document.getState();
  const node = nodeOf(state, target.node);
  const definition = node && state.library.definition(node.type);
  const edits: { param: string; value: ParamValue }[] = [];
  for (const [inner, value] of Object.entries(values)) {
    const name = getOwn(target.names, inner);
    const param = name === undefined ? undefined : getOwn(definition?.params ?? {}, name);
    if (name === undefined || param === undefined) continue;
    const binding = getOwn(node?.params ?? {}, name);
    const fitting = inRange(param, value);
    if (binding && 'track' in binding) editAt(editor, target.node, name, timeS, fitting);
    else edits.push({ param: name, value: fitting });
  }
  const verb = target.inImage ? 'Adjust' : VERBS[mode];
  if (edits.length > 0) editParams(editor, `${verb} ${target.title}`, target.node, edits, keyOf(target.node));
}

/** Decimals of lengths and factors: 0.1 mm. Those of angles are below 0.00001°. */
const DIGITS = 4;
const DIGITS_RAD = 7;

/** Clamps a value to the range of the param, and removes floating-point errors. */
function inRange(param: ParamDefinition, value: ParamValue): ParamValue {
  const digits = 'unit' in param && param.unit === 'rad' ? DIGITS_RAD : DIGITS;
  const clean = (part: number, min = Number.NEGATIVE_INFINITY, max = Number.POSITIVE_INFINITY) =>
    Math.min(Math.max(Number(part.toFixed(digits)), min), max);
  if (param.type === 'number') return clean(Number(value), param.min, param.max);
  if ((param.type !== 'vector2' && param.type !== 'vector3') || !Array.isArray(value)) return value;
  return (value as readonly number[]).map((part, i) => clean(part, param.min?.[i], param.max?.[i]));
}

/**
 * Selects the node that created the clicked object, of a copy the node that arranges the copies. Further clicks select the next node in
 * its chain that has a transform.
 */
function receivePick(editor: Editor, { chain, phantom }: Extract<FromPreview, { kind: 'picked' }>): void {
  const { document, selection, gizmo, ui } = editor;
  const state = document.getState();
  const inGraph = Object.keys(state.project.graphs[state.graph]?.nodes ?? {});
  const ids = chain.flatMap((id) => inGraph.find((node) => isWithin(id, nodePath(state, node))) ?? []);
  const [source] = ids;
  if (source === undefined) return;
  const placing = ids.filter((id) => Object.values(definitionParams(editor, id)).some((param) => 'handle' in param));
  // Phantoms of detected surfaces cover the whole room, and have no transform.
  if (phantom && placing.length === 0) return;
  const copies = [...placing].reverse().find((id) => arrangesCopies({ params: definitionParams(editor, id) }));
  const choices = [...new Set([copies ?? source, source, ...placing])];
  const selected = soleNode(selection.getState());
  const next = choices[(selected === null ? -1 : choices.indexOf(selected)) + 1] ?? source;
  gizmo.setState({ chain });
  selectOnly(selection, [next]);
  revealNodes(ui, [next]);
}

function definitionParams({ document }: Editor, id: string): Readonly<Record<string, ParamDefinition>> {
  const state = document.getState();
  return state.library.definition(nodeOf(state, id)?.type ?? '')?.params ?? {};
}
