import { useEffect } from 'react';
import { useStore } from 'zustand';
import type { GizmoMode } from '../preview-protocol.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useKeys } from '../shell/use-keys.ts';
import { type AppCommandId, runCommand } from '../state/app-commands.ts';
import { cancelDrag } from '../state/gizmo.ts';
import { gripOf } from '../state/grip.ts';
import { soleNode } from '../state/selection.ts';
import { addToast } from '../state/ui.ts';
import { onEscape } from '../ui/escape.ts';
import { Icon, type IconName } from '../ui/icon.tsx';
import './gizmo-bar.css';

const MODES: readonly { readonly mode: GizmoMode; readonly label: string; readonly icon: IconName; readonly command: AppCommandId }[] = [
  { mode: 'move', label: 'Move', icon: 'move', command: 'gizmo.move' },
  { mode: 'rotate', label: 'Turn', icon: 'rotate', command: 'gizmo.rotate' },
  { mode: 'scale', label: 'Resize', icon: 'scale', command: 'gizmo.scale' },
];

/** How the selected thing is taken hold of in the preview; nothing where it has no place in the room. */
export function GizmoBar() {
  const { selection } = useEditor();
  const selected = useStore(selection, soleNode);
  useGiveUp();
  return selected === null ? null : <Tools selected={selected} />;
}

function Tools({ selected }: { readonly selected: string }) {
  const editor = useEditor();
  const { mode: chosen, space, snap, way } = useStore(editor.gizmo);
  // Compared as text, so that the bar is drawn anew only where one of them changes.
  const text = useDocument((state) => JSON.stringify(MODES.map(({ mode }) => toolOf(gripOf(state, selected, way, mode)))));
  const tools = JSON.parse(text) as ReturnType<typeof toolOf>[];
  if (tools.every(({ of, reason }) => of === null && reason === null)) return null;
  return (
    <div className="gizmo-bar" role="toolbar" aria-label="Take hold in the preview" aria-orientation="vertical">
      {MODES.map(({ label, icon, command, mode }, i) => {
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
      <Tool label="Axes of the object, not of the world" icon="axes" command="gizmo.space" pressed={space === 'local'} />
      <Tool label="Snap to 0.1 m, 15° and tenths (Ctrl: the opposite)" icon="snap" command="gizmo.snap" pressed={snap} />
    </div>
  );
}

function toolOf(gripped: ReturnType<typeof gripOf>): { readonly of: string | null; readonly reason: string | null } {
  return gripped.grip === null ? { of: null, reason: gripped.reason } : { of: gripped.grip.title, reason: null };
}

interface ToolProps {
  readonly label: string;
  readonly icon: IconName;
  readonly command: AppCommandId;
  readonly pressed: boolean;
  /** Why it cannot be used; absent where it can. */
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

/** Lets go of what is dragged, wherever the focus is. */
function useGiveUp(): void {
  const editor = useEditor();
  const dragging = useStore(editor.gizmo, (state) => state.drag !== null);
  useEffect(() => {
    if (!dragging) return;
    return onEscape(() => cancelDrag(editor));
  }, [dragging, editor]);
}
