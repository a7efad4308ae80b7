import { type ReactNode, useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { runCommand } from '../state/commands/app-commands.ts';
import { togglePreviewExtent } from '../state/commands/command-actions.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import type { StopReason } from '../state/editor/preview-state.ts';
import { chosenSource, frameOf, isLoading, LOCAL_SOURCES, shownFrame, shownShape, timeOf } from '../state/editor/preview-state.ts';
import { goToStart, isHeld, stepFrames, togglePlay } from '../state/preview/playback.ts';
import { popOutPreview } from '../state/preview/pop-out.ts';
import { startPreview } from '../state/preview/stopped-preview.ts';
import { usePreviewSync } from '../state/preview-sync/preview-sync-context.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { PhysicsMenu } from './physics-menu.tsx';
import { PictureDrop } from './picture-drop.tsx';
import { PopOut } from './pop-out.tsx';
import { PosterGuide } from './poster-guide.tsx';
import { connectPreview } from './preview-link.ts';
import { PreviewNotice } from './preview-notice.tsx';
import { PreviewRail } from './preview-rail.tsx';
import { RoomLight } from './room-light.tsx';
import { SafeAreas } from './safe-areas.tsx';
import { ViewerOverlay } from './viewer-overlay.tsx';
import './preview-panel.css';
import { PreviewMenu } from './preview-menu.tsx';

/** The preview page in an iframe, its overlays, and the transport with the preview source. */
export function PreviewPanel({ previewUrl }: { readonly previewUrl: string }) {
  const editor = useEditor();
  const { preview, compile } = editor;
  const loading = useStore(preview, isLoading);
  const newest = useStore(compile, (state) => state.programRevision);
  const answered = useStore(preview, ({ playing, refused, asked }) => (playing === newest || refused === newest) && asked === null);
  const stopped = useStore(preview, (state) => state.stopped);
  const poppedOut = useStore(preview, (state) => state.poppedOut);
  const picture = (
    <Device>
      {stopped === null ? (
        <>
          <PreviewFrame url={previewUrl} />
          <SafeAreas />
          <PreviewNotice />
          <ViewerOverlay />
          <PosterGuide />
          <PictureDrop />
        </>
      ) : (
        <StoppedNotice reason={stopped} />
      )}
    </Device>
  );
  return (
    <section className="stage" aria-label="Preview" aria-busy={stopped === null && (loading || !answered)}>
      <div className="stage-image">
        <PreviewRail />
        <div className="stage-room">
          {stopped === null && poppedOut ? (
            <>
              <PopOut>{picture}</PopOut>
              <div className="stage-notice stage-stopped">
                <p>The preview is in its own window.</p>
                <Button onPress={() => popOutPreview(editor, false)}>Show it here</Button>
              </div>
            </>
          ) : (
            picture
          )}
        </div>
      </div>
      <Transport />
    </section>
  );
}

/** Gives the preview the shape of a device, a recording or a camera, or fits it to the panel. */
function Device({ children }: { readonly children: ReactNode }) {
  const { preview } = useEditor();
  const frame = useStore(preview, shownFrame);
  const shape = useStore(preview, shownShape);
  return (
    <div
      className="stage-device"
      data-frame={frame}
      {...(shape !== null && { 'data-shaped': '', style: { ['--shape' as string]: shape } })}
    >
      {children}
    </div>
  );
}

function PreviewFrame({ url }: { readonly url: string }) {
  const previewSync = usePreviewSync();
  const foreign = useStore(useEditor().preview, (state) => state.foreign);
  const frame = useRef<HTMLIFrameElement>(null);
  useEffect(() => {
    const element = frame.current;
    if (!element) return;
    const link = connectPreview(element, url, previewSync.receive);
    const detach = previewSync.attach(link.send);
    return () => {
      detach();
      link.dispose();
    };
  }, [previewSync, url]);
  return (
    <iframe
      ref={frame}
      className="stage-frame"
      data-foreign={foreign ? '' : undefined}
      title="Preview"
      allow="gamepad; microphone; camera; accelerometer; gyroscope; autoplay"
      referrerPolicy="no-referrer"
    />
  );
}

const STOPPED: Readonly<Record<StopReason, string>> = {
  lost: 'The preview is stopped. The graphics device was lost when this project was last open: its shaders or models may be too demanding.',
  'broken-off': 'The preview is stopped. Scrim ended during playback when this project was last open.',
  asked: 'The preview is stopped. Shift was held while the project opened.',
};

/** Shown in place of a stopped preview, with a button that starts it. */
function StoppedNotice({ reason }: { readonly reason: StopReason }) {
  const editor = useEditor();
  return (
    <div className="stage-notice stage-stopped" role="status">
      <p>{STOPPED[reason]}</p>
      <Button onPress={() => startPreview(editor)}>Start preview</Button>
    </div>
  );
}

function Transport() {
  const editor = useEditor();
  const held = useStore(editor.preview, isHeld);
  return (
    <div className="transport" role="toolbar" aria-label="Transport">
      <IconButton icon={held ? 'play' : 'pause'} label={held ? 'Play' : 'Pause'} onPress={() => togglePlay(editor)} />
      <IconButton icon="step" label="Next frame" onPress={() => stepFrames(editor, 1)} />
      <IconButton icon="reset" label="Go to first frame" onPress={() => goToStart(editor)} />
      <TransportTime />
      <span className="transport-gap" />
      <PhysicsMenu />
      <PreviewMenu />
      <RoomLight />
      <ViewsToggle />
      <PopOutButton />
      <FullScreenToggle />
      <SourcePicker />
    </div>
  );
}

/** Session time and frame number. They are a component of their own, because they rerender ten times a second. */
function TransportTime() {
  const { preview } = useEditor();
  const known = useStore(preview, ({ status }) => status !== null);
  const frame = useStore(preview, frameOf);
  const timeS = useStore(preview, timeOf);
  return (
    <output className="transport-time" data-tip="Session time and frame number">
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
  const options = groups.flatMap(([group, list]) => list.map(({ id, title }) => ({ value: id, label: title, group })));
  const file = useRef<HTMLInputElement>(null);
  return (
    <>
      <input
        ref={file}
        type="file"
        hidden
        accept="image/*"
        aria-label="Image instead of the camera"
        onChange={({ target }) => {
          const [still] = target.files ?? [];
          if (still) preview.setState({ still, sourceId: 'still' });
          target.value = '';
        }}
      />
      <div className="transport-source">
        <SelectField
          label="Preview source"
          value={chosen}
          options={options}
          onChoose={(sourceId) => {
            if (sourceId === 'still') file.current?.click();
            else preview.setState({ sourceId });
          }}
        />
      </div>
    </>
  );
}

function PopOutButton() {
  const editor = useEditor();
  const poppedOut = useStore(editor.preview, (state) => state.poppedOut);
  const label = poppedOut ? 'Show the preview here' : 'Pop out preview';
  return <IconButton icon="pop-out" label={label} pressed={poppedOut} onPress={() => runCommand(editor, 'view.pop-out')} />;
}

function FullScreenToggle() {
  const editor = useEditor();
  const extent = useStore(editor.ui, (state) => state.previewExtent);
  const isFull = extent !== 'panel';
  return (
    <IconButton
      icon="fit"
      label={isFull ? 'Leave full screen' : 'Full-screen preview'}
      pressed={isFull}
      onPress={() => togglePreviewExtent(editor, isFull ? extent : 'full')}
    />
  );
}

/** Switches an emulated room between one view and two. Recordings have fixed views. */
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
