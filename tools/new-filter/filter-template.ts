const NAME = /^[a-z][a-z0-9]*(-[a-z0-9]+)*$/;

/** Why a filter cannot be called so, or null; `types` are those that there are. */
export function refuseName(name: string, types: ReadonlySet<string>): string | null {
  if (!NAME.test(name)) return `"${name}" is no name of a filter: write lower-case words joined with "-", such as dark-corners.`;
  return types.has(`filter/${name}`) ? `There is a filter ${name} already.` : null;
}

/** Path in the repository → text: the filter and its test. */
export function filterFiles(name: string): Readonly<Record<string, string>> {
  return {
    [`shader-library/filters/${name}.fs`]: FILTER,
    [`tests/browser/${name}.test.ts`]: testText(name),
  };
}

/** Something to see at once, something to set, and a formula that can be worked out by hand. */
const FILTER = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Darkens the picture towards its corners.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Style"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to darken." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "How dark the corners become.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// From the middle to a corner, where both sides are 1.
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

/** Every pixel another color, opaque. */
const picture = paint(WIDTH, HEIGHT, (x, y) => [x * 8, y * 16, 255 - x * 4, 255]);

const apply = (params?: Params) => applyShader(page, 'filters/${name}.fs', { inputImage: picture }, params);

test.each([0.5, 1])('amount %d follows the formula, worked out here', async (amount) => {
  const expected = paint(WIDTH, HEIGHT, (x, y) => {
    const far = Math.hypot((x + 0.5) / WIDTH - 0.5, (y + 0.5) / HEIGHT - 0.5) / Math.SQRT1_2;
    const kept = 1 - amount * far ** 2;
    return [x * 8 * kept, y * 16 * kept, (255 - x * 4) * kept, 255];
  });
  // Half a step of rounding on either side.
  await expectSamePixels(\`${name}-\${amount}\`, await apply({ amount }), expected, { tolerance: 1 });
});

test('changes nothing at its identity', async () => {
  await expectSamePixels('${name}-identity', await apply({ amount: 0 }), picture, { tolerance: 0 });
});
`;
}
