import { useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { animatedParams } from '../state/params/keyframes.ts';
import { KeyframeBar } from './keyframe-bar.tsx';
import { type ChosenKeyframe, KeyframeMark } from './keyframe-mark.tsx';
import { RangeHandles, RangeShade } from './range-handles.tsx';
import { Playhead, Ruler } from './ruler.tsx';
import { TimeBar } from './time-bar.tsx';
import { lengthOf } from './time-scale.ts';
import './timeline.css';

/** Timeline: transport, ruler with play range, and the tracks of the open graph. */
export function TimelinePanel() {
  const { preview } = useEditor();
  const state = useDocument((document) => document);
  const tracks = useMemo(() => animatedParams(state), [state]);
  const [chosen, setChosen] = useState<ChosenKeyframe | null>(null);
  const frames = useStore(preview, ({ frames }) => frames);
  const lengthS = lengthOf(tracks, frames);
  return (
    // Focusable, so that shortcuts work after a press anywhere in it.
    <div className="timeline" tabIndex={-1}>
      <div className="timeline-bar">
        <TimeBar />
        <KeyframeBar chosen={chosen} tracks={tracks} />
      </div>
      <div className="timeline-rows scroll">
        <Ruler lengthS={lengthS} />
        {tracks.map(({ node, param, label, track }) => (
          <div key={`${node}.${param}`} className="timeline-row">
            <TrackName node={node} label={label} />
            <fieldset className="timeline-lane" aria-label={`Keyframes of ${label}`}>
              {Object.entries(track.keys).map(([at, key]) => (
                <KeyframeMark
                  // A keyframe keeps its index while it is dragged.
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
        {tracks.length === 0 && <p className="timeline-none">No keyframes yet. Press the diamond beside a parameter to set one.</p>}
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
