import { expect, test } from '@jest/globals';
import { joinFaces, splitFaces } from './cube-faces.ts';

const files = (...names: string[]) => names.map((name) => ({ name, arrayBuffer: async () => new ArrayBuffer(0) }));
const namesOf = (found: readonly { readonly name: string }[] | null) => found?.map(({ name }) => name) ?? null;

test.each([
  [
    ['nz.png', 'px.png', 'py.png', 'nx.png', 'ny.png', 'pz.png'],
    ['px.png', 'nx.png', 'py.png', 'ny.png', 'pz.png', 'nz.png'],
  ],
  [
    ['sky_back.jpg', 'sky_left.jpg', 'sky_top.jpg', 'sky_right.jpg', 'sky_bottom.jpg', 'sky_front.jpg'],
    ['sky_right.jpg', 'sky_left.jpg', 'sky_top.jpg', 'sky_bottom.jpg', 'sky_front.jpg', 'sky_back.jpg'],
  ],
  [
    ['bay_rt.webp', 'bay_lf.webp', 'bay_up.webp', 'bay_dn.webp', 'bay_ft.webp', 'bay_bk.webp'],
    ['bay_rt.webp', 'bay_lf.webp', 'bay_up.webp', 'bay_dn.webp', 'bay_ft.webp', 'bay_bk.webp'],
  ],
])('finds the faces %j', (names, expected) => {
  const { faces, rest } = splitFaces(files('chair.glb', ...names, 'wood.png'));
  expect(namesOf(faces)).toEqual(expected);
  expect(namesOf(rest)).toEqual(['chair.glb', 'wood.png']);
});

test.each([
  [['px.png', 'nx.png', 'py.png', 'ny.png', 'pz.png']],
  [['a_left.png', 'b_right.png', 'a_top.png', 'a_bottom.png', 'a_front.png', 'a_back.png']],
  [['copyright.png', 'cleft.png', 'stop.png', 'bottom2.png', 'storefront.png', 'paperback.png']],
])('takes %j for separate images', (names) => {
  expect(splitFaces(files(...names)).faces).toBeNull();
});

test('says what to do with faces that hold radiance', async () => {
  await expect(joinFaces(files('px.hdr', 'nx.hdr', 'py.hdr', 'ny.hdr', 'pz.hdr', 'nz.hdr'))).rejects.toThrow('to a cross');
});
