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
  /** Why figures are null, as the end of a sentence that begins with “because”. */
  readonly notMeasured: Readonly<Partial<Record<Figure, string>>>;
}

export type Figure = 'occlusion' | 'flicker' | 'contrastKept' | 'toneError';

/** What was compared: the layers with objects, the layer of the reference, and the number of pixels of a frame. */
export interface Compared {
  readonly layers: readonly ScoredLayer[];
  readonly reference: string | null;
  readonly pixels: number;
}

export function summarize(frames: readonly FrameScore[], { layers, reference, pixels }: Compared): ScoreSummary {
  const figures = {
    occlusion: occlusionOf(frames, layers),
    flicker: flickerOf(frames, pixels),
    contrastKept: contrastOf(frames),
    toneError: finite(meanOf(present(frames.map(({ tone }) => tone)))),
  };
  const reasons: Record<Figure, string> = {
    occlusion: whyNoOcclusion(frames, layers),
    flicker: whyNoFlicker(frames),
    contrastKept: 'the first frame has no details',
    toneError: whyNoTone(frames, reference),
  };
  const notMeasured = Object.fromEntries(Object.entries(reasons).filter(([figure]) => figures[figure as Figure] === null));
  return { ...figures, notMeasured };
}

function whyNoOcclusion(frames: readonly FrameScore[], layers: readonly ScoredLayer[]): string {
  if (layers.length === 0) return 'the output shows no Scene';
  if (frames.every(({ occlusion }) => occlusion.every((counts) => counts === null)))
    return 'no layer with objects has the size of the output';
  return 'no objects are in view where the depth is known';
}

function whyNoFlicker(frames: readonly FrameScore[]): string {
  if (frames.length === 1) return 'it takes two frames with depth';
  if (frames.every(({ flicker }) => flicker === null)) return 'no two frames with depth follow each other';
  return 'no frame sees the same surfaces as the previous one';
}

function whyNoTone(frames: readonly FrameScore[], reference: string | null): string {
  if (reference === null) return 'the output shows no camera video; name a layer with --reference';
  if (frames.every(({ tone }) => tone === null)) return `${reference} is not drawn`;
  return 'virtual objects cover all of the image';
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
export function scoreLines({ occlusion, flicker, contrastKept, toneError, notMeasured }: ScoreSummary): string[] {
  const beside = (value: number | null, digits: number): string => (value === null ? '' : `, the reference ${value.toFixed(digits)}`);
  const none = (figure: Figure): string => `not measured: ${notMeasured[figure]}`;
  return [
    `  occlusion   ${occlusion ? `IoU ${occlusion.visibleIou.toFixed(3)} of what is visible, ${occlusion.hiddenIou.toFixed(3)} of what is hidden (${(100 * occlusion.hiddenShare).toFixed(0)} % of the objects)` : none('occlusion')}`,
    ...(occlusion && occlusion.layers.length > 1
      ? occlusion.layers.map((one) => `    ${one.layer}: ${one.visibleIou.toFixed(3)}, ${one.hiddenIou.toFixed(3)}`)
      : []),
    `  flicker     ${flicker ? `${flicker.mean.toFixed(2)} of 255 per frame${beside(flicker.reference, 2)}; at most ${flicker.worst.toFixed(2)}, in frame ${flicker.worstFrame}; ${(100 * flicker.compared).toFixed(0)} % of the image compared` : none('flicker')}`,
    `  contrast    ${contrastKept ? `${contrastKept.least.toFixed(2)} of the first frame kept${beside(contrastKept.reference, 2)}` : none('contrastKept')}`,
    `  tone error  ${toneError === null ? none('toneError') : `${toneError.toFixed(2)} of 255`}`,
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
export function missedLimits({ occlusion, flicker, contrastKept, toneError, notMeasured }: ScoreSummary, limits: Limits): string[] {
  const missed = (figure: Figure, name: string, value: number | null | undefined, limit: number | null, isLeast: boolean): string[] => {
    if (limit === null) return [];
    if (value === undefined || value === null)
      return [`${name} is not measured, so its limit of ${limit} is missed: ${notMeasured[figure]}.`];
    const keeps = isLeast ? value >= limit : value <= limit;
    return keeps ? [] : [`${name} is ${besideLimit(value, limit)}, ${isLeast ? 'below' : 'above'} the limit of ${limit}.`];
  };
  return [
    ...missed('occlusion', 'The IoU of what is visible', occlusion?.visibleIou, limits.minIou, true),
    ...missed('flicker', 'The flicker', flicker?.mean, limits.maxFlicker, false),
    ...missed('contrastKept', 'The contrast kept', contrastKept?.least, limits.minContrast, true),
    ...missed('toneError', 'The tone error', toneError, limits.maxToneError, false),
  ];
}

/** A value with four digits, or as many as it takes to differ from its limit. */
function besideLimit(value: number, limit: number): string {
  for (let digits = 4; digits < 16; digits++) {
    const rounded = Number(value.toFixed(digits));
    if (rounded !== limit) return String(rounded);
  }
  return String(value);
}
