import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { type AppCommandId, runCommand } from '../state/commands/app-commands.ts';
import { commandItem } from '../state/commands/command-item.ts';
import { MENUS } from '../state/commands/menus.ts';
import { isDirty } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { cancelExport, isExportDialog } from '../state/files/export-page.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { MenuButton, type MenuItem } from '../ui/menu.tsx';
import { Logo } from './logo.tsx';
import './top-bar.css';
import { useKeys } from '../state/commands/command-item.ts';

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
      {dirty ? <span className="unsaved">Not saved</span> : path !== '' && <span className="saved">Saved</span>}
    </div>
  );
}

function Tools() {
  const editor = useEditor();
  const canUndo = useDocument((state) => state.history.past.length > 0);
  const canRedo = useDocument((state) => state.history.future.length > 0);
  const open = useDocument((state) => state.open !== null);
  // The dialogs of an export show its progress themselves.
  const exporting = useStore(editor.ui, ({ exporting, dialog }) => (isExportDialog(dialog) ? null : exporting));
  const undoKeys = useKeys('edit.undo');
  const redoKeys = useKeys('edit.redo');
  return (
    <div className="top-tools">
      <IconButton icon="undo" label="Undo" keys={undoKeys} disabled={!canUndo} onPress={() => runCommand(editor, 'edit.undo')} />
      <IconButton icon="redo" label="Redo" keys={redoKeys} disabled={!canRedo} onPress={() => runCommand(editor, 'edit.redo')} />
      <span className="top-gap" />
      <span data-tour="add">
        <Button icon="add" tip="Add node" onPress={() => runCommand(editor, 'graph.add')} disabled={!open}>
          Add node
        </Button>
      </span>
      <span className="export-progress" role="status">
        {exporting?.text}
      </span>
      {exporting === null ? (
        <span data-tour="export">
          <Button icon="export" look="primary" tip="Export" onPress={() => runCommand(editor, 'file.export')} disabled={!open}>
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
