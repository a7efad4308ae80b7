import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import type { Program } from '../../../export/program/program.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { FromPreview, PreviewShaderError, PreviewStatus, ToPreview } from '../../preview-protocol.ts';
import { type CompilerLink, type CompilerWorker, createCompilerLink } from '../compile/compiler-link.ts';
import type { CompileAnswer } from '../compile/messages.ts';
import type { Editor } from '../editor/editor.ts';
import { type PreviewState, towardsLight } from '../editor/preview-state.ts';
import { resetViewer } from '../editor/viewer.ts';
import { createGizmos } from '../gizmo/apply-gizmo.ts';
import { previewRange } from '../preview/playback.ts';
import { previewSource } from '../preview/preview-source.ts';
import { consequenceOf } from './changes.ts';
import type { PlacedEdit } from './param-places.ts';
import { placesOf } from './param-places.ts';
import { createPosterRequests } from './preview-posters.ts';
import { takeCapture } from './save-capture.ts';
import { createShaderTrials } from './shader-trials.ts';
import { createViewerSync } from './viewer-sync.ts';

/** Keeps compiler and preview up with the document. */
export interface PreviewSync {
  /** A preview page is there; what it has to know is sent once it is ready. The returned function lets it go. */
  attach(send: (message: ToPreview) => void): () => void;
  /** What the preview page says. */
  receive(message: FromPreview): void;
  send(message: ToPreview): void;
  dispose(): void;
}

/** What the source of the picture is chosen by. Sources are listed anew for every project: its files are at an address of its own. */
const SOURCE_PARTS = ['sources', 'sourceId', 'views', 'frame', 'tier', 'still'] as const satisfies readonly (keyof PreviewState)[];

interface PendingEdit extends PlacedEdit {
  readonly revision: number;
}

/**
 * The way of every change: values that may be set while running go straight to the preview; all else goes through the compiler,
 * whose newest program the preview is given. Values set while a program was being compiled are sent after it, because it was
 * made before them.
 */
