import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { checkIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { companionOf } from '../isf/read-isf.ts';
import type { GlslSymbol } from '../syntax/ast.ts';
import { asWritten } from '../syntax/free-names.ts';
import { GlslError } from '../syntax/token.ts';
import { checkLimits } from './limits.ts';
import type { PartedPass } from './link-parts.ts';
import { linkPass, reachOfPass } from './link-pass.ts';
import { type LinkUnit, loopsOf, usable } from './link-unit.ts';
import { varyingsOf } from './link-vertex.ts';
import type { LinkOptions } from './linked-pass.ts';
import { type PlannedPass, planPasses } from './plan-passes.ts';

/**
 * Links an ISF file to GLSL ES 3.00.
 *
 * @returns The passes to draw, in order; or null with SCR041 if the GLSL cannot be parsed or SCR043 if it needs unsupported features. The
 * driver finds all other mistakes (`driverDiagnostics`).
 */
export function linkIsf(shader: IsfShader, options: LinkOptions): Result<readonly PartedPass[]> {
  try {
    const checked = checkIsf(shader, options.partial);
    const unit = { shader, options, ...checked, loops: loopsOf(checked, options) };
    return { output: linkPasses(unit, planPasses(shader)), diagnostics: [...strayUniforms(unit), ...strayVaryings(unit)] };
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    const { code, message, place } = error;
    return {
      output: null,
      diagnostics: [
        { code, severity: 'error', message: asWritten(message), nodeId: options.node, file: error.file ?? shader.file, ...place },
      ],
    };
  }
}

function linkPasses(unit: LinkUnit, passes: readonly PlannedPass[]): PartedPass[] {
  const reached = new Set<GlslSymbol>();
  const authors = passes.filter((pass) => pass.kind === 'author');
  for (const pass of authors) {
    const { instances, globals } = reachOfPass(unit, pass);
    for (const symbol of [...instances.keys(), ...globals]) reached.add(symbol);
  }
  const unused = usable(unit.checked).filter((symbol) => !reached.has(symbol));
  const last = authors.at(-1);
  return passes.map((pass) => {
    const linked = linkPass(unit, pass, pass === last ? unused : []);
    checkLimits(unit.shader, linked);
    return linked;
  });
}

/** Warns about uniforms that nothing sets. As in other hosts, they stay 0 or at their initializer. */
function strayUniforms(unit: LinkUnit): Diagnostic[] {
  const diagnostics: Diagnostic[] = [];
  for (const declaration of unit.checked.declarations) {
    if (declaration.kind !== 'variables' || !declaration.qualifiers.some((qualifier) => qualifier.text === 'uniform')) continue;
    for (const { name, symbol, initializer } of declaration.declarators) {
      const isImage = symbol !== null && unit.checked.strayImages.includes(symbol);
      if (symbol?.role !== 'global' && !isImage) continue;
      const stays = isImage ? 'transparent' : initializer === null ? '0' : 'what it is';
      const message = `Nothing sets the uniform "${asWritten(name.text)}", so it stays ${stays}. Declare it under INPUTS in the header.`;
      const place = { file: unit.shader.file, line: name.line, column: name.column };
      diagnostics.push({ code: 'SCR043', severity: 'warning', message, nodeId: unit.options.node, ...place });
    }
  }
  return diagnostics;
}

/** Warns about varyings that nothing sets. Other hosts reject the file; here they are 0. */
function strayVaryings(unit: LinkUnit): Diagnostic[] {
  const set = unit.vertex === null ? null : varyingsOf(unit.vertex.checked);
  return [...varyingsOf(unit.checked)].flatMap(([name, { token }]): Diagnostic[] => {
    if (set?.has(name)) return [];
    const { file } = unit.shader;
    const why = set === null ? 'which is not there' : 'which does not declare it';
    const message = `Nothing sets "${asWritten(name)}", so it stays 0: it comes from the vertex shader ${companionOf(file)}, ${why}.`;
    const { line, column } = token ?? { line: 1, column: 1 };
    return [{ code: 'SCR043', severity: 'warning', message, nodeId: unit.options.node, file, line, column }];
  });
}
