import type { HostInput, OpenProject, ProjectFiles } from '../../../app/contract/contract.ts';
import { HostError } from '../../../app/contract/host-error.ts';
import { setTitle } from '../../../export/graph/commands/project-info.ts';
import { emptyHistory } from '../../../export/graph/history.ts';
import { migrateNodes } from '../../../export/graph/library/migrate-nodes.ts';
import { loadProject } from '../../../export/graph/load.ts';
import { EMPTY_LAYOUT } from '../../../export/graph/new-project.ts';
import { placeNodes } from '../../../export/graph/place-nodes.ts';
import { type GraphLayout, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { saveProject } from '../../../export/graph/save.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply, endGesture } from '../document/apply.ts';
import { finishTyping } from '../document/edit-shader.ts';
import { type DocumentState, isDirty, type OpenInfo } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { rememberProject } from '../editor/preferences.ts';
import { selectNothing } from '../editor/selection.ts';
import { addToast, clearDialogErrors, toastDiagnostic } from '../editor/ui.ts';

/** The files of the open project, with pending text edits. */
export function filesOf(editor: Editor): ProjectFiles {
  finishTyping(editor);
  return saveProject(editor.document.getState().project);
}

/** Shows a diagnostic of the host. Rethrows other errors, which are bugs. */
export function showRefusal(editor: Editor, error: unknown): void {
  if (!(error instanceof HostError)) throw error;
  toastDiagnostic(editor.ui, error.diagnostic as Diagnostic);
}

/** Opens the start screen, after asking about unsaved changes. */
export function openProject(editor: Editor): void {
  confirmUnsaved(editor, () => editor.ui.setState({ dialog: { kind: 'open' } }));
}

/** Opens the dialog for a new project, after asking about unsaved changes. */
export function newProject(editor: Editor): void {
  confirmUnsaved(editor, () => editor.ui.setState({ dialog: { kind: 'new' } }));
}

/** Calls `proceed` at once, or after the user has decided about unsaved changes. */
export function confirmUnsaved(editor: Editor, proceed: () => void): void {
  finishTyping(editor);
  if (isDirty(editor.document.getState())) editor.ui.setState({ dialog: { kind: 'unsaved', proceed } });
  else proceed();
}

/** Opens a project in place of the current one, which stays open if that fails. */
export function openPath(editor: Editor, path: string): Promise<boolean> {
  return editor.fileWork(() => openWith(editor, path, () => editor.host.call('project.open', { path })));
}

/** Creates a project from a template in a new or empty folder, and opens it in place of the current one. */
export function createProject(editor: Editor, project: HostInput<'project.create'>): Promise<boolean> {
  return editor.fileWork(() => openWith(editor, project.path, () => editor.host.call('project.create', project), true));
}

/** Opens a project and discards unsaved changes; callers ask the user first. */
async function openWith(editor: Editor, asked: string, ask: () => Promise<OpenProject>, isNew = false): Promise<boolean> {
  const { open: before } = editor.document.getState();
  clearDialogErrors(editor.ui);
  try {
    const opened = await ask();
    const discarded = isDirty(editor.document.getState());
    if (!showProject(editor, { ...opened, isNew }, opened.files)) {
      await editor.host.call('project.close', { handle: opened.handle });
      return false;
    }
    if (before) await closeProject(editor, before.handle, discarded);
    editor.ui.setState({ dialog: opened.recovery === null ? null : { kind: 'recovery', files: opened.recovery } });
    rememberProject(editor, { path: opened.displayPath, title: editor.document.getState().project.title });
    if (opened.openElsewhere) warnOfOtherWindow(editor);
    if (isCopy(editor, asked, opened.displayPath)) {
      addToast(editor.ui, { tone: 'info', text: 'Opened a copy of the example.', detail: opened.displayPath });
    }
    await listSessions(editor);
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** Whether the host opened a copy in the projects folder, because `asked` is an example. */
function isCopy({ document }: Editor, asked: string, opened: string): boolean {
  return asked !== opened && document.getState().examples.some(({ path }) => path === asked);
}

/** Closes a project that has been replaced. Failures are shown, but do not stop the caller. */
export async function closeProject(editor: Editor, handle: string, discarded: boolean): Promise<void> {
  try {
    if (discarded) await editor.host.call('project.autosave', { handle, files: null });
    await editor.host.call('project.close', { handle });
  } catch (error) {
    showRefusal(editor, error);
  }
}

function warnOfOtherWindow(editor: Editor): void {
  addToast(editor.ui, {
    tone: 'warning',
    text: 'This project is also open in another window.',
    detail: 'Saves of the other window appear here. If both change the project, you choose which version to keep.',
  });
}

/**
 * Loads the version on disk after another program changed the project. Asks first if there are unsaved changes, including those made
 * while the files are read.
 */
export function loadExternalChanges(editor: Editor): Promise<void> {
  return editor.fileWork(() => reloadFromDisk(editor));
}

async function reloadFromDisk(editor: Editor): Promise<void> {
  finishTyping(editor);
  const { open } = editor.document.getState();
  if (open === null) return;
  if (isDirty(editor.document.getState())) return openConflictDialog(editor);
  try {
    const opened = await editor.host.call('project.open', { path: open.displayPath });
    finishTyping(editor);
    const changed = isDirty(editor.document.getState());
    const taken = !changed && showProject(editor, opened, opened.files);
    await closeProject(editor, (taken ? open : opened).handle, false);
    if (taken) {
      await listSessions(editor);
      addToast(editor.ui, { tone: 'info', text: 'The project changed on disk and was reloaded.' });
      if (opened.recovery !== null) editor.ui.setState({ dialog: { kind: 'recovery', files: opened.recovery } });
    } else if (changed) openConflictDialog(editor);
  } catch (error) {
    showRefusal(editor, error);
  }
}

export function openConflictDialog(editor: Editor): void {
  editor.ui.setState({ dialog: { kind: 'changed-outside' } });
}

export interface ReadProject {
  readonly project: Project;
  readonly library: DocumentState['library'];
  readonly diagnostics: readonly Diagnostic[];
}

/** Reads the files of a project. If they are invalid, shows why and returns null. */
export function readProject(editor: Editor, files: ProjectFiles): ReadProject | null {
  const loaded = loadProject(files);
  if (loaded.output === null) {
    for (const diagnostic of loaded.diagnostics.slice(0, 3)) toastDiagnostic(editor.ui, withPlace(diagnostic));
    return null;
  }
  const library = editor.libraries.of(loaded.output);
  const { project, diagnostics } = migrateNodes(loaded.output, library);
  return { project: withPlaces(project), library, diagnostics: [...loaded.diagnostics, ...diagnostics] };
}

/** Shows a project in the editor. If the files are invalid, shows why and returns false. */
export function showProject(editor: Editor, opened: OpenInfo, files: ProjectFiles, asSaved = true): boolean {
  const read = readProject(editor, files);
  if (read === null) return false;
  selectNothing(editor.selection);
  editor.ui.setState({ outside: [] });
  const { handle, displayPath, revision, assetBaseUrl, assetFiles, isNew = false } = opened;
  editor.document.setState((state) => ({
    open: { handle, displayPath, revision, assetBaseUrl, assetFiles, isNew },
    project: read.project,
    graph: MAIN_GRAPH,
    trail: [],
    library: read.library,
    history: emptyHistory(),
    // Recovered changes are not saved yet.
    savedState: asSaved ? 0 : -1,
    revision: state.revision + 1,
    loadDiagnostics: read.diagnostics,
  }));
  return true;
}

/** Adds missing positions of nodes, such as in projects that were written by hand or merged. */
function withPlaces(project: Project): Project {
  const layout: Record<string, GraphLayout> = { ...project.layout };
  for (const [name, graph] of Object.entries(project.graphs)) {
    const known = getOwn(project.layout, name) ?? EMPTY_LAYOUT;
    layout[name] = { ...known, nodes: placeNodes(graph, known) };
  }
  return { ...project, layout };
}

export function save(editor: Editor, overwrite = false): Promise<boolean> {
  return editor.fileWork(() => write(editor, overwrite));
}

async function write(editor: Editor, overwrite: boolean): Promise<boolean> {
  const files = filesOf(editor);
  const { open, history } = editor.document.getState();
  if (open === null) return false;
  try {
    const { revision, kept } = await editor.host.call('project.save', { handle: open.handle, files, revision: open.revision, overwrite });
    editor.document.setState((state) => ({ open: state.open && { ...state.open, revision }, savedState: history.state }));
    if (kept !== null) addToast(editor.ui, { tone: 'info', text: `The previous version was kept in ${kept}.` });
    return true;
  } catch (error) {
    const code = error instanceof HostError ? error.diagnostic.code : null;
    if (code === 'SCR063') openConflictDialog(editor);
    else if (code === 'SCR066') editor.ui.setState({ dialog: { kind: 'locked', overwrite } });
    else showRefusal(editor, error);
    return false;
  }
}

/** Breaks the lock of the project and saves. */
export async function breakLockAndSave(editor: Editor, overwrite: boolean): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null) return false;
  try {
    await editor.host.call('project.break-lock', { handle: open.handle });
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
  return save(editor, overwrite);
}

/** Opens the dialog for a copy of the project. */
export function openSaveAs({ document, ui }: Pick<Editor, 'document' | 'ui'>): void {
  if (document.getState().open !== null) ui.setState({ dialog: { kind: 'save-as' } });
}

/** Saves a copy with its own title in another folder and continues with the copy. */
export function saveAs(editor: Editor, path: string, title: string): Promise<boolean> {
  return editor.fileWork(() => writeCopy(editor, path, title));
}

async function writeCopy(editor: Editor, path: string, title: string): Promise<boolean> {
  finishTyping(editor);
  const { open, project, history } = editor.document.getState();
  if (open === null) return false;
  clearDialogErrors(editor.ui);
  try {
    const files = saveProject(setTitle(project, { title }).project);
    const opened = await editor.host.call('project.save-as', { handle: open.handle, path, files });
    const { handle, displayPath, revision, assetBaseUrl, assetFiles } = opened;
    await closeProject(editor, open.handle, true);
    const isChanged = editor.document.getState().history.state !== history.state;
    endGesture(editor);
    apply(editor, 'Name the copy', setTitle(editor.document.getState().project, { title }));
    editor.document.setState((now) => ({
      open: { handle, displayPath, revision, assetBaseUrl, assetFiles },
      // Work since the copy was written is not in it.
      savedState: isChanged ? -1 : now.history.state,
    }));
    editor.ui.setState({ dialog: null });
    rememberProject(editor, { path: displayPath, title });
    addToast(editor.ui, { tone: 'success', text: `Saved to ${displayPath}.` });
    await listSessions(editor);
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** Asks for a folder with the native dialog; null if the user cancels. */
export async function askForFolder(editor: Editor, purpose: HostInput<'folder.pick'>['purpose']): Promise<string | null> {
  try {
    return (await editor.host.call('folder.pick', { purpose })).path;
  } catch (error) {
    showRefusal(editor, error);
    return null;
  }
}

/** Replaces the project in the editor by the version on disk. */
export async function reload(editor: Editor): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null) return false;
  return openPath(editor, open.displayPath);
}

/** Lists the preview sources of the open project. */
export async function listSessions(editor: Editor): Promise<void> {
  const { open } = editor.document.getState();
  if (open === null) return;
  try {
    editor.preview.setState({ sources: await editor.host.call('session.list', { handle: open.handle }) });
  } catch (error) {
    showRefusal(editor, error);
  }
}

function withPlace(diagnostic: Diagnostic): Diagnostic {
  const { file, line, message } = diagnostic;
  return file === undefined ? diagnostic : { ...diagnostic, message: `${file}${line === undefined ? '' : `:${line}`}: ${message}` };
}
