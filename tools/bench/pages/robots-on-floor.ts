import { AnimationMixer, Group, Mesh, MeshStandardMaterial, PlaneGeometry, type Scene, ShadowMaterial } from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

/** Pose of a robot: meters, and radians about the vertical axis. */
export interface Standing {
  readonly x: number;
  readonly z: number;
  readonly turn: number;
  readonly scale: number;
}

/** A floor that shows nothing but shadows. */
export function createFloor(): Mesh {
  const floor = new Mesh(new PlaneGeometry(5, 4.5), new ShadowMaterial({ opacity: 0.55 }));
  floor.rotation.x = -Math.PI / 2;
  floor.receiveShadow = true;
  return floor;
}

/** Adds a copy of the model for each pose, with shadows. Returns what plays their animations. */
export function addRobots(scene: Scene, gltf: GLTF, robots: readonly Standing[]): AnimationMixer[] {
  return robots.map(({ x, z, turn, scale }) => {
    const robot = new Group().add(clone(gltf.scene));
    robot.position.set(x, 0, z);
    robot.rotation.y = turn;
    robot.scale.setScalar(scale);
    robot.traverse((part) => {
      if (!(part instanceof Mesh)) return;
      part.castShadow = true;
      part.receiveShadow = part.material instanceof MeshStandardMaterial;
    });
    scene.add(robot);
    const mixer = new AnimationMixer(robot);
    for (const clip of gltf.animations) mixer.clipAction(clip).play();
    return mixer;
  });
}
