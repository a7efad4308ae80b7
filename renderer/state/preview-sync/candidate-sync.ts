import type { Program } from '../../../export/program/program.ts';
import type { Capability } from '../../../nodes/kit/definition.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import type { CompileAnswer, CompileRequest } from '../compile/compiler-link.ts';
import { endCandidate } from '../editor/candidate-state.ts';
import type { Editor } from '../editor/editor.ts';
import { viewedLayers } from '../preview/viewed-layers.ts';

/** Shows the candidate in the preview, and the program of the document again when it ends. */
export interface CandidateSync {
  /** Handles an answer of the compiler. Returns whether it was about a candidate. */
  receive(answer: CompileAnswer): boolean;
  /** The document changed: ends the candidate. Its image stays until the next program, if the document is compiled. */
  documentChanged(compiles: boolean): void;
  /** The preview got the program of the document. */
  replaced(): void;
  dispose(): void;
}

interface CandidateLinks {
  readonly request: (request: CompileRequest) => void;
  readonly post: (message: ToPreview) => void;
  /** Sends the program of the document. */
  readonly restore: () => void;
}

/** Whether a revision is that of a candidate. Those of the document are not negative. */
export function isCandidate(revision: number): boolean {
  return revision < 0;
}

export function createCandidateSync(editor: Editor, { request, post, restore }: CandidateLinks): CandidateSync {
  let revision = 0;
  /** Whether the preview shows a candidate. */
  let shown = false;
  /** Whether the image of an ended candidate stays until the next program of the document. */
  let stays = false;
  const stop = editor.candidate.subscribe(({ project }, before) => {
    if (project === before.project) return;
    revision--;
    if (project !== null) {
      const { layout: _, ...logic } = project;
      // Without thumbnails, which keep showing the document.
      request({ revision, project: logic, taps: viewedLayers(editor), thumbnails: [] });
    } else if (shown) {
      shown = false;
      restore();
    }
  });
  return {
    receive: (answer) => {
      if (!isCandidate(answer.revision)) {
        if (stays && answer.program === null) restore();
        return false;
      }
      const base = editor.compile.getState().program;
      if (answer.revision !== revision || editor.candidate.getState().project === null || base === null) return true;
      const program = answer.program && shownProgram(answer.program, base);
      if (program !== null) {
        shown = true;
        post({ kind: 'program', revision, program });
      } else if (shown) {
        shown = false;
        restore();
      }
      return true;
    },
    documentChanged: (compiles) => {
      if (compiles && shown) {
        shown = false;
        stays = true;
      }
      endCandidate(editor);
    },
    replaced: () => {
      shown = false;
      stays = false;
    },
    dispose: stop,
  };
}

/** What rooms and recordings give the preview without asking anybody. */
const GIVEN: readonly Capability[] = ['camera-image', 'depth', 'light-estimation'];

/**
 * The program of a candidate as the preview shows it. With the needs of the document's program where it needs the same, because the
 * session of a room begins again with other needs. Null if it needs more than is given: a choice that is only looked at must not ask for a
 * microphone or show controls.
 */
function shownProgram(program: Program, base: Program): Program | null {
  const known = new Set(base.needs.map(({ capability }) => capability));
  const more = program.needs.filter(({ capability }) => !known.has(capability));
  const controls = (program.controls ?? []).length > (base.controls ?? []).length;
  if (controls || more.some(({ capability }) => !GIVEN.includes(capability))) return null;
  return more.length === 0 ? { ...program, needs: base.needs } : program;
}
