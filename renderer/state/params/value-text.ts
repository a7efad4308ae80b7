import type { Binding } from '../../../export/graph/project.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import { STOP_NUMBERS } from '../../../nodes/kit/gradient.ts';
import { formatNumber, shownUnit } from './units.ts';

/** The constant value of a binding; for a track or an expression, the default value. */
export function boundValue(param: ParamDefinition, binding: Binding | undefined): ParamValue {
  if (binding !== undefined && 'value' in binding) return binding.value;
  if (binding !== undefined && 'port' in binding) return binding.port;
  return param.default;
}

/** Short text of a value on a node: `4 px`, `#c08040`, `on`. */
export function valueText(param: ParamDefinition, binding: Binding | undefined): string {
  if (binding !== undefined && 'track' in binding) return 'keys';
  if (binding !== undefined && 'expression' in binding) return binding.expression;
  const value = boundValue(param, binding);
  switch (param.type) {
    case 'number': {
      const { suffix, shownPerStored } = shownUnit(param.unit);
      const number = formatNumber(rounded(Number(value) * shownPerStored));
      return suffix === '' || suffix === '°' ? `${number}${suffix}` : `${number} ${suffix}`;
    }
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return numbersOf(value)
        .map((part) => formatNumber(rounded(part * shownUnit(param.unit).shownPerStored)))
        .join(', ');
    case 'color':
      return `#${numbersOf(value)
        .slice(0, 3)
        .map((part) =>
          Math.round(part * 255)
            .toString(16)
            .padStart(2, '0'),
        )
        .join('')}`;
    case 'toggle':
      return value === true ? 'on' : 'off';
    case 'choice':
      return param.options.find((option) => option.value === value)?.label ?? String(value);
    case 'curve':
      return `${numbersOf(value).length / 2} points`;
    case 'gradient':
      return `${numbersOf(value).length / STOP_NUMBERS} stops`;
    case 'text':
    case 'asset':
      return String(value);
  }
}

function rounded(value: number): number {
  return Math.round(value * 100) / 100;
}

function numbersOf(value: ParamValue): readonly number[] {
  return Array.isArray(value) ? value : [];
}
