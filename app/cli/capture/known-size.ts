import type { KnownSize, PhotoPlace } from '../../services/measure-capture.ts';
import { type Call, UsageError } from '../command.ts';

const NUMBER = String.raw`(\d+(?:\.\d+)?)`;
const DISTANCE = new RegExp(`^(.+):${NUMBER},${NUMBER}:${NUMBER},${NUMBER}=${NUMBER}$`);
const PLACE = new RegExp(`^(.+):${NUMBER},${NUMBER}$`);

/** What `--distance`, `--floor` and `--camera-height` say. @throws UsageError */
export function readKnownSize(call: Call): KnownSize {
  const height = call.text('camera-height');
  const floor = call.text('floor');
  if (height !== null && floor === null) throw new UsageError('--camera-height needs --floor, a point below the camera.');
  const scales = ['unit', 'distance', 'camera-height'].filter((option) => call.text(option) !== null);
  if (scales.length > 1)
    throw new UsageError(`${scales.map((option) => `--${option}`).join(' and ')} exclude each other: each gives the unit.`);
  const cameraHeightM = height === null ? null : Number(height);
  if (cameraHeightM !== null && !(cameraHeightM > 0 && Number.isFinite(cameraHeightM))) {
    throw new UsageError(`--camera-height needs a number of meters above 0, not ${JSON.stringify(height)}.`);
  }
  return { distance: readDistance(call.text('distance')), floor: readFloor(floor), cameraHeightM };
}

function readDistance(text: string | null): KnownSize['distance'] {
  if (text === null) return null;
  const [, photo = '', ...numbers] = DISTANCE.exec(text) ?? [];
  const [x1 = 0, y1 = 0, x2 = 0, y2 = 0, meters = 0] = numbers.map(Number);
  if (!(meters > 0)) {
    throw new UsageError(
      `--distance needs a photograph, two places and meters, such as a.jpg:310,842:1490,830=2.1, not ${JSON.stringify(text)}.`,
    );
  }
  return { from: { photo, column: x1, row: y1 }, to: { photo, column: x2, row: y2 }, meters };
}

function readFloor(text: string | null): PhotoPlace | null {
  if (text === null) return null;
  const [, photo, column, row] = PLACE.exec(text) ?? [];
  if (photo === undefined)
    throw new UsageError(`--floor needs a photograph and a place, such as a.jpg:900,1400, not ${JSON.stringify(text)}.`);
  return { photo, column: Number(column), row: Number(row) };
}
