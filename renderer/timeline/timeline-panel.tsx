import { type PointerEvent, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import type { Keyframe, Track } from '../../export/graph/project.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useFeed } from '../shell/feed-context.ts';
import { animatedParams, setEasing, setRepeat } from '../state/keyframes.ts';
import { timeOf } from '../state/preview.ts';
import { selectOnly } from '../state/selection.ts';
import { KeyMark } from './key-mark.tsx';
import { lengthOf, marksOf, percentOf } from './time-scale.ts';
import './timeline.css';

export interface ChosenKey {
  readonly node: string;
  readonly param: string;
  readonly index: number;
}

const EASINGS: readonly (readonly [Keyframe['easing'], string])[] = [
  ['linear', 'Evenly'],
  ['ease-in', 'Slow at first'],
  ['ease-out', 'Slow at last'],
  ['ease-in-out', 'Slow at both ends'],
  ['step', 'In a step'],
];
const REPEATS: readonly (readonly [Track['repeat'], string])[] = [
  ['once', 'Once'],
  ['loop', 'Again and again'],
  ['mirror', 'To and fro'],
];

/** All keyframes of the open graph over the session's time. */
export function TimelinePanel() {
  const state = useDocument((document) => document);
  const tracks = useMemo(() => animatedParams(state), [state]);
  const [chosen, setChosen] = useState<ChosenKey | null>(null);
  const lengthS = lengthOf(tracks);
  if (tracks.length === 0) {
    return <p className="timeline-none">Nothing moves by keyframes yet. Press the diamond beside a value to set the first one.</p>;
  }
  return (
    <div className="timeline">
      <ChosenBar chosen={chosen} tracks={tracks} />
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
        <Playhead lengthS={lengthS} />
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

/** What can be chosen for the key that is: how it goes on to the next, and what comes after the last. */
function ChosenBar({ chosen, tracks }: { readonly chosen: ChosenKey | null; readonly tracks: ReturnType<typeof animatedParams> }) {
  const editor = useEditor();
  const track = tracks.find(({ node, param }) => node === chosen?.node && param === chosen.param)?.track;
  const key = chosen === null ? undefined : track?.keys[chosen.index];
  if (!chosen || !track || !key) return <div className="timeline-bar">Drag keys, or choose one to change how it goes on.</div>;
  return (
    <div className="timeline-bar">
      <output>{key.timeS.toFixed(2)} s</output>
      <label>
        To the next key{' '}
        <select
          className="select"
          value={key.easing}
          onChange={(event) => void setEasing(editor, chosen.node, chosen.param, chosen.index, event.target.value as Keyframe['easing'])}
        >
          {EASINGS.map(([easing, words]) => (
            <option key={easing} value={easing}>
              {words}
            </option>
          ))}
        </select>
      </label>
      <label>
        Play{' '}
        <select
          className="select"
          value={track.repeat}
          onChange={(event) => void setRepeat(editor, chosen.node, chosen.param, event.target.value as Track['repeat'])}
        >
          {REPEATS.map(([repeat, words]) => (
            <option key={repeat} value={repeat}>
              {words}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

/** Seconds. Pressed or dragged, recordings go to that moment and hold. */
function Ruler({ lengthS }: { readonly lengthS: number }) {
  const feed = useFeed();
  const seek = (event: PointerEvent<HTMLElement>) => {
    const { left, width } = event.currentTarget.getBoundingClientRect();
    const timeS = Math.max(0, Math.min(1, (event.clientX - left) / width)) * lengthS;
    feed.send({ kind: 'seek', timeS });
  };
  return (
    <div className="timeline-row">
      <span />
      <div
        className="timeline-ruler"
        data-tip="Go to a moment"
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          feed.send({ kind: 'transport', action: 'pause' });
          seek(event);
        }}
        onPointerMove={(event) => {
          if (event.currentTarget.hasPointerCapture(event.pointerId)) seek(event);
        }}
      >
        {marksOf(lengthS).map((markS) => (
          <span key={markS} style={{ left: percentOf(markS, lengthS) }}>
            {markS} s
          </span>
        ))}
      </div>
    </div>
  );
}

function Playhead({ lengthS }: { readonly lengthS: number }) {
  const { preview } = useEditor();
  const timeS = useStore(preview, timeOf);
  return (
    <div className="timeline-head" aria-hidden="true">
      {timeS <= lengthS && <span style={{ left: percentOf(timeS, lengthS) }} />}
    </div>
  );
}
