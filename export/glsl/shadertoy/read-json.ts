import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { BUFFER_LETTERS, type BufferLetter, CHANNEL_COUNT, type Channel, type Shadertoy, type Tab, tabName } from './shadertoy.ts';

type Json = Readonly<Record<string, unknown>>;

/** Kinds of inputs that a layer can replace. */
const PICTURES = new Set(['texture', 'video', 'webcam', 'buffer']);

/**
 * Reads the JSON of the site: the answer of its API (`{ "Shader": … }`), the export of a profile (`{ "shaders": [ … ] }`), or a single
 * work. Of several works it takes the first. Returns null for other text.
 */
export function readShadertoyJson(source: string, file: string): Result<Shadertoy> | null {
  const work = workOf(source);
  if (work === null) return null;
  const passes = list(work.renderpass).map(object);
  const info = object(work.info);
  const diagnostics: Diagnostic[] = [];
  const warn = (message: string) => diagnostics.push({ code: 'SCR045', severity: 'warning', file, message });
  const letters = new Map<string, BufferLetter>();
  for (const pass of passes) {
    const letter = bufferOf(pass);
    if (letter) for (const output of list(pass.outputs)) letters.set(String(object(output).id), letter);
  }
  const tabs: Tab[] = [];
  const common: string[] = [];
  for (const pass of passes) {
    const type = text(pass.type);
    const code = text(pass.code);
    const buffer = bufferOf(pass);
    if (type === 'common') common.push(code);
    else if (type === 'image' || buffer !== null) tabs.push({ buffer, code, channels: channelsOf(pass, buffer, letters, warn) });
    else warn(`The tab “${text(pass.name) || type}” is left out: Scrim supports no ${type === 'sound' ? 'sound' : 'cube map'} tabs.`);
  }
  tabs.sort((a, b) => (a.buffer ?? 'Z').localeCompare(b.buffer ?? 'Z'));
  const id = text(info.id);
  const credit = [text(info.username), id === '' ? '' : `https://www.shadertoy.com/view/${id}`].filter((part) => part !== '').join(', ');
  const shader: Shadertoy = {
    title: text(info.name),
    description: text(info.description),
    tags: list(info.tags).map(text),
    credit,
    tabs,
    common: common.join('\n'),
  };
  return { output: shader, diagnostics };
}

function workOf(source: string): Json | null {
  if (!/^\s*[[{]/.test(source)) return null;
  let whole: unknown;
  try {
    whole = JSON.parse(source);
  } catch {
    return null;
  }
  const outer = Array.isArray(whole) ? object(whole[0]) : object(whole);
  const candidates = [outer, object(outer.Shader), object(list(outer.shaders)[0])];
  return candidates.find((one) => list(one.renderpass).length > 0) ?? null;
}

function bufferOf(pass: Json): BufferLetter | null {
  if (text(pass.type) !== 'buffer') return null;
  const letter = /([A-D])\s*$/i.exec(text(pass.name))?.[1]?.toUpperCase();
  return BUFFER_LETTERS.find((one) => one === letter) ?? null;
}

function channelsOf(
  pass: Json,
  buffer: BufferLetter | null,
  letters: ReadonlyMap<string, BufferLetter>,
  warn: (message: string) => void,
): Channel[] {
  const inputs = list(pass.inputs).map(object);
  return Array.from({ length: CHANNEL_COUNT }, (_, index): Channel => {
    const input = inputs.find((one) => one.channel === index);
    if (input === undefined) return { kind: 'picture', key: `iChannel${index}`, repeat: false };
    const type = text(input.ctype) || text(input.type);
    const source = text(input.src) || text(input.filepath);
    const known = letters.get(String(input.id)) ?? BUFFER_LETTERS[Number(/\/buffer0([0-3])\.png$/.exec(source)?.[1] ?? Number.NaN)];
    if (type === 'buffer' && known !== undefined) return { kind: 'buffer', buffer: known };
    if (!PICTURES.has(type)) warn(`iChannel${index} of ${tabName({ buffer })} is of kind “${type}”. A layer takes its place.`);
    return { kind: 'picture', key: source || String(input.id), repeat: text(object(input.sampler).wrap) === 'repeat' };
  });
}

function object(value: unknown): Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value) ? (value as Json) : {};
}

function list(value: unknown): readonly unknown[] {
  return Array.isArray(value) ? value : [];
}

function text(value: unknown): string {
  return typeof value === 'string' ? value : '';
}
