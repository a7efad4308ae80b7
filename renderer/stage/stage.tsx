import { type ReactNode, useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { hasErrors } from '../../nodes/kit/diagnostics.ts';
import { useEditor } from '../shell/editor-context.ts';
import { useFeed } from '../shell/feed-context.ts';
import { goToStart, isHeld, stepFrames, togglePlay } from '../state/playing.ts';
import { chosenSource, frameOf, isLoading, LOCAL_SOURCES, timeOf } from '../state/preview.ts';
import { IconButton } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';
import { GizmoBar } from './gizmo-bar.tsx';
import { LookLayer } from './look-layer.tsx';
import { connectPreview } from './preview-link.ts';
import { RoomLight } from './room-light.tsx';
import './stage.css';
import { StageMenu } from './stage-menu.tsx';

/** The preview: a page of its own in a frame, the bar that moves its time, and where its picture comes from. */
export function Stage({ previewUrl }: { readonly previewUrl: string }) {
  const { preview, compile } = useEditor();
  const loading = useStore(preview, isLoading);
  const newest = useStore(compile, (state) => state.programRevision);
  const answered = useStore(preview, ({ playing, refused, asked }) => (playing === newest || refused === newest) && asked === null);
  return (
    <section className="stage" aria-label="Preview" aria-busy={loading || !answered}>
      <div className="stage-picture">
        <Device>
          <PreviewFrame url={previewUrl} />
          <Notice />
          <LookLayer />
          <GizmoBar />
        </Device>
      </div>
      <Transport />
    </section>
  );
}

/** As large as there is room, or in the shape of a device. */
function Device({ children }: { readonly children: ReactNode }) {
  const { preview } = useEditor();
  const frame = useStore(preview, (state) => state.frame);
  return (
    <div className="stage-device" data-frame={frame}>
      {children}
    </div>
  );
}

function PreviewFrame({ url }: { readonly url: string }) {
  const feed = useFeed();
  const frame = useRef<HTMLIFrameElement>(null);
  useEffect(() => {
    const element = frame.current;
    if (!element) return;
    const link = connectPreview(element, url, feed.receive);
    const detach = feed.attach(link.send);
    return () => {
      detach();
      link.dispose();
    };
  }, [feed, url]);
  return (
    <iframe
      ref={frame}
      className="stage-frame"
      title="Preview"
      allow="gamepad; microphone; camera; accelerometer; gyroscope; autoplay"
      referrerPolicy="no-referrer"
    />
  );
}

/** What the picture cannot say itself. */
function Notice() {
  const editor = useEditor();
  const state = useStore(editor.preview, (preview) => preview.status?.state ?? null);
  const loading = useStore(editor.preview, isLoading);
  const playing = useStore(editor.preview, (preview) => preview.playing);
  const hasProgram = useStore(editor.compile, (compile) => compile.program !== null);
  const refused = useStore(editor.compile, (compile) => hasErrors(compile.diagnostics));
  const unlinked = useStore(editor.preview, (preview) => hasErrors(preview.shaderDiagnostics));
  const broken = refused || unlinked;
  if (state === 'lost') return <p className="stage-notice">The graphics device was lost. The preview comes back by itself when it does.</p>;
  if (playing === null && broken && !hasProgram) {
    return <p className="stage-notice">Nothing to show yet. The problems below the graph say what is missing.</p>;
  }
  if (loading) return <p className="stage-notice stage-loading">Loading…</p>;
  if (broken) {
    return (
      <p className="stage-flag">
        <Icon name="warning" size={14} /> Showing the last version that worked
      </p>
    );
  }
  return null;
}

function Transport() {
  const editor = useEditor();
  const held = useStore(editor.preview, isHeld);
  return (
    <div className="transport" role="toolbar" aria-label="Transport">
      <IconButton icon={held ? 'play' : 'pause'} label={held ? 'Play' : 'Pause'} onPress={() => togglePlay(editor)} />
      <IconButton icon="step" label="One frame on" onPress={() => stepFrames(editor, 1)} />
      <IconButton icon="reset" label="Back to the first frame" onPress={() => goToStart(editor)} />
      <TransportTime />
      <span className="transport-gap" />
      <StageMenu />
      <RoomLight />
      <ViewsToggle />
      <SourcePicker />
    </div>
  );
}

/** Drawn anew ten times a second, and nothing with it. */
function TransportTime() {
  const { preview } = useEditor();
  const known = useStore(preview, ({ status }) => status !== null);
  const frame = useStore(preview, frameOf);
  const timeS = useStore(preview, timeOf);
  return (
    <output className="transport-time" data-tip="Time in the session and number of the frame">
      {known ? `${timeS.toFixed(2)} s` : '–'}
      <span>{known ? frame : ''}</span>
    </output>
  );
}

function SourcePicker() {
  const { preview } = useEditor();
  const sources = useStore(preview, (state) => state.sources);
  const chosen = useStore(preview, (state) => chosenSource(state)?.id ?? '');
  const groups = [
    ['Recordings', sources.filter(({ kind }) => kind === 'recorded')],
    ['Emulated rooms', sources.filter(({ kind }) => kind === 'room')],
    ['This computer', LOCAL_SOURCES],
  ] as const;
  const file = useRef<HTMLInputElement>(null);
  return (
    <>
      <input
        ref={file}
        type="file"
        hidden
        accept="image/*"
        aria-label="Picture in the camera’s place"
        onChange={({ target }) => {
          const [still] = target.files ?? [];
          if (still) preview.setState({ still, sourceId: 'still' });
          target.value = '';
        }}
      />
      <select
        className="select transport-source"
        aria-label="Where the picture comes from"
        value={chosen}
        onChange={({ target }) => {
          if (target.value === 'still') file.current?.click();
          else preview.setState({ sourceId: target.value });
        }}
      >
        {groups.map(
          ([label, list]) =>
            list.length > 0 && (
              <optgroup key={label} label={label}>
                {list.map(({ id, title }) => (
                  <option key={id} value={id}>
                    {title}
                  </option>
                ))}
              </optgroup>
            ),
        )}
      </select>
    </>
  );
}

/** A headset has two views; recordings have the one they were made with. */
function ViewsToggle() {
  const { preview } = useEditor();
  const isRoom = useStore(preview, (state) => chosenSource(state)?.kind === 'room');
  const views = useStore(preview, (state) => state.views);
  if (!isRoom) return null;
  return (
    <IconButton
      icon="eyes"
      label={views === 2 ? 'One view' : 'Two views, as in a headset'}
      pressed={views === 2}
      onPress={() => preview.setState({ views: views === 2 ? 1 : 2 })}
    />
  );
}
