import { ASSET_KINDS } from '../../../nodes/kit/definition.ts';
import type { PosterFraming } from '../../../nodes/kit/poster-framing.ts';
import type { JsonPath } from '../json/positions.ts';
import { isObject, type ShapeReader } from '../json/shape-reader.ts';
import { DEFAULT_PAGE } from '../new-project.ts';
import {
  type Asset,
  type ExposedPort,
  type Graph,
  type GraphNode,
  MAIN_GRAPH,
  type PageInfo,
  type Project,
  type RecipeInfo,
  type Wire,
} from '../project.ts';
import { getOwn } from '../record.ts';
import { parseWire, sortWires } from '../wires.ts';
import { ENTRY_ID, GRAPH_NAME, NODE_ID, NODE_TYPE, PORT_NAME } from './name-rules.ts';
import { readBinding } from './read-binding.ts';

/** The content of `project.scrim.json`. */
export type ProjectDocument = Omit<Project, 'layout' | 'sources'>;

/** Reads the newest version of the document; the caller has checked `format` and `version`. */
export function readProject(reader: ShapeReader, json: unknown): ProjectDocument {
  const fields = reader.fields(json, [], ['format', 'version', 'title', 'page', 'graphs', 'assets', 'recipe']);
  const graphs = reader.record(fields('graphs'), ['graphs'], GRAPH_NAME, (item, path) => readGraph(reader, item, path));
  if (isObject(json) && getOwn(graphs, MAIN_GRAPH) === undefined) reader.problem(['graphs'], `the graph "${MAIN_GRAPH}" is missing.`);
  return {
    title: reader.text(fields('title'), ['title']),
    page: readPage(reader, fields('page')),
    graphs,
    assets: reader.record(fields('assets'), ['assets'], ENTRY_ID, (item, path) => readAsset(reader, item, path)),
    ...(fields('recipe') !== undefined && { recipe: readRecipeInfo(reader, fields('recipe')) }),
  };
}

function readRecipeInfo(reader: ShapeReader, json: unknown): RecipeInfo {
  const keywords = reader.fields(json, ['recipe'], ['keywords'])('keywords');
  if (keywords === undefined) return { keywords: [] };
  return { keywords: reader.list(keywords, ['recipe', 'keywords'], (item, path) => reader.text(item, path)) };
}

function readPage(reader: ShapeReader, json: unknown): PageInfo {
  if (json === undefined) return DEFAULT_PAGE;
  const fields = reader.fields(json, ['page'], ['description', 'language', 'poster', 'framing']);
  const text = (key: 'description' | 'language') =>
    fields(key) === undefined ? DEFAULT_PAGE[key] : reader.text(fields(key), ['page', key]);
  const language = text('language');
  if (!isLanguage(language)) {
    reader.problem(
      ['page', 'language'],
      `${JSON.stringify(language)} is not a language tag. Use a BCP 47 tag such as "en", "de-CH" or "zh-Hant".`,
    );
  }
  const poster = fields('poster') === undefined ? '' : reader.text(fields('poster'), ['page', 'poster']);
  const framing = fields('framing') === undefined ? null : readFraming(reader, fields('framing'), ['page', 'framing']);
  return { description: text('description'), language, ...(poster !== '' && { poster }), ...(framing && { framing }) };
}

function readFraming(reader: ShapeReader, json: unknown, path: JsonPath): PosterFraming {
  const fields = reader.fields(json, path, ['center', 'height', 'room']);
  const numbers = (value: unknown, at: JsonPath, count: number) => {
    const list = reader.list(value, at, (item, itemPath) => reader.number(item, itemPath));
    if (Array.isArray(value) && list.length !== count) reader.problem(at, `must have ${count} numbers.`);
    return list;
  };
  const [x = 0, y = 0] = numbers(fields('center'), [...path, 'center'], 2);
  const height = reader.number(fields('height'), [...path, 'height']);
  if (typeof fields('height') === 'number' && !(height > 0)) reader.problem([...path, 'height'], 'must be greater than 0.');
  if (fields('room') === undefined) return { center: [x, y], height };
  const roomPath = [...path, 'room'];
  const room = reader.fields(fields('room'), roomPath, ['name', 'eye', 'target']);
  const point = (key: 'eye' | 'target'): [number, number, number] => {
    const [px = 0, py = 0, pz = 0] = numbers(room(key), [...roomPath, key], 3);
    return [px, py, pz];
  };
  const name = reader.text(room('name'), [...roomPath, 'name']);
  return { center: [x, y], height, room: { name, eye: point('eye'), target: point('target') } };
}

