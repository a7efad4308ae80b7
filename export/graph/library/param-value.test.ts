import { expect, test } from '@jest/globals';
import { misfit } from './param-value.ts';

test('a choice that is none is answered with the values that a file holds, and what they are called', () => {
  const mode = { type: 'choice', stage: 'uniform', label: 'Mode', doc: 'How.', default: 0 } as const;
  const options = [
    { value: 0, label: 'Normal' },
    { value: 3, label: 'Lighten' },
  ];
  expect(misfit({ ...mode, options }, 'lighten')).toBe('one of 0 (Normal), 3 (Lighten)');
  expect(misfit({ ...mode, options }, 3)).toBeNull();
});
