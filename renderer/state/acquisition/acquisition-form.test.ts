import { expect, test } from '@jest/globals';
import { type AcquisitionForm, defaultForm, photographsGpuBytes, readForm, reducedCamera, withProjection } from './acquisition-form.ts';

const FORM = defaultForm('My object');
const errorsOf = (part: Partial<AcquisitionForm>) => readForm({ ...FORM, ...part }).errors;

test('the form begins as the command line does', () => {
  const { plan } = readForm(FORM);
  expect([plan?.name, plan?.poses.length, plan?.camera]).toEqual([
    'My object',
    24,
    { projection: 'perspective', widthPx: 1024, heightPx: 768, fovYRad: expect.closeTo(Math.PI / 3, 9) },
  ]);
  // All stand 1 m from the center, and look at it: the z axis of a camera leads away from it.
  for (const m of plan?.poses ?? []) {
    const away = [0, 1, 2].map((axis) => (m[12 + axis] ?? 0) - (axis === 1 ? 1 : 0));
    expect(away).toEqual([8, 9, 10].map((i) => expect.closeTo(m[i] ?? 0, 6)));
  }
});

test('a grid has cameras along three axes, and 360° photographs are twice as wide as high', () => {
  const grid = withProjection({ ...FORM, shape: 'grid', counts: ['2', '1', '3'], extent: ['1', '0', '4'], yaw: '90' }, 'equirectangular');
  const { plan } = readForm(grid);
  expect(plan?.poses.map((m) => [m[12], m[13], m[14]])).toEqual(
    [-2, 0, 2].flatMap((z) => [
      [-0.5, 1, z],
      [0.5, 1, z],
    ]),
  );
  expect(plan?.camera).toEqual({ projection: 'equirectangular', widthPx: 2048, heightPx: 1024 });
  // Turned left by a right angle, the cameras look along −x.
  expect(plan?.poses[0]?.slice(8, 11)).toEqual([1, 0, 0].map((x) => expect.closeTo(x, 9)));
  expect(plan && reducedCamera(plan.camera, 300)).toEqual({ projection: 'equirectangular', widthPx: 300, heightPx: 150 });
  // Six views with mipmaps: photographs of 4 bytes per pixel and a third more, and depth maps.
  expect(plan && photographsGpuBytes(plan)).toBeGreaterThan((6 * 2048 * 1024 * 4 * 4) / 3);
});

test.each([
  ['name', { name: ' … ' }, /name with letters/],
  ['count', { count: '2.5' }, /from 1 to 1000/],
  ['count', { count: '' }, /from 1 to 1000/],
  ['counts', { shape: 'grid', counts: ['20', '20', '3'] }, /These are 1200 cameras/],
  ['center', { center: ['0', 'up', '0'] }, /three numbers/],
  ['extent', { extent: ['1', '0', '1'] }, /above 0/],
  ['extent', { shape: 'grid', extent: ['1', '-1', '1'] }, /at least 0/],
  ['elevation', { lowest: '20', highest: '10' }, /lower one first/],
  ['yaw', { shape: 'grid', yaw: 'left' }, /a number/],
  ['fov', { fov: '180' }, /from 1° to 150°/],
  ['size', { width: '9000' }, /from 16 to 8192/],
  ['size', { projection: 'equirectangular', width: '1023' }, /even number/],
] as const)('an error stands at %s (%#)', (field, part, message) => {
  const errors = errorsOf(part);
  expect(Object.keys(errors)).toEqual([field]);
  expect(errors[field]).toMatch(message);
});
