import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { encode } from 'fast-png';
import { Matrix4, Mesh, Raycaster, Vector3 } from 'three';
import { acceleratedRaycast, MeshBVH } from 'three-mesh-bvh';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { addDomPoint } from '../support/dom-point.ts';

const WIDTH = 640;
const HEIGHT = 480;
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
  for (let i = 0; i < data.length; i++) {
    const x = ((((i % WIDTH) + 0.5) / WIDTH) * 2 - 1) * HALF_X;
    const y = ((1 - (Math.floor(i / WIDTH) + 0.5) / HEIGHT) * 2 - 1) * HALF_X * (HEIGHT / WIDTH);
    const length = along.set(x, y, -1).length();
    raycaster.set(origin, along.applyMatrix4(turn).normalize());
    const [hit] = raycaster.intersectObject(room.solids, true);
    data[i] = hit ? Math.min(Math.round((hit.distance / length) * 1000), 65534) : 0;
  }
  room.dispose();
  const file = 'view.png';
  writeFileSync(join(folder, file), encode({ width: WIDTH, height: HEIGHT, data, channels: 1, depth: 16 }));
  return file;
}
