import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import type { Program } from '../../../export/program/program.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { FromPreview, PreviewShaderError, PreviewStatus, ToPreview } from '../../preview-protocol.ts';
import { type CompileAnswer, type CompilerLink, type CompilerWorker, createCompilerLink } from '../compile/compiler-link.ts';
import { noteFileDrag, takePreviewDrop, takesDrops } from '../drops/take-drop.ts';
import type { Editor } from '../editor/editor.ts';
import { titleOfName } from '../editor/library.ts';
import { type PreviewState, towardsLight } from '../editor/preview-state.ts';
import { addToast } from '../editor/ui.ts';
import { resetViewer } from '../editor/viewer.ts';
import { createGizmoSync } from '../gizmo/apply-gizmo.ts';
import { previewRange } from '../preview/playback.ts';
import { previewSource } from '../preview/preview-source.ts';
import { saveRecordedSession } from '../preview/record-session.ts';
import { createCandidateSync, isCandidate } from './candidate-sync.ts';
import { consequenceOf } from './changes.ts';
import { type PlacedEdit, placesOf } from './param-places.ts';
import { createPosterRequests } from './preview-posters.ts';
import { createShaderTrials } from './shader-trials.ts';
import { createViewerSync } from './viewer-sync.ts';

type Captured = Extract<FromPreview, { kind: 'captured' }>;

/** Keeps the preview at the newest program and params of the document. */
export interface PreviewSync {
  /** Connects a preview page. The returned function disconnects it. */
  attach(send: (message: ToPreview) => void): () => void;
  /** Handles a message of the preview page. */
  receive(message: FromPreview): void;
  send(message: ToPreview): void;
  dispose(): void;
}

/** State that the preview source depends on. `sources` changes with each project, because its files have other URLs. */
const SOURCE_PARTS = [
  'sources',
  'sourceId',
  'views',
  'frame',
  'tier',
  'deviceKind',
  'still',
] as const satisfies readonly (keyof PreviewState)[];

interface PendingEdit extends PlacedEdit {
  readonly revision: number;
}

/**
 * Routes each change of the document: uniform params go directly to the preview; other changes are compiled, and the new program is
 * sent. Params that change during a compile are sent again after its program, which has older values.
 */
