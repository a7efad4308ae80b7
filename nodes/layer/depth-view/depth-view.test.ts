import { test } from '@jest/globals';
import { expectSpeaksFor } from '../../../tests/support/shader-definition.ts';
import { definition } from './definition.ts';

/** What it looks like is proved on pixels, in `tests/browser/room-depth.test.ts`. */
test('its shader is one the definition can speak for: same ports, same ranges, same cost', () => {
  expectSpeaksFor(definition, new URL('./depth-view.fs', import.meta.url));
});
