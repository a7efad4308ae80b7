import { useMemo } from 'react';
import type { DepthPoint } from '../../export/captures/depth/depth-plan.ts';
import { type DepthUnit, depthUnitWord } from '../../export/captures/depth/depth-scale.ts';
import type { JudgedDepth } from '../../export/captures/depth/judge-depth.ts';
import type { FolderSurvey } from '../state/acquisition/survey-photographs.ts';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import { type PhotographsForm, UNITS } from './photographs-form.ts';

type Depth = NonNullable<FolderSurvey['depth']>;

const KIND_WORDS = { z: 'distance along the view axis', ray: 'distance along the ray of each pixel' } as const;

interface DepthSectionProps {
  readonly depth: Depth;
  readonly hasMesh: boolean;
  readonly form: PhotographsForm;
  /** Null while the other unit is not a number. */
  readonly judged: JudgedDepth | null;
  readonly onChange: (change: Partial<PhotographsForm>) => void;
}

/** What the depth files of a folder mean: what was detected, what it gives, and fields for another choice. */
export function DepthSection({ depth, hasMesh, form, judged, onChange }: DepthSectionProps) {
  const isUsed = form.from === 'auto';
  const isAround = depth.samples.every(({ pinhole }) => pinhole.isAround);
  const scale = judged?.scale;
  const detectedUnit = form.unit === 'auto' && scale ? `Detected: ${unitWords(scale.unit)}` : 'Detect';
  const detectedKind = form.kind === 'auto' && scale ? `Detected: ${scale.kind === 'z' ? 'view axis' : 'rays'}` : 'Detect';
  return (
    <fieldset className="photographs-section">
      <legend>Depth: {depth.count === 1 ? `1 ${depth.files} file` : `${depth.count} ${depth.files} files`}</legend>
      <div className="photographs-depth">
        <div className="photographs-fields">
          <ChoiceField
            label="Depth meshes from"
            value={form.from}
            options={[
              { value: 'auto' as const, label: 'Depth files' },
              ...(hasMesh ? [{ value: 'mesh' as const, label: 'The mesh' }] : []),
              ...(hasMesh ? [{ value: 'none' as const, label: 'Nothing: no depth meshes' }] : []),
            ]}
            onChoose={(from) => onChange({ from })}
          />
          {isUsed && (
            <div className="form-row">
              <ChoiceField
                label="Unit"
                value={form.unit}
                options={[{ value: 'auto' as const, label: detectedUnit }, ...UNITS]}
                onChoose={(unit) => onChange({ unit })}
              />
              {!isAround && (
                <ChoiceField
                  label="Measured"
                  value={form.kind}
                  options={[
                    { value: 'auto' as const, label: detectedKind },
                    { value: 'z' as const, label: 'Along the view axis (z)' },
                    { value: 'ray' as const, label: 'Along the ray of each pixel' },
                  ]}
                  onChoose={(kind) => onChange({ kind })}
                />
              )}
            </div>
          )}
          {isUsed && form.unit === 'other' && (
            <TextField
              label="Millimeters per unit"
              text={form.otherMm}
              error={judged === null ? 'Enter a number above 0.' : undefined}
              onChange={(otherMm) => onChange({ otherMm })}
            />
          )}
          {isUsed && judged && (
            <output className="photographs-judged">
              {scale && <p>{meaningWords(depth, form, scale.unit, scale.kind)}</p>}
              <p>
                <strong>{metersText(judged.medianM)}</strong> away in the median, <strong>{metersText(judged.farthestM)}</strong> at most.
              </p>
              {judged.problem === null ? <p>{fitWords(depth, judged)}</p> : <p className="form-error">{judged.problem}</p>}
            </output>
          )}
        </div>
        {isUsed && depth.hasCameras && judged && <DepthPlan judged={judged} isAround={isAround} />}
      </div>
    </fieldset>
  );
}

function unitWords(unit: DepthUnit): string {
  if (typeof unit === 'string') return unit === 'reconstruction' ? 'unit of the cameras' : `1 ${depthUnitWord(unit)}`;
  return unit < 1 ? `${Number((1000 * unit).toPrecision(4))} mm` : `${unit} m`;
}