export function createPreviewSync(editor: Editor, worker: CompilerWorker): PreviewSync {
  let send: ((message: ToPreview) => void) | null = null;
  let pending: PendingEdit[] = [];
  /** Description of the source that the page plays. It contains the key of a still image instead of its bytes. */
  let asked = '';
  /** First document revision of the open project. Answers about earlier ones belong to another project. */
  let since = 0;
  const post = (message: ToPreview) => send?.(message);
  const posters = createPosterRequests(editor, post);
  const gizmoSync = createGizmoSync(editor, post);
  const trials = createShaderTrials(editor, post);
  const viewerSync = createViewerSync(editor, post, () => compile());
  const postEdit = ({ node, param, value }: PlacedEdit) => post({ kind: 'param', node, param, value });

  const setPending = (edits: PendingEdit[]) => {
    pending = edits;
    editor.compile.setState({ laterValues: edits });
  };

  const postProgram = () => {
    const { program, programRevision: revision } = editor.compile.getState();
    if (program === null || revision === null) return;
    post({ kind: 'program', revision, program });
    candidates.replaced();
    setPending(pending.filter((edit) => edit.revision > revision));
    for (const edit of pending) postEdit(edit);
    if (pending.some((edit) => !hasSlot(program, edit))) compile();
  };
  const postSource = () => {
    const source = previewSource(editor);
    // Without a page there is no answer. A new page gets the source when it is ready.
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
  const postPhysics = () => {
    const { paused, showsBodies, showsVoxels } = editor.preview.getState().physics;
    post({ kind: 'physics', action: paused ? 'pause' : 'play' });
    post({ kind: 'physics-view', bodies: showsBodies, voxels: showsVoxels });
  };
  const postSize = () => post({ kind: 'render-size', size: editor.preferences.getState().renderSize });
  const stopSize = editor.preferences.subscribe((state, before) => {
    if (state.renderSize !== before.renderSize) postSize();
  });
  const compiler: CompilerLink = createCompilerLink(worker, (answer, more) => {
    if (candidates.receive(answer) || answer.revision < since) return;
    storeAnswer(editor, answer, more);
    trials.storeAnswer(answer);
    if (answer.program !== null) postProgram();
  });
  const candidates = createCandidateSync(editor, { request: compiler.request, post, restore: () => postProgram() });
  const compile = () => {
    const { revision, project, open } = editor.document.getState();
    if (open === null) return;
    const { layout: _, ...logic } = project;
    editor.compile.setState({ busy: true });
    compiler.request({ revision, project: logic, ...viewerSync.layers() });
  };

  const stopDocument = editor.document.subscribe((state, before) => {
    const reopened = state.open?.handle !== before.open?.handle;
    if (state.project === before.project && !reopened) return;
    if (reopened) {
      since = state.revision;
      resetViewer(editor.viewer);
      setPending([]);
      trials.reset();
      editor.compile.setState({ program: null, programRevision: null, diagnostics: [] });
      // What is recorded belongs to the project before.
      editor.preview.setState({ diagnostics: [], shaderDiagnostics: [], playing: null, sessionRecording: 'no' });
      // A project that is loaded again or saved as a copy keeps its picture until the next one is there.
      const isOther = state.open?.displayPath !== before.open?.displayPath && state.project !== before.project;
      if (isOther && before.open !== null) editor.preview.setState({ foreign: true });
    }
    const consequence = reopened ? { kind: 'program' as const } : consequenceOf(before.project, state.project, state.library);
    candidates.documentChanged(consequence.kind === 'program');
    if (consequence.kind === 'program') compile();
    if (consequence.kind === 'params') {
      const places = consequence.edits.map((edit) => placesOf(state.project, edit));
      const edits = places.flatMap((placed) => placed ?? []);
      for (const edit of edits) {
        const others = pending.filter(({ node, param }) => node !== edit.node || param !== edit.param);
        setPending([...others, { ...edit, revision: state.revision }]);
        postEdit(edit);
      }
      // Without a program, the first compile is already running.
      const { program } = editor.compile.getState();
      if (program !== null && (places.includes(null) || edits.some((edit) => !hasSlot(program, edit)))) compile();
    }
  });
  const postRange = () => post({ kind: 'range', range: previewRange(editor.preview.getState()) });
  editor.transport.post = post;
  const stopSource = editor.preview.subscribe((state, before) => {
    if (state.range !== before.range || state.loop !== before.loop || state.frames !== before.frames) postRange();
    if (SOURCE_PARTS.some((part) => state[part] !== before[part])) postSource();
    if (state.roomLight !== before.roomLight) postLight();
    if (state.physics !== before.physics) postPhysics();
  });
  const receive = (message: FromPreview): void => {
    switch (message.kind) {
      case 'ready':
        // A page that was loaded again records nothing.
        editor.preview.setState({ ready: true, sessionRecording: 'no' });
        asked = '';
        postSize();
        postSource();
        if (editor.preview.getState().roomLight) postLight();
        postPhysics();
        postProgram();
        trials.sendAll();
        viewerSync.sendAll();
        gizmoSync.sendAll();
        return;
      case 'playing':
        if (message.revision >= since) editor.preview.setState({ playing: message.revision, foreign: false });
        return;
      case 'diagnostics':
        if (!isCandidate(message.revision)) editor.preview.setState({ diagnostics: message.diagnostics });
        return;
      case 'shader-errors':
        storeShaderErrors(editor, message);
        return;
      case 'trial-errors':
        trials.storeErrors(message);
        return;
      case 'status':
        storeStatus(editor, message.status);
        return;
      case 'frames':
        editor.preview.setState({ frames: message.frames, shape: message.shape, asked: null });
        return;
      case 'poster':
        posters.deliver(message.request, message.bytes);
        return;
      case 'thumbnail':
        editor.thumbnails.deliver(message.port, message.image);
        return;
      case 'file-drag':
        if (takesDrops(editor)) noteFileDrag(editor.ui);
        return;
      case 'dropped':
        takePreviewDrop(editor, message);
        return;
      case 'captured':
        saveCapture(editor, message);
        return;
      case 'session-filming':
        editor.preview.setState({ sessionRecording: 'filming' });
        addToast(editor.ui, { tone: 'info', text: 'Making the images of the recorded session…' });
        return;
      case 'session-recorded':
        void saveRecordedSession(editor, message);
        return;
      case 'panorama':
        addToast(editor.ui, { tone: message.state === 'taken' ? 'success' : 'error', text: message.text });
        return;
      case 'costs':
        editor.costs.setState({ measured: message.costs, memory: message.memory });
        return;
      case 'probed':
        editor.viewer.setState({ probed: message.probe });
        return;
      case 'gizmo':
      case 'picked':
      case 'key':
        gizmoSync.receive(message);
        return;
      // Only pages that render frames, photographs or pictures of models send these.
      case 'photographed':
      case 'rephotographed':
      case 'frame-rendered':
      case 'render-finished':
      case 'render-failed':
      case 'model-drawn':
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
        editor.preview.setState({ ready: false, playing: null, foreign: false, status: null, sessionRecording: 'no' });
      };
    },
    receive,
    send: post,
    dispose: () => {
      stopDocument();
      stopSource();
      stopSize();
      viewerSync.dispose();
      candidates.dispose();
      gizmoSync.dispose();
      compiler.dispose();
    },
  };
}

