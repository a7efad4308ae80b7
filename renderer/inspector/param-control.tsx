import { type Curve, curveMisfit } from '../../nodes/kit/curve.ts';
import type {
  AssetParam,
  ChoiceParam,
  ColorParam,
  NumberParam,
  ParamDefinition,
  ParamValue,
  TableParam,
  TextParam,
  ToggleParam,
  VectorParam,
} from '../../nodes/kit/definition.ts';
import { type Gradient, gradientMisfit } from '../../nodes/kit/gradient.ts';
import { ColorField } from '../ui/color-field.tsx';
import type { Rgba } from '../ui/color-text.ts';
import { CurveField } from '../ui/curve-field.tsx';
import { GradientField } from '../ui/gradient-field.tsx';
import { type EditHandlers, NumberField } from '../ui/number-field.tsx';
import { SelectField } from '../ui/select-field.tsx';
import { Slider } from '../ui/slider.tsx';
import { AssetPicker } from './asset-picker.tsx';
import { ColorSwatches } from './color-swatches.tsx';
import './inspector.css';
import { EyedropperButton } from '../preview-panel/eyedropper-button.tsx';
import { clampTo, formatNumber, rangeOf, shownUnit } from '../state/params/units.ts';
import { parseTyped } from './typed-number.ts';

interface ControlProps<P extends ParamDefinition> extends Required<EditHandlers<ParamValue>> {
  readonly param: P;
  readonly value: ParamValue;
  /** Element id, which the `for` of the label refers to. */
  readonly id: string;
  /** Called with an expression typed in place of a number, without its `=`. Returns false if it is invalid. */
  readonly onExpression: (text: string) => boolean;
  /** Called with a choice that the pointer or a key rests on; null: with none. */
  readonly onPoint: (value: ParamValue | null) => void;
}

/** Classes of the row of a param: controls that need it have the whole width. */
export function rowClass({ type }: ParamDefinition): string {
  if (type === 'curve') return 'param-row param-row-curve';
  return type.startsWith('vector') || type === 'color' || type === 'gradient' ? 'param-row param-row-wide' : 'param-row';
}

/** The control for the type of a param. Independent of node types. */
export function ParamControl({ param, ...rest }: ControlProps<ParamDefinition>) {
  switch (param.type) {
    case 'number':
      return <NumberControl param={param} {...rest} />;
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return <VectorControl param={param} {...rest} />;
    case 'color':
      return <ColorControl param={param} {...rest} />;
    case 'toggle':
      return <ToggleControl param={param} {...rest} />;
    case 'text':
      return <TextControl param={param} {...rest} />;
    case 'choice':
      return <ChoiceControl param={param} {...rest} />;
    case 'curve':
      return <CurveControl param={param} {...rest} />;
    case 'gradient':
      return <GradientControl param={param} {...rest} />;
    case 'asset':
      return <AssetControl param={param} {...rest} />;
  }
}

function NumberControl({ param, value, id, onExpression, onPoint: _, ...gesture }: ControlProps<NumberParam>) {
  const { suffix, shownPerStored } = shownUnit(param.unit);
  const range = rangeOf(param);
  const stored = Number(value);
  const format = (number: number) => formatNumber(number * shownPerStored);
  const field = (
    <NumberField
      id={id}
      label={param.label}
      value={stored}
      step={range.step}
      suffix={suffix}
      format={format}
      parse={(text) => parseTyped(text, param.unit)}
      clamp={(number) => clampTo(number, range)}
      {...(param.stage === 'uniform' ? { onExpression } : {})}
      {...gesture}
    />
  );
  if (range.min === undefined || range.max === undefined) return field;
  return (
    <div className="number-control">
      <Slider
        label={`${param.label}, slider`}
        value={stored}
        min={range.min}
        max={range.max}
        step={range.step}
        valueText={`${format(stored)} ${suffix}`}
        {...gesture}
      />
      {field}
    </div>
  );
}

const AXES = ['X', 'Y', 'Z', 'W'] as const;

