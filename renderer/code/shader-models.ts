import { editor, type IRange, Range, Uri } from 'monaco-editor/editor';
import { type NeighbourFile, readShaderDocument, type ShaderDocument } from '../../export/glsl/language/shader-document.ts';
import type { TextEdit, TextRange } from '../../export/glsl/language/source-text.ts';
import { GLSL_LANGUAGE } from './glsl-language.ts';

const SHADER_SCHEME = 'scrim-shader';
const NEIGHBOUR_SCHEME = 'scrim-neighbour';

/** Text of `chunks/NAME.glsl`. */
export type ChunkOf = (name: string) => string | undefined;

/** What a text's neighbours hold. */
export interface ShaderTexts {
  readonly chunkOf: ChunkOf;
  /** The vertex shader beside an ISF file, or the ISF file beside a vertex shader. */
  readonly besideOf: (file: string) => NeighbourFile | undefined;
}

interface Reading {
  readonly version: number;
  readonly file: string;
  /** The chunks that it asked for, with what they were. */
  readonly chunks: ReadonlyMap<string, string | undefined>;
  /** Of the file whose header counts for it, too. */
  readonly header: string | undefined;
  readonly document: ShaderDocument;
}

/** Files that the models show, and what was last read of them. */
const files = new WeakMap<editor.ITextModel, string>();
const readings = new WeakMap<editor.ITextModel, Reading>();

/** The model of a shader, made when it is first asked for; `name` is its own for as long as it lives. */
export function shaderModel(name: string, file: string, text: string): editor.ITextModel {
  const uri = Uri.from({ scheme: SHADER_SCHEME, path: `/${name}` });
  const model = editor.getModel(uri) ?? editor.createModel(text, GLSL_LANGUAGE, uri);
  files.set(model, file);
  return model;
}

/** Another file to be looked at where a name leads to it, before it is opened: a chunk, or the ISF file beside a vertex shader. */
export function neighbourModel(file: string, from: string, { chunkOf, besideOf }: ShaderTexts): editor.ITextModel | null {
  const beside = besideOf(from);
  const text = beside?.file === file ? beside.source : chunkOf(file.replace(/^chunks\//, '').replace(/\.glsl$/, ''));
  if (text === undefined) return null;
  const uri = Uri.from({ scheme: NEIGHBOUR_SCHEME, path: `/${file}` });
  const model = editor.getModel(uri) ?? editor.createModel(text, GLSL_LANGUAGE, uri);
  if (model.getValue() !== text) model.setValue(text);
  files.set(model, file);
  return model;
}

/** The other file that an address stands for; null for any other. */
export function neighbourFileOf(uri: Uri): string | null {
  return uri.scheme === NEIGHBOUR_SCHEME ? uri.path.slice(1) : null;
}

/** Ends the models of shaders whose names are not to be kept. */
export function forgetModels(keep: (name: string) => boolean): void {
  for (const model of editor.getModels()) if (model.uri.scheme === SHADER_SCHEME && !keep(model.uri.path.slice(1))) model.dispose();
}

/** What the language knows of a model's text, read once per version of it and of what it includes. */
export function documentOf(model: editor.ITextModel, { chunkOf, besideOf }: ShaderTexts): ShaderDocument {
  const known = readings.get(model);
  const version = model.getVersionId();
  const file = files.get(model) ?? '';
  const isSame = (chunks: Reading['chunks']) => [...chunks].every(([name, text]) => chunkOf(name) === text);
  const fragment = isVertexShader(file) ? besideOf(file) : undefined;
  const header = fragment?.source;
  if (known?.version === version && known.file === file && known.header === header && isSame(known.chunks)) return known.document;
  const chunks = new Map<string, string | undefined>();
  const remember: ChunkOf = (name) => {
    const text = chunkOf(name);
    chunks.set(name, text);
    return text;
  };
  const options = { chunkOf: remember, fragment, ...(known?.file === file ? { before: known.document } : {}) };
  const document = readShaderDocument(model.getValue(), file, options);
  readings.set(model, { version, file, chunks, header, document });
  return document;
}

export function isVertexShader(file: string): boolean {
  return file.endsWith('.vs');
}

export function rangeOf({ start, end }: TextRange): IRange {
  return new Range(start.line, start.column, end.line, end.column);
}

export function editOf(edit: TextEdit): { readonly range: IRange; readonly text: string } {
  return { range: rangeOf(edit), text: edit.text };
}