/**
 * Whether the program has a uniform slot for the param. A value may change the structure of the program: Alpha over at full opacity
 * compiles to plain blending, without opacity.
 */
function hasSlot({ slots }: Program, { node, param }: PlacedEdit): boolean {
  return Object.hasOwn(slots.params, `${node}.${param}`);
}

/** Stores an answer of the compiler. After an error the preview keeps the last program. */
function storeAnswer(editor: Editor, { revision, program, diagnostics, tookMs }: CompileAnswer, busy: boolean): void {
  editor.compile.setState({ busy, revision, diagnostics, tookMs, ...(program === null ? {} : { program, programRevision: revision }) });
}

function storeStatus({ preview }: Editor, status: PreviewStatus): void {
  // A requested frame is done once the preview shows it.
  preview.setState(({ asked }) => ({
    status,
    asked: status.state !== 'paused' || (asked === status.frame && !status.late) ? null : asked,
  }));
}

function storeShaderErrors(
  { preview, compile, document }: Editor,
  { revision, errors }: Extract<FromPreview, { kind: 'shader-errors' }>,
): void {
  const { program, programRevision } = compile.getState();
  // Ignores results of older programs.
  if (program === null || revision !== programRevision) return;
  preview.setState({
    // A newer text may have no program; the errors of its trials stay.
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

/** Saves a screenshot or video of the preview to the downloads. */
function saveCapture(editor: Editor, { what, file }: Captured): void {
  if (what === 'video') editor.preview.setState({ recording: false });
  if (file === null) {
    const text = what === 'video' ? 'The video is empty. This browser cannot record the preview.' : 'The preview shows nothing to capture.';
    addToast(editor.ui, { tone: 'error', text });
    return;
  }
  const { title } = editor.document.getState().project;
  const name = `${title.trim() === '' ? titleOfName(what) : title}.${endingOf(file.type)}`;
  editor.keepFile(file, name);
  addToast(editor.ui, { tone: 'success', text: `Saved ${name} to your downloads.` });
}

function endingOf(type: string): string {
  if (type.startsWith('image/')) return 'png';
  return type.startsWith('video/mp4') ? 'mp4' : 'webm';
}
