import { getOwn } from '../../../export/graph/record.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import type { FromPreview, GizmoMode, ToPreview } from '../../preview-protocol.ts';
import { appCommand, appCommandIds, runCommand } from '../commands/app-commands.ts';
import { commandOfKeybinding, keybindingsOf } from '../commands/keybindings.ts';
import { endGesture } from '../document/apply.ts';
import { nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import type { GizmoDrag } from '../editor/gizmo-state.ts';
import { type GizmoTargetResult, gizmoTargetOf, isOnWay } from '../editor/gizmo-target.ts';
import { nodePath } from '../editor/layer-names.ts';
import { timeOf } from '../editor/preview-state.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';
import { editParams } from '../params/edit-params.ts';
import { editAt } from '../params/keyframes.ts';
import { cancelDrag } from './cancel-drag.ts';

export function currentGizmoTarget(
  { document, selection, gizmo }: Pick<Editor, 'document' | 'selection' | 'gizmo'>,
  mode: GizmoMode,
): GizmoTargetResult {
  return gizmoTargetOf(document.getState(), soleNode(selection.getState()), gizmo.getState().way, mode);
}

const VERBS: Readonly<Record<GizmoMode, string>> = { move: 'Move', rotate: 'Turn', scale: 'Resize' };

/** The end of the line to the preview's gizmo. */
export interface Gizmos {
  /** Sends everything to a preview page that has just loaded. */
  tell(): void;
  take(message: Extract<FromPreview, { kind: 'gizmo' | 'picked' | 'key' }>): void;
  dispose(): void;
}

export function createGizmos(editor: Editor, post: (message: ToPreview) => void): Gizmos {
  const { document, selection, gizmo, preferences } = editor;
  let told = '';
  const follow = () => {
    const { mode, space, snap, way, drag } = gizmo.getState();
    const target = mode === null ? null : currentGizmoTarget(editor, mode).target;
    if (target === null && drag !== null) gizmo.setState({ drag: null, endedDrag: drag.id });
    const wanted = mode && target && { node: target.program, mode, space, snap, handles: target.handles, way };
    const text = JSON.stringify([wanted, mode !== null]);
    if (text === told) return;
    told = text;
    post({ kind: 'gizmo', gizmo: wanted });
    post({ kind: 'picking', on: mode !== null });
  };
  const tellKeys = () => {
    const keybindings = appCommandIds().flatMap((id) => (appCommand(id).byEvent === true ? [] : keybindingsOf(editor, id)));
    post({ kind: 'keys', keybindings: keybindings.filter((keybinding) => keybinding !== 'Tab'), mac: editor.mac });
  };
  const stops = [
    document.subscribe((state, before) => {
      if (state.project !== before.project || state.graph !== before.graph) follow();
    }),
    selection.subscribe(follow),
    gizmo.subscribe((state, before) => {
      if (before.drag !== null && state.drag === null) told = '';
      follow();
    }),
    preferences.subscribe((state, before) => {
      if (state.keybindings !== before.keybindings) tellKeys();
    }),
  ];
  return {
    tell: () => {
      told = '';
      cancelDrag(editor);
      gizmo.setState({ endedDrag: 0 });
      follow();
      tellKeys();
    },
    take: (message) => {
      if (message.kind === 'gizmo') takeDrag(editor, message);
      if (message.kind === 'picked') takePick(editor, message);
      if (message.kind === 'key') takeKey(editor, message.keybinding);
    },
    dispose: () => {
      for (const stop of stops) stop();
    },
  };
}

function takeDrag(editor: Editor, { drag: id, state, values }: Extract<FromPreview, { kind: 'gizmo' }>): void {
  const { gizmo, document, preview } = editor;
  const { mode, endedDrag } = gizmo.getState();
  let { drag } = gizmo.getState();
  if (id <= endedDrag) return;
  if (state === 'cancelled') {
    cancelDrag(editor);
    return;
  }
  if (drag === null) {
    const target = mode === null ? null : currentGizmoTarget(editor, mode).target;
    if (target === null || state === 'ended') return;
    endGesture(editor);
    drag = { id, target, state: document.getState().history.state, timeS: timeOf(preview.getState()) };
    gizmo.setState({ drag });
  }
  setValues(editor, drag, mode ?? 'move', values);
  if (state !== 'ended') return;
  endGesture(editor);
  gizmo.setState({ drag: null, endedDrag: id });
}

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
  if (edits.length > 0) editParams(editor, `${VERBS[mode]} ${target.title}`, target.node, edits, `gizmo ${target.node}`);
}

/** A tenth of a millimeter, and less than a hundred-thousandth of a degree. */
const DIGITS = 4;
const DIGITS_RAD = 7;

/** Within the param's range, and without the dust of floating-point numbers. */
function inRange(param: ParamDefinition, value: ParamValue): ParamValue {
  const digits = 'unit' in param && param.unit === 'rad' ? DIGITS_RAD : DIGITS;
  const bring = (part: number, min = Number.NEGATIVE_INFINITY, max = Number.POSITIVE_INFINITY) =>
    Math.min(Math.max(Number(part.toFixed(digits)), min), max);
  if (param.type === 'number') return bring(Number(value), param.min, param.max);
  if (param.type !== 'vector3' || !Array.isArray(value)) return value;
  return (value as readonly number[]).map((part, i) => bring(part, param.min?.[i], param.max?.[i]));
}

/** Selects the node that made the object; clicked again, the next on its way that has a place. */
function takePick(editor: Editor, { way, phantom }: Extract<FromPreview, { kind: 'picked' }>): void {
  const { document, selection, gizmo, ui } = editor;
  const state = document.getState();
  const inGraph = Object.keys(state.project.graphs[state.graph]?.nodes ?? {});
  const ids = way.flatMap((id) => inGraph.find((node) => isOnWay(id, nodePath(state, node))) ?? []);
  const [source] = ids;
  if (source === undefined) return;
  const placing = ids.filter((id) => Object.values(definitionParams(editor, id)).some((param) => 'handle' in param));
  // The floor and walls that a device finds are everywhere, and nobody can move them.
  if (phantom && placing.length === 0) return;
  const choices = [...new Set([source, ...placing])];
  const selected = soleNode(selection.getState());
  const next = choices[(selected === null ? -1 : choices.indexOf(selected)) + 1] ?? source;
  gizmo.setState({ way });
  selectOnly(selection, [next]);
  revealNodes(ui, [next]);
}

function definitionParams({ document }: Editor, id: string): Readonly<Record<string, ParamDefinition>> {
  const state = document.getState();
  return state.library.definition(nodeOf(state, id)?.type ?? '')?.params ?? {};
}

function takeKey(editor: Editor, keybinding: string): void {
  const { dialog, palette } = editor.ui.getState();
  if (dialog !== null || palette !== null) return;
  // Of keys that mean something else over the timeline, those of the gizmo are the preview's.
  const plain = commandOfKeybinding(editor, keybinding, false);
  const id = plain?.startsWith('gizmo.') ? plain : commandOfKeybinding(editor, keybinding, false, 'time');
  if (id !== null) runCommand(editor, id);
}
