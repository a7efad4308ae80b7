import { useMemo } from 'react';
import { useStore } from 'zustand';
import { type DeviceLoss, type DeviceRow, deviceTable } from '../../export/program/devices/device-table.ts';
import { fixedImageNote } from '../../export/program/fixed-image.ts';
import { titleOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { goToNode, placeOnPath } from '../state/graph/graph-path.ts';
import { playDevice } from '../state/preview/play-device.ts';
import { IconButton } from '../ui/button.tsx';
import './devices-section.css';
import { tierWords } from './tier-words.ts';

/** What the page shows on each kind of device, and which nodes lose something there. */
export function DevicesSection() {
  const editor = useEditor();
  const program = useStore(editor.compile, (state) => state.program);
  const note = useMemo(() => program && fixedImageNote(program), [program]);
  const rows = useMemo(() => (program === null ? [] : deviceTable(program)), [program]);
  return (
    <section className="inspector-section" aria-label="Devices">
      <h3>Devices</h3>
      {note !== null && <p className="inspector-note">{note}</p>}
      {rows.length === 0 ? (
        <p className="inspector-note">The table appears when the graph compiles.</p>
      ) : (
        <ul className="device-list">
          {rows.map((row) => (
            <Row key={row.kind} row={row} />
          ))}
        </ul>
      )}
    </section>
  );
}

function Row({ row }: { readonly row: DeviceRow }) {
  const { preview } = useEditor();
  const plays = useStore(preview, ({ deviceKind }) => deviceKind === row.kind);
  const hasRoom = useStore(preview, ({ sources }) => sources.some(({ kind }) => kind === 'room'));
  const { title, tier, lost, unseen, worthless, display } = row;
  return (
    <li className="device-row">
      <div className="device-head">
        <span className="device-title">{title}</span>
        <IconButton
          icon="play"
          label={`Play as ${title}`}
          small
          pressed={plays}
          disabled={!hasRoom && tier !== 'camera' && tier !== 'orbit'}
          onPress={() => void playDevice(preview, row)}
        />
      </div>
      <p className={worthless ? 'device-tier device-worthless' : 'device-tier'}>
        {tierWords(tier)}
        {display === 'additive' && ', additive display'}
        {worthless ? ': a required feature is missing.' : lost.length === 0 && unseen.length === 0 && ': everything works.'}
      </p>
      {unseen.length > 0 && <p className="device-tier">Shadows are invisible: use Negative shadow instead of {unseen.join(', ')}.</p>}
      {lost.length > 0 && (
        <ul className="device-losses">
          {lost.map((loss) => (
            <Loss key={`${loss.node} ${loss.capability}`} loss={loss} />
          ))}
        </ul>
      )}
    </li>
  );
}

function Loss({ loss: { node, effect, fact } }: { readonly loss: DeviceLoss }) {
  const editor = useEditor();
  const title = useDocument(({ project, library }) => {
    const place = placeOnPath(project, node);
    return place ? titleOf({ project, library, graph: place.graph }, place.node) : node;
  });
  const show = () => {
    const place = placeOnPath(editor.document.getState().project, node);
    if (place) goToNode(editor, place);
  };
  return (
    <li data-tip={`${fact.source} (${fact.date})`}>
      <button type="button" className="device-node" onClick={show}>
        {title}
      </button>
      : {fact.has === 'no' ? effect : `Not known. Perhaps: ${effect}`}
    </li>
  );
}
