import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { NAMED_EASINGS } from '../../../nodes/kit/ease.ts';
import type { JsonPath } from '../json/positions.ts';
import { isObject, type ShapeReader } from '../json/shape-reader.ts';
import type { Binding, Keyframe, Track } from '../project.ts';
import { getOwn } from '../record.ts';

const REPEATS = ['once', 'loop', 'mirror'] as const satisfies readonly Track['repeat'][];

/** Reads what a param is bound to: a plain JSON value, or an object whose only key is `track`, `expression` or `port`. */
export function readBinding(reader: ShapeReader, json: unknown, path: JsonPath): Binding {
  if (!isObject(json)) return { value: readValue(reader, json, path) };
  const fields = reader.fields(json, path, ['track', 'expression', 'port']);
  const kinds = Object.keys(json);
  if (kinds.length !== 1) reader.problem(path, 'a parameter must be bound to exactly one of a value, a track, an expression or a port.');
  if (getOwn(json, 'track') !== undefined) return { track: readTrack(reader, fields('track'), [...path, 'track']) };
  if (getOwn(json, 'expression') !== undefined) return { expression: reader.text(fields('expression'), [...path, 'expression']) };
  return { port: readValue(reader, fields('port'), [...path, 'port']) };
}

function readValue(reader: ShapeReader, json: unknown, path: JsonPath): ParamValue {
  if (typeof json === 'string' || typeof json === 'boolean') return json;
  if (Array.isArray(json)) return readNumbers(reader, json, path);
  return reader.number(json, path);
}

function readNumbers(reader: ShapeReader, json: unknown, path: JsonPath): readonly number[] {
  return reader.list(json, path, (item, itemPath) => reader.number(item, itemPath));
}

function readTrack(reader: ShapeReader, json: unknown, path: JsonPath): Track {
  const fields = reader.fields(json, path, ['keys', 'repeat']);
  const keys = reader.list(fields('keys'), [...path, 'keys'], (item, itemPath) => readKeyframe(reader, item, itemPath));
  const repeat = fields('repeat');
  return { keys, repeat: repeat === undefined ? 'once' : reader.oneOf(repeat, [...path, 'repeat'], REPEATS) };
}

function readKeyframe(reader: ShapeReader, json: unknown, path: JsonPath): Keyframe {
  const fields = reader.fields(json, path, ['timeS', 'value', 'easing']);
  const value = fields('value');
  const valuePath = [...path, 'value'];
  const easing = fields('easing');
  return {
    timeS: reader.number(fields('timeS'), [...path, 'timeS']),
    value: Array.isArray(value) ? readNumbers(reader, value, valuePath) : reader.number(value, valuePath),
    easing: easing === undefined ? 'linear' : readEasing(reader, easing, [...path, 'easing']),
  };
}

function readEasing(reader: ShapeReader, json: unknown, path: JsonPath): Keyframe['easing'] {
  if (!Array.isArray(json)) return reader.oneOf(json, path, NAMED_EASINGS);
  if (json.length !== 4) reader.problem(path, 'the control points of an easing must be four numbers: [x1, y1, x2, y2].');
  const [x1 = 0, y1 = 0, x2 = 0, y2 = 0] = readNumbers(reader, json, path);
  // The limits of the control points are checked with the node.
  return [x1, y1, x2, y2];
}
