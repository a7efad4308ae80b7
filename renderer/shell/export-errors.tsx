import { useStore } from 'zustand';
import { withTitles } from '../state/document/message-titles.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { goToProblem, problemKey } from '../state/problems/problems.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

/** Errors of the last export. `onShow` closes the dialog, so that the node is seen. */
export function ExportErrors({ onShow }: { readonly onShow: () => void }) {
  const editor = useEditor();
  const errors = useStore(editor.ui, (state) => state.exportErrors);
  const state = useDocument((document) => document);
  if (errors.length === 0) return null;
  return (
    <div role="alert">
      <ul className="export-errors scroll">
        {errors.map((error) => (
          <li key={problemKey(error)}>
            <Icon name="error" />
            <span className="export-error-text">
              {withTitles(state, error.message)}
              {error.fix !== undefined && <span className="export-error-fix"> {error.fix}</span>}
            </span>
            {(error.nodeId !== undefined || error.line !== undefined) && (
              <Button
                onPress={() => {
                  onShow();
                  goToProblem(editor, error);
                }}
              >
                Show
              </Button>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}