/** Whether the tag is well-formed by BCP 47 (RFC 5646). The parts of the tag are not looked up. */
function isLanguage(tag: string): boolean {
  try {
    return Intl.getCanonicalLocales(tag).length === 1;
  } catch {
    return false;
  }
}

function readGraph(reader: ShapeReader, json: unknown, path: JsonPath): Graph {
  const fields = reader.fields(json, path, ['nodes', 'wires', 'exposed']);
  const wires = reader.list(fields('wires'), [...path, 'wires'], (item, itemPath) => readWire(reader, item, itemPath));
  const exposedPath = [...path, 'exposed'];
  const exposed = reader.fields(fields('exposed') === undefined ? {} : fields('exposed'), exposedPath, ['inputs', 'outputs']);
  const ports = (side: 'inputs' | 'outputs') =>
    reader.list(exposed(side), [...exposedPath, side], (item, itemPath) => readExposedPort(reader, item, itemPath));
  return {
    nodes: reader.record(fields('nodes'), [...path, 'nodes'], NODE_ID, (item, itemPath) => readNode(reader, item, itemPath)),
    wires: sortWires(wires),
    exposed: { inputs: ports('inputs'), outputs: ports('outputs') },
  };
}

function readNode(reader: ShapeReader, json: unknown, path: JsonPath): GraphNode {
  const fields = reader.fields(json, path, ['type', 'version', 'muted', 'unfused', 'params']);
  const versionPath = [...path, 'version'];
  const version = reader.number(fields('version'), versionPath);
  if (!Number.isInteger(version) || version < 1) reader.problem(versionPath, 'a version must be a whole number from 1.');
  const flag = (name: 'muted' | 'unfused') => fields(name) !== undefined && reader.flag(fields(name), [...path, name]);
  const muted = flag('muted');
  const unfused = flag('unfused');
  return {
    type: reader.name(fields('type'), [...path, 'type'], NODE_TYPE),
    version,
    params: reader.record(fields('params'), [...path, 'params'], PORT_NAME, (item, itemPath) => readBinding(reader, item, itemPath)),
    ...(muted ? { muted } : {}),
    ...(unfused ? { unfused } : {}),
  };
}

const NO_WIRE: Wire = { from: { node: '', port: '' }, to: { node: '', port: '' } };

function readWire(reader: ShapeReader, json: unknown, path: JsonPath): Wire {
  const text = reader.text(json, path);
  const wire = parseWire(text);
  if (wire && NODE_ID.is(wire.from.node) && NODE_ID.is(wire.to.node) && PORT_NAME.is(wire.from.port) && PORT_NAME.is(wire.to.port))
    return wire;
  if (typeof json === 'string') reader.problem(path, 'a wire must be written as "video-a1b2.layer -> sepia-k7q2.inputImage".');
  return NO_WIRE;
}

function readExposedPort(reader: ShapeReader, json: unknown, path: JsonPath): ExposedPort {
  const fields = reader.fields(json, path, ['name', 'node', 'port']);
  return {
    name: reader.name(fields('name'), [...path, 'name'], PORT_NAME),
    node: reader.name(fields('node'), [...path, 'node'], NODE_ID),
    port: reader.name(fields('port'), [...path, 'port'], PORT_NAME),
  };
}

function readAsset(reader: ShapeReader, json: unknown, path: JsonPath): Asset {
  const fields = reader.fields(json, path, ['path', 'kind', 'credit', 'licence']);
  const optional = (key: 'credit' | 'licence') => (fields(key) === undefined ? {} : { [key]: reader.text(fields(key), [...path, key]) });
  return {
    path: reader.text(fields('path'), [...path, 'path']),
    kind: reader.oneOf(fields('kind'), [...path, 'kind'], ASSET_KINDS),
    ...optional('credit'),
    ...optional('licence'),
  };
}
