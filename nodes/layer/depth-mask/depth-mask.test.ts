import { test } from '@jest/globals';
import { expectSpeaksFor } from '../../../tests/support/shader-definition.ts';
import { definition } from './definition.ts';

/** What it looks like is proved on pixels, in `tests/browser/masks.test.ts`. */
test('its shader is one the definition can speak for: same ports, same ranges, same cost', () => {
  expectSpeaksFor(definition, new URL('./depth-mask.fs', import.meta.url));
});
