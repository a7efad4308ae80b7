import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { checkIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import type { FunctionSymbol, GlslSymbol, VariableSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { type LinkUnit, linkPass, reachOfPass } from './link-pass.ts';
import type { LinkedPass, LinkOptions } from './linked-pass.ts';
import { type PlannedPass, planPasses } from './plan-passes.ts';

/**
 * Makes GLSL ES 3.00 of an ISF file: the passes to draw, in order. SCR041 where the GLSL cannot be read, SCR043 where it asks
 * for what Scrim cannot give; everything else that is wrong with it the driver finds (`driverDiagnostics`).
 */
export function linkIsf(shader: IsfShader, options: LinkOptions): Result<readonly LinkedPass[]> {
  const diagnostics = unsupported(shader, options);
  if (diagnostics.length > 0) return { output: null, diagnostics };
  try {
    const unit = { shader, options, ...checkIsf(shader) };
    return { output: linkPasses(unit, planPasses(shader)), diagnostics: strayUniforms(unit) };
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    const { code, message, place } = error;
    return { output: null, diagnostics: [{ code, severity: 'error', message, nodeId: options.node, file: shader.file, ...place }] };
  }
}

function linkPasses(unit: LinkUnit, passes: readonly PlannedPass[]): LinkedPass[] {
  const reached = new Set<GlslSymbol>();
  const authors = passes.filter((pass) => pass.kind === 'author');
  for (const pass of authors) {
    const { instances, globals } = reachOfPass(unit, pass);
    for (const symbol of [...instances.keys(), ...globals]) reached.add(symbol);
  }
  const unused = usable(unit).filter((symbol) => !reached.has(symbol));
  const last = authors.at(-1);
  return passes.map((pass) => linkPass(unit, pass, pass === last ? unused : []));
}

/** Functions and variables that can be printed without being called: those that take no image. */
function usable(unit: LinkUnit): (FunctionSymbol | VariableSymbol)[] {
  const symbols = new Set<FunctionSymbol | VariableSymbol>();
  for (const declaration of unit.checked.declarations) {
    if (declaration.kind === 'function') {
      const { symbol } = declaration;
      if (symbol !== null && !symbol.parameterTypes.includes('sampler2D')) symbols.add(symbol);
      continue;
    }
    for (const { symbol } of declaration.declarators) if (symbol?.role === 'global') symbols.add(symbol);
  }
  return [...symbols];
}

function unsupported(shader: IsfShader, options: LinkOptions): Diagnostic[] {
  const diagnostics: Diagnostic[] = [];

  function refuse(at: { readonly line: number; readonly column: number }, message: string): void {
    const { line, column } = at;
    diagnostics.push({ code: 'SCR043', severity: 'error', message, nodeId: options.node, file: shader.file, line, column });
  }

  for (const input of shader.inputs) {
    if (input.type === 'event') refuse(input, `The input "${input.name}" is an event, which Scrim cannot send to a shader yet.`);
    if (input.type === 'audio' || input.type === 'audioFFT')
      refuse(input, `The input "${input.name}" is sound, which Scrim cannot give to a shader yet.`);
  }
  for (const image of shader.imported)
    refuse(image, `The imported picture "${image.name}" cannot be loaded by Scrim yet. Make it an image input instead.`);
  return diagnostics;
}

/** Other hosts leave them at 0, or at what they are declared with, and so does Scrim. */
function strayUniforms(unit: LinkUnit): Diagnostic[] {
  const diagnostics: Diagnostic[] = [];
  for (const declaration of unit.checked.declarations) {
    if (declaration.kind !== 'variables' || !declaration.qualifiers.some((qualifier) => qualifier.text === 'uniform')) continue;
    for (const { name, symbol, initializer } of declaration.declarators) {
      if (symbol?.role !== 'global') continue;
      const stays = initializer === null ? '0' : 'what it is';
      const message = `Nothing sets the uniform "${name.text}", so it stays ${stays}. Declare it under INPUTS in the header.`;
      const place = { file: unit.shader.file, line: name.line, column: name.column };
      diagnostics.push({ code: 'SCR043', severity: 'warning', message, nodeId: unit.options.node, ...place });
    }
  }
  return diagnostics;
}
