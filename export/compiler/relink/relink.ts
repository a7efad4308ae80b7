import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { companionOf } from '../../glsl/isf/read-isf.ts';
import type { PartedPass } from '../../glsl/link/link-parts.ts';
import type { ProjectLibrary } from '../../graph/library/project-library.ts';
import type { ProjectLogic } from '../../graph/project.ts';
import type { LinkedShader } from '../../program/program.ts';
import type { CompileOptions } from '../compile-options.ts';
import type { Schedule } from '../schedule/schedule.ts';
import { isPass } from '../schedule/scheduled.ts';
import type { ShaderStore } from '../shaders/shader-store.ts';
import { isSame } from './is-same.ts';
import type { ImageLink, LinkRequest, ReadLog } from './read-log.ts';

/** A compilation up to its schedule, without fusion and folding, with what it depends on. */
export interface Compilation extends CompilationInput {
  readonly log: ReadLog;
  /** The project after migration of its params. */
  readonly migrated: ProjectLogic;
  readonly schedule: Schedule;
  /** Of all phases until the schedule. */
  readonly diagnostics: readonly Diagnostic[];
}

export interface CompilationInput {
  readonly project: ProjectLogic;
  readonly options: CompileOptions;
  /** With the shaders of the project. */
  readonly library: ProjectLibrary;
}

/**
 * Updates a compilation after an edit of image shaders: links these again and replaces them in the schedule.
 *
 * The schedule depends on the project, the options, and what it read of the library and the linked passes. If all of these are equal except
 * for the texts of shaders, whose linked passes have equal inputs, params and targets, then the schedule is equal except for these texts.
 *
 * @returns Null if anything else differs, so that everything must be compiled.
 */
export function relink(last: Compilation, input: CompilationInput, shaders: ShaderStore): Compilation | null {
  const { sources: _, ...before } = last.project;
  const { sources, ...after } = input.project;
  const { library, options } = input;
  if (!isSame(after, before) || !isSame(options, last.options) || !isSame(library.diagnostics, last.library.diagnostics)) return null;
  for (const [type, known] of last.log.definitions) if (!isSame(library.definition(type), known)) return null;
  const edited = editedTexts(last.log, library);
  const links = relinkTexts(last.log, edited, library, shaders);
  if (links === null) return null;
  const passes = new Map(links.flatMap(({ known, made }) => replacements(known, made)));
  const log: ReadLog = {
    ...last.log,
    texts: new Map([...last.log.texts].map(([name, text]) => [name, edited.has(name) ? edited.get(name) : text])),
    links: new Map([...last.log.links].map(([known, request]) => [links.find((link) => link.known === known)?.made ?? known, request])),
  };
  const operations = last.schedule.operations.map((operation) => {
    const pass = isPass(operation) ? passes.get(operation.shader) : undefined;
    return pass && isPass(operation) ? { ...operation, shader: pass.shader, parts: pass.parts } : operation;
  });
  return { ...last, ...input, log, migrated: { ...last.migrated, sources }, schedule: { ...last.schedule, operations } };
}

/** Texts that differ from those that were read, by name. */
function editedTexts({ texts }: ReadLog, library: ProjectLibrary): ReadonlyMap<string, string | undefined> {
  const edited = new Map<string, string | undefined>();
  for (const [name, text] of texts) {
    const now = library.shader(name);
    if (now !== text) edited.set(name, now);
  }
  return edited;
}

interface Relinked {
  readonly known: ImageLink;
  readonly made: ImageLink;
}

/** Links the edited shaders again; null if a text is no image shader or vertex shader, or a linked shader differs in more than its text. */
function relinkTexts(
  { links, otherwise }: ReadLog,
  edited: ReadonlyMap<string, string | undefined>,
  library: ProjectLibrary,
  shaders: ShaderStore,
): Relinked[] | null {
  const left = new Set(edited.keys());
  const relinked: Relinked[] = [];
  for (const [known, request] of links) {
    const files = [request.file, companionOf(request.file)];
    if (!files.some((file) => edited.has(file))) continue;
    for (const file of files) left.delete(file);
    const made = linkAgain(request, library, shaders);
    if (otherwise.has(request.file) || made === null || !isSameLink(known, made)) return null;
    relinked.push({ known, made });
  }
  return left.size > 0 ? null : relinked;
}

function linkAgain({ file, variant }: LinkRequest, library: ProjectLibrary, shaders: ShaderStore): ImageLink | null {
  const source = library.shader(file);
  return source === undefined ? null : shaders.link(file, source, library.shader(companionOf(file)) ?? null, variant);
}

/** Whether two linked shaders differ in nothing that the schedule depends on, and have no diagnostics. */
function isSameLink(a: ImageLink, b: ImageLink): boolean {
  if (a.output === null || b.output === null || a.diagnostics.length + b.diagnostics.length > 0) return false;
  return isSame(a.output.map(scheduledFacts), b.output.map(scheduledFacts));
}

/** A pass without its texts. The number of operations only counts in fusion. */
function scheduledFacts({ shader, parts, ...pass }: PartedPass) {
  const { id: _, vertex: _vertex, fragment: _fragment, sourceMap: _sourceMap, vertexMap: _vertexMap, ...drawing } = shader;
  if (typeof parts === 'string') return { ...pass, drawing, parts };
  const { functions: _functions, body: _body, operations: _operations, ...facts } = parts;
  const images = facts.images.map(({ reading: _reading, ...image }) => image);
  return { ...pass, drawing, parts: { ...facts, images } };
}

function replacements(known: ImageLink, made: ImageLink): [LinkedShader, PartedPass][] {
  return (known.output ?? []).flatMap(({ shader }, i) => {
    const pass = made.output?.[i];
    return pass ? [[shader, pass] as [LinkedShader, PartedPass]] : [];
  });
}