export function createPreviewSync(editor: Editor, worker: CompilerWorker): PreviewSync {
  let send: ((message: ToPreview) => void) | null = null;
  let pending: PendingEdit[] = [];
  /** Where the page was told to take its picture from; a picture of one's own stands in it by its key. */
  let asked = '';
  /** Document revision with which the open project began: what is about an earlier one is another project's. */
  let since = 0;
  const post = (message: ToPreview) => send?.(message);
  const posters = createPosterRequests(editor, post);
  const gizmos = createGizmos(editor, post);
  const trials = createShaderTrials(editor, post);
  const looking = createViewerSync(editor, post, () => compile());
  const postEdit = ({ node, param, value }: PlacedEdit) => post({ kind: 'param', node, param, value });

  const setPending = (edits: PendingEdit[]) => {
    pending = edits;
    editor.compile.setState({ laterValues: edits });
  };

  const postProgram = () => {
    const { program, programRevision: revision } = editor.compile.getState();
    if (program === null || revision === null) return;
    post({ kind: 'program', revision, program });
    setPending(pending.filter((edit) => edit.revision > revision));
    for (const edit of pending) postEdit(edit);
    if (pending.some((edit) => !follows(program, edit))) compile();
  };
  const postSource = () => {
    const source = previewSource(editor);
    // Without a preview page nobody would answer; the one that comes is asked anew.
    if (source === null || send === null) return;
    const description = JSON.stringify(source);
    if (description === asked) return;
    asked = description;
    const request = editor.preview.getState().request + 1;
    editor.preview.setState({ request });
    send({ kind: 'session', source, request });
  };
  const postLight = () => {
    const { roomLight } = editor.preview.getState();
    post({ kind: 'room-light', directionWorld: roomLight && towardsLight(roomLight) });
  };
  const compiler: CompilerLink = createCompilerLink(worker, (answer, more) => {
    if (answer.revision < since) return;
    takeAnswer(editor, answer, more);
    trials.takeAnswer(answer);
    if (answer.program !== null) postProgram();
  });
  const compile = () => {
    const { revision, project, open } = editor.document.getState();
    if (open === null) return;
    const { layout: _, ...logic } = project;
    editor.compile.setState({ busy: true });
    compiler.request({ revision, project: logic, taps: looking.taps() });
  };

  const stopDocument = editor.document.subscribe((state, before) => {
    const reopened = state.open?.handle !== before.open?.handle;
    if (state.project === before.project && !reopened) return;
    if (reopened) {
      since = state.revision;
      resetViewer(editor.viewer);
      setPending([]);
      trials.forget();
      editor.compile.setState({ program: null, programRevision: null, diagnostics: [] });
      editor.preview.setState({ diagnostics: [], shaderDiagnostics: [], playing: null });
    }
    const consequence = reopened ? { kind: 'program' as const } : consequenceOf(before.project, state.project, state.library);
    if (consequence.kind === 'program') compile();
    if (consequence.kind === 'params') {
      const places = consequence.edits.map((edit) => placesOf(state.project, edit));
      const edits = places.flatMap((placed) => placed ?? []);
      for (const edit of edits) {
        const others = pending.filter(({ node, param }) => node !== edit.node || param !== edit.param);
        setPending([...others, { ...edit, revision: state.revision }]);
        postEdit(edit);
      }
      // Until there is a program, one is on its way already.
      const { program } = editor.compile.getState();
      if (program !== null && (places.includes(null) || edits.some((edit) => !follows(program, edit)))) compile();
    }
  });
  const postRange = () => post({ kind: 'range', range: previewRange(editor.preview.getState()) });
  editor.transport.post = post;
  const stopSource = editor.preview.subscribe((state, before) => {
    if (state.range !== before.range || state.loop !== before.loop || state.frames !== before.frames) postRange();
    if (SOURCE_PARTS.some((part) => state[part] !== before[part])) postSource();
    if (state.roomLight !== before.roomLight) postLight();
  });
  const receive = (message: FromPreview): void => {
    switch (message.kind) {
      case 'ready':
        editor.preview.setState({ ready: true });
        asked = '';
        postSource();
        if (editor.preview.getState().roomLight) postLight();
        postProgram();
        trials.tell();
        looking.tell();
        gizmos.tell();
        return;
      case 'playing':
        if (message.revision >= since) editor.preview.setState({ playing: message.revision });
        return;
      case 'diagnostics':
        editor.preview.setState({ diagnostics: message.diagnostics });
        return;
      case 'shader-errors':
        takeShaderErrors(editor, message);
        return;
      case 'trial-errors':
        trials.takeErrors(message);
        return;
      case 'status':
        takeStatus(editor, message.status);
        return;
      case 'frames':
        editor.preview.setState({ frames: message.frames, asked: null });
        return;
      case 'poster':
        posters.deliver(message.request, message.bytes);
        return;
      case 'thumbnail':
        editor.thumbnails.deliver(message.port, message.image);
        return;
      case 'captured':
        takeCapture(editor, message);
        return;
      case 'costs':
        editor.costs.setState({ measured: message.costs });
        return;
      case 'probed':
        editor.viewer.setState({ probed: message.probe });
        return;
      case 'gizmo':
      case 'picked':
      case 'key':
        gizmos.take(message);
        return;
      // Films are drawn by pages of their own.
      case 'frame-rendered':
      case 'render-finished':
      case 'render-failed':
        return;
      default:
        message satisfies never;
    }
  };

  return {
    attach: (to) => {
      send = to;
      editor.posters.take = posters.take;
      return () => {
        if (send !== to) return;
        send = null;
        editor.posters.take = null;
        posters.stop();
        editor.preview.setState({ ready: false, playing: null, status: null });
      };
    },
    receive,
    send: post,
    dispose: () => {
      stopDocument();
      stopSource();
      looking.dispose();
      gizmos.dispose();
      compiler.dispose();
    },
  };
}

/**
 * Whether a program takes the value while it runs. Some values decide what is drawn rather than how: an `over` at full opacity
 * is plain blending, which any other opacity has to take back.
 */
function follows({ slots }: Program, { node, param }: PlacedEdit): boolean {
  return Object.hasOwn(slots.params, `${node}.${param}`);
}

/** The last good program stays what the preview plays. */
function takeAnswer(editor: Editor, { revision, program, diagnostics, tookMs }: CompileAnswer, busy: boolean): void {
  editor.compile.setState({ busy, revision, diagnostics, tookMs, ...(program === null ? {} : { program, programRevision: revision }) });
}

function takeStatus({ preview }: Editor, status: PreviewStatus): void {
  // Once it has been shown, what was asked for is what is there.
  preview.setState(({ asked }) => ({
    status,
    asked: status.state !== 'paused' || (asked === status.frame && !status.late) ? null : asked,
  }));
}

function takeShaderErrors(
  { preview, compile, document }: Editor,
  { revision, errors }: Extract<FromPreview, { kind: 'shader-errors' }>,
): void {
  const { program, programRevision } = compile.getState();
  // An answer about an older program is of no use any more.
  if (program === null || revision !== programRevision) return;
  preview.setState({
    // A newer text may have no program: what is said of it stays.
    ...(compile.getState().revision === revision && {
      shaderDiagnostics: readShaderErrors(program, errors, document.getState().library),
    }),
    ...(errors.length > 0 && { refused: revision }),
  });
}

function readShaderErrors(program: Program, errors: readonly PreviewShaderError[], library: NodeLibrary): Diagnostic[] {
  return errors.flatMap(({ shaderId, stage, log }) => {
    const linked = program.shaders.find(({ id }) => id === shaderId);
    return linked ? driverDiagnostics(linked, log, (file) => library.shader(file), stage) : [];
  });
}
