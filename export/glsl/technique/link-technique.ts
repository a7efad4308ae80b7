import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { COUNTED_BUDGET, LOOP_BUDGET } from '../../program/loop-budget.ts';
import type { LinkedShader, PassUniform, SourceMap } from '../../program/program.ts';
import { checkCalls } from '../check/check-calls.ts';
import { type CheckedShader, checkShader } from '../check/check-shader.ts';
import { countRounds } from '../check/count-rounds.ts';
import { INPUT_TYPES, variableOf } from '../isf/given-symbols.ts';
import { hashText } from '../link/hash.ts';
import type { Image } from '../link/images.ts';
import { createLineWriter } from '../link/line-writer.ts';
import { type Above, findAbove } from '../link/link-above.ts';
import { usable } from '../link/link-unit.ts';
import { createNames, type Names } from '../link/names.ts';
import { FRAGMENT_HEAD, VERTEX_SHADER } from '../link/prelude.ts';
import type { PrintContext } from '../link/print-context.ts';
import { choiceText, needsHoisting } from '../link/print-declaration.ts';
import { printAuthorsText } from '../link/print-shader.ts';
import { findReach, type Reach } from '../link/reach.ts';
import type { FunctionDeclaration, FunctionSymbol, ParsedShader, VariableSymbol } from '../syntax/ast.ts';
import { parseShader } from '../syntax/parse.ts';
import { textAbove } from '../syntax/text-above.ts';
import { GlslError, type Place } from '../syntax/token.ts';
import { type ExpandedText, expandIncludes } from './expand-includes.ts';
import { INTERFACE_LINES, LIGHT_FUNCTIONS, PRINTED_BEHIND, PRINTED_STRUCTS, TECHNIQUE_INTERFACE } from './interface.ts';
import { techniqueImages, techniqueImageText } from './technique-images.ts';
import type { TechniqueShader } from './technique-shader.ts';

/** The text that a technique adds to the vertex and fragment stage of a material, and a complete shader to test it. */
export interface LinkedTechnique {
  /** Declares uniforms and structs, and `void a_vertex(inout a_Vertex v)`, which does nothing if the author has none. */
  readonly vertex: string;
  /** Declares uniforms and structs, and `vec4 a_surface(const in a_Surface s)`. */
  readonly fragment: string;
  /**
   * All of the author's text in one fragment shader. It draws nothing useful: if a driver accepts it, it accepts the technique, and its
   * messages are on the author's lines.
   */
  readonly trial: LinkedShader;
  readonly uniforms: readonly { readonly name: string; readonly type: PassUniform['type']; readonly param: string }[];
  /** Uniform name and input of the layers that the technique reads, with `NAME_uvFromViewUv` (mat3) and `NAME_size` (vec2, pixels). */
  readonly samplers: readonly { readonly name: string; readonly input: string }[];
  /** Whether the technique reads what is behind its objects (`BEHIND`). */
  readonly readsBehind: boolean;
  /** Uniform name and path of the library images that the technique reads. */
  readonly pictures: readonly { readonly name: string; readonly path: string }[];
}

interface Unit {
  readonly technique: TechniqueShader;
  readonly expanded: ExpandedText;
  readonly checked: CheckedShader;
  readonly given: ReadonlyMap<string, VariableSymbol>;
  readonly loopBudget: boolean;
  readonly absent: ReadonlySet<string>;
  /** Functions that the test shader contains although it does not call them. */
  readonly also: readonly FunctionSymbol[];
}

export interface TechniqueOptions {
  /** Returns the text of a chunk, `chunks/NAME.glsl`, by its name. */
  readonly chunkOf: (name: string) => string | undefined;
  /** Limits the iterations of every invocation, so that endless loops end; for previews. */
  readonly loopBudget: boolean;
  /** Unconnected optional image inputs. */
  readonly absent?: readonly string[];
}

/** Links a technique. SCR041 if the GLSL cannot be parsed, SCR043 if it needs unsupported features. */
export function linkTechnique(technique: TechniqueShader, options: TechniqueOptions): Result<LinkedTechnique> {
  const { output: expanded, diagnostics } = expand(technique, options.chunkOf);
  return expanded === null ? { output: null, diagnostics } : linkText(technique, expanded, options);
}

/**
 * Links the text above the mistake for which `linkTechnique` rejected the technique, including chunks. Returns null if there is no text
 * above.
 *
 * @returns The test shader, which also contains functions that are not called yet.
 */
export function linkTechniqueAbove(
  technique: TechniqueShader,
  options: TechniqueOptions,
  refused: Diagnostic,
): Above<LinkedTechnique> | null {
  const expanded = expand(technique, options.chunkOf).output ?? expand(linesAbove(technique, refused), options.chunkOf).output;
  if (expanded === null) return null;
  return findAbove(expanded, refused, expandedAbove, (above) => linkText(technique, above, { ...options, partial: true }));
}

