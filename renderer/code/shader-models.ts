import { editor, type IRange, Range, Uri } from 'monaco-editor/editor';
import { type NeighborFile, readShaderDocument, type ShaderDocument } from '../../export/glsl/language/shader-document.ts';
import type { TextEdit, TextRange } from '../../export/glsl/language/source-text.ts';
import { GLSL_LANGUAGE } from './glsl-language.ts';

const SHADER_SCHEME = 'scrim-shader';
const NEIGHBOR_SCHEME = 'scrim-neighbor';

/** Returns the text of `chunks/NAME.glsl`. */
export type ChunkOf = (name: string) => string | undefined;

/** Access to the files that a shader refers to. */
export interface ShaderTexts {
  readonly chunkOf: ChunkOf;
  /** The vertex shader beside an ISF file, or the ISF file beside a vertex shader. */
  readonly besideOf: (file: string) => NeighborFile | undefined;
}

interface Reading {
  readonly version: number;
  readonly file: string;
  /** Chunks that the document requested, with their texts at that time. */
  readonly chunks: ReadonlyMap<string, string | undefined>;
  /** For a vertex shader: text of its ISF file, whose header also applies to the vertex shader. Else undefined. */
  readonly header: string | undefined;
  readonly document: ShaderDocument;
}

/** File names of models, and their cached documents. */
const files = new WeakMap<editor.ITextModel, string>();
const readings = new WeakMap<editor.ITextModel, Reading>();

/** The model of a shader, created on first use. `name` is its unique, stable key. */
export function shaderModel(name: string, file: string, text: string): editor.ITextModel {
  const uri = Uri.from({ scheme: SHADER_SCHEME, path: `/${name}` });
  const model = editor.getModel(uri) ?? editor.createModel(text, GLSL_LANGUAGE, uri);
  files.set(model, file);
  return model;
}

/** Model of another file for peeking and go to definition: a chunk, or the ISF file beside a vertex shader. */
export function neighborModel(file: string, from: string, { chunkOf, besideOf }: ShaderTexts): editor.ITextModel | null {
  const beside = besideOf(from);
  const text = beside?.file === file ? beside.source : chunkOf(file.replace(/^chunks\//, '').replace(/\.glsl$/, ''));
  if (text === undefined) return null;
  const uri = Uri.from({ scheme: NEIGHBOR_SCHEME, path: `/${file}` });
  const model = editor.getModel(uri) ?? editor.createModel(text, GLSL_LANGUAGE, uri);
  if (model.getValue() !== text) model.setValue(text);
  files.set(model, file);
  return model;
}

/** File of a neighbor model’s URI; null for other URIs. */
export function neighborFileOf(uri: Uri): string | null {
  return uri.scheme === NEIGHBOR_SCHEME ? uri.path.slice(1) : null;
}

/** Disposes the models whose names `keep` rejects. */
export function forgetModels(keep: (name: string) => boolean): void {
  for (const model of editor.getModels()) if (model.uri.scheme === SHADER_SCHEME && !keep(model.uri.path.slice(1))) model.dispose();
}

/** Parsed document of a model, cached per version of the text and of its includes. */
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
