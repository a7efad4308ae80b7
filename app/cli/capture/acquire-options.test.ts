import { expect, test } from '@jest/globals';
import { acquireCommand } from '../commands/acquire.ts';
import { parseCall } from '../parse-call.ts';
import { readCamera, readDepthFormat, readPlaces } from './acquire-options.ts';

const call = (...args: string[]) => parseCall(acquireCommand, ['project', ...args]);

test('reads the cameras that the options describe', () => {
  expect(readPlaces(call('--shape', 'grid', '--count', '3x1x2', '--extent', '2,0,4', '--center', '0,1.6,-1', '--yaw', '90'))).toMatchObject(
    {
      shape: 'grid',
      counts: [3, 1, 2],
      extentM: [2, 0, 4],
      centerM: [0, 1.6, -1],
      yawRad: Math.PI / 2,
    },
  );
  expect(readPlaces(call('--count', '42', '--extent', '1.5', '--elevation=-30..60'))).toMatchObject({
    shape: 'outside-in',
    counts: [42, 1, 1],
    extentM: [1.5, 1.5, 1.5],
    elevationRad: [-Math.PI / 6, Math.PI / 3],
  });
  expect(readCamera(call('--size', '640x480', '--fov', '90'))).toEqual({
    projection: 'perspective',
    widthPx: 640,
    heightPx: 480,
    fovYRad: Math.PI / 2,
  });
  expect(readCamera(call('--around'))).toEqual({ projection: 'equirectangular', widthPx: 2048, heightPx: 1024 });
});

test.each([
  [['--shape', 'ring'], /--shape needs one of grid, inside-out, outside-in/],
  [['--shape', 'grid', '--count', '9'], /--count needs the numbers of cameras along x, y and z/],
  [['--count', '3x3x1'], /--count needs a number of cameras/],
  [['--count', '0'], /--count needs/],
  [['--count', '1001'], /is 1001 cameras, more than the 1000 of a capture/],
  [['--extent', '1,2'], /--extent needs three numbers/],
  [['--extent', '0'], /sizes above 0/],
  [['--extent=-1'], /0 or more/],
  [['--center', 'here'], /--center needs three numbers/],
  [['--elevation', '60..10'], /--elevation needs two angles/],
  [['--shape', 'grid', '--elevation', '0..10'], /a grid has none/],
  [['--shape', 'grid', '--yaw', 'left'], /--yaw needs a number/],
  [['--yaw', '90'], /--yaw is for grids and 360° photographs/],
  [['--fov', '180'], /--fov needs an angle from 1 to 150/],
  [['--around', '--fov', '60'], /exclude each other/],
  [['--around', '--size', '1024x768'], /twice as wide as high/],
  [['--size', 'big'], /is not a size/],
  [['--depth-format', 'exr'], /--depth-format needs one of pfm, png/],
])('%j is refused', (args, message) => {
  const read = () => [readPlaces(call(...args)), readCamera(call(...args)), readDepthFormat(call(...args))];
  expect(read).toThrow(message);
});
