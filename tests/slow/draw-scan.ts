import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { encode } from 'fast-png';
import { Matrix4, Mesh, Raycaster, Vector3 } from 'three';
import { acceleratedRaycast, MeshBVH } from 'three-mesh-bvh';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { addDomPoint } from '../support/dom-point.ts';

const WIDTH = 640;
const HEIGHT = 480;
/** Pixels per side of a square that share a ray: rays are slow under Jest. */
const SQUARE_PX = 2;
/** Half the width of the view at 1 m. */
const HALF_X = 0.6;

/** Writes depth in millimeters of a scanned room, from where a visitor looks around, as a 16-bit image. Returns its name. */
export function drawScan(name: string, folder: string): string {
  addDomPoint();
  const room = createRoom({ capture: JSON.parse(readFileSync(`node_modules/@iwer/sem/captures/${name}.json`, 'utf8')) });
  room.solids.traverse((solid) => {
    if (!(solid instanceof Mesh)) return;
    solid.geometry.boundsTree = new MeshBVH(solid.geometry);
    solid.raycast = acceleratedRaycast;
  });
  const raycaster = new Raycaster();
  raycaster.firstHitOnly = true;
  const origin = new Vector3(0, 1.5, 0);
  const turn = new Matrix4().makeRotationX(-0.5);
  const data = new Uint16Array(WIDTH * HEIGHT);
  const along = new Vector3();
  for (let row = 0; row < HEIGHT; row += SQUARE_PX) {
    for (let column = 0; column < WIDTH; column += SQUARE_PX) {
      const x = ((column + SQUARE_PX / 2) / WIDTH) * 2 - 1;
      const y = (1 - 2 * ((row + SQUARE_PX / 2) / HEIGHT)) * (HEIGHT / WIDTH);
      const length = along.set(x * HALF_X, y * HALF_X, -1).length();
      raycaster.set(origin, along.applyMatrix4(turn).normalize());
      const [hit] = raycaster.intersectObject(room.solids, true);
      const millimeters = hit ? Math.min(Math.round((hit.distance / length) * 1000), 65534) : 0;
      for (let dy = 0; dy < SQUARE_PX; dy++) data.fill(millimeters, (row + dy) * WIDTH + column, (row + dy) * WIDTH + column + SQUARE_PX);
    }
  }
  room.dispose();
  const file = 'view.png';
  writeFileSync(join(folder, file), encode({ width: WIDTH, height: HEIGHT, data, channels: 1, depth: 16 }));
  return file;
}