function expand({ source, file }: TechniqueShader, chunkOf: TechniqueOptions['chunkOf']): Result<ExpandedText> {
  return caught(
    () => expandIncludes(source, file, chunkOf),
    ({ line }) => ({ file, line }),
  );
}

function linkText(technique: TechniqueShader, expanded: ExpandedText, options: TechniqueOptions & Partial): Result<LinkedTechnique> {
  return caught(
    () => linkExpanded(technique, expanded, options),
    (place) => originOf(expanded, place),
  );
}

function caught<T>(make: () => T, placeOf: (place: Place) => { readonly file: string; readonly line: number }): Result<T> {
  try {
    return { output: make(), diagnostics: [] };
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    const { code, message, place } = error;
    return { output: null, diagnostics: [{ code, severity: 'error', message, ...placeOf(place), column: place.column }] };
  }
}

/** Cuts a technique above the line of an `#include` that failed. The whole line is cut, because an include is alone on its line. */
function linesAbove(technique: TechniqueShader, { line = 1 }: Diagnostic): TechniqueShader {
  const lines = technique.source.split(/\r\n|\r|\n/).slice(0, line - 1);
  return { ...technique, source: lines.join('\n') };
}

const SURFACE = 'vec4 surface(const in Surface s) { return vec4(0.0); }';

function expandedAbove(expanded: ExpandedText, file: string, { line, column }: Place): ExpandedText | null {
  const { text, sources, lines } = expanded;
  const at = lines.findIndex(([source, from]) => sources[source] === file && from === line);
  // If the line itself was cut off, use the end of the text.
  const above = textAbove(text, { line: (at < 0 ? lines.length : at) + 1, column }, SURFACE);
  return above === null ? null : { ...expanded, text: above };
}

/** `partial`: the text ends above a mistake, so functions may lack their bodies. */
interface Partial {
  readonly partial?: boolean;
}

function linkExpanded(
  technique: TechniqueShader,
  expanded: ExpandedText,
  { loopBudget, absent, partial = false }: TechniqueOptions & Partial,
): LinkedTechnique {
  const given = new Map([
    ...technique.inputs.map(({ name, type }) => [name, variableOf(name, INPUT_TYPES[type], type === 'image' ? 'image' : 'input')] as const),
    ...technique.imported.map(({ name }) => [name, variableOf(name, 'sampler2D', 'image')] as const),
  ]);
  const text = `${TECHNIQUE_INTERFACE}${expanded.text}\n`;
  const parsed = parseShader(`${text}${mainFor(parseShader(text))}`);
  const surface = functionOf(parsed, 'surface', 'vec4', 'Surface');
  if (!surface)
    throw new GlslError({ line: INTERFACE_LINES + 1, column: 1 }, 'The technique has no "vec4 surface(const in Surface s) { … }".');
  const vertex = functionOf(parsed, 'vertex', 'void', 'Vertex');
  const checked = checkShader(parsed, given);
  refuseStrayImages(checked);
  const isGiven = (name: string) =>
    checked.declarations.some((one) => one.kind === 'function' && one.name.text === name && isInterface(one));
  checkCalls(checked, (name) => partial || isGiven(name));
  const also = partial ? ownFunctions(checked) : [];
  const unit: Unit = { technique, expanded, checked, given, loopBudget, absent: new Set(absent), also };
  const names = namesFor(unit);
  const uses = usesOf(unit, checked.main, names);
  if (vertex) refuseLights(unit, vertex);
  const inVertex = vertex ? printStage(unit, vertex) : null;
  const inFragment = printStage(unit, surface);
  const trial = printStage(unit, checked.main);
  return {
    vertex: `${inVertex?.text ?? PRINTED_STRUCTS}\n${vertex ? '' : 'void a_vertex(inout a_Vertex v) {}\n'}`,
    fragment: `${inFragment.text}\n`,
    trial: trialShader(unit, trial),
    uniforms: uniformsOf(unit, uses.reach, names).map(({ name, type, param }) => ({ name, type: type as PassUniform['type'], param })),
    readsBehind: callsBehind(uses.reach),
    samplers: [...uses.reach.images.keys()].flatMap(({ kind, name: input, sampler: name }) => (kind === 'input' ? [{ name, input }] : [])),
    pictures: [...uses.reach.images.keys()].flatMap(({ kind, buffer: path, sampler: name }) => (kind === 'buffer' ? [{ name, path }] : [])),
  };
}

