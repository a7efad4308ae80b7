import { parseExpression } from '../../export/graph/expression/expression-parser.ts';
import type { Unit } from '../../nodes/kit/definition.ts';
import { EXPRESSION_CLOCK } from '../../nodes/kit/expression.ts';
import { playExpression } from '../../nodes/kit/play-expression.ts';
import { parseNumber, shownUnit, storedPerTyped } from '../state/params/units.ts';

/**
 * Parses a typed number or arithmetic (`1/3`, `=2*12`, `1 m + 20 cm`).
 *
 * @param unit Unit that the field shows; numbers without a unit are in it.
 * @returns The value in stored units, or null if the text is not a number.
 */
export function parseTyped(text: string, unit: Unit | undefined): number | null {
  const bare = text.trim().replace(/^=/, '');
  return parseNumber(bare, unit) ?? valueOfSum(inShownUnits(bare, unit), shownUnit(unit).shownPerStored);
}

/** Converts numbers with a unit to the shown unit. A percent sign between numbers is the modulo operator. */
function inShownUnits(text: string, unit: Unit | undefined): string {
  return text.replace(/(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([a-z°]+)(?![\w(])/gi, (all, number: string, typed: string) => {
    const factor = storedPerTyped(typed, unit);
    return factor === undefined ? all : `(${number} * ${factor * shownUnit(unit).shownPerStored})`;
  });
}

function valueOfSum(text: string, shownPerStored: number): number | null {
  const parsed = parseExpression(text, 1);
  const postfix = parsed.ok ? (parsed.parts[0] ?? '') : '';
  if (postfix === '' || postfix.split(' ').some((word) => EXPRESSION_CLOCK.some((name) => name === word))) return null;
  const played = playExpression(postfix);
  played.update({ timeS: 0, frame: 0 });
  const value = (played.results[0] ?? Number.NaN) / shownPerStored;
  return Number.isFinite(value) ? value : null;
}
