import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { getOwn } from '../../export/graph/record.ts';
import { type FoundLamps, NO_LAMPS } from '../../nodes/kit/panorama/found-lamps.ts';
import { graphOf, nodeOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { isOfOneLamp, MAX_CHANGED, pinLamp } from '../state/lamps/edit-lamps.ts';
import { type LampView, searchLamps, startLampWorker } from '../state/lamps/lamp-search.ts';
import { LAMPS_TYPE, lampSourceOf } from '../state/lamps/lamp-source.ts';
import type { LampStage } from '../state/lamps/messages.ts';
import { Button } from '../ui/button.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { LampImage } from './lamp-image.tsx';
import { ParamRow } from './param-row.tsx';
import './lamps-section.css';

const STAGES: Readonly<Record<LampStage['kind'], string>> = { picture: 'Panorama', gray: 'Gray', threshold: 'Threshold', median: 'Median' };

/** The panorama of a node with the lamps that are found in it, which can be dragged, and the steps of the search. */
export function LampsSection({ id }: { readonly id: string }) {
  const editor = useEditor();
  // Compared as text, so that the search starts again only if it would find something else.
  const text = useDocument((state) => JSON.stringify(lampSourceOf(state, id)));
  const [view, setView] = useState<LampView | null>(null);
  useEffect(() => {
    const source = JSON.parse(text) as ReturnType<typeof lampSourceOf>;
    setView(null);
    return source === null ? undefined : searchLamps(editor, source, startLampWorker, setView);
  }, [editor, text]);
  return (
    <section className="inspector-section" aria-label="Lamps" aria-busy={view?.state === 'searching'}>
      <h3>Lamps</h3>
      {text === 'null' ? (
        <p className="inspector-note">Connect a node with a panorama file to see its lamps here.</p>
      ) : view === null || view.state === 'searching' ? (
        <progress className="lamps-progress" aria-label="Searching the panorama" value={view?.part ?? 0} />
      ) : view.state === 'failed' ? (
        <p className="inspector-note">{view.reason}</p>
      ) : (
        <Found id={id} found={view.found} stages={view.stages} />
      )}
    </section>
  );
}

interface FoundProps {
  readonly id: string;
  readonly found: FoundLamps;
  readonly stages: readonly LampStage[];
}

function Found({ id, found, stages }: FoundProps) {
  const editor = useEditor();
  const [shown, setShown] = useState(0);
  const lamp = useStore(editor.gizmo, (state) => Math.min(state.lamp, Math.max(1, found.lamps.length)));
  const stage = stages[shown] ?? stages[0];
  const step = stage && stage.kind !== 'picture' ? found.steps[stage.iteration] : undefined;
  if (!stage) return null;
  return (
    <>
      {stages.length > 1 && (
        <SelectField
          label="Step of the search"
          value={shown}
          options={stages.map(({ kind, iteration }, value) => ({
            value,
            label: kind === 'picture' ? STAGES[kind] : `${iteration + 1}: ${STAGES[kind]}`,
          }))}
          onChoose={setShown}
        />
      )}
      <LampImage id={id} found={found} stage={stage} step={step} chosen={lamp} onChoose={(next) => editor.gizmo.setState({ lamp: next })} />
      {step && <Histogram step={step} />}
      {found.none !== null && <p className="inspector-note">No lamp was found: {NO_LAMPS[found.none]}.</p>}
      {lamp <= Math.min(found.lamps.length, MAX_CHANGED) && <Lamp id={id} found={found} lamp={lamp} />}
    </>
  );
}

/**
 * Histogram of a step: the number of pixels per gray level on a square-root scale, with a line at the threshold, 93 % of the brightest
 * level.
 */
function Histogram({ step: { histogram, max, mean, threshold, abovePart } }: { readonly step: FoundLamps['steps'][number] }) {
  const path = useMemo(() => {
    const most = Math.max(...histogram.map(Math.sqrt));
    return `M0 1${[...histogram].map((count, level) => `L${level / 255} ${(1 - Math.sqrt(count) / most).toFixed(4)}`).join('')}L1 1Z`;
  }, [histogram]);
  return (
    <figure className="lamps-histogram">
      <svg viewBox="0 0 1 1" preserveAspectRatio="none" role="img" aria-label="Histogram">
        <path d={path} />
        <line x1={threshold / 255} x2={threshold / 255} y1="0" y2="1" />
      </svg>
      <figcaption className="inspector-note">
        Brightest {max}, mean {mean.toFixed(1)}, ratio {mean > 0 ? (max / mean).toFixed(2) : '–'}. Above 93 % (level {threshold.toFixed(0)}
        ): {(abovePart * 100).toFixed(2)} % of the pixels.
      </figcaption>
    </figure>
  );
}

interface LampProps {
  readonly id: string;
  readonly found: FoundLamps;
  readonly lamp: number;
}

/** The params of one lamp. */
function Lamp({ id, found, lamp }: LampProps) {
  const editor = useEditor();
  const definition = useDocument((state) => state.library.definition(LAMPS_TYPE));
  const params = useDocument((state) => nodeOf(state, id)?.params);
  const wires = useDocument((state) => graphOf(state).wires);
  const pinned = params && getOwn(params, `lamp${lamp}Pinned`);
  const isPinned = pinned !== undefined && 'value' in pinned && pinned.value === true;
  if (!definition || !params) return null;
  const rows = Object.entries(definition.params).filter(
    ([name]) => isOfOneLamp(name) && name.startsWith(`lamp${lamp}`) && !(isPinned ? /Pinned$/ : /Pinned$|Rad$/).test(name),
  );
  return (
    <>
      <Button
        tip="A pinned lamp stays where it is when the panorama or the search changes."
        onPress={() => pinLamp(editor, id, lamp, found, !isPinned)}
      >
        {isPinned ? `Unpin lamp ${lamp}` : `Pin lamp ${lamp}`}
      </Button>
      {rows.map(([name, param]) => (
        <ParamRow
          key={name}
          node={id}
          name={name}
          param={param}
          binding={getOwn(params, name)}
          source={wires.find(({ to }) => to.node === id && to.port === name)?.from}
        />
      ))}
    </>
  );
}
