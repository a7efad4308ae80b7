import {
  BoxGeometry,
  type BufferGeometry,
  Color,
  DirectionalLight,
  EquirectangularReflectionMapping,
  Group,
  type Light,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  PCFShadowMap,
  PerspectiveCamera,
  PMREMGenerator,
  PointLight,
  Scene,
  SphereGeometry,
  SpotLight,
  type Texture,
  TorusGeometry,
  WebGLRenderer,
} from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { type Drawn, measureFrames } from './frame-ms.ts';

type Place = readonly [xM: number, yM: number, zM: number];

/** Dimensions and positions of the gallery in meters. */
export interface GalleryPlan {
  readonly middle: Place;
  readonly wall: { readonly width: number; readonly height: number };
  readonly rail: number;
  readonly cells: readonly { readonly kind: 'height' | 'place' | 'color' | 'things'; readonly foot: Place }[];
  /** Centers of the cells with the bulb, the spot light, the ball of chalk and the mirror ball. */
  readonly lit: readonly [bulb: Place, stage: Place, matt: Place, mirror: Place];
  /** Positions of the pegs, relative to the center of the cell with the bulb. */
  readonly pegs: readonly (readonly [right: number, up: number])[];
}

type Rgb = readonly [number, number, number];

const BALL = new SphereGeometry(0.5, 48, 32);
const BOX = new BoxGeometry(1, 1, 1);
const RING = new TorusGeometry(0.4, 0.1, 24, 64);

/**
 * Opens the three scenes of the gallery as somebody who knows three.js writes them by hand: as many balls, rails and boxes, the same
 * lights, shadows and panorama. Rings have a standard material, because three.js has none of the techniques. Sines replace the values that
 * move objects, and cost next to nothing.
 */
export async function open(skyUrl: string, widthPx: number, heightPx: number, plan: GalleryPlan): Promise<void> {
  const renderer = new WebGLRenderer({ antialias: false, alpha: true });
  renderer.setSize(widthPx, heightPx, false);
  renderer.autoClear = false;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const camera = new PerspectiveCamera(50, widthPx / heightPx, 0.05, 100);
  const [x, y, z] = plan.middle;
  camera.position.set(x, y + 1.55 * Math.sin(0.25), z + 1.55 * Math.cos(0.25));
  camera.lookAt(x, y, z);

  const pmrem = new PMREMGenerator(renderer);
  const room = pmrem.fromScene(new RoomEnvironment()).texture;
  const sky = await new HDRLoader().loadAsync(skyUrl);
  sky.mapping = EquirectangularReflectionMapping;
  const wall = makeWall(plan, room);
  const scenes = [wall.scene, makeLamps(plan, room), makeSky(plan, pmrem.fromEquirectangular(sky).texture)];

  let timeS = 0;
  stage = {
    gl: renderer.getContext(),
    draw: (deltaS) => {
      timeS += deltaS;
      for (const [i, ball] of wall.moving.entries()) ball.position.y = plan.rail * (0.5 + 0.5 * Math.sin(timeS + i));
      renderer.clear();
      for (const scene of scenes) {
        renderer.clearDepth();
        renderer.render(scene, camera);
      }
    },
  };
}

function makeWall(
  { middle, wall, rail, cells }: GalleryPlan,
  room: Texture,
): { readonly scene: Scene; readonly moving: readonly Object3D[] } {
  const scene = lit(room, 0.8, new DirectionalLight(0xffffff, 0.6 * Math.PI));
  const moving: Object3D[] = [];
  scene.add(mesh(BOX, [wall.width + 0.04, wall.height + 0.04, 0.02], [0.12, 0.13, 0.16], moved(middle, 0, 0, -0.075)));
  for (const { kind, foot } of cells) {
    const cell = new Group();
    cell.position.set(...foot);
    const half: Place = [0, rail / 2, 0];
    if (kind === 'color') cell.add(mesh(BOX, thrice(0.7 * rail), [0.8, 0.3, 0.2], half));
    else if (kind === 'things') cell.add(mesh(RING, thrice(0.9 * rail), [0.85, 0.35, 0.3], half));
    else {
      const ball = mesh(BALL, thrice(0.24 * rail), [0.95, 0.75, 0.3], half);
      moving.push(ball);
      cell.add(ball);
      if (kind === 'height') cell.add(mesh(BOX, [0.05 * rail, rail, 0.05 * rail], [0.2, 0.21, 0.24], half));
    }
    scene.add(cell);
  }
  return { scene, moving };
}

function makeLamps({ lit: [bulbAt, stageAt], pegs }: GalleryPlan, room: Texture): Scene {
  const bulb = new PointLight(new Color(1, 0.72, 0.4), 0.03, 0.17);
  bulb.position.set(...moved(bulbAt, 0, 0, -0.015));
  const spot = new SpotLight(new Color(0.65, 0.85, 1), 0.05, 0.255, 0.3, 0.4);
  spot.position.set(...moved(stageAt, -0.04, 0.05, 0.09));
  spot.target.position.set(...moved(stageAt, 0, 0, -0.045));
  for (const { shadow } of [bulb, spot]) shadow.mapSize.set(512, 512);
  const scene = lit(room, 0.05, bulb, spot);
  scene.add(spot.target);
  const gray: Rgb = [0.75, 0.75, 0.75];
  for (const at of [bulbAt, stageAt]) scene.add(mesh(BOX, [0.118, 0.118, 0.006], gray, moved(at, 0, 0, -0.045)));
  for (const [right, up] of pegs) scene.add(mesh(BALL, thrice(0.018), gray, moved(bulbAt, right, up, -0.035)));
  scene.add(mesh(BALL, thrice(0.034), gray, moved(stageAt, -0.008, -0.01, -0.012)));
  scene.traverse((part) => {
    part.castShadow = true;
    part.receiveShadow = part instanceof Mesh;
  });
  return scene;
}

function makeSky({ lit: [, , matt, mirror], rail }: GalleryPlan, sky: Texture): Scene {
  const scene = lit(sky, 1);
  scene.add(mesh(BALL, thrice(rail), [0.95, 0.95, 0.95], matt));
  scene.add(mesh(BALL, thrice(rail), [1, 1, 1], mirror, { roughness: 0.05, metalness: 1 }));
  return scene;
}

function lit(environment: Texture, intensity: number, ...lights: readonly Light[]): Scene {
  const scene = new Scene();
  scene.environment = environment;
  scene.environmentIntensity = intensity;
  if (lights.length > 0) scene.add(...lights);
  return scene;
}

function mesh(
  geometry: BufferGeometry,
  sizeM: Place,
  color: Rgb,
  positionM: Place,
  surface: { readonly roughness?: number; readonly metalness?: number } = {},
): Mesh {
  const made = new Mesh(geometry, new MeshStandardMaterial({ color: new Color().setRGB(...color), roughness: 1, ...surface }));
  made.scale.set(...sizeM);
  made.position.set(...positionM);
  return made;
}

function moved([x, y, z]: Place, right: number, up: number, near: number): Place {
  return [x + right, y + up, z + near];
}

function thrice(length: number): Place {
  return [length, length, length];
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage, count);
}

let stage: Drawn | null = null;
