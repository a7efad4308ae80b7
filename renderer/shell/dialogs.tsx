import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { DialogRequest } from '../state/editor/ui.ts';
import { breakLockAndSave, reload, save, showProject } from '../state/files/files.ts';
import { ChoiceDialog } from '../ui/choice-dialog.tsx';
import { CaptureReportDialog } from './capture-report-dialog.tsx';
import { CommandsDialog } from './commands-dialog.tsx';
import { ExportDialog } from './export-dialog.tsx';
import { ExportedDialog } from './exported-dialog.tsx';
import { FindDialog } from './find-dialog.tsx';
import { LibraryNameDialog, LibraryRemoveDialog } from './library-dialogs.tsx';
import { NewDialog } from './new-dialog.tsx';
import { OpenDialog } from './open-dialog.tsx';
import { PhotographDialog } from './photograph-dialog.tsx';
import { PhotographsDialog } from './photographs-dialog.tsx';
import { RecipeDialog, RecipesDialog } from './recipe-dialogs.tsx';
import { RenderDialog } from './render-dialog.tsx';
import { RephotographDialog, RephotographedDialog } from './rephotograph-dialogs.tsx';
import { SaveAsDialog } from './save-as-dialog.tsx';
import { ShadertoyDialog } from './shadertoy-dialog.tsx';
import { ShortcutsDialog } from './shortcuts-dialog.tsx';
import { SimplifyDialog } from './simplify-dialog.tsx';

/** The open dialog, if any. */
export function Dialogs() {
  const { ui } = useEditor();
  const dialog = useStore(ui, (state) => state.dialog);
  const close = () => ui.setState({ dialog: null });
  if (dialog === null) return null;
  switch (dialog.kind) {
    case 'open':
      return <OpenDialog onClose={close} />;
    case 'new':
      return <NewDialog {...(dialog.template === undefined ? {} : { chosen: dialog.template })} onClose={close} />;
    case 'save-as':
      return <SaveAsDialog onClose={close} />;
    case 'export':
      return <ExportDialog onClose={close} />;
    case 'exported':
      return <ExportedDialog onClose={close} />;
    case 'render':
      return <RenderDialog onClose={close} />;
    case 'photograph':
      return <PhotographDialog onClose={close} />;
    case 'photographs':
      return <PhotographsDialog folder={dialog.folder} onClose={close} />;
    case 'capture-report':
      return <CaptureReportDialog path={dialog.path} note={dialog.note} onClose={close} />;
    case 'simplify':
      return <SimplifyDialog id={dialog.id} onClose={close} />;
    case 'rephotograph':
      return <RephotographDialog path={dialog.path} onClose={close} />;
    case 'rephotographed':
      return <RephotographedDialog means={dialog.rephotographed} onClose={close} />;
    case 'unsaved':
      return <UnsavedDialog proceed={dialog.proceed} onClose={close} />;
    case 'recovery':
      return <RecoveryDialog request={dialog} onClose={close} />;
    case 'changed-outside':
      return <ChangedOutsideDialog onClose={close} />;
    case 'locked':
      return <LockedDialog overwrite={dialog.overwrite} onClose={close} />;
    case 'shadertoy':
      return <ShadertoyDialog onClose={close} />;
    case 'library':
      return <LibraryNameDialog name={dialog.name} rename={dialog.rename === true} onClose={close} />;
    case 'library-remove':
      return <LibraryRemoveDialog name={dialog.name} onClose={close} />;
    case 'recipe':
      return <RecipeDialog onClose={close} />;
    case 'recipes':
      return <RecipesDialog onClose={close} />;
    case 'commands':
      return <CommandsDialog onClose={close} />;
    case 'shortcuts':
      return <ShortcutsDialog onClose={close} />;
    case 'find':
      return <FindDialog onClose={close} />;
  }
}

function UnsavedDialog({ proceed, onClose }: { readonly proceed: () => void; readonly onClose: () => void }) {
  const editor = useEditor();
  const title = useStore(editor.document, (state) => state.project.title);
  const closeAndProceed = () => {
    onClose();
    proceed();
  };
  const saveAndProceed = async () => {
    if (await save(editor)) closeAndProceed();
  };
  return (
    <ChoiceDialog
      title={`Save the changes to “${title}”?`}
      onClose={onClose}
      choices={[
        { label: 'Cancel', look: 'quiet', run: onClose },
        { label: 'Do not save', look: 'danger', run: closeAndProceed },
        { label: 'Save', look: 'primary', run: () => void saveAndProceed() },
      ]}
    >
      Unsaved changes are lost.
    </ChoiceDialog>
  );
}

interface RecoveryDialogProps {
  readonly request: Extract<DialogRequest, { kind: 'recovery' }>;
  readonly onClose: () => void;
}

function RecoveryDialog({ request, onClose }: RecoveryDialogProps) {
  const editor = useEditor();
  const { open } = editor.document.getState();
  const discard = async () => {
    onClose();
    if (open) await editor.host.call('project.autosave', { handle: open.handle, files: null });
  };
  const restore = () => {
    onClose();
    if (open) showProject(editor, open, request.files, false);
  };
  return (
    <ChoiceDialog
      title="Unsaved changes found"
      // Escape must not close it: working on without a decision would overwrite the recovered changes.
      onClose={() => {}}
      choices={[
        { label: 'Discard', look: 'quiet', run: () => void discard() },
        { label: 'Restore', look: 'primary', run: restore },
      ]}
    >
      Scrim ended before this project was saved. Restore the changes to continue; files stay as they are until you save.
    </ChoiceDialog>
  );
}

function closeAnd(onClose: () => void, run: () => Promise<unknown>): () => void {
  return () => {
    onClose();
    void run();
  };
}

function ChangedOutsideDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  return (
    <ChoiceDialog
      title="Project changed on disk"
      onClose={onClose}
      choices={[
        { label: 'Not now', look: 'quiet', run: onClose },
        { label: 'Load from disk', look: 'danger', run: closeAnd(onClose, () => reload(editor)) },
        { label: 'Overwrite', look: 'primary', run: closeAnd(onClose, () => save(editor, true)) },
      ]}
    >
      Another program or window changed this project after you opened it. Nothing is lost yet. Load the version on disk, or overwrite it
      with yours.
    </ChoiceDialog>
  );
}

function LockedDialog({ overwrite, onClose }: { readonly overwrite: boolean; readonly onClose: () => void }) {
  const editor = useEditor();
  return (
    <ChoiceDialog
      title="Project is locked"
      onClose={onClose}
      choices={[
        { label: 'Not now', look: 'quiet', run: onClose },
        { label: 'Break lock', look: 'danger', run: closeAnd(onClose, () => breakLockAndSave(editor, overwrite)) },
        { label: 'Try again', look: 'primary', run: closeAnd(onClose, () => save(editor, overwrite)) },
      ]}
    >
      Another window or machine is saving this project, or ended during a save. Nothing was saved. Try again in a minute, when the lock
      expires. Break the lock only if nobody else is saving.
    </ChoiceDialog>
  );
}
