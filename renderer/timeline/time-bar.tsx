import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';
import { useKeys } from '../shell/use-keys.ts';
import { type AppCommandId, runCommand } from '../state/app-commands.ts';
import { isHeld, playedRange } from '../state/playing.ts';
import { IconButton } from '../ui/button.tsx';
import type { IconName } from '../ui/icon.tsx';

/** Moves through the recording, and says which part of it is played. */
export function TimeBar() {
  const { preview } = useEditor();
  const held = useStore(preview, isHeld);
  const hasFrames = useStore(preview, ({ frames }) => frames !== null);
  const hasRange = useStore(preview, ({ range }) => range !== null);
  const loop = useStore(preview, (state) => state.loop);
  return (
    <div className="timeline-time" role="toolbar" aria-label="Timeline">
      <Act command="play.first" icon="first" label="First frame" />
      <Act command="play.back" icon="step-back" label="Previous frame" disabled={!hasFrames} />
      <Act command="play.toggle" icon={held ? 'play' : 'pause'} label={held ? 'Play the timeline' : 'Pause the timeline'} />
      <Act command="play.next" icon="step" label="Next frame" />
      <Act command="play.last" icon="last" label="Last frame" disabled={!hasFrames} />
      <span className="timeline-gap" />
      <Act command="play.in" icon="mark-in" label="Begin the range here" disabled={!hasFrames} />
      <Act command="play.out" icon="mark-out" label="End the range here" disabled={!hasFrames} />
      <Act command="play.loop" icon="loop" label="Loop" disabled={!hasFrames} pressed={loop} />
      {hasFrames && hasRange && <Act command="play.whole" icon="close" label="Play all of the recording" />}
      <RangeWords />
    </div>
  );
}

interface ActProps {
  readonly command: AppCommandId;
  readonly icon: IconName;
  readonly label: string;
  readonly disabled?: boolean;
  readonly pressed?: boolean;
}

function Act({ command, icon, label, disabled = false, pressed }: ActProps) {
  const editor = useEditor();
  const keys = useKeys(command);
  return (
    <IconButton icon={icon} label={label} keys={keys} disabled={disabled} pressed={pressed} onPress={() => runCommand(editor, command)} />
  );
}

function RangeWords() {
  const { preview } = useEditor();
  const words = useStore(preview, (state) => {
    if (state.frames === null) return 'Only recordings are played in parts.';
    const { from, to } = playedRange(state);
    const count = to - from + 1;
    return `${from}–${to} · ${count} ${count === 1 ? 'frame' : 'frames'}`;
  });
  return (
    <output className="timeline-words" data-tip="Frames that are played" aria-label="Range">
      {words}
    </output>
  );
}
