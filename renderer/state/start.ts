import { debounce } from '../clock.ts';
import { showToolEvent } from './acquisition/outside-run.ts';
import { type AppCommandId, appCommandIds, runCommand } from './commands/app-commands.ts';
import { finishTyping } from './document/edit-shader.ts';
import { isDirty } from './editor/document.ts';
import type { Editor } from './editor/editor.ts';
import { openStartScreen } from './editor/ui.ts';
import { showExportProgress } from './files/export-page.ts';
import { applyExternalShaders } from './files/external-changes.ts';
import { confirmUnsaved, filesOf, loadExternalChanges, openPath, showRefusal } from './files/files.ts';
import { listRecipes } from './recipes/list-recipes.ts';

/** Pause in editing after which autosave writes. */
const AUTOSAVE_MS = 2000;
/** Longest time without an autosave during continuous edits. A crash loses at most five seconds of work, including the time to write. */
const AUTOSAVE_AT_MOST_MS = 4000;
/** Key of the path of the open project in the storage of the window. */
const OPEN_KEY = 'scrim-open';

/** Requests information about the host. Returns the URL of the preview, and whether the window has native menus. */
export async function start(editor: Editor): Promise<{ readonly previewUrl: string; readonly hasMenu: boolean }> {
  const info = await editor.host.call('app.info', {});
  const { canPickFolders, canReveal, projectsDir, examples, templates } = info;
  editor.document.setState({ canPickFolders, canReveal, projectsDir, examples, templates });
  await listRecipes(editor);
  return { previewUrl: info.previewUrl, hasMenu: info.shell === 'electron' };
}

/** Opens the project that this window showed before it was reloaded; at its first start, the one that the host was started with. */
export async function openFirst(editor: Editor, storage: Pick<Storage, 'getItem'>): Promise<void> {
  const path = storage.getItem(OPEN_KEY) ?? (await editor.host.call('app.info', {})).startPath;
  const opened = path !== null && (await openPath(editor, path));
  if (!opened) openStartScreen(editor.ui);
}

/** Stores the path of the open project for reloads. `storage`: that of this window, which ends with it. */
export function keepOpenPath({ document }: Pick<Editor, 'document'>, storage: Pick<Storage, 'setItem'>): () => void {
  return document.subscribe(({ open }, before) => {
    if (open !== null && open.displayPath !== before.open?.displayPath) storage.setItem(OPEN_KEY, open.displayPath);
  });
}

/** Writes unsaved changes to the recovery files. */
export function autosave(editor: Editor): () => void {
  let last = '';
  const write = () => {
    const state = editor.document.getState();
    if (state.open === null || !isDirty(state)) return;
    const work = `${state.open.handle} ${state.history.state}`;
    if (work === last) return;
    last = work;
    editor.host
      .call('project.autosave', { handle: state.open.handle, files: filesOf(editor) })
      .catch((error: unknown) => showRefusal(editor, error));
  };
  const keep = debounce(editor.clock, AUTOSAVE_MS, write, AUTOSAVE_AT_MOST_MS);
  const stop = editor.document.subscribe((state, before) => {
    if (state.history.state !== before.history.state) keep.trigger();
  });
  return () => {
    stop();
    keep.cancel();
  };
}

/** Handles events of the host: menu commands, changes on disk, and the close button. */
export function handleHostEvents(editor: Editor, runFromMenu: (id: AppCommandId) => void = (id) => runCommand(editor, id)): () => void {
  return editor.host.subscribe((event) => {
    switch (event.kind) {
      case 'menu':
        for (const id of appCommandIds()) if (id === event.command) runFromMenu(id);
        return;
      case 'project-changed-outside':
        if (event.handle === editor.document.getState().open?.handle) void loadExternalChanges(editor);
        return;
      case 'export-progress':
        showExportProgress(editor, event.handle, event.text);
        return;
      case 'tool-progress':
      case 'tool-log':
        showToolEvent(editor, event);
        return;
      case 'shaders-changed-outside':
        applyExternalShaders(editor, event);
        return;
      case 'close-requested':
        confirmUnsaved(editor, () => void close(editor));
        return;
      default:
        event satisfies never;
    }
  });
}

/** Closes the window after changes have been saved or discarded. */
function close(editor: Editor): Promise<void> {
  return editor.fileWork(async () => {
    const { open } = editor.document.getState();
    editor.document.setState(({ history }) => ({ savedState: history.state }));
    // If the recovery files cannot be deleted, the next start offers them again; the window closes anyway.
    if (open !== null) await editor.host.call('project.autosave', { handle: open.handle, files: null }).catch(() => {});
    await editor.host.call('app.close', {});
  });
}

/** Whether the page must ask before it unloads. */
export function hasUnsavedWork(editor: Editor): boolean {
  finishTyping(editor);
  return isDirty(editor.document.getState());
}
