import { type FormEvent, useId, useState } from 'react';
import { useStore } from 'zustand';
import { startTour } from '../state/commands/tour.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { forgetProject } from '../state/editor/preferences.ts';
import { askForFolder, openPath } from '../state/files/files.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { Icon } from '../ui/icon.tsx';
import { FolderField } from './folder-field.tsx';
import './open-dialog.css';
import { ImageCard } from '../ui/image-card.tsx';

/** Start screen: recent projects, templates, examples, or a folder. */
export function OpenDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [path, setPath] = useState('');
  const [busy, setBusy] = useState(false);
  const examples = useStore(editor.document, (state) => state.examples);
  const templates = useStore(editor.document, (state) => state.templates);
  const canPick = useStore(editor.document, (state) => state.canPickFolders);
  const isStart = useStore(editor.document, (state) => state.open === null);
  const open = async (chosen: string): Promise<boolean> => {
    setBusy(true);
    const opened = await openPath(editor, chosen);
    if (opened) return true;
    // The error stands at the path that it is about.
    setPath(chosen);
    setBusy(false);
    return false;
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (path.trim() !== '') void open(path.trim());
  };
  const [firstExample] = examples.filter((example) => example.path.endsWith('first-light'));
  const tour = async (example: string) => {
    if (await open(example)) startTour(editor);
  };
  return (
    <Dialog
      title={isStart ? 'Scrim' : 'Open project'}
      size="large"
      onClose={onClose}
      actions={
        <>
          {isStart && firstExample && (
            <Button look="quiet" disabled={busy} onPress={() => void tour(firstExample.path)}>
              Take the tour
            </Button>
          )}
          <span className="open-gap" />
          <Button look="quiet" onPress={onClose}>
            Cancel
          </Button>
          {canPick && (
            <Button
              icon="folder"
              onPress={async () => {
                const picked = await askForFolder(editor, 'open');
                if (picked !== null) await open(picked);
              }}
            >
              Choose a folder…
            </Button>
          )}
          <Button look="primary" disabled={busy || path.trim() === ''} onPress={() => void open(path.trim())}>
            Open
          </Button>
        </>
      }
    >
      <div className="open-body scroll">
        <Recent busy={busy} onOpen={open} />
        <section aria-labelledby={`${id}-new`}>
          <h3 id={`${id}-new`} className="folder-heading">
            New project
          </h3>
          <ul className="open-cards">
            {templates.map(({ name, title, description, picture }) => (
              <li key={name}>
                <ImageCard
                  purpose="New project"
                  title={title}
                  text={description}
                  image={picture}
                  disabled={busy}
                  onPress={() => editor.ui.setState({ dialog: { kind: 'new', template: name } })}
                />
              </li>
            ))}
          </ul>
        </section>
        {examples.length > 0 && (
          <section aria-labelledby={`${id}-examples`}>
            <h3 id={`${id}-examples`} className="folder-heading">
              Examples
            </h3>
            <ul className="open-cards open-cards-small">
              {examples.map((example) => (
                <li key={example.path}>
                  <ImageCard title={example.title} image={example.picture} disabled={busy} onPress={() => void open(example.path)} />
                </li>
              ))}
            </ul>
          </section>
        )}
      </div>
      <form className="dialog-form open-folder" onSubmit={submit}>
        <FolderField id={id} label="Project folder" path={path} chooses="itself" onChange={setPath} />
      </form>
    </Dialog>
  );
}

function Recent({ busy, onOpen }: { readonly busy: boolean; readonly onOpen: (path: string) => Promise<boolean> }) {
  const editor = useEditor();
  const recent = useStore(editor.preferences, (state) => state.recent);
  if (recent.length === 0) return null;
  return (
    <section aria-label="Recent">
      <h3 className="folder-heading">Recent</h3>
      <ul className="folder-list open-recent">
        {recent.map(({ path, title }) => (
          <li key={path}>
            <button type="button" className="open-project" disabled={busy} data-tip={path} onClick={() => void onOpen(path)}>
              <Icon name="folder" />
              <span className="open-title">{title}</span>
              <span className="open-path">{path}</span>
            </button>
            <IconButton icon="close" label={`Remove ${title} from recent projects`} small onPress={() => forgetProject(editor, path)} />
          </li>
        ))}
      </ul>
    </section>
  );
}
