import { parseExpression } from '../../export/graph/expression/parse-expression.ts';
import type { Unit } from '../../nodes/kit/definition.ts';
import { EXPRESSION_CLOCK } from '../../nodes/kit/expression.ts';
import { playExpression } from '../../nodes/kit/play-expression.ts';
import { parseNumber, shownUnit, storedPerTyped } from './units.ts';

/** What was typed as a number, in stored units: a number, or sums that come to one (`1/3`, `=2*12`, `1 m + 20 cm`); null for all else. */
export function parseTyped(text: string, unit: Unit | undefined): number | null {
  const bare = text.trim().replace(/^=/, '');
  return parseNumber(bare, unit) ?? valueOfSum(inShownUnits(bare, unit), shownUnit(unit).shownPerStored);
}

/** Numbers with a unit become numbers of the unit that is shown; a percent sign between numbers is the rest of a division. */
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