/** The technique's own functions that can be printed without a call: those without image parameters. */
function ownFunctions(checked: CheckedShader): FunctionSymbol[] {
  const declarations = checked.declarations.filter((declaration) => declaration.kind === 'function' && !isInterface(declaration));
  return usable({ ...checked, declarations }).filter((symbol) => symbol.kind === 'function');
}

function refuseStrayImages({ strayImages: [stray] }: CheckedShader): void {
  if (stray?.token) {
    const fix = `Add it to INPUTS as { "NAME": "${stray.name}", "TYPE": "image" }.`;
    throw new GlslError(stray.token, `The image "${stray.name}" is not in the header. ${fix}`, 'SCR043');
  }
}

/**
 * Prints the `main` of the test shader, which calls `vertex`, if the author has one, and `surface`. It follows the author's text, whose
 * line numbers stay the same.
 */
function mainFor(author: ParsedShader): string {
  const vertex = functionOf(author, 'vertex', 'void', 'Vertex') ? 'Vertex v; vertex(v);' : '';
  return `void main() { ${vertex} Surface s; surface(s); }`;
}

/**
 * Finds the author's function with this name; null if there is none. Call it before the check, which renames the types of structs.
 *
 * @throws GlslError if the function has another return type or other parameters.
 */
function functionOf(shader: ParsedShader, name: string, returns: string, takes: string): FunctionDeclaration | null {
  for (const declaration of shader.declarations) {
    if (declaration.kind !== 'function' || declaration.name.text !== name || declaration.body === null) continue;
    const [parameter, ...others] = declaration.parameters;
    if (declaration.returnType.name.text === returns && parameter?.type.name.text === takes && others.length === 0) return declaration;
    throw new GlslError(declaration.name, `"${name}" must return ${returns} and take one ${takes}.`);
  }
  return null;
}

function namesFor({ checked, given }: Unit): Names {
  const names = createNames();
  // The interface and the inputs are named first, so that their names do not depend on the author's.
  for (const declaration of checked.declarations) {
    if (!isInterface(declaration)) continue;
    if (declaration.kind === 'function') {
      if (declaration.symbol) names.of(declaration.symbol);
      continue;
    }
    if (declaration.type.struct?.symbol) names.of(declaration.type.struct.symbol);
    for (const { symbol } of declaration.declarators) if (symbol) names.of(symbol);
  }
  for (const symbol of given.values()) if (symbol.role === 'input') names.of(symbol);
  for (const name of ['vertex', 'surface']) for (const symbol of functionSymbols(checked, name)) names.of(symbol);
  return names;
}

function functionSymbols({ declarations }: CheckedShader, name: string) {
  return declarations.flatMap((declaration) =>
    declaration.kind === 'function' && declaration.name.text === name && declaration.symbol ? [declaration.symbol] : [],
  );
}

function isInterface(declaration: ParsedShader['declarations'][number]): boolean {
  const { line } = declaration.kind === 'function' ? declaration.name : declaration.start;
  return line <= INTERFACE_LINES;
}

interface Uses {
  readonly reach: Reach;
  readonly images: ReadonlyMap<string, Image>;
}

function usesOf(unit: Unit, root: FunctionDeclaration, names = namesFor(unit)): Uses {
  const images = techniqueImages(unit.technique, unit.absent, names);
  const also = root === unit.checked.main ? unit.also : [];
  return { reach: findReach({ ...unit.checked, main: root }, { passIndex: 0, images, names, also }), images };
}

function callsBehind({ instances }: Reach): boolean {
  return [...instances.keys()].some(({ name }) => name === 'BEHIND');
}

function refuseLights(unit: Unit, vertex: FunctionDeclaration): void {
  for (const symbol of usesOf(unit, vertex).reach.instances.keys()) {
    if (LIGHT_FUNCTIONS.has(symbol.name))
      throw new GlslError(vertex.name, 'Lights and what is behind are available in "surface" only, not in "vertex".', 'SCR043');
  }
}

/** The inputs that a technique uses as uniforms, in the header's order. */
function uniformsOf({ technique, given }: Unit, { params }: Reach, names: Names) {
  return technique.inputs.flatMap(({ name: param, type }) => {
    const symbol = params.has(param) ? given.get(param) : undefined;
    return symbol ? [{ name: names.of(symbol), type: INPUT_TYPES[type], param }] : [];
  });
}

interface Stage {
  readonly text: string;
  readonly head: readonly string[];
  readonly lines: readonly string[];
  readonly map: SourceMap['lines'];
}

