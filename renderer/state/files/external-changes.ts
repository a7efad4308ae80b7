import type { HostEvent } from '../../../app/contract/contract.ts';
import { sequence } from '../../../export/graph/commands/change.ts';
import { setSource } from '../../../export/graph/commands/shader-commands.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { apply } from '../document/apply.ts';
import { finishTyping } from '../document/edit-shader.ts';
import { isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { askWhichVersion, followFolder } from './files.ts';

type ShadersChanged = Extract<HostEvent, { kind: 'shaders-changed-outside' }>;

/**
 * Takes over shaders that another program has saved, with all that follows from their headers, as a step of the history; until
 * they are taken back, they are to be read only here. Where one of them has unsaved changes, asks which version stays.
 */
export function followShaders(editor: Editor, { handle, from, revision, shaders }: ShadersChanged): void {
  finishTyping(editor);
  const state = editor.document.getState();
  const { open, project, library } = state;
  if (open === null || open.handle !== handle) return;
  const gone = shaders.some(({ text }) => text === null);
  if (open.revision !== from || gone) {
    void followFolder(editor);
    return;
  }
  const touched = shaders.some(({ file, before, text }) => ![before, text].includes(getOwn(project.sources, file) ?? null));
  if (touched) {
    askWhichVersion(editor);
    return;
  }
  const wasClean = !isDirty(state);
  const { base, readShader } = editor.libraries;
  const change = sequence(
    project,
    ...shaders.map(
      ({ file, text }) =>
        (before: typeof project) =>
          setSource(before, { base, readShader, file, text: text ?? '', known: library }),
    ),
  );
  const files = shaders.map(({ file }) => file);
  const key = `outside ${files.join(' ')}`;
  if (!apply(editor, `Change ${files.join(', ')} outside`, change, key)) return;
  // What a header has changed in the graph is not in the folder yet.
  const isSaved = wasClean && change.project.graphs === project.graphs;
  editor.document.setState((now) => ({
    open: now.open && { ...now.open, revision },
    ...(isSaved ? { savedState: now.history.state } : {}),
  }));
  editor.ui.setState(({ outside }) => ({ outside: [...new Set([...outside, ...files])] }));
}

/** From now on the shader is typed here again; what the other program saves is still taken over. */
export function takeBack(editor: Editor, file: string): void {
  editor.ui.setState(({ outside }) => ({ outside: outside.filter((other) => other !== file) }));
}
