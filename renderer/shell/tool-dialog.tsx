import { type ReactNode, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { HostDiagnostic } from '../../app/contract/contract.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import type { ProgramPath } from '../state/editor/preferences.ts';
import type { ToolRun, ToolStep } from '../state/editor/ui.ts';
import { cancelExport } from '../state/files/export-page.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { DialogForm } from '../ui/dialog-form.tsx';
import { TextField } from '../ui/form-fields.tsx';
import { ErrorText } from './dialog-error.tsx';
import { ExportProgress } from './export-dialog.tsx';
import './tool-dialog.css';

interface ToolDialogProps {
  readonly kind: ToolRun['dialog'];
  readonly title: string;
  /** Label of the button that begins. */
  readonly action: string;
  /** Label of the button after a failure, if the next run continues. Default: `action`. */
  readonly again?: string;
  /** Name of the program whose output is shown. */
  readonly program: string;
  readonly steps: readonly { readonly step: ToolStep; readonly label: string }[];
  /** Whether the form is complete. */
  readonly ready: boolean;
  readonly onGo: () => void;
  readonly onClose: () => void;
  /** The fields. */
  readonly children: ReactNode;
}

/** Asks for work with a program of others, and shows its steps and output. Closed meanwhile, the work goes on. */
export function ToolDialog({ kind, title, action, again = action, program, steps, ready, onGo, onClose, children }: ToolDialogProps) {
  const editor = useEditor();
  const handle = useDocument((state) => state.open?.handle ?? '');
  const exporting = useStore(editor.ui, (state) => state.exporting);
  const last = useStore(editor.ui, ({ toolRun }) => (toolRun?.handle === handle && toolRun.dialog === kind ? toolRun : null));
  const running = exporting !== null;
  const go = () => {
    if (ready && !running) onGo();
  };
  return (
    <Dialog
      title={title}
      wide
      onClose={onClose}
      actions={
        <>
          <ExportProgress />
          <Button look="quiet" onPress={onClose}>
            {running ? 'Hide' : 'Close'}
          </Button>
          {running ? (
            <Button disabled={exporting.cancelled} onPress={() => void cancelExport(editor)}>
              Cancel
            </Button>
          ) : (
            <Button look="primary" disabled={!ready} onPress={go}>
              {last?.error ? again : action}
            </Button>
          )}
        </>
      }
    >
      <DialogForm action={action} onGo={go}>
        {children}
      </DialogForm>
      {last !== null && <Progress of={last} steps={steps} program={program} />}
    </Dialog>
  );
}

interface ProgressProps extends Pick<ToolDialogProps, 'steps' | 'program'> {
  readonly of: ToolRun;
}

function Progress({ of: { step, lines, error }, steps, program }: ProgressProps) {
  const log = useRef<HTMLTextAreaElement>(null);
  const at = steps.findIndex((each) => each.step === step);
  useEffect(() => {
    if (lines.length > 0) log.current?.scrollTo({ top: log.current.scrollHeight });
  }, [lines]);
  return (
    <section className="tool-progress" aria-label="Progress">
      <ol>
        {steps.map(({ step: each, label }, i) => (
          <li key={each} data-state={i < at ? 'done' : i === at ? 'current' : 'waiting'} aria-current={i === at ? 'step' : undefined}>
            {label}
          </li>
        ))}
      </ol>
      {lines.length > 0 && (
        <textarea ref={log} className="field scroll" aria-label={`Output of ${program}`} readOnly value={lines.join('\n')} />
      )}
      {error !== null && (
        <div role="alert">
          <ErrorText text={error.message} detail={error.fix} />
        </div>
      )}
    </section>
  );
}

interface ProgramFieldProps {
  readonly title: string;
  readonly preference: ProgramPath;
  /** Why there is no such program; absent if there is one, or it is not known. */
  readonly problem: Pick<HostDiagnostic, 'message' | 'fix'> | null | undefined;
}

/** Field for the path of a program, which is kept for all projects. */
export function ProgramField({ title, preference, problem }: ProgramFieldProps) {
  const editor = useEditor();
  const path = useStore(editor.preferences, (state) => state[preference]);
  return (
    <TextField
      label={`${title} (empty: the one in PATH)`}
      text={path}
      error={problem ? problemText(problem) : undefined}
      plain
      onChange={(text) => editor.preferences.setState({ [preference]: text })}
    />
  );
}

export function problemText({ message, fix }: Pick<HostDiagnostic, 'message' | 'fix'>): string {
  return `${message} ${fix ?? ''}`.trim();
}

/** Pause in typing after which the host is asked. */
const PAUSE_MS = 300;

/**
 * What the host says about what was typed; null until it answers.
 *
 * @param key What was typed. The host is asked again when it changes; null: there is nothing to ask.
 */
export function useAnswer<T>(key: string | null, ask: () => Promise<T | null>): T | null {
  const editor = useEditor();
  const [answer, setAnswer] = useState<T | null>(null);
  const latest = useRef(ask);
  latest.current = ask;
  useEffect(() => {
    setAnswer(null);
    if (key === null) return;
    let isCurrent = true;
    const stop = editor.clock.after(PAUSE_MS, () => {
      void latest.current().then((found) => {
        if (isCurrent) setAnswer(found);
      });
    });
    return () => {
      isCurrent = false;
      stop();
    };
  }, [editor, key]);
  return answer;
}
