/** A measured value as text, in the unit and the number format of a locale. */

export type LengthUnit = 'm' | 'cm' | 'ft' | 'in';
export type Dimension = 'length' | 'area' | 'volume' | 'angle';

const METERS: Readonly<Record<LengthUnit, number>> = { m: 1, cm: 0.01, ft: 0.3048, in: 0.0254 };
const POWER: Readonly<Record<Exclude<Dimension, 'angle'>, number>> = { length: 1, area: 2, volume: 3 };
const SUFFIX = ['', '', '²', '³'] as const;
/** Regions that measure in feet and inches (Unicode CLDR, measurement system US). */
const FEET: ReadonlySet<string> = new Set(['US', 'LR', 'MM']);

/** Writes measured values in one locale; number formats are cached. */
export interface ValueFormat {
  /**
   * Writes a value such as `1.23 m ± 0.02 m`, with as many digits as its uncertainty allows.
   *
   * @param value SI units: m, m², m³ or radians.
   * @param uncertainty Half-width of the 95 % interval, in the unit of the value.
   */
  write(value: number, uncertainty: number, dimension: Dimension): string;
}

/**
 * Creates a format.
 *
 * @param unit `auto`: meters and centimeters, or feet and inches, by the region of the locale and the size of the value.
 * @param locale BCP 47. Undefined: that of the browser.
 */
export function createValueFormat(unit: LengthUnit | 'auto', locale?: string): ValueFormat {
  const formats: Intl.NumberFormat[] = [];
  const resolved = new Intl.NumberFormat(locale).resolvedOptions().locale;
  const isInFeet = FEET.has(new Intl.Locale(resolved).maximize().region ?? '');
  const digits = (value: number, decimals: number): string => {
    formats[decimals] ??= new Intl.NumberFormat(locale, { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
    return formats[decimals].format(value);
  };
  const unitOf = (value: number, power: number): LengthUnit => {
    if (unit !== 'auto') return unit;
    const [large, small] = isInFeet ? (['ft', 'in'] as const) : (['m', 'cm'] as const);
    return value >= METERS[large] ** power ? large : small;
  };
  return {
    write: (value, uncertainty, dimension) => {
      if (dimension === 'angle') {
        const degrees = 180 / Math.PI;
        return join(digits, value * degrees, uncertainty * degrees, '°', '');
      }
      const power = POWER[dimension];
      const chosen = unitOf(value, power);
      const scale = METERS[chosen] ** power;
      return join(digits, value / scale, uncertainty / scale, `${chosen}${SUFFIX[power]}`, ' ');
    },
  };
}

function join(
  digits: (value: number, decimals: number) => string,
  value: number,
  uncertainty: number,
  unit: string,
  space: string,
): string {
  const decimals = decimalsOf(uncertainty);
  // A narrow no-break space keeps number and unit on one line.
  const gap = space === '' ? '' : ' ';
  return `${digits(value, decimals)}${gap}${unit} ± ${digits(uncertainty, decimals)}${gap}${unit}`;
}

/**
 * The number of decimals of a value: those up to the first digit of the uncertainty, or up to its second if the first is 1; at most four.
 */
function decimalsOf(uncertainty: number): number {
  if (!(uncertainty > 0)) return 3;
  const exponent = Math.floor(Math.log10(uncertainty));
  const first = uncertainty / 10 ** exponent;
  return Math.min(Math.max(first < 2 ? 1 - exponent : -exponent, 0), 4);
}
