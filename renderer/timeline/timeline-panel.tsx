import { useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { animatedParams } from '../state/keyframes.ts';
import { selectOnly } from '../state/selection.ts';
import { ChosenBar } from './chosen-bar.tsx';
import { type ChosenKey, KeyMark } from './key-mark.tsx';
import { RangeHandles, RangeShade } from './range-handles.tsx';
import { Playhead, Ruler } from './ruler.tsx';
import { TimeBar } from './time-bar.tsx';
import { lengthOf } from './time-scale.ts';
import './timeline.css';

/** The session's time, what of it is played, and all keyframes of the open graph over it. */
export function TimelinePanel() {
  const { preview } = useEditor();
  const state = useDocument((document) => document);
  const tracks = useMemo(() => animatedParams(state), [state]);
  const [chosen, setChosen] = useState<ChosenKey | null>(null);
  const frames = useStore(preview, ({ frames }) => frames);
  const lengthS = lengthOf(tracks, frames);
  return (
    // Focusable, so that its keys work wherever it was pressed.
    <div className="timeline" tabIndex={-1}>
      <div className="timeline-bar">
        <TimeBar />
        <ChosenBar chosen={chosen} tracks={tracks} />
      </div>
      <div className="timeline-rows scroll">
        <Ruler lengthS={lengthS} />
        {tracks.map(({ node, param, label, track }) => (
          <div key={`${node}.${param}`} className="timeline-row">
            <TrackName node={node} label={label} />
            <fieldset className="timeline-lane" aria-label={`Keyframes of ${label}`}>
              {Object.entries(track.keys).map(([at, key]) => (
                <KeyMark
                  // A key keeps its place among the others while it is dragged.
                  key={at}
                  node={node}
                  param={param}
                  index={Number(at)}
                  timeS={key.timeS}
                  lengthS={lengthS}
                  chosen={chosen?.node === node && chosen.param === param && chosen.index === Number(at)}
                  onChoose={setChosen}
                />
              ))}
            </fieldset>
          </div>
        ))}
        {tracks.length === 0 && (
          <p className="timeline-none">Nothing moves by keyframes yet. Press the diamond beside a value to set the first one.</p>
        )}
        <div className="timeline-over timeline-under">
          <RangeShade lengthS={lengthS} />
        </div>
        <div className="timeline-over">
          <Playhead lengthS={lengthS} />
          <RangeHandles lengthS={lengthS} />
        </div>
      </div>
    </div>
  );
}

function TrackName({ node, label }: { readonly node: string; readonly label: string }) {
  const { selection } = useEditor();
  return (
    <button type="button" className="timeline-name" data-tip="Select the node" onClick={() => selectOnly(selection, [node])}>
      {label}
    </button>
  );
}
