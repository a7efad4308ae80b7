import {
  addVertex,
  canAddVertex,
  copyShader,
  originalOf,
  removeVertex,
  revertShader,
  shaderOf,
  vertexOf,
} from '../state/document/edit-shader.ts';
import { titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { Button, IconButton } from '../ui/button.tsx';

interface CodeHeadProps {
  readonly node: string;
  readonly form: boolean;
  readonly comparing: boolean;
  readonly readOnly: boolean;
  /** Whether the vertex shader is shown. */
  readonly inVertex: boolean;
  readonly onVertex: (shown: boolean) => void;
  readonly onForm: (open: boolean) => void;
  readonly onCompare: (open: boolean) => void;
}

/** Header of the code panel: file, origin and shader stage, and actions on the whole shader. */
export function CodeHead({ node, form, comparing, readOnly, inVertex, onVertex, onForm, onCompare }: CodeHeadProps) {
  const editor = useEditor();
  const vertex = useDocument((state) => vertexOf(state, node));
  const hasNoVertex = useDocument((state) => canAddVertex(state, node));
  const title = useDocument((state) => titleOf(state, node));
  const name = useDocument((state) => shaderOf(state, node)?.name ?? '');
  const ofLibrary = useDocument((state) => shaderOf(state, node)?.file === null);
  const original = useDocument((state) => originalOf(editor, state, node)?.name ?? null);
  const changed = useDocument((state) => {
    const text = originalOf(editor, state, node)?.text;
    return text !== undefined && text !== shaderOf(state, node)?.text;
  });
  return (
    <div className="code-head">
      <IconButton icon="form" label="Header form" small pressed={form} disabled={inVertex} onPress={() => onForm(!form)} />
      <strong>{title}</strong>
      <code>{inVertex ? vertex : name}</code>
      {vertex !== null && (
        <fieldset className="code-files" aria-label="File">
          <Button look="quiet" pressed={!inVertex} onPress={() => onVertex(false)}>
            Fragment
          </Button>
          <Button look="quiet" pressed={inVertex} onPress={() => onVertex(true)}>
            Vertex
          </Button>
        </fieldset>
      )}
      {hasNoVertex && (
        <Button
          look="quiet"
          tip="A file beside this one that works things out once for each corner"
          disabled={readOnly}
          onPress={() => {
            if (addVertex(editor, node)) onVertex(true);
          }}
        >
          Add vertex shader
        </Button>
      )}
      <span className="code-head-gap" />
      {ofLibrary && (
        <>
          <span className="code-head-note">From the library. The first edit makes a copy in this project.</span>
          <Button look="quiet" onPress={() => void copyShader(editor, node)}>
            Copy into project
          </Button>
        </>
      )}
      {inVertex && !ofLibrary && (
        <Button
          look="quiet"
          tip="Out of the project; undo brings it back"
          disabled={readOnly}
          onPress={() => void removeVertex(editor, node)}
        >
          Remove vertex shader
        </Button>
      )}
      {original !== null && !inVertex && (
        <>
          <Button look="quiet" tip={`With ${original}`} onPress={() => onCompare(!comparing)} disabled={!changed && !comparing}>
            {comparing ? 'Stop comparing' : 'Compare with original'}
          </Button>
          <Button
            look="quiet"
            tip={`To ${original}; undo takes it back`}
            onPress={() => void revertShader(editor, node)}
            disabled={!changed || readOnly}
          >
            Revert
          </Button>
        </>
      )}
    </div>
  );
}
