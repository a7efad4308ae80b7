import { useStore } from 'zustand';
import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { isLoading } from '../state/editor/preview-state.ts';
import { canGoToProblem, goToProblem } from '../state/problems/problems.ts';
import { useProblems } from '../state/problems/use-problems.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';

/** Message over the preview: lost device, loading, or the first error, with a button that goes to its place. */
export function PreviewNotice() {
  const editor = useEditor();
  const state = useStore(editor.preview, (preview) => preview.status?.state ?? null);
  const loading = useStore(editor.preview, isLoading);
  const playing = useStore(editor.preview, (preview) => preview.playing);
  const hasProgram = useStore(editor.compile, (compile) => compile.program !== null);
  const refused = useStore(editor.compile, (compile) => hasErrors(compile.diagnostics));
  const unlinked = useStore(editor.preview, (preview) => hasErrors(preview.shaderDiagnostics));
  const problems = useProblems();
  const exported = useStore(editor.ui, (ui) => ui.exportDiagnostics);
  // What an export reports stands in its dialog.
  const ofExport = ({ code, nodeId }: Diagnostic) => exported.some((other) => other.code === code && other.nodeId === nodeId);
  const error = problems.find((problem) => problem.severity === 'error' && !ofExport(problem)) ?? null;
  const broken = refused || unlinked;
  if (state === 'lost')
    return <p className="stage-notice">The graphics device was lost. The preview continues when the device is restored.</p>;
  if (playing === null && broken && !hasProgram) {
    return (
      <div className="stage-notice stage-nothing">
        <p>Nothing to show yet. {error?.message ?? 'See the problems below the graph.'}</p>
        <Show problem={error} />
      </div>
    );
  }
  if (loading)
    return (
      <p className="stage-notice stage-loading">
        <span>Loading…</span>
      </p>
    );
  if (!broken && error === null) return null;
  return (
    <div className="stage-flag">
      <Icon name={broken ? 'warning' : 'error'} size={14} />
      {broken && <span className="stage-flag-state">Showing the last working version</span>}
      {error !== null && (
        <span className="stage-flag-text" data-tip={error.message}>
          {error.message}
        </span>
      )}
      <Show problem={error} />
    </div>
  );
}

/** Goes to the node or the line of a problem, if it has one. */
function Show({ problem }: { readonly problem: Diagnostic | null }) {
  const editor = useEditor();
  if (problem === null || !canGoToProblem(editor, problem)) return null;
  return <Button onPress={() => goToProblem(editor, problem)}>Show</Button>;
}
