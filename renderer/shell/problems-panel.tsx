import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { withTitles } from '../state/document/message-titles.ts';
import type { DocumentState } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { goToProblem, problemKey } from '../state/problems/problems.ts';
import { quickFixOf } from '../state/problems/quick-fixes.ts';
import { useProblems } from '../state/problems/use-problems.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';
import './problems-panel.css';

/** Problems of the project, errors first. Each links to its node, port or line. */
export function ProblemsPanel() {
  const editor = useEditor();
  const problems = useProblems();
  const state = useDocument((document) => document);
  if (problems.length === 0) {
    return (
      <div className="problems-none">
        <Icon name="check" />
        No problems.
      </div>
    );
  }
  return (
    <ul className="problems scroll" aria-label="Problems">
      {problems.map((problem) => (
        <li key={problemKey(problem)} className="problem-row">
          <button type="button" className="problem" onClick={() => goToProblem(editor, problem)}>
            <span className={`problem-icon problem-${problem.severity}`}>
              <Icon name={problem.severity} />
              <span className="visually-hidden">{problem.severity}</span>
            </span>
            <span className="problem-text">
              {problem.message}
              {problem.fix !== undefined && <span className="problem-fix"> {problem.fix}</span>}
            </span>
            <span className="problem-place">{placeOf(problem, state)}</span>
            <code className="problem-code">{problem.code}</code>
          </button>
          <Fix problem={problem} />
        </li>
      ))}
    </ul>
  );
}

function Fix({ problem }: { readonly problem: Diagnostic }) {
  const editor = useEditor();
  const fix = quickFixOf(editor, problem);
  return fix && <Button onPress={() => fix.run(editor)}>{fix.label}</Button>;
}

function placeOf({ nodeId, port, file, line }: Diagnostic, state: DocumentState): string {
  const node = nodeId === undefined ? '' : withTitles(state, port === undefined ? nodeId : `${nodeId}.${port}`);
  const place = file === undefined ? '' : `${file}${line === undefined ? '' : `:${line}`}`;
  return [node, place].filter(Boolean).join(' · ');
}
