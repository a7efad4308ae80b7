import type { JsonPath } from '../json/positions.ts';
import type { ShapeReader } from '../json/shape-reader.ts';
import type { Frame, GraphLayout, NodeLayout, Note, Place, Project } from '../project.ts';
import { ENTRY_ID, GRAPH_NAME, NODE_ID, WIRE } from './name-rules.ts';

/** Reads the newest version of the layout; the caller has checked `format` and `version`. */
export function readLayout(reader: ShapeReader, json: unknown): Project['layout'] {
  const fields = reader.fields(json, [], ['format', 'version', 'graphs']);
  return reader.record(fields('graphs'), ['graphs'], GRAPH_NAME, (item, path) => readGraphLayout(reader, item, path));
}

function readGraphLayout(reader: ShapeReader, json: unknown, path: JsonPath): GraphLayout {
  const fields = reader.fields(json, path, ['nodes', 'frames', 'notes', 'reroutes', 'routes', 'borders']);
  const borders = fields('borders');
  return {
    nodes: reader.record(fields('nodes'), [...path, 'nodes'], NODE_ID, (item, itemPath) => readNode(reader, item, itemPath)),
    frames: reader.record(fields('frames'), [...path, 'frames'], ENTRY_ID, (item, itemPath) => readFrame(reader, item, itemPath)),
    notes: reader.record(fields('notes'), [...path, 'notes'], ENTRY_ID, (item, itemPath) => readNote(reader, item, itemPath)),
    reroutes: reader.record(fields('reroutes'), [...path, 'reroutes'], ENTRY_ID, (item, itemPath) => readPlace(reader, item, itemPath)),
    routes: reader.record(fields('routes'), [...path, 'routes'], WIRE, (item, itemPath) =>
      reader.list(item, itemPath, (id, idPath) => reader.name(id, idPath, ENTRY_ID)),
    ),
    ...(borders === undefined ? {} : { borders: readBorders(reader, borders, [...path, 'borders']) }),
  };
}

function readBorders(reader: ShapeReader, json: unknown, path: JsonPath): NonNullable<GraphLayout['borders']> {
  const sides = ['inputs', 'outputs'] as const;
  const fields = reader.fields(json, path, sides);
  const kept = sides.filter((side) => fields(side) !== undefined);
  return Object.fromEntries(kept.map((side) => [side, readPlace(reader, fields(side), [...path, side])]));
}

function readNode(reader: ShapeReader, json: unknown, path: JsonPath): NodeLayout {
  const fields = reader.fields(json, path, ['x', 'y', 'collapsed']);
  const collapsed = fields('collapsed') !== undefined && reader.flag(fields('collapsed'), [...path, 'collapsed']);
  return {
    x: reader.number(fields('x'), [...path, 'x']),
    y: reader.number(fields('y'), [...path, 'y']),
    ...(collapsed ? { collapsed } : {}),
  };
}

function readFrame(reader: ShapeReader, json: unknown, path: JsonPath): Frame {
  const fields = reader.fields(json, path, ['x', 'y', 'width', 'height', 'title', 'color']);
  const color = fields('color');
  return {
    ...readBox(reader, fields, path),
    title: reader.text(fields('title'), [...path, 'title']),
    ...(color === undefined ? {} : { color: reader.text(color, [...path, 'color']) }),
  };
}

function readNote(reader: ShapeReader, json: unknown, path: JsonPath): Note {
  const fields = reader.fields(json, path, ['x', 'y', 'width', 'height', 'text']);
  return { ...readBox(reader, fields, path), text: reader.text(fields('text'), [...path, 'text']) };
}

function readPlace(reader: ShapeReader, json: unknown, path: JsonPath): Place {
  const fields = reader.fields(json, path, ['x', 'y']);
  return { x: reader.number(fields('x'), [...path, 'x']), y: reader.number(fields('y'), [...path, 'y']) };
}

function readBox(reader: ShapeReader, fields: (key: string) => unknown, path: JsonPath) {
  const number = (key: string) => reader.number(fields(key), [...path, key]);
  return { x: number('x'), y: number('y'), width: number('width'), height: number('height') };
}
