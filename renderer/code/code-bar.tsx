import { own } from '../../export/graph/own.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { copyChunk } from '../state/edit-shader.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

interface CodeBarProps {
  /** The chunk that is looked at in the place of the shader's text. */
  readonly chunk: string | null;
  /** Another program has saved what is shown. */
  readonly outside: boolean;
  readonly onTakeBack: () => void;
  readonly onBack: () => void;
}

/** Over the text: whose it is where it is a chunk, why it cannot be typed in, and the ways out. */
export function CodeBar({ chunk, outside, onTakeBack, onBack }: CodeBarProps) {
  const editor = useEditor();
  const ofLibrary = useDocument(({ project }) => chunk !== null && own(project.sources, chunk) === undefined);
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
          Edit it here
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
  if (outside) return `Another program has saved this ${what}: it is read only here, and follows what is saved there.`;
  return ofLibrary ? 'A chunk of the library, to be read.' : 'A chunk of this project, in all its techniques that include it.';
}
