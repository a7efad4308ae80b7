import type { DepthAnswers, DepthUnit } from '../../export/captures/depth/depth-scale.ts';
import type { Axis } from '../../export/captures/upright.ts';
import type { PhotographsRequest } from '../state/acquisition/import-photographs.ts';
import type { SelectOption } from '../ui/select-field.tsx';

/** The options of an import as they are typed. */
export interface PhotographsForm {
  readonly sidePx: string;
  readonly up: Axis | 'auto';
  /** Meters per unit of the cameras; empty: as in the files. */
  readonly metersPerUnit: string;
  readonly from: 'auto' | 'mesh' | 'none';
  readonly unit: UnitChoice;
  /** Millimeters per unit, if `unit` is `other`. */
  readonly otherMm: string;
  readonly kind: 'auto' | 'z' | 'ray';
}

type UnitChoice = 'auto' | 'other' | 'reconstruction' | '1' | '0.001' | '0.00025' | '0.0002' | '0.0001' | '0.01';

export const FORM: PhotographsForm = {
  sidePx: '1600',
  up: 'auto',
  metersPerUnit: '',
  from: 'auto',
  unit: 'auto',
  otherMm: '',
  kind: 'auto',
};

/** Units of depth, the usual ones first. */
export const UNITS: readonly SelectOption<Exclude<UnitChoice, 'auto'>>[] = [
  { value: '0.001', label: '1 mm' },
  { value: '0.0002', label: '0.2 mm (1/5000 m, as TUM)' },
  { value: '0.00025', label: '0.25 mm' },
  { value: '0.0001', label: '0.1 mm' },
  { value: '0.01', label: '1 cm' },
  { value: '1', label: '1 m' },
  { value: 'reconstruction', label: 'Unit of the cameras' },
  { value: 'other', label: 'Other' },
];

const LEAST_SIDE_PX = 64;
const MOST_SIDE_PX = 8192;

/** The options of the request; a member is `null` where the text is not valid. */
export interface ReadForm {
  readonly maxSidePx: number | null;
  readonly metersPerUnit: PhotographsRequest['metersPerUnit'] | 'wrong';
  /** Null: the other unit is not typed yet, or not a number. */
  readonly answers: DepthAnswers | null;
}

export function readForm({ sidePx, metersPerUnit, unit, otherMm, kind }: PhotographsForm): ReadForm {
  const side = Number(sidePx);
  const meters = positive(metersPerUnit);
  const read = unitOf(unit, otherMm);
  return {
    maxSidePx: Number.isInteger(side) && side >= LEAST_SIDE_PX && side <= MOST_SIDE_PX ? side : null,
    metersPerUnit: metersPerUnit.trim() === '' ? null : (meters ?? 'wrong'),
    answers: read === 'wrong' ? null : { unit: read, kind: kind === 'auto' ? null : kind },
  };
}

function unitOf(unit: UnitChoice, otherMm: string): DepthUnit | null | 'wrong' {
  switch (unit) {
    case 'auto':
      return null;
    case 'reconstruction':
      return unit;
    case 'other': {
      const mm = positive(otherMm);
      return mm === null ? 'wrong' : mm / 1000;
    }
    case '1':
      return 'm';
    case '0.001':
      return 'mm';
    default:
      return Number(unit);
  }
}

function positive(text: string): number | null {
  const value = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && value > 0 && Number.isFinite(value) ? value : null;
}
