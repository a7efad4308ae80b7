import { clampToRange } from '../../../export/graph/library/param-value.ts';
import type { Binding, Keyframe, Track } from '../../../export/graph/project.ts';
import { type ParamDefinition, type ParamValue, paramWireType } from '../../../nodes/kit/definition.ts';
import { type Easing, ease } from '../../../nodes/kit/ease.ts';
import { timeInTrack } from '../../../nodes/kit/track-time.ts';
import { type DocumentState, graphOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { type BoundParam, bind, findParam } from './bound-param.ts';
import { boundValue } from './value-text.ts';

/** Precision of keyframe times, and least distance between the keyframes of a param: one frame. */
const STEP_S = 0.001;
export const FRAME_S = 1 / 60;

export interface AnimatedParam {
  readonly node: string;
  readonly param: string;
  /** Titles of the node and the param. */
  readonly label: string;
  readonly track: Track;
}

/** Whether a param can have keyframes: numbers, vectors and colors that update at once. */
export function isAnimatable(param: ParamDefinition): boolean {
  const type = paramWireType(param);
  return type !== undefined && type !== 'text' && type !== 'toggle' && param.type !== 'choice';
}

/** All tracks of the open graph. */
export function animatedParams(state: DocumentState): readonly AnimatedParam[] {
  return Object.entries(graphOf(state).nodes).flatMap(([node, { type, params }]) =>
    Object.entries(params).flatMap(([param, binding]) => {
      if (!('track' in binding)) return [];
      const label = state.library.definition(type)?.params[param]?.label ?? param;
      return [{ node, param, label: `${titleOf(state, node)} · ${label}`, track: binding.track }];
    }),
  );
}

/** Value of a track as in `nodes/binding/track`, clamped to the range of the param. */
export function valueAt(param: ParamDefinition, track: Track, timeS: number): ParamValue {
  return clampToRange(param, valueBetweenKeys(track, timeS));
}

function valueBetweenKeys({ keys, repeat }: Track, timeS: number): ParamValue {
  const times = Float64Array.from(keys, (key) => key.timeS);
  const within = timeInTrack(timeS, times, repeat);
  const after = keys.findIndex((key) => key.timeS > within);
  const index = Math.max((after === -1 ? keys.length : after) - 1, 0);
  const [from, to] = [keys[index], keys[index + 1]];
  if (!from) return 0;
  if (!to || within <= from.timeS) return from.value;
  const progress = ease(from.easing, (within - from.timeS) / (to.timeS - from.timeS));
  const mix = (a: number, b: number) => (progress === 1 ? b : a + (b - a) * progress);
  if (typeof from.value === 'number') return mix(from.value, Number(to.value));
  const end = typeof to.value === 'number' ? [] : to.value;
  return from.value.map((part, i) => mix(part, end[i] ?? part));
}

/** Index of the keyframe at a time, within half a frame; -1 if there is none. */
export function keyAt({ keys }: Track, timeS: number): number {
  return keys.findIndex((key) => Math.abs(key.timeS - timeS) < FRAME_S / 2);
}

/** Sets a keyframe with the current value, or deletes the one at this time. Without keyframes, the track is removed. */
export function toggleKey(editor: Editor, node: string, param: string, timeS: number): boolean {
  const found = findAnimatable(editor, node, param);
  if (!found) return false;
  const { definition, binding } = found;
  const track = trackOf(binding);
  const at = track === null ? -1 : keyAt(track, timeS);
  if (track !== null && at !== -1) return removeKey(editor, node, param, at);
  const value = track === null ? boundValue(definition, binding) : valueAt(definition, track, timeS);
  return bind(editor, `Set a keyframe of ${definition.label}`, node, param, { track: withKey(track, timeS, value) });
}

/** Sets the value of the keyframe at this time, or adds one. Edits form one undo step until `endGesture`. */
export function editAt(editor: Editor, node: string, param: string, timeS: number, value: ParamValue): boolean {
  const found = findAnimatable(editor, node, param);
  const track = trackOf(found?.binding);
  if (!found || track === null) return false;
  const binding = { track: withKey(track, timeS, value) };
  return bind(editor, `Change ${found.definition.label}`, node, param, binding, `key ${node} ${param} ${roundTime(timeS)}`);
}

/** Moves a keyframe, at most to its neighbors. Moves form one undo step until `endGesture`. */
export function moveKey(editor: Editor, node: string, param: string, index: number, timeS: number): boolean {
  return changeKey(
    editor,
    node,
    param,
    index,
    'Move a keyframe',
    (key, keys) => {
      const least = (keys[index - 1]?.timeS ?? -FRAME_S) + FRAME_S;
      const most = (keys[index + 1]?.timeS ?? Number.POSITIVE_INFINITY) - FRAME_S;
      return { ...key, timeS: roundTime(Math.min(Math.max(timeS, least), most)) };
    },
    `move key ${node} ${param} ${index}`,
  );
}

/** Sets the interpolation of a keyframe. Edits form one undo step until `endGesture`. */
export function setEasing(editor: Editor, node: string, param: string, index: number, easing: Easing): boolean {
  const gesture = `easing ${node} ${param} ${index}`;
  return changeKey(editor, node, param, index, 'Change interpolation', (key) => ({ ...key, easing }), gesture);
}

export function setRepeat(editor: Editor, node: string, param: string, repeat: Track['repeat']): boolean {
  const track = trackOf(findAnimatable(editor, node, param)?.binding);
  return track !== null && bind(editor, 'Change keyframe repeat', node, param, { track: { ...track, repeat } });
}

/** Deletes a keyframe. Without keyframes, the track is replaced by the last value. */
export function removeKey(editor: Editor, node: string, param: string, index: number): boolean {
  const track = trackOf(findAnimatable(editor, node, param)?.binding);
  const key = track?.keys[index];
  if (!track || !key) return false;
  const keys = track.keys.filter((other) => other !== key);
  return bind(editor, 'Delete a keyframe', node, param, keys.length === 0 ? { value: key.value } : { track: { ...track, keys } });
}

function changeKey(
  editor: Editor,
  node: string,
  param: string,
  index: number,
  label: string,
  next: (key: Keyframe, keys: readonly Keyframe[]) => Keyframe,
  gesture?: string,
): boolean {
  const track = trackOf(findAnimatable(editor, node, param)?.binding);
  const key = track?.keys[index];
  if (!track || !key) return false;
  const keys = track.keys.map((other) => (other === key ? next(key, track.keys) : other));
  return bind(editor, label, node, param, { track: { ...track, keys } }, gesture);
}

function withKey(track: Track | null, timeS: number, value: ParamValue): Track {
  const { keys, repeat } = track ?? { keys: [], repeat: 'once' };
  const at = track === null ? -1 : keyAt(track, timeS);
  const old = keys[at];
  const made = {
    timeS: old?.timeS ?? roundTime(timeS),
    value: value as Keyframe['value'],
    easing: old?.easing ?? ('ease-in-out' as const),
  };
  return { repeat, keys: [...keys.filter((key) => key !== old), made].sort((a, b) => a.timeS - b.timeS) };
}

function roundTime(timeS: number): number {
  return Math.max(0, Math.round(timeS / STEP_S) / (1 / STEP_S));
}

function trackOf(binding: Binding | undefined): Track | null {
  return binding !== undefined && 'track' in binding ? binding.track : null;
}

function findAnimatable(editor: Editor, node: string, param: string): BoundParam | null {
  const found = findParam(editor, node, param);
  return found && isAnimatable(found.definition) ? found : null;
}
