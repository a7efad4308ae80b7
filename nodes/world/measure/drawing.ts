import {
  type BufferGeometry,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { setMaterialColor } from '../../kit/three/material-color.ts';
import { createMeshItem } from '../../kit/three/mesh-item.ts';
import type { Figure } from './figure.ts';

/** The lines and ends of a measurement as objects, which the room hides like other objects. */
export interface Drawing {
  /** Changes whenever the objects do, apart from their color. */
  readonly version: number;
  /**
   * Updates the objects.
   *
   * @param color Display-referred sRGB, straight alpha.
   */
  update(figure: Figure, widthM: number, color: ArrayLike<number>): void;
  dispose(): void;
}

/** Size of the ends relative to the width of the lines, so that they stand out. */
const END_RATIO = 3;
const UP = new Vector3(0, 1, 0);

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchAlong = new Vector3();
const scratchMiddle = new Vector3();
const scratchScale = new Vector3();
const scratchRotation = new Quaternion();

export function createDrawing(output: ObjectList, { lines, ends }: Figure): Drawing {
  const material = new MeshBasicMaterial();
  const make = (key: string, geometry: BufferGeometry, count: number) => {
    const mesh = new InstancedMesh(geometry, material, count);
    mesh.count = 0;
    const item = createMeshItem(key, mesh, { hidden: true });
    output.items.push(item);
    return { mesh, item };
  };
  const rods = make('lines', new CylinderGeometry(0.5, 0.5, 1, 8), lines.length / 2);
  const balls = make('ends', new SphereGeometry(0.5, 16, 12), ends.length);
  output.version++;

  let version = 0;
  /** Sets the matrix of an instance to `scratchMatrix`. Returns whether it was another. */
  function put({ mesh }: typeof rods, index: number): boolean {
    const { array } = mesh.instanceMatrix;
    let changed = false;
    for (let n = 0; n < 16; n++) if (array[16 * index + n] !== Math.fround(scratchMatrix.elements[n] ?? 0)) changed = true;
    if (changed) mesh.setMatrixAt(index, scratchMatrix);
    return changed;
  }
  function show({ mesh, item }: typeof rods, count: number, moved: boolean): void {
    if (!moved && mesh.count === count) return;
    version++;
    item.hidden = count === 0;
    mesh.count = count;
    mesh.instanceMatrix.needsUpdate = true;
    if (count > 0) mesh.computeBoundingSphere();
  }

  return {
    get version() {
      return version;
    },
    update: (figure, widthM, color) => {
      setMaterialColor(material, color);
      let rodsMoved = false;
      let ballsMoved = false;
      for (let i = 0; i < figure.lineCount; i++) {
        const [from, to] = [figure.lines[2 * i] as Vector3, figure.lines[2 * i + 1] as Vector3];
        const lengthM = scratchAlong.subVectors(to, from).length();
        scratchRotation.setFromUnitVectors(UP, lengthM > 0 ? scratchAlong.divideScalar(lengthM) : UP);
        scratchMiddle.addVectors(from, to).multiplyScalar(0.5);
        scratchMatrix.compose(scratchMiddle, scratchRotation, scratchScale.set(widthM, lengthM, widthM));
        if (put(rods, i)) rodsMoved = true;
      }
      for (let i = 0; i < figure.endCount; i++) {
        scratchMatrix.makeScale(END_RATIO * widthM, END_RATIO * widthM, END_RATIO * widthM).setPosition(figure.ends[i] as Vector3);
        if (put(balls, i)) ballsMoved = true;
      }
      show(rods, widthM > 0 ? figure.lineCount : 0, rodsMoved);
      show(balls, widthM > 0 ? figure.endCount : 0, ballsMoved);
    },
    dispose: () => {
      rods.mesh.geometry.dispose();
      balls.mesh.geometry.dispose();
      rods.mesh.dispose();
      balls.mesh.dispose();
      material.dispose();
    },
  };
}
