import { describe, expect, test } from '@jest/globals';
import { lookUp, lutImage } from './lut-image.ts';
import { type CubeTable, readCube } from './read-cube.ts';

/** Two entries an axis that leave every color as it is. */
const SAME = `# nothing changes
TITLE "Same"
LUT_3D_SIZE 2
0 0 0
1 0 0
0 1 0
1 1 0
0 0 1
1 0 1
0 1 1   # yellow's opposite is blue
1 1 1
`;

function table(text: string): CubeTable {
  const { output, diagnostics } = readCube(text, 'look.cube');
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  return output;
}

describe('a .cube file', () => {
  test('is read with its comments, line ends and unknown words', () => {
    const read = table(SAME.replaceAll('\n', '\r\n').replace('TITLE', 'LUT_IN_VIDEO_RANGE\r\nTITLE'));
    expect(read).toMatchObject({ kind: '3D', size: 2, domainMin: [0, 0, 0], domainMax: [1, 1, 1] });
    expect(lookUp(read, [0.2, 0.7, 0.4])).toEqual([0.2, 0.7, 0.4].map((value) => expect.closeTo(value, 6)));
  });

  test('says which colors its entries are for', () => {
    const wide = table(SAME.replace('LUT_3D_SIZE 2', 'LUT_3D_SIZE 2\nDOMAIN_MIN -1 -1 -1\nDOMAIN_MAX 3 3 3'));
    expect(lookUp(wide, [1, 0, -5])).toEqual([0.5, 0.25, 0]);
    expect(table('LUT_1D_SIZE 2\nLUT_1D_INPUT_RANGE 0 2\n0 0 0\n1 1 1')).toMatchObject({ domainMax: [2, 2, 2] });
  });

  test.each([
    ['no size', '0 0 0', 1, 1, 'before LUT_3D_SIZE'],
    ['another file', 'hello', 1, 1, 'no .cube file'],
    ['a size that is none', 'LUT_3D_SIZE 1', 1, 13, 'from 2 to 129'],
    ['a size that is too large', 'LUT_3D_SIZE 256', 1, 13, 'from 2 to 129'],
    ['two sizes', 'LUT_1D_SIZE 2\nLUT_3D_SIZE 2', 2, 1, 'two sizes'],
    ['a word among numbers', SAME.replace('1 1 0', '1 one 0'), 7, 3, '“one” is not a number'],
    ['a number too few', SAME.replace('1 1 0', '1 1'), 7, 1, 'The line has 2 numbers instead of 3'],
    ['an entry too few', SAME.replace('1 1 1\n', ''), 11, 1, 'The table has 7 entries, but its size requires 8'],
    ['an entry too many', `${SAME}1 1 1`, 12, 1, 'more than 8 entries'],
    ['a domain upside down', SAME.replace('TITLE', 'DOMAIN_MAX -1 1 1\nTITLE'), 1, 1, 'DOMAIN_MIN is not below'],
  ])('with %s is refused at its place', (_, text, line, column, message) => {
    const { output, diagnostics } = readCube(text, 'look.cube');
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR032', severity: 'error', file: 'look.cube', line, column }]);
    expect(diagnostics[0]?.message).toContain(message);
  });
});

describe('as a picture', () => {
  test('small tables keep their entries, in one row of squares', () => {
    const { widthPx, heightPx, size, columns, rgba } = lutImage(table(SAME));
    expect({ widthPx, heightPx, size, columns }).toEqual({ widthPx: 4, heightPx: 2, size: 2, columns: 2 });
    // Top row: green 0; black, red, then blue, purple.
    expect([...rgba.slice(0, 16)]).toEqual([0, 0, 0, 255, 255, 0, 0, 255, 0, 0, 255, 255, 255, 0, 255, 255]);
  });

  test('curves become eight rows of eight squares', () => {
    const { widthPx, heightPx, size, columns } = lutImage(table('LUT_1D_SIZE 2\n0 0 0\n1 1 1'));
    expect({ widthPx, heightPx, size, columns }).toEqual({ widthPx: 512, heightPx: 512, size: 64, columns: 8 });
  });
});
