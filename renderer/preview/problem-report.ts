import { phantomNodes } from '../../export/program/phantom-nodes.ts';
import type { Program } from '../../export/program/program.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { FromPreview } from '../preview-protocol.ts';

/** Reports the problems of session and player to the editor, whenever they change. */
export interface ProblemReport {
  /** Takes up a program, without a report. */
  follow(revision: number, program: Program): void;
  setSession(problems: readonly Diagnostic[]): void;
  addSession(problem: Diagnostic): void;
  setPlayer(problems: readonly Diagnostic[]): void;
  /** Forgets the problems of a player that has ended, without a report. */
  forgetPlayer(): void;
  /** Reports the problems of the player again, because they depend on the program. */
  programChanged(): void;
}

export function createProblemReport(send: (message: FromPreview) => void): ProblemReport {
  let revision = 0;
  let program: Program | null = null;
  let ofSession: readonly Diagnostic[] = [];
  let ofPlayer: readonly Diagnostic[] = [];
  /** Omits open edges of models that are not phantoms in the current program. */
  const playerProblems = (): readonly Diagnostic[] => {
    const phantoms = program === null ? new Set<string>() : phantomNodes(program);
    return ofPlayer.filter(({ code, nodeId = '' }) => code !== 'SCR035' || phantoms.has(nodeId));
  };
  const report = () => send({ kind: 'diagnostics', revision, diagnostics: [...ofSession, ...playerProblems()] });
  return {
    follow: (nextRevision, next) => {
      revision = nextRevision;
      program = next;
    },
    setSession: (problems) => {
      ofSession = problems;
      report();
    },
    addSession: (problem) => {
      ofSession = [...ofSession, problem];
      report();
    },
    setPlayer: (problems) => {
      ofPlayer = problems;
      report();
    },
    forgetPlayer: () => {
      ofPlayer = [];
    },
    programChanged: () => {
      if (ofPlayer.length > 0) report();
    },
  };
}
