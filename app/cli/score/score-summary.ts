import { meanOf, type Sum } from '../../../export/score/mean-of.ts';
import { type OcclusionCounts, occlusionIou } from '../../../export/score/occlusion.ts';
import type { FrameScore, ScoredLayer } from './score.page.ts';

/** What frames have together. A figure is null where the project or the session lacks what it is measured against. */
export interface ScoreSummary {
  readonly occlusion: {
    /** Over all layers and frames. */
    readonly visibleIou: number;
    readonly hiddenIou: number;
    /** The part of the objects that is truly hidden. */
    readonly hiddenShare: number;
    readonly layers: readonly {
      readonly layer: string;
      readonly visibleIou: number;
      readonly hiddenIou: number;
      readonly hiddenShare: number;
    }[];
  } | null;
  /** Per frame, in steps of 8 bits. */
  readonly flicker: {
    readonly mean: number;
    readonly worst: number;
    readonly worstFrame: number;
    readonly reference: number | null;
    /** The part of the image that is compared, from 0 to 1. */
    readonly compared: number;
  } | null;
  /** The least contrast of a frame, relative to the first frame. */
  readonly contrastKept: { readonly least: number; readonly reference: number | null } | null;
  /** In steps of 8 bits. */
  readonly toneError: number | null;
}

/** @param pixels Number of pixels of a frame. */
export function summarize(frames: readonly FrameScore[], layers: readonly ScoredLayer[], pixels: number): ScoreSummary {
  return {
    occlusion: occlusionOf(frames, layers),
    flicker: flickerOf(frames, pixels),
    contrastKept: contrastOf(frames),
    toneError: finite(meanOf(present(frames.map(({ tone }) => tone)))),
  };
}

function present<T>(values: readonly (T | null | undefined)[]): T[] {
  return values.filter((value) => value !== null && value !== undefined);
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}

function occlusionOf(frames: readonly FrameScore[], layers: readonly ScoredLayer[]): ScoreSummary['occlusion'] {
  const seen = layers.flatMap(({ shown }, i) => {
    const counts = present(frames.map(({ occlusion }) => occlusion[i]));
    return counts.some(({ all }) => all > 0) ? [{ layer: shown, counts }] : [];
  });
  if (seen.length === 0) return null;
  const figures = (counts: readonly OcclusionCounts[]) => {
    const { visible, hidden, hiddenShare } = occlusionIou(counts);
    return { visibleIou: visible, hiddenIou: hidden, hiddenShare };
  };
  return { ...figures(seen.flatMap(({ counts }) => counts)), layers: seen.map(({ layer, counts }) => ({ layer, ...figures(counts) })) };
}

function flickerOf(frames: readonly FrameScore[], pixels: number): ScoreSummary['flicker'] {
  const steps = frames.flatMap(({ index, flicker }) => (flicker && flicker.count > 0 ? [{ index, flicker }] : []));
  const [first] = steps;
  if (!first) return null;
  const rate = ({ sum, count }: Sum): number => sum / count;
  const worst = steps.reduce((most, step) => (rate(step.flicker) > rate(most.flicker) ? step : most), first);
  return {
    mean: meanOf(steps.map(({ flicker }) => flicker)),
    worst: rate(worst.flicker),
    worstFrame: worst.index,
    reference: finite(meanOf(present(frames.map(({ referenceFlicker }) => referenceFlicker)))),
    compared: steps.reduce((sum, { flicker }) => sum + flicker.count, 0) / (steps.length * pixels),
  };
}

function contrastOf(frames: readonly FrameScore[]): ScoreSummary['contrastKept'] {
  const least = leastKept(frames.map(({ contrast }) => contrast));
  return least === null ? null : { least, reference: leastKept(present(frames.map(({ referenceContrast }) => referenceContrast))) };
}

/** The least of the values, relative to the first one; null without a value above 0 to compare with. */
function leastKept([first = 0, ...others]: readonly number[]): number | null {
  return first > 0 ? Math.min(1, ...others.map((value) => value / first)) : null;
}

/** The summary as lines for people. */
export function scoreLines({ occlusion, flicker, contrastKept, toneError }: ScoreSummary): string[] {
  const beside = (value: number | null, digits: number): string => (value === null ? '' : `, the reference ${value.toFixed(digits)}`);
  const none = (why: string): string => `not measured: ${why}`;
  return [
    `  occlusion   ${occlusion ? `IoU ${occlusion.visibleIou.toFixed(3)} of what is visible, ${occlusion.hiddenIou.toFixed(3)} of what is hidden (${(100 * occlusion.hiddenShare).toFixed(0)} % of the objects)` : none('no objects are in view')}`,
    ...(occlusion && occlusion.layers.length > 1
      ? occlusion.layers.map((one) => `    ${one.layer}: ${one.visibleIou.toFixed(3)}, ${one.hiddenIou.toFixed(3)}`)
      : []),
    `  flicker     ${flicker ? `${flicker.mean.toFixed(2)} of 255 per frame${beside(flicker.reference, 2)}; at most ${flicker.worst.toFixed(2)}, in frame ${flicker.worstFrame}; ${(100 * flicker.compared).toFixed(0)} % of the image compared` : none('it takes two frames with depth that see the same surfaces')}`,
    `  contrast    ${contrastKept ? `${contrastKept.least.toFixed(2)} of the first frame kept${beside(contrastKept.reference, 2)}` : none('the first frame has no details')}`,
    `  tone error  ${toneError === null ? none('the output shows no camera video; name a layer with --reference') : `${toneError.toFixed(2)} of 255`}`,
  ];
}

/** Limits of the options; null where there is none. */
export interface Limits {
  readonly minIou: number | null;
  readonly maxFlicker: number | null;
  readonly minContrast: number | null;
  readonly maxToneError: number | null;
}

/** What is wrong, one sentence per limit that is missed. A limit on a figure that could not be measured is missed. */
export function missedLimits({ occlusion, flicker, contrastKept, toneError }: ScoreSummary, limits: Limits): string[] {
  const lowest = (name: string, value: number | undefined, limit: number | null): string[] =>
    limit === null || (value !== undefined && value >= limit) ? [] : [`${name} is ${said(value)}, below the limit of ${limit}.`];
  const highest = (name: string, value: number | null | undefined, limit: number | null): string[] =>
    limit === null || (value !== undefined && value !== null && value <= limit)
      ? []
      : [`${name} is ${said(value)}, above the limit of ${limit}.`];
  return [
    ...lowest('The IoU of what is visible', occlusion?.visibleIou, limits.minIou),
    ...highest('The flicker', flicker?.mean, limits.maxFlicker),
    ...lowest('The contrast kept', contrastKept?.least, limits.minContrast),
    ...highest('The tone error', toneError, limits.maxToneError),
  ];
}

function said(value: number | null | undefined): string {
  return value === undefined || value === null ? 'not measured' : String(Number(value.toFixed(4)));
}
