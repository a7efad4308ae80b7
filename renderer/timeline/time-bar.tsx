import { useStore } from 'zustand';
import { type AppCommandId, runCommand } from '../state/commands/app-commands.ts';
import { useKeys } from '../state/commands/command-item.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { isHeld, playedRange } from '../state/preview/playback.ts';
import { IconButton } from '../ui/button.tsx';
import type { IconName } from '../ui/icon.tsx';

/** Transport of the timeline: playback, in and out point, and loop. */
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
      <Act command="play.in" icon="mark-in" label="Set in point" disabled={!hasFrames} />
      <Act command="play.out" icon="mark-out" label="Set out point" disabled={!hasFrames} />
      <Act command="play.loop" icon="loop" label="Loop" disabled={!hasFrames} pressed={loop} />
      {hasFrames && hasRange && <Act command="play.whole" icon="close" label="Clear play range" />}
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
    if (state.frames === null) return 'Only recordings have a play range.';
    const { from, to } = playedRange(state);
    const count = to - from + 1;
    return `${from}–${to} · ${count} ${count === 1 ? 'frame' : 'frames'}`;
  });
  return (
    <output className="timeline-words" data-tip="Frames in the play range" aria-label="Play range">
      {words}
    </output>
  );
}
