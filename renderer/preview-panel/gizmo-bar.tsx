import { useEffect } from 'react';
import { useStore } from 'zustand';
import type { GizmoMode } from '../preview-protocol.ts';
import { type AppCommandId, runCommand } from '../state/commands/app-commands.ts';
import { useKeys } from '../state/commands/command-item.ts';
import { cancelDrag } from '../state/document/cancel-drag.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { gizmoTargetOf } from '../state/editor/gizmo-target.ts';
import { soleNode } from '../state/editor/selection.ts';
import { addToast } from '../state/editor/ui.ts';
import { onEscape } from '../ui/escape.ts';
import { Icon, type IconName } from '../ui/icon.tsx';
import './gizmo-bar.css';

const MODES: readonly { readonly mode: GizmoMode; readonly label: string; readonly icon: IconName; readonly command: AppCommandId }[] = [
  { mode: 'move', label: 'Move', icon: 'move', command: 'gizmo.move' },
  { mode: 'rotate', label: 'Rotate', icon: 'rotate', command: 'gizmo.rotate' },
  { mode: 'scale', label: 'Scale', icon: 'scale', command: 'gizmo.scale' },
];

const SNAP_IN_ROOM = 'Snap to 0.1 m, 15° and scale 0.1 (Ctrl inverts)';
const SNAP_IN_IMAGE = 'Snap to 5 % of the image, 10 px and 15° (Ctrl inverts)';

/** Gizmo toolbar: move, rotate, scale, local space and snapping; in an image one tool for all handles. Empty if the selected node has no gizmo target. */
export function GizmoBar() {
  const { selection } = useEditor();
  const selected = useStore(selection, soleNode);
  useCancelDrag();
  return selected === null ? null : <Tools selected={selected} />;
}

function Tools({ selected }: { readonly selected: string }) {
  const editor = useEditor();
  const { mode: chosen, space, snap, chain, lamp } = useStore(editor.gizmo);
  // Compared as JSON, so that the bar rerenders only if a tool changes.
  const text = useDocument((state) => JSON.stringify(MODES.map(({ mode }) => toolOf(gizmoTargetOf(state, selected, chain, mode, lamp)))));
  const tools = JSON.parse(text) as ToolTarget[];
  if (tools.every(({ of, reason }) => of === null && reason === null)) return null;
  const inImage = tools[0]?.inImage ? tools[0].of : null;
  return (
    <div className="gizmo-bar" role="toolbar" aria-label="Gizmo" aria-orientation="vertical">
      {inImage !== null && (
        <Tool label={`Handles of ${inImage}`} icon="move" command={`gizmo.${chosen ?? 'move'}`} pressed={chosen !== null} />
      )}
      {(inImage === null ? MODES : []).map(({ label, icon, command, mode }, i) => {
        const { of = null, reason = null } = tools[i] ?? {};
        const words = of === null ? label : `${label} ${of}`;
        return (
          <Tool
            key={mode}
            label={words}
            icon={icon}
            command={command}
            pressed={of !== null && chosen === mode}
            {...(of === null ? { reason } : {})}
          />
        );
      })}
      <hr />
      {inImage === null && <Tool label="Local space" icon="axes" command="gizmo.space" pressed={space === 'local'} />}
      <Tool label={inImage === null ? SNAP_IN_ROOM : SNAP_IN_IMAGE} icon="snap" command="gizmo.snap" pressed={snap} />
    </div>
  );
}

interface ToolTarget {
  readonly of: string | null;
  readonly reason: string | null;
  readonly inImage: boolean;
}

function toolOf({ target, ...rest }: ReturnType<typeof gizmoTargetOf>): ToolTarget {
  if (target === null) return { of: null, reason: 'reason' in rest ? rest.reason : null, inImage: false };
  return { of: target.title, reason: null, inImage: target.inImage === true };
}

interface ToolProps {
  readonly label: string;
  readonly icon: IconName;
  readonly command: AppCommandId;
  readonly pressed: boolean;
  /** Why the tool is disabled; absent if it is enabled. */
  readonly reason?: string | null;
}

function Tool({ label, icon, command, pressed, reason }: ToolProps) {
  const editor = useEditor();
  const keys = useKeys(command);
  const press = () => {
    if (reason === undefined) runCommand(editor, command);
    else addToast(editor.ui, { tone: 'info', text: reason ?? label });
  };
  return (
    <button
      type="button"
      className="gizmo-tool"
      aria-label={reason ? `${label}: ${reason}` : label}
      aria-pressed={pressed}
      aria-disabled={reason !== undefined}
      data-tip={reason ?? label}
      data-tip-keys={keys}
      onClick={press}
    >
      <Icon name={icon} />
    </button>
  );
}

/** Escape cancels a gizmo drag, wherever the focus is. */
function useCancelDrag(): void {
  const editor = useEditor();
  const dragging = useStore(editor.gizmo, (state) => state.drag !== null);
  useEffect(() => {
    if (!dragging) return;
    return onEscape(() => cancelDrag(editor));
  }, [dragging, editor]);
}
