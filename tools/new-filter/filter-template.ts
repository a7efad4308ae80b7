const NAME = /^[a-z][a-z0-9]*(-[a-z0-9]+)*$/;

/**
 * Checks the name of a new filter.
 *
 * @param types The node types that exist.
 * @returns Why the name is refused, or null.
 */
export function refuseName(name: string, types: ReadonlySet<string>): string | null {
  if (!NAME.test(name)) return `“${name}” is not a filter name. Use lower-case words joined with “-”, such as dark-corners.`;
  return types.has(`filter/${name}`) ? `The filter ${name} exists already. Choose another name.` : null;
}

/**
 * The files of a new filter: the shader and its test.
 *
 * @returns Path in the repository → text.
 */
export function filterFiles(name: string): Readonly<Record<string, string>> {
  return {
    [`shader-library/filters/${name}.fs`]: FILTER,
    [`tests/browser/${name}.test.ts`]: testText(name),
  };
}

/** An example with a visible effect, one param, and a formula that a test can compute independently. */
const FILTER = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Darkens an image towards its corners.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Style"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to darken." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the effect: 0 leaves the image unchanged.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// Distance from the center to a corner; both sides have the length 1.
const float CORNER = 0.70710678;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float far = distance(isf_FragNormCoord, vec2(0.5)) / CORNER;
  gl_FragColor = vec4(color.rgb * (1.0 - amount * far * far), color.a);
}
`;

function testText(name: string): string {
  return `import { test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { expectSamePixels } from '../support/pixels.ts';
import { PAGE, paint } from './glsl-kit.ts';
import { applyShader, type Params } from './shader-library-kit.ts';

const page = useModule(PAGE);

const WIDTH = 32;
const HEIGHT = 16;

/** Opaque; every pixel has another color. */
const image = paint(WIDTH, HEIGHT, (x, y) => [x * 8, y * 16, 255 - x * 4, 255]);

const apply = (params?: Params) => applyShader(page, 'filters/${name}.fs', { inputImage: image }, params);

test.each([0.5, 1])('amount %d follows the formula, computed independently', async (amount) => {
  const expected = paint(WIDTH, HEIGHT, (x, y) => {
    const far = Math.hypot((x + 0.5) / WIDTH - 0.5, (y + 0.5) / HEIGHT - 0.5) / Math.SQRT1_2;
    const kept = 1 - amount * far ** 2;
    return [x * 8 * kept, y * 16 * kept, (255 - x * 4) * kept, 255];
  });
  // Rounding: half a step on either side.
  await expectSamePixels(\`${name}-\${amount}\`, await apply({ amount }), expected, { tolerance: 1 });
});

test('the identity value changes nothing', async () => {
  await expectSamePixels('${name}-identity', await apply({ amount: 0 }), image, { tolerance: 0 });
});
`;
}
