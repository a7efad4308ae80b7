import { useStore } from 'zustand';
import { runCommand } from '../state/commands/app-commands.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { countProblems } from '../state/problems/problems.ts';
import { Icon } from '../ui/icon.tsx';
import './status-bar.css';
import { useProblems } from '../state/problems/use-problems.ts';

/** Status bar: problems, compiler and preview. */
export function StatusBar() {
  const editor = useEditor();
  const { error, warning, info } = countProblems(useProblems());
  const summary = error + warning === 0 ? 'No problems' : [counted(error, 'error'), counted(warning, 'warning')].filter(Boolean).join(', ');
  return (
    <footer className="status-bar">
      <button type="button" className="status-problems" onClick={() => runCommand(editor, 'view.problems')} data-tip="Show the problems">
        <span className={error > 0 ? 'status-bad' : warning > 0 ? 'status-warn' : 'status-good'}>
          <Icon name={error > 0 ? 'error' : warning > 0 ? 'warning' : 'check'} size={14} />
        </span>
        {summary}
        {info > 0 && <span className="status-quiet">{counted(info, 'note')}</span>}
      </button>
      <CompileStatus />
      <span className="status-gap" />
      <PreviewStatus />
    </footer>
  );
}

function CompileStatus() {
  const { compile } = useEditor();
  const busy = useStore(compile, (state) => state.busy);
  const tookMs = useStore(compile, (state) => state.tookMs);
  const known = useStore(compile, (state) => state.revision !== null);
  if (busy) return <span className="status-quiet">Compiling…</span>;
  return known ? <span className="status-quiet">Compiled in {Math.max(1, Math.round(tookMs))} ms</span> : null;
}

function PreviewStatus() {
  const { preview } = useEditor();
  const status = useStore(preview, (state) => state.status);
  if (!status) return null;
  return (
    <span className="status-quiet" data-tip="Preview: size in pixels, frames per second, CPU time per frame">
      {status.widthPx} × {status.heightPx}
      {status.framesPerS > 0 && ` · ${Math.round(status.framesPerS)} fps`} · {status.frameMs.toFixed(1)} ms
    </span>
  );
}

function counted(count: number, word: string): string {
  return count === 0 ? '' : `${count} ${word}${count === 1 ? '' : 's'}`;
}