function VectorControl({ param, value, id, onEdit, onEnd, onCancel, onExpression }: ControlProps<VectorParam>) {
  const { suffix, shownPerStored } = shownUnit(param.unit);
  const parts: readonly number[] = Array.isArray(value) ? value : param.default;
  return (
    <div className="vector-control" data-size={param.default.length}>
      {AXES.slice(0, param.default.length).map((axis, index) => {
        const limits = { min: param.min?.[index], max: param.max?.[index] };
        return (
          <span key={axis} className="vector-part">
            <span aria-hidden="true">{axis}</span>
            <NumberField
              {...(index === 0 ? { id } : {})}
              label={`${param.label} ${axis}`}
              value={parts[index] ?? 0}
              step={0.01 / (param.unit === 'rad' ? shownPerStored / 100 : 1)}
              suffix={suffix}
              format={(number) => formatNumber(number * shownPerStored)}
              parse={(text) => parseTyped(text, param.unit)}
              onExpression={(text) => onExpression(asList(text, parts, index))}
              clamp={(number) => clampTo(number, limits)}
              onEdit={(number) => onEdit(param.default.map((fallback, i) => (i === index ? number : (parts[i] ?? fallback))))}
              onEnd={onEnd}
              onCancel={onCancel}
            />
          </span>
        );
      })}
    </div>
  );
}

/** Turns an expression typed for one component into one for the whole vector. */
function asList(text: string, parts: readonly number[], index: number): string {
  return text.startsWith('[') ? text : `[${parts.map((part, i) => (i === index ? text : String(part))).join(', ')}]`;
}

function ColorControl({ param, value, onEdit, onEnd, onCancel, onPoint }: ControlProps<ColorParam>) {
  const [r = 0, g = 0, b = 0, a = 1] = Array.isArray(value) ? (value as readonly number[]) : param.default;
  const color: Rgba = [r, g, b, a];
  const eyedropper = (
    <EyedropperButton
      label={param.label}
      onTake={([red, green, blue]) => {
        onEdit([red, green, blue, a]);
        onEnd();
      }}
    />
  );
  return (
    <div className="color-control">
      <ColorField label={param.label} value={color} eyedropper={eyedropper} onEdit={onEdit} onEnd={onEnd} onCancel={onCancel} />
      <ColorSwatches
        label={param.label}
        value={color}
        onPoint={onPoint}
        onChoose={(chosen) => {
          onEdit([...chosen]);
          onEnd();
        }}
      />
    </div>
  );
}

function ToggleControl({ param, value, id, onEdit, onEnd }: ControlProps<ToggleParam>) {
  return (
    <input
      id={id}
      type="checkbox"
      role="switch"
      className="switch"
      aria-label={param.label}
      aria-checked={value === true}
      checked={value === true}
      onChange={(event) => {
        onEdit(event.target.checked);
        onEnd();
      }}
    />
  );
}

function TextControl({ param, value, id, onEdit, onEnd }: ControlProps<TextParam>) {
  return (
    <input
      id={id}
      className="field"
      aria-label={param.label}
      value={String(value)}
      onChange={(event) => onEdit(event.target.value)}
      onBlur={onEnd}
    />
  );
}

function ChoiceControl({ param, value, id, onEdit, onEnd, onPoint }: ControlProps<ChoiceParam>) {
  return (
    <SelectField
      id={id}
      label={param.label}
      value={value as string | number}
      options={param.options}
      onPoint={onPoint}
      onChoose={(option) => {
        onEdit(option);
        onEnd();
      }}
    />
  );
}

function CurveControl({ param, value, id, onExpression: _, onPoint: _point, ...gesture }: ControlProps<TableParam>) {
  const curve = curveMisfit(value) === null ? (value as Curve) : param.default;
  return <CurveField id={id} label={param.label} value={curve} {...gesture} />;
}

function GradientControl({ param, value, id: _id, onExpression: _, onPoint: _point, ...gesture }: ControlProps<TableParam>) {
  const gradient = gradientMisfit(value) === null ? (value as Gradient) : param.default;
  const eyedropper = (take: (rgb: readonly [number, number, number]) => void) => <EyedropperButton label={param.label} onTake={take} />;
  return <GradientField label={param.label} value={gradient} eyedropper={eyedropper} {...gesture} />;
}

function AssetControl({ param, value, id, onEdit, onEnd, onPoint }: ControlProps<AssetParam>) {
  return (
    <AssetPicker
      id={id}
      label={param.label}
      kind={param.accept}
      value={String(value)}
      onPoint={onPoint}
      onChoose={(asset) => {
        onEdit(asset);
        onEnd();
      }}
    />
  );
}
