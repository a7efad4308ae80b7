import { getOwn } from '../../../export/graph/record.ts';
import type { GizmoMode } from '../../preview-protocol.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { type DeviceFrame, shownFrame } from '../editor/preview-state.ts';
import type { BottomTab, Dock } from '../editor/ui.ts';
import type { AppCommandId } from './app-commands.ts';

interface Tick {
  /** Whether what the command switches is on. */
  readonly isOn: (editor: Editor) => boolean;
  /** One of several, of which at most one is on. */
  readonly radio?: true;
}

/** The commands that menus tick while what they switch is on. */
const TICKS: Partial<Record<AppCommandId, Tick>> = {
  'edit.mute': ofNodes(({ muted }) => muted === true),
  'edit.unfuse': ofNodes(({ unfused }) => unfused === true),
  'graph.collapse': {
    isOn: ({ document, selection }) => {
      const places = layoutOf(document.getState()).nodes;
      return all(selection.getState().nodes, (id) => getOwn(places, id)?.collapsed === true);
    },
  },
  'view.thumbnails': { isOn: ({ preferences }) => preferences.getState().thumbnails },
  'view.costs': { isOn: ({ costs }) => costs.getState().on },
  'view.camera': { isOn: ({ viewer }) => viewer.getState().beforeCamera !== null },
  'view.probe': { isOn: ({ viewer }) => viewer.getState().probing },
  'view.code': bottom('code'),
  'view.timeline': bottom('timeline'),
  'view.assets': bottom('assets'),
  'view.history': bottom('history'),
  'view.problems': bottom('problems'),
  'view.help': { isOn: ({ ui }) => ui.getState().help },
  'view.preview-full': { isOn: ({ ui }) => ui.getState().previewExtent === 'full' },
  'view.preview-overlay': { isOn: ({ ui }) => ui.getState().previewExtent === 'overlay' },
  'view.pop-out': { isOn: ({ preview }) => preview.getState().poppedOut },
  'view.dock-right': dock('right'),
  'view.dock-left': dock('left'),
  'view.dock-below': dock('below'),
  'preview.fill': frame('fill'),
  'preview.phone': frame('phone'),
  'preview.phone-wide': frame('phone-wide'),
  'preview.headset': frame('headset'),
  'preview.glasses': frame('glasses'),
  'preview.safe-areas': { isOn: ({ preview }) => preview.getState().safeAreas },
  'view.motion': { isOn: ({ preferences }) => preferences.getState().motion === 'reduced' },
  'gizmo.move': gizmo('move'),
  'gizmo.rotate': gizmo('rotate'),
  'gizmo.scale': gizmo('scale'),
  'gizmo.snap': { isOn: (editor) => editor.gizmo.getState().snap },
  'play.loop': { isOn: ({ preview }) => preview.getState().loop },
  'play.record': { isOn: ({ preview }) => preview.getState().sessionRecording === 'recording' },
};

/** Whether menus tick a command, and how; null for commands that switch nothing. */
export function tickOf(editor: Editor, id: AppCommandId): { readonly on: boolean; readonly radio: boolean } | null {
  const tick = TICKS[id];
  return tick ? { on: tick.isOn(editor), radio: tick.radio === true } : null;
}

function bottom(tab: BottomTab): Tick {
  return { isOn: ({ ui }) => ui.getState().bottom === tab };
}

function dock(side: Dock): Tick {
  return { isOn: ({ ui }) => ui.getState().dock === side, radio: true };
}

function frame(device: DeviceFrame): Tick {
  return { isOn: ({ preview }) => shownFrame(preview.getState()) === device, radio: true };
}

function gizmo(mode: GizmoMode): Tick {
  return { isOn: (editor) => editor.gizmo.getState().mode === mode, radio: true };
}

type NodeState = ReturnType<typeof graphOf>['nodes'][string];

function ofNodes(isSet: (node: NodeState) => boolean): Tick {
  return {
    isOn: ({ document, selection }) => {
      const { nodes } = graphOf(document.getState());
      return all(selection.getState().nodes, (id) => nodes[id] !== undefined && isSet(nodes[id]));
    },
  };
}

function all(ids: ReadonlySet<string>, isSet: (id: string) => boolean): boolean {
  return ids.size > 0 && [...ids].every(isSet);
}
