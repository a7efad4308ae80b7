import { type BufferGeometry, CapsuleGeometry, CylinderGeometry, Group, type Material, Mesh, SphereGeometry } from 'three';

/**
 * The model of a plain controller, in grip space: the handle along z through the palm, the head in front at -z with its two buttons and
 * stick on top.
 */
export interface ControllerModel {
  readonly root: Group;
  dispose(): void;
}

/** Angle by which the head is tilted relative to the handle, as in controllers of headsets. */
const TILT_RAD = 0.6;

/**
 * Creates the model.
 *
 * @param material The material of all parts; the caller disposes it.
 */
export function createControllerModel(isLeft: boolean, material: Material): ControllerModel {
  const geometries: BufferGeometry[] = [];
  const part = (geometry: BufferGeometry, x: number, y: number, z: number): Mesh => {
    geometries.push(geometry);
    const mesh = new Mesh(geometry, material);
    mesh.position.set(x, y, z);
    return mesh;
  };
  const inward = isLeft ? 1 : -1;
  const handle = part(new CapsuleGeometry(0.017, 0.07, 6, 20).rotateX(Math.PI / 2), 0, 0, 0.005);
  const head = new Group();
  head.position.set(0, 0.008, -0.048);
  head.rotation.x = TILT_RAD;
  head.add(part(new SphereGeometry(1, 24, 16).scale(0.027, 0.014, 0.032), 0, 0, 0));
  const stick = part(new CylinderGeometry(0.008, 0.005, 0.012, 16), -0.008 * inward, 0.016, -0.006);
  head.add(stick);
  head.add(part(new CylinderGeometry(0.0045, 0.0045, 0.006, 12), 0.012 * inward, 0.013, 0.001));
  head.add(part(new CylinderGeometry(0.0045, 0.0045, 0.006, 12), 0.013 * inward, 0.012, -0.013));
  const trigger = part(new CapsuleGeometry(0.007, 0.012, 4, 12), 0, -0.013, -0.05);
  trigger.rotation.x = 0.5;
  const root = new Group();
  root.add(handle, head, trigger);
  root.updateMatrixWorld(true);
  return {
    root,
    dispose: () => {
      for (const geometry of geometries) geometry.dispose();
    },
  };
}
