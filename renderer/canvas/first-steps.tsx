import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { openProject } from '../state/files/files.ts';
import { isBlank, startFilter, startObject } from '../state/graph/first-steps.ts';
import { Button } from '../ui/button.tsx';

/** Says what to do first while the graph holds nothing but the camera and the output. */
export function FirstSteps({ isEmpty }: { readonly isEmpty: boolean }) {
  const editor = useEditor();
  const blank = useDocument(isBlank);
  if (!blank && !isEmpty) return null;
  return (
    <section className={isEmpty ? 'canvas-empty' : 'canvas-empty canvas-start'} aria-label="First steps">
      <p>{blank ? 'Where do you want to start?' : 'This graph is empty.'}</p>
      {blank && (
        <div className="canvas-first">
          <Button icon="filter" onPress={() => startFilter(editor)}>
            Filter the camera
          </Button>
          <Button icon="cube" onPress={() => void startObject(editor)}>
            Place an object in the room
          </Button>
          <Button icon="folder" onPress={() => openProject(editor)}>
            Open an example
          </Button>
        </div>
      )}
      <p>
        {blank ? 'Or press' : 'Press'} <kbd>Tab</kbd> or double-click to add a node, or drop a model or an image.
      </p>
    </section>
  );
}
