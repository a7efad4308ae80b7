import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/format-text',
  version: 1,
  title: 'Format text',
  doc: 'Writes numbers into a text, for a Label or a Text 3D. In the template {a} is the number A, {a:2} the same with two decimals and {a:1 cm} a length in meters, written as centimeters with its unit. Units: mm, cm, m, km, in and ft for meters, ° for radians, % for ratios. {text} is the text input, and {{ is a brace. A number that is not finite is written as –.',
  keywords: ['string', 'number to string', 'print', 'decimals', 'unit', 'template', 'compose', 'concat', 'placeholder', 'round', 'label'],
  inputs: {},
  outputs: { result: { type: 'text', label: 'Text', doc: 'The template with the values in it.' } },
  params: {
    template: {
      type: 'text',
      stage: 'structure',
      label: 'Template',
      doc: 'The text with placeholders, such as: {a:2 m} ± {b:2 m}',
      default: '{a}',
    },
    a: { type: 'number', stage: 'uniform', label: 'A', doc: 'The value of {a}.', default: 0 },
    b: { type: 'number', stage: 'uniform', label: 'B', doc: 'The value of {b}.', default: 0 },
    c: { type: 'number', stage: 'uniform', label: 'C', doc: 'The value of {c}.', default: 0 },
    d: { type: 'number', stage: 'uniform', label: 'D', doc: 'The value of {d}.', default: 0 },
    text: { type: 'text', stage: 'uniform', label: 'Text', doc: 'The value of {text}.', default: '' },
    decimals: {
      type: 'number',
      stage: 'structure',
      label: 'Decimals',
      doc: 'Digits after the decimal mark where the placeholder names none.',
      default: 2,
      min: 0,
      max: 10,
      step: 1,
    },
    mark: {
      type: 'choice',
      stage: 'structure',
      label: 'Decimal mark',
      doc: 'The mark before the decimals. With that of the visitor’s language, renders on two machines can differ.',
      default: 'point',
      options: [
        { value: 'point', label: 'Point' },
        { value: 'visitor', label: 'That of the visitor’s language' },
      ],
    },
  },
  lowering: { kind: 'value' },
});
