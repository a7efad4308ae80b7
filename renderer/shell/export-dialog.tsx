import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { cancelExport, exportPage } from '../state/files/export-page.ts';
import { suggestFolder } from '../state/files/suggest-folder.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { DialogForm } from '../ui/dialog-form.tsx';
import { ExportErrors } from './export-errors.tsx';
import { ExportPoster, usePoster } from './export-poster.tsx';
import { FolderField } from './folder-field.tsx';
import './export-dialog.css';

/** Asks for the folder of a page, and shows the progress of the export. Closed meanwhile, the export goes on. */
export function ExportDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const title = useDocument((state) => state.project.title);
  const exporting = useStore(editor.ui, (state) => state.exporting);
  const [path, setPath] = useState(() => editor.ui.getState().exportSettings.out || suggestFolder(editor, title, '-page'));
  const ready = exporting === null && path.trim() !== '';
  const poster = usePoster();
  const go = () => {
    if (ready) void exportPage(editor, { out: path.trim() }, poster.bytes);
  };
  return (
    <Dialog
      title="Export the page"
      onClose={onClose}
      actions={
        <>
          <ExportProgress />
          {exporting === null ? (
            <>
              <Button look="quiet" onPress={onClose}>
                Cancel
              </Button>
              <Button look="primary" disabled={!ready} onPress={go}>
                Export
              </Button>
            </>
          ) : (
            <>
              <Button look="quiet" onPress={onClose}>
                Hide
              </Button>
              <Button disabled={exporting.cancelled} onPress={() => void cancelExport(editor)}>
                Cancel
              </Button>
            </>
          )}
        </>
      }
    >
      <DialogForm action="Export" onGo={go}>
        <FolderField id={id} label="Folder" path={path} example="/home/me/pages/my-effect" purpose="export" onChange={setPath} />
        <p className="dialog-note">A folder of static files for any web server. It must be new, empty, or an earlier export.</p>
      </DialogForm>
      <ExportPoster poster={poster} busy={exporting !== null} />
      <ExportErrors onShow={onClose} />
    </Dialog>
  );
}

/** What the export in progress does at the moment. */
export function ExportProgress() {
  const { ui } = useEditor();
  const text = useStore(ui, ({ exporting }) => exporting?.text ?? '');
  return (
    <span className="export-state" role="status">
      {text}
    </span>
  );
}
