import { useEffect, useState } from 'react';
import type { PreviewProbe } from '../preview-protocol.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerName } from '../state/editor/layer-names.ts';
import type { PickRequest } from '../state/editor/viewer.ts';
import { scaleToLength, standOnFloor } from '../state/params/true-size.ts';
import { formatNumber, parseNumber } from '../state/params/units.ts';
import { Button } from '../ui/button.tsx';

type Point = NonNullable<PreviewProbe['depth']>['positionWorld'];

/** What is being picked: nothing, a point of the floor, or one of two points whose distance is known. */
type Step = { readonly kind: 'idle' | 'floor' | 'first' } | { readonly kind: 'second'; readonly first: Point };

/**
 * Gives a capture its true size: by the known distance of two points that are clicked in the preview, and by a click on the floor, which then
 * is at height 0.
 */
export function TrueSizeSection({ id }: { readonly id: string }) {
  const editor = useEditor();
  const { viewer } = editor;
  const layer = useDocument((state) => layerName(state, id, 'layer'));
  const [step, setStep] = useState<Step>({ kind: 'idle' });
  const [measuredM, setMeasuredM] = useState<number | null>(null);
  const [missed, setMissed] = useState(false);
  useEffect(() => {
    if (step.kind === 'idle') return;
    const label = { floor: 'Floor', first: 'First point', second: 'Second point' }[step.kind];
    const take = ({ depth }: PreviewProbe) => {
      setMissed(depth === null);
      if (depth === null) setStep({ kind: 'idle' });
      else if (step.kind === 'first') setStep({ kind: 'second', first: depth.positionWorld });
      else {
        if (step.kind === 'floor') standOnFloor(editor, id, depth.positionWorld[1]);
        if (step.kind === 'second') setMeasuredM(distance(step.first, depth.positionWorld));
        setStep({ kind: 'idle' });
      }
    };
    const onEnd = () => setStep((now) => (now === step ? { kind: 'idle' } : now));
    const request: PickRequest = { label, what: 'point', layer, take, onEnd };
    viewer.setState({ picking: request, probed: null });
    return () => {
      if (viewer.getState().picking === request) viewer.setState({ picking: null });
    };
  }, [editor, viewer, layer, id, step]);
  const start = (kind: 'floor' | 'first') => {
    setMeasuredM(null);
    setMissed(false);
    setStep({ kind });
  };
  return (
    <section className="inspector-section" aria-label="True size">
      <h3>True size</h3>
      <Button icon="probe" onPress={() => start('first')}>
        Set scale by two points
      </Button>
      <Button icon="probe" onPress={() => start('floor')}>
        Put floor at height 0
      </Button>
      <output className="inspector-note">
        {step.kind === 'first' && 'Click a point in the preview whose distance to another one you know.'}
        {step.kind === 'second' && 'Click the other point.'}
        {step.kind === 'floor' && 'Click the floor in the preview.'}
        {missed && 'There is no surface at this point. Pick another one.'}
      </output>
      {measuredM !== null && (
        <KnownLength
          measuredM={measuredM}
          onTake={(trueM) => {
            if (scaleToLength(editor, id, measuredM, trueM)) setMeasuredM(null);
          }}
        />
      )}
    </section>
  );
}

function distance([ax, ay, az]: Point, [bx, by, bz]: Point): number {
  return Math.hypot(bx - ax, by - ay, bz - az);
}

function KnownLength({ measuredM, onTake }: { readonly measuredM: number; readonly onTake: (trueM: number) => void }) {
  const [text, setText] = useState('');
  const [wrong, setWrong] = useState(false);
  const submit = () => {
    const trueM = parseNumber(text, 'm');
    const isLength = trueM !== null && trueM > 0 && measuredM > 0;
    setWrong(!isLength);
    if (isLength) onTake(trueM);
  };
  return (
    <form
      className="true-size"
      onSubmit={(event) => {
        event.preventDefault();
        submit();
      }}
    >
      <p className="inspector-note">The points are {formatNumber(Number(measuredM.toFixed(3)))} m apart now.</p>
      <label>
        True distance (m)
        <input
          className="field"
          type="text"
          inputMode="decimal"
          value={text}
          aria-invalid={wrong}
          onChange={(event) => setText(event.target.value)}
        />
      </label>
      {wrong && <p role="alert">Enter a distance above 0, such as 0.9.</p>}
      <Button onPress={submit}>Set scale</Button>
    </form>
  );
}
