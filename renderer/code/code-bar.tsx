import { getOwn } from '../../export/graph/record.ts';
import { copyChunk } from '../state/document/edit-shader.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

interface CodeBarProps {
  /** Path of the chunk that is shown instead of the shader; null if it is the shader. */
  readonly chunk: string | null;
  /** Whether another program saved the file, which is then read-only here. */
  readonly outside: boolean;
  readonly onTakeBack: () => void;
  readonly onBack: () => void;
}

/** Bar above the text of a chunk or a read-only file: why it is read-only, and what to do. */
export function CodeBar({ chunk, outside, onTakeBack, onBack }: CodeBarProps) {
  const editor = useEditor();
  const ofLibrary = useDocument(({ project }) => chunk !== null && getOwn(project.sources, chunk) === undefined);
  if (chunk === null && !outside) return null;
  return (
    <p className={outside ? 'code-bar code-bar-outside' : 'code-bar'}>
      {outside && <Icon name="link" size={14} />}
      {chunk !== null && <code>{chunk}</code>}
      <span>{reason(chunk !== null, ofLibrary, outside)}</span>
      {chunk !== null && ofLibrary && (
        <Button look="quiet" onPress={() => void copyChunk(editor, chunk)}>
          Copy chunk into project
        </Button>
      )}
      {outside && (
        <Button look="quiet" onPress={onTakeBack}>
          Edit here
        </Button>
      )}
      {chunk !== null && (
        <Button look="quiet" onPress={onBack}>
          Back to the shader
        </Button>
      )}
    </p>
  );
}

function reason(isChunk: boolean, ofLibrary: boolean, outside: boolean): string {
  const what = isChunk ? 'chunk' : 'shader';
  if (outside) return `This ${what} was saved by another program. It is read-only here and follows the file.`;
  return ofLibrary ? 'This library chunk is read-only.' : 'Changes apply to every material of the project that includes this chunk.';
}
