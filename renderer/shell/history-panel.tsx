import { goToStep, historySteps, savedStep } from '../state/document/apply.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import './history-panel.css';

/** The undo history as a list, oldest step first. A click shows the project after that step; later steps stay until the next change. */
export function HistoryPanel() {
  const history = useDocument((state) => state.history);
  const saved = useDocument(savedStep);
  const done = history.past.length;
  const steps = historySteps(history);
  // The oldest steps of a long history are gone.
  const first = steps[0] === undefined || steps[0].before === 0 ? 'Opened' : 'Earlier';
  const step = (label: string, count: number) => ({ label, count, done, isSaved: count === saved });
  return (
    <ol className="history scroll" aria-label="History">
      <Step {...step(first, 0)} />
      {steps.map(({ label, after }, i) => (
        <Step key={after} {...step(label, i + 1)} />
      ))}
    </ol>
  );
}

interface StepProps {
  readonly label: string;
  /** The number of steps that are done with this one. */
  readonly count: number;
  /** The number of steps that are done now. */
  readonly done: number;
  readonly isSaved: boolean;
}

function Step({ label, count, done, isSaved }: StepProps) {
  const editor = useEditor();
  return (
    <li>
      <button
        ref={count === done ? scrollTo : null}
        type="button"
        className={count > done ? 'history-step history-undone' : 'history-step'}
        aria-current={count === done ? 'step' : undefined}
        onClick={() => goToStep(editor, count)}
      >
        <span>{label}</span>
        {isSaved && <span className="history-saved">Saved</span>}
      </button>
    </li>
  );
}

/** React calls it when the step becomes the current one. */
function scrollTo(step: HTMLElement | null): void {
  step?.scrollIntoView({ block: 'nearest' });
}
