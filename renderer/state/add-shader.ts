import { inTurn } from '../../export/graph/commands/change.ts';
import { addNode } from '../../export/graph/commands/nodes.ts';
import { setSource } from '../../export/graph/commands/sources.ts';
import { isShaderFile, makeNodeId } from '../../export/graph/names.ts';
import type { Project } from '../../export/graph/project.ts';
import { apply } from './apply.ts';
import type { Place } from './canvas.ts';
import type { Editor } from './editor.ts';
import { addToast } from './ui.ts';

/** One step: the shader as a file of the project, and a node of it; the node's id, or null where something is wrong, which is shown. */
export function addShader(editor: Editor, file: { readonly name: string; readonly text: string }, place: Place): string | null {
  const { text } = file;
  const { project, graph } = editor.document.getState();
  const name = freeShaderName(project, file.name);
  if (!isShaderFile(name)) {
    addToast(editor.ui, { tone: 'error', text: `${file.name} will not do as the name of a shader: rename it and drop it again.` });
    return null;
  }
  const { base, readShader } = editor.libraries;
  const read = readShader(`shaders/${name}`, text);
  if (read.output === null) {
    const [first] = read.diagnostics;
    addToast(editor.ui, {
      tone: 'error',
      text: `${file.name}: ${first?.message ?? 'its header cannot be read.'}`,
      detail: first?.fix ?? '',
    });
    return null;
  }
  const { type } = read.output;
  const id = makeNodeId(project, type, editor.random);
  const change = inTurn(
    project,
    (before) => setSource(before, { base, readShader, file: name, text }),
    (before) => addNode(before, { library: editor.libraries.of(before), graph, id, type, ...place }),
  );
  return apply(editor, `Add ${name}`, change) ? id : null;
}

function freeShaderName({ sources }: Project, wanted: string): string {
  const stem = wanted.replace(/\.[^.]*$/, '');
  const ending = wanted.slice(stem.length).toLowerCase();
  let name = `${stem}${ending}`;
  for (let number = 2; Object.hasOwn(sources, name); number++) name = `${stem}-${number}${ending}`;
  return name;
}
