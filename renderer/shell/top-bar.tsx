import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { type AppCommandId, runCommand } from '../state/app-commands.ts';
import { isDirty } from '../state/document.ts';
import { cancelExport } from '../state/export-page.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { MenuButton, type MenuItem } from '../ui/menu.tsx';
import { commandItem } from './command-item.ts';
import { useDocument, useEditor } from './editor-context.ts';
import { Logo } from './logo.tsx';
import './top-bar.css';
import { useKeys } from './use-keys.ts';

const MENUS: readonly { readonly label: string; readonly entries: readonly (AppCommandId | 'line')[] }[] = [
  {
    label: 'File',
    entries: ['file.new', 'file.open', 'line', 'file.save', 'file.save-as', 'line', 'graph.import-shadertoy', 'file.export', 'file.render'],
  },
  {
    label: 'Edit',
    entries: [
      'edit.undo',
      'edit.redo',
      'line',
      'edit.cut',
      'edit.copy',
      'edit.paste',
      'edit.duplicate',
      'edit.duplicate-wired',
      'edit.delete',
      'line',
      'edit.select-all',
      'edit.mute',
    ],
  },
  {
    label: 'Graph',
    entries: [
      'graph.add',
      'graph.swap',
      'graph.collapse',
      'graph.frame',
      'graph.note',
      'graph.reroute',
      'line',
      'graph.subgraph',
      'graph.enter',
      'graph.leave',
      'graph.independent',
      'graph.unpack',
    ],
  },
  {
    label: 'Arrange',
    entries: [
      'arrange.tidy',
      'line',
      'arrange.left',
      'arrange.centre',
      'arrange.right',
      'line',
      'arrange.top',
      'arrange.middle',
      'arrange.bottom',
      'line',
      'arrange.across',
      'arrange.down',
    ],
  },
  {
    label: 'View',
    entries: [
      'view.find',
      'view.fit',
      'view.fit-selection',
      'line',
      'view.thumbnails',
      'view.costs',
      'view.pin',
      'view.compare',
      'view.screen',
      'view.probe',
      'line',
      'gizmo.move',
      'gizmo.rotate',
      'gizmo.scale',
      'gizmo.space',
      'gizmo.snap',
      'line',
      'view.code',
      'view.timeline',
      'view.problems',
      'line',
      'view.theme',
      'view.motion',
    ],
  },
  {
    label: 'Playback',
    entries: [
      'play.toggle',
      'play.next',
      'play.back',
      'play.first',
      'play.last',
      'line',
      'play.in',
      'play.out',
      'play.to-in',
      'play.to-out',
      'play.whole',
      'play.loop',
    ],
  },
  { label: 'Help', entries: ['view.help', 'help.commands', 'help.shortcuts', 'line', 'help.tour'] },
];

export function TopBar() {
  return (
    <header className="top-bar">
      <Logo />
      <MenuBar />
      <Title />
      <Tools />
    </header>
  );
}

function MenuBar() {
  const editor = useEditor();
  const [open, setOpen] = useState<string | null>(null);
  const itemOf = (id: AppCommandId | 'line'): MenuItem => (id === 'line' ? { kind: 'line' } : commandItem(editor, id));
  return (
    <nav className="menu-bar" aria-label="Menus">
      {MENUS.map(({ label, entries }) => (
        <MenuButton key={label} label={label} items={open === label ? entries.map(itemOf) : []} openInBar={open} onOpenInBar={setOpen} />
      ))}
    </nav>
  );
}

function Title() {
  const title = useDocument((state) => state.project.title);
  const path = useDocument((state) => state.open?.displayPath ?? '');
  const dirty = useDocument(isDirty);
  useEffect(() => {
    document.title = `${dirty ? '• ' : ''}${title} – Scrim`;
  }, [dirty, title]);
  return (
    <div className="top-title" data-tip={path === '' ? undefined : path}>
      <h1>{title}</h1>
      {dirty && <span className="unsaved">Edited</span>}
    </div>
  );
}

function Tools() {
  const editor = useEditor();
  const canUndo = useDocument((state) => state.history.past.length > 0);
  const canRedo = useDocument((state) => state.history.future.length > 0);
  const open = useDocument((state) => state.open !== null);
  const exporting = useStore(editor.ui, (state) => state.exporting);
  const undoKeys = useKeys('edit.undo');
  const redoKeys = useKeys('edit.redo');
  return (
    <div className="top-tools">
      <IconButton icon="undo" label="Undo" keys={undoKeys} disabled={!canUndo} onPress={() => runCommand(editor, 'edit.undo')} />
      <IconButton icon="redo" label="Redo" keys={redoKeys} disabled={!canRedo} onPress={() => runCommand(editor, 'edit.redo')} />
      <span className="top-gap" />
      <span data-tour="add">
        <Button icon="add" onPress={() => runCommand(editor, 'graph.add')} disabled={!open}>
          Add node
        </Button>
      </span>
      <span className="export-progress" role="status">
        {exporting?.text}
      </span>
      {exporting === null ? (
        <span data-tour="export">
          <Button icon="export" look="primary" onPress={() => runCommand(editor, 'file.export')} disabled={!open}>
            Export
          </Button>
        </span>
      ) : (
        <Button icon="close" onPress={() => void cancelExport(editor)} disabled={exporting.cancelled}>
          Cancel
        </Button>
      )}
    </div>
  );
}
