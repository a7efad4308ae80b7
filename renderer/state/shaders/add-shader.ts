import { companionOf } from '../../../export/glsl/isf/read-isf.ts';
import { sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { setSource } from '../../../export/graph/commands/shader-commands.ts';
import { isShaderFile, makeNodeId, makeShaderFile } from '../../../export/graph/document-names.ts';
import type { Project } from '../../../export/graph/project.ts';
import { type AddStep, apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { placeFreely } from '../graph/free-places.ts';

/** An imported shader file. */
export interface ForeignShader {
  readonly name: string;
  readonly text: string;
  /** Text of its vertex shader. */
  readonly vertex?: string;
}

interface AddShaderOptions {
  readonly step?: AddStep;
  /** Whether the node moves to a free place; else the caller places it in the same step. */
  readonly isFree?: boolean;
}

/** Adds a shader file to the project and a node for it, as one undo step. Returns the node id, or null after an error, which is shown. */
export function addShader(
  editor: Editor,
  file: ForeignShader,
  place: Place,
  { step = {}, isFree = true }: AddShaderOptions = {},
): string | null {
  const { text, vertex } = file;
  const { project, graph } = editor.document.getState();
  const name = freeShaderName(project, file.name);
  if (!isShaderFile(name)) {
    addToast(editor.ui, { tone: 'error', text: `${file.name} is not a valid name for a shader. Rename the file and drop it again.` });
    return null;
  }
  const { base, readShader } = editor.libraries;
  const read = readShader(`shaders/${name}`, text);
  if (read.output === null) {
    const [first] = read.diagnostics;
    addToast(editor.ui, {
      tone: 'error',
      text: `${file.name}: ${first?.message ?? 'the header is invalid.'}`,
      detail: first?.fix ?? '',
    });
    return null;
  }
  const { type } = read.output;
  const id = makeNodeId(project, type, editor.random);
  const change = sequence(
    project,
    (before) => setSource(before, { base, readShader, file: name, text }),
    ...(vertex === undefined ? [] : [(before: Project) => setSource(before, { base, readShader, file: companionOf(name), text: vertex })]),
    (before) => addNode(before, { library: editor.libraries.of(before), graph, id, type, ...place }),
    (before) => {
      const { thumbnails } = editor.preferences.getState();
      return isFree
        ? placeFreely(project, { library: editor.libraries.of(before), graph, hasThumbnail: thumbnails })(before)
        : unchanged(before);
    },
  );
  return apply(editor, step.label ?? `Add ${name}`, change, step.key) ? id : null;
}

function freeShaderName({ sources }: Project, wanted: string): string {
  const given = wanted.replace(/\.[^.]*$/, '');
  const ending = wanted.slice(given.length).toLowerCase();
  // File names may contain characters that node types may not, such as “Glow+More!.fs”.
  const stem = isShaderFile(`${given}${ending}`) ? given : makeShaderFile(given).replace(/\.fs$/, '');
  let name = `${stem}${ending}`;
  for (let number = 2; Object.hasOwn(sources, name); number++) name = `${stem}-${number}${ending}`;
  return name;
}