/** Prints everything of the author's text that one function uses. */
function printStage(unit: Unit, root: FunctionDeclaration): Stage {
  const names = namesFor(unit);
  const { reach, images } = usesOf(unit, root, names);
  const context: PrintContext = {
    writer: createLineWriter(0, unit.loopBudget),
    names,
    reach,
    passIndex: 0,
    images,
    structs: unit.checked.structs,
    loopBudget: unit.loopBudget && reach.hasLoops && countRounds(unit.checked) > COUNTED_BUDGET,
    stage: 'fragment',
    varyings: new Set(),
    normCoord: 'scrim_uv',
    binding: new Map(),
    returnType: '',
    found: { discards: false, projects: false, returns: false },
  };
  const own = unit.checked.declarations.filter((declaration) => !isInterface(declaration));
  printAuthorsText({ ...unit.checked, declarations: own }, context);
  for (const declaration of own) {
    if (declaration.kind !== 'variables') continue;
    for (const declarator of declaration.declarators) {
      if (declarator.symbol && reach.globals.has(declarator.symbol) && needsHoisting(declarator)) {
        throw new GlslError(
          declarator.name,
          'A global variable must be initialized with a constant. Set it in "surface" instead.',
          'SCR043',
        );
      }
    }
  }
  const head = [
    PRINTED_STRUCTS,
    ...(callsBehind(reach) ? [PRINTED_BEHIND] : []),
    ...chosenStructs(unit, names).map(choiceText),
    ...(context.loopBudget ? [LOOPS_END] : []),
    ...uniformsOf(unit, reach, names).map(({ name, type }) => `uniform ${type} ${name};`),
    ...techniqueImageText(reach),
  ]
    .join('\n')
    .split('\n');
  const map = context.writer.map.map((entry) => {
    if (entry === null) return null;
    const place = { line: entry[1], column: entry[2] };
    const origin = unit.expanded.lines[place.line - 1 - INTERFACE_LINES];
    return origin ? ([origin[0], origin[1], place.column] as const) : null;
  });
  return { text: [...head, ...context.writer.lines].join('\n'), head, lines: context.writer.lines, map };
}

/**
 * Names of the interface's structs between whose values a `? :` selects. Their `choiceText` must be printed here, because
 * `printAuthorsText` prints only that of the author's structs.
 */
function chosenStructs({ checked }: Unit, names: Names): string[] {
  return checked.declarations.filter(isInterface).flatMap((declaration) => {
    const symbol = declaration.kind === 'variables' ? declaration.type.struct?.symbol : null;
    return symbol?.chosen ? [names.of(symbol)] : [];
  });
}

/** GLSL that ends loops when the budget is used up, as in filters (`export/program/loop-budget.ts`), but without reporting the loop. */
const LOOPS_END = `int scrim_roundsLeft = ${LOOP_BUDGET};
bool scrim_spend(const in int line) {
  scrim_roundsLeft -= 1;
  return scrim_roundsLeft >= 0;
}`;

/** Declarations that the material supplies when drawing, so that the test shader compiles without it. */
const TRIAL_HEAD = `${FRAGMENT_HEAD}
uniform vec3 a_EYE;
uniform vec3 a_AMBIENT;
uniform int a_LIGHT_COUNT;
uniform int a_PASSINDEX;
uniform float a_TIME;
uniform vec2 a_RENDERSIZE;`;

const TRIAL_TAIL = `a_Light a_LIGHT(const in int index) { return a_Light(a_EYE, a_AMBIENT, 1.0); }
vec3 a_IRRADIANCE(const in vec3 normal) { return a_AMBIENT * normal; }
vec3 a_REFLECTION(const in vec3 direction, const in float roughness) { return a_AMBIENT * direction * roughness; }
a_Light a_ENVIRONMENT() { return a_Light(a_EYE, a_AMBIENT, 1.0); }
vec2 a_VIEW_UV(const in vec3 position) { return position.xy; }
float a_VIEW_DEPTH(const in vec3 position) { return position.z; }
float a_PIXEL_M(const in vec3 position) { return position.z; }
vec4 a_BEHIND(const in vec2 uv, const in float roughness) { return vec4(uv, roughness, 1.0); }
void main() {
  a_main();
  scrim_output = vec4(0.0);
}`;

function trialShader({ expanded }: Unit, { head, lines, map }: Stage): LinkedShader {
  const before = [...TRIAL_HEAD.split('\n'), ...head];
  const fragment = `${[...before, ...lines, TRIAL_TAIL].join('\n')}\n`;
  return {
    id: hashText(`${VERTEX_SHADER}\0${fragment}`),
    vertex: VERTEX_SHADER,
    fragment,
    sourceMap: { sources: expanded.sources, nodes: expanded.sources.map(() => ''), lines: [...before.map(() => null), ...map] },
  };
}

function originOf({ sources, lines }: ExpandedText, { line }: Place): { readonly file: string; readonly line: number } {
  const [source, at] = lines[line - 1 - INTERFACE_LINES] ?? [0, 1];
  return { file: sources[source] ?? '', line: at };
}
