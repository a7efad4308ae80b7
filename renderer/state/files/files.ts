import type { HostInput, OpenProject, ProjectFiles } from '../../../app/contract/contract.ts';
import { HostError } from '../../../app/contract/host-error.ts';
import { emptyHistory } from '../../../export/graph/history.ts';
import { migrateNodes } from '../../../export/graph/library/migrate-nodes.ts';
import { loadProject } from '../../../export/graph/load.ts';
import { EMPTY_LAYOUT } from '../../../export/graph/new-project.ts';
import { placeNodes } from '../../../export/graph/place-nodes.ts';
import { type GraphLayout, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { saveProject } from '../../../export/graph/save.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { finishTyping } from '../document/edit-shader.ts';
import { isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { rememberProject } from '../editor/preferences.ts';
import { selectNothing } from '../editor/selection.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';

/** The texts that the open project would be saved as, with what is being typed at the moment. */
export function filesOf(editor: Editor): ProjectFiles {
  finishTyping(editor);
  return saveProject(editor.document.getState().project);
}

/** Shows what the host refused; rethrows every other error, which is a fault of the program. */
export function showRefusal(editor: Editor, error: unknown): void {
  if (!(error instanceof HostError)) throw error;
  toastDiagnostic(editor.ui, error.diagnostic as Diagnostic);
}

/** Asks what to open, after asking about unsaved work. */
export function openProject(editor: Editor): void {
  withoutUnsaved(editor, () => editor.ui.setState({ dialog: { kind: 'open' } }));
}

/** Asks what to begin with, after asking about unsaved work. */
export function newProject(editor: Editor): void {
  withoutUnsaved(editor, () => editor.ui.setState({ dialog: { kind: 'new' } }));
}

/** Goes on at once, or after the person has decided what becomes of unsaved work. */
export function withoutUnsaved(editor: Editor, proceed: () => void): void {
  finishTyping(editor);
  if (isDirty(editor.document.getState())) editor.ui.setState({ dialog: { kind: 'unsaved', proceed } });
  else proceed();
}

/** Opens a folder in place of what is open. Where it cannot be read, what is open stays. */
export function openPath(editor: Editor, path: string): Promise<boolean> {
  return editor.fileWork(() => goOnWith(editor, () => editor.host.call('project.open', { path })));
}

/** Makes a project from a template, in a new or an empty folder, and opens it in place of what is open. */
export function createProject(editor: Editor, path: string, template: string): Promise<boolean> {
  return editor.fileWork(() => goOnWith(editor, () => editor.host.call('project.create', { path, template })));
}

/** The caller has asked what becomes of unsaved work: what is unsaved now is discarded. */
async function goOnWith(editor: Editor, ask: () => Promise<OpenProject>): Promise<boolean> {
  const { open: before } = editor.document.getState();
  try {
    const opened = await ask();
    const givenUp = isDirty(editor.document.getState());
    if (!showProject(editor, opened, opened.files)) {
      await editor.host.call('project.close', { handle: opened.handle });
      return false;
    }
    if (before) await letGo(editor, before.handle, givenUp);
    editor.ui.setState({ dialog: opened.recovery === null ? null : { kind: 'recovery', files: opened.recovery } });
    rememberProject(editor, { path: opened.displayPath, title: editor.document.getState().project.title });
    if (opened.openElsewhere) tellOfOtherWindow(editor);
    await listSessions(editor);
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** Of a project that another one has taken the place of. What cannot be tidied up is told, and no reason not to go on. */
async function letGo(editor: Editor, handle: string, givenUp: boolean): Promise<void> {
  try {
    if (givenUp) await editor.host.call('project.autosave', { handle, files: null });
    await editor.host.call('project.close', { handle });
  } catch (error) {
    showRefusal(editor, error);
  }
}

function tellOfOtherWindow(editor: Editor): void {
  addToast(editor.ui, {
    tone: 'warning',
    text: 'This project is open in another window, too.',
    detail: 'What is saved there shows up here. If both change it, you are asked which version stays.',
  });
}

/**
 * Takes the folder's version after somebody else has written it, where nothing here would be lost by that; else asks. What is
 * done while the files are read counts, too.
 */
export function followFolder(editor: Editor): Promise<void> {
  return editor.fileWork(() => takeFolder(editor));
}

async function takeFolder(editor: Editor): Promise<void> {
  finishTyping(editor);
  const { open } = editor.document.getState();
  if (open === null) return;
  if (isDirty(editor.document.getState())) return askWhichVersion(editor);
  try {
    const opened = await editor.host.call('project.open', { path: open.displayPath });
    finishTyping(editor);
    const changed = isDirty(editor.document.getState());
    const taken = !changed && showProject(editor, opened, opened.files);
    await letGo(editor, (taken ? open : opened).handle, false);
    if (taken) {
      await listSessions(editor);
      addToast(editor.ui, { tone: 'info', text: 'The project changed on disk and was loaded again.' });
      if (opened.recovery !== null) editor.ui.setState({ dialog: { kind: 'recovery', files: opened.recovery } });
    } else if (changed) askWhichVersion(editor);
  } catch (error) {
    showRefusal(editor, error);
  }
}

export function askWhichVersion(editor: Editor): void {
  editor.ui.setState({ dialog: { kind: 'changed-outside' } });
}

/** Puts files on the canvas; false, with the reasons shown, where they are no project. */
export function showProject(editor: Editor, opened: OpenProject, files: ProjectFiles, asSaved = true): boolean {
  const loaded = loadProject(files);
  if (loaded.output === null) {
    for (const diagnostic of loaded.diagnostics.slice(0, 3)) toastDiagnostic(editor.ui, withPlace(diagnostic));
    return false;
  }
  const library = editor.libraries.of(loaded.output);
  const { project, diagnostics } = migrateNodes(loaded.output, library);
  selectNothing(editor.selection);
  editor.ui.setState({ outside: [] });
  const { handle, displayPath, revision, assetBaseUrl, assetFiles } = opened;
  editor.document.setState((state) => ({
    open: { handle, displayPath, revision, assetBaseUrl, assetFiles },
    project: withPlaces(project),
    graph: MAIN_GRAPH,
    trail: [],
    library,
    history: emptyHistory(),
    // Recovered work is unsaved by definition.
    savedState: asSaved ? 0 : -1,
    revision: state.revision + 1,
    loadDiagnostics: [...loaded.diagnostics, ...diagnostics],
  }));
  return true;
}

/** A project that was written by hand, or merged, may not say of every node where it stands: it is told once, for good. */
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
    if (kept !== null) addToast(editor.ui, { tone: 'info', text: `What was there before is kept in ${kept}.` });
    return true;
  } catch (error) {
    const code = error instanceof HostError ? error.diagnostic.code : null;
    if (code === 'SCR063') askWhichVersion(editor);
    else if (code === 'SCR066') editor.ui.setState({ dialog: { kind: 'locked', overwrite } });
    else showRefusal(editor, error);
    return false;
  }
}

/** Takes the project's lock from its holder, and saves. */
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

/** Saves a copy into another folder and goes on there. */
export async function saveAs(editor: Editor, chosen?: string): Promise<boolean> {
  if (editor.document.getState().open === null) return false;
  const path = chosen ?? (await pickFolder(editor, 'save-as'));
  return path !== null && editor.fileWork(() => writeCopy(editor, path));
}

async function writeCopy(editor: Editor, path: string): Promise<boolean> {
  const files = filesOf(editor);
  const { open, history } = editor.document.getState();
  if (open === null) return false;
  try {
    const opened = await editor.host.call('project.save-as', { handle: open.handle, path, files });
    const { handle, displayPath, revision, assetBaseUrl, assetFiles } = opened;
    await letGo(editor, open.handle, true);
    editor.document.setState({ open: { handle, displayPath, revision, assetBaseUrl, assetFiles }, savedState: history.state });
    editor.ui.setState({ dialog: null });
    addToast(editor.ui, { tone: 'success', text: `Saved to ${displayPath}.` });
    await listSessions(editor);
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  }
}

/** The shell's own dialog; where it has none, ours, which comes back with a typed path. */
export async function pickFolder(editor: Editor, purpose: 'save-as' | 'export'): Promise<string | null> {
  if (editor.document.getState().canPickFolders) return askForFolder(editor, purpose);
  editor.ui.setState({ dialog: { kind: purpose } });
  return null;
}

/** By the shell's own dialog; null where the person chose none. */
export async function askForFolder(editor: Editor, purpose: HostInput<'folder.pick'>['purpose']): Promise<string | null> {
  try {
    return (await editor.host.call('folder.pick', { purpose })).path;
  } catch (error) {
    showRefusal(editor, error);
    return null;
  }
}

/** Takes the folder's version in place of what is on the canvas. */
export async function reload(editor: Editor): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null) return false;
  return openPath(editor, open.displayPath);
}

/** What the preview can take its picture from, at the addresses that the open project has now. */
async function listSessions(editor: Editor): Promise<void> {
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
