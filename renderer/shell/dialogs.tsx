import { useStore } from 'zustand';
import { reload, save, showProject } from '../state/files.ts';
import type { DialogRequest } from '../state/ui.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { CommandsDialog } from './commands-dialog.tsx';
import { useEditor } from './editor-context.ts';
import { FindDialog } from './find-dialog.tsx';
import { FolderDialog } from './folder-dialog.tsx';
import { LibraryNameDialog, LibraryRemoveDialog } from './library-dialogs.tsx';
import { NewDialog } from './new-dialog.tsx';
import { OpenDialog } from './open-dialog.tsx';
import { RenderDialog } from './render-dialog.tsx';
import { ShadertoyDialog } from './shadertoy-dialog.tsx';
import { ShortcutsDialog } from './shortcuts-dialog.tsx';

/** The question that is open, if one is. */
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
    case 'export':
      return <FolderDialog key={dialog.kind} purpose={dialog.kind} onClose={close} />;
    case 'render':
      return <RenderDialog onClose={close} />;
    case 'unsaved':
      return <UnsavedDialog proceed={dialog.proceed} onClose={close} />;
    case 'recovery':
      return <RecoveryDialog request={dialog} onClose={close} />;
    case 'changed-outside':
      return <ChangedOutsideDialog onClose={close} />;
    case 'shadertoy':
      return <ShadertoyDialog onClose={close} />;
    case 'library':
      return <LibraryNameDialog name={dialog.name} rename={dialog.rename === true} onClose={close} />;
    case 'library-remove':
      return <LibraryRemoveDialog name={dialog.name} onClose={close} />;
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
  return (
    <Dialog
      title={`Save the changes to “${title}”?`}
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          <Button
            look="danger"
            onPress={() => {
              onClose();
              proceed();
            }}
          >
            Do not save
          </Button>
          <Button
            look="primary"
            autoFocus
            onPress={async () => {
              if (!(await save(editor))) return;
              onClose();
              proceed();
            }}
          >
            Save
          </Button>
        </>
      }
    >
      Without saving, they are lost.
    </Dialog>
  );
}

interface RecoveryDialogProps {
  readonly request: Extract<DialogRequest, { kind: 'recovery' }>;
  readonly onClose: () => void;
}

function RecoveryDialog({ request, onClose }: RecoveryDialogProps) {
  const editor = useEditor();
  const { open } = editor.document.getState();
  const forget = async () => {
    onClose();
    if (open) await editor.host.call('project.autosave', { handle: open.handle, files: null });
  };
  return (
    <Dialog
      title="Unsaved work was found"
      // Escape decides nothing, and going on without a decision would write over that work.
      onClose={() => {}}
      actions={
        <>
          <Button look="quiet" onPress={() => void forget()}>
            Discard it
          </Button>
          <Button
            look="primary"
            autoFocus
            onPress={() => {
              onClose();
              if (open) showProject(editor, { ...open, files: request.files, recovery: null, openElsewhere: false }, request.files, false);
            }}
          >
            Restore it
          </Button>
        </>
      }
    >
      Scrim was closed before this project was saved. Restoring puts that work on the canvas; nothing is written until you save.
    </Dialog>
  );
}

function ChangedOutsideDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  return (
    <Dialog
      title="The project changed on disk"
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Not now
          </Button>
          <Button
            look="danger"
            onPress={() => {
              onClose();
              void reload(editor);
            }}
          >
            Take the version on disk
          </Button>
          <Button
            look="primary"
            autoFocus
            onPress={() => {
              onClose();
              void save(editor, true);
            }}
          >
            Save over it
          </Button>
        </>
      }
    >
      Another program, or another window, has written to this project since it was opened here. Nothing has been lost yet: decide which
      version stays.
    </Dialog>
  );
}
