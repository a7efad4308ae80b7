import { debounce } from '../clock.ts';
import { type AppCommandId, appCommandIds, runCommand } from './commands/app-commands.ts';
import { finishTyping } from './document/edit-shader.ts';
import { isDirty } from './editor/document.ts';
import type { Editor } from './editor/editor.ts';
import { showExportProgress } from './files/export-page.ts';
import { followShaders } from './files/external-changes.ts';
import { filesOf, followFolder, openPath, showRefusal, withoutUnsaved } from './files/files.ts';

/** Unsaved work goes to the disk when nothing was done for so long… */
const AUTOSAVE_MS = 2000;
/** …and after so long in any case: five seconds are lost at most, with the time that writing takes. */
const AUTOSAVE_AT_MOST_MS = 4000;

/** Asks the host what it is. Returns the preview's address, and whether the window has a menu of its own. */
export async function start(editor: Editor): Promise<{ readonly previewUrl: string; readonly hasMenu: boolean }> {
  const info = await editor.host.call('app.info', {});
  editor.document.setState({ canPickFolders: info.canPickFolders, examples: info.examples, templates: info.templates });
  return { previewUrl: info.previewUrl, hasMenu: info.shell === 'electron' };
}

export async function openFirst(editor: Editor): Promise<void> {
  const { startPath } = await editor.host.call('app.info', {});
  const opened = startPath !== null && (await openPath(editor, startPath));
  if (!opened) editor.ui.setState({ dialog: { kind: 'open' } });
}

/** Keeps unsaved work where it is found again after a crash. */
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

/** What the host says unasked: its menu, changes on disk, the window's close button. */
export function followHost(editor: Editor, runFromMenu: (id: AppCommandId) => void = (id) => runCommand(editor, id)): () => void {
  return editor.host.subscribe((event) => {
    switch (event.kind) {
      case 'menu':
        for (const id of appCommandIds()) if (id === event.command) runFromMenu(id);
        return;
      case 'project-changed-outside':
        if (event.handle === editor.document.getState().open?.handle) void followFolder(editor);
        return;
      case 'export-progress':
        showExportProgress(editor, event.handle, event.text);
        return;
      case 'shaders-changed-outside':
        followShaders(editor, event);
        return;
      case 'close-requested':
        withoutUnsaved(editor, () => void close(editor));
        return;
      default:
        event satisfies never;
    }
  });
}

/** The work that is open has been saved or given up. */
function close(editor: Editor): Promise<void> {
  return editor.fileWork(async () => {
    const { open } = editor.document.getState();
    editor.document.setState(({ history }) => ({ savedState: history.state }));
    // What the disk does not let go of is offered again at the next opening, and is no reason to stay.
    if (open !== null) await editor.host.call('project.autosave', { handle: open.handle, files: null }).catch(() => {});
    await editor.host.call('app.close', {});
  });
}

/** For the page's own guard: asks before a reload throws work away. */
export function hasUnsavedWork(editor: Editor): boolean {
  finishTyping(editor);
  return isDirty(editor.document.getState());
}