function meaningWords({ samples }: Depth, { unit, kind }: PhotographsForm, meaning: DepthUnit, along: 'z' | 'ray'): string {
  const isAround = samples.every(({ pinhole }) => pinhole.isAround);
  const words = `1 unit = ${meaning === 'reconstruction' ? '1 unit of the cameras' : unitWords(meaning)}, ${isAround ? 'distance from the camera' : KIND_WORDS[along]}`;
  if (unit !== 'auto' && (isAround || kind !== 'auto')) return `${words}.`;
  const surface = samples[0]?.surface?.kind;
  return `${words}; detected by ${surface === undefined ? 'the kind of file' : surface === 'mesh' ? 'the mesh' : 'the points of the cameras'}.`;
}

function fitWords({ samples, hasCameras }: Depth, { scale, offSurface }: JudgedDepth): string {
  if (!hasCameras) return 'Compare this with the place: nothing else tells the unit before COLMAP has found the cameras.';
  if (offSurface === null || !scale) return 'Compare this with the place: there is no mesh and no point that tells the unit.';
  const surface = samples[0]?.surface?.kind === 'points' ? 'points of the cameras' : 'mesh';
  return `It differs from the ${surface} by ${percent(offSurface)} in the median.`;
}

function percent(share: number): string {
  return `${Number((100 * share).toPrecision(2))} %`;
}

function metersText(meters: number): string {
  if (!Number.isFinite(meters)) return '–';
  return meters < 0.1 ? `${Number((1000 * meters).toPrecision(3))} mm` : `${Number(meters.toPrecision(3))} m`;
}

const STEPS_M = [0.001, 0.01, 0.1, 0.5, 1, 2, 5, 10, 50, 100, 1000, 10_000];
/** At most so many lines of the grid in each direction. */
const MOST_LINES = 8;
const SIZE = 200;

/** What one photograph shows, from above: depth over the mesh, on a grid of meters. */
function DepthPlan({ judged: { plan, surfacePlan }, isAround }: { readonly judged: JudgedDepth; readonly isAround: boolean }) {
  const drawn = useMemo(() => {
    const all = [...plan, ...surfacePlan];
    const extentM = Math.max(1e-6, ...all.flatMap(([x, z]) => [Math.abs(x) * (isAround ? 1 : 2), Math.abs(z)]));
    const stepM = STEPS_M.find((step) => extentM / step <= MOST_LINES) ?? extentM;
    const perM = (SIZE * (isAround ? 0.48 : 0.96)) / extentM;
    const eyeY = isAround ? SIZE / 2 : SIZE * 0.98;
    const at = ([x, z]: DepthPoint) => `M${(SIZE / 2 + x * perM).toFixed(1)} ${(eyeY - z * perM).toFixed(1)}h0`;
    const lines = Array.from({ length: 4 * MOST_LINES + 1 }, (_, i) => (i - 2 * MOST_LINES) * stepM * perM);
    const grid = lines.map((off) => `M${(SIZE / 2 + off).toFixed(1)} 0v${SIZE}M0 ${(eyeY + off).toFixed(1)}h${SIZE}`).join('');
    return { depth: plan.map(at).join(''), surface: surfacePlan.map(at).join(''), grid, stepM, eyeY };
  }, [plan, surfacePlan, isAround]);
  const label = `One photograph from above; lines are ${metersText(drawn.stepM)} apart.`;
  return (
    <figure className="depth-plan">
      <svg viewBox={`0 0 ${SIZE} ${SIZE}`} role="img" aria-label={label}>
        <path className="depth-plan-grid" d={drawn.grid} />
        <path className="depth-plan-surface" d={drawn.surface} />
        <path className="depth-plan-depth" d={drawn.depth} />
        <path className="depth-plan-eye" d={`M${SIZE / 2} ${drawn.eyeY}h0`} />
      </svg>
      <figcaption>
        {label} In color: depth{surfacePlan.length > 0 && '; gray: the mesh'}.{!isAround && ' Walls must be straight.'}
      </figcaption>
    </figure>
  );
}
