import {
  AdditiveBlending,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshMatcapMaterial,
  MeshNormalMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  PlaneGeometry,
  Points,
  PointsMaterial,
} from 'three';
import type { ObjectList, RoomDepthOutput } from '../../nodes/kit/scene-lists.ts';
import type { RoomDepth } from '../../nodes/kit/session.ts';
import {
  covered,
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  room,
  type Stand,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const FRONT = lookingAt([0, 0, 2], [0, 0, 0]);
interface Params {
  softnessM?: { value: number };
  biasM?: { value: number };
}

/** One frame of a scene whose only reader is an occlusion. */
function shoot(stand: Stand, list: ObjectList, depth: RoomDepth | null, params: Params = {}): Uint8Array {
  const { backend, layer } = stand;
  const roomDepth: RoomDepthOutput = { views: [depth] };
  const scene = backend
    .serviceFor({
      shadowMaps: null,
      occlusion: depth ? { roomDepth, params: { softnessM: { value: 0 }, biasM: { value: 0 }, ...params } } : null,
    })
    .createScene({ kind: 'shaded', ambient: { value: 0 } });
  scene.update([list], [lights(sun([0.2, 0.3, 1]))]);
  layer.clear();
  scene.draw(drawView(viewOf(FRONT), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

/** A white sheet 2 m away that fills the view. */
const wall = (): ObjectList => objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial())));

/** Where the room is nearer than the sheet, by view UV. */
export function border() {
  const stand = createStand();
  const { gl } = stand;
  const at = (pixels: Uint8Array): number[] => [20, 60, 100, 140].map((x) => pixel(pixels, x, HEIGHT / 2)[3] ?? 0);
  // Columns: before the sheet, just before, just behind, unknown.
  const columns = [1, 1.99, 2.01, 0];
  const turned = [0, 1, 0, -1, 0, 0, 1, 0, 1];
  const rows = shoot(stand, wall(), room(gl, 4, 1, columns, turned));
  const result = {
    columns: at(shoot(stand, wall(), room(gl, 4, 1, columns))),
    // A crop of the middle half: columns 1 and 2 fill the view.
    cropped: at(shoot(stand, wall(), room(gl, 4, 1, columns, [0.5, 0, 0, 0, 1, 0, 0.25, 0, 1]))),
    flipped: at(shoot(stand, wall(), room(gl, 4, 1, columns, [-1, 0, 0, 0, 1, 0, 1, 0, 1]))),
    // A quarter turn: u = 1 - v of the view, so columns become rows from the top.
    turned: [105, 75, 45, 15].map((y) => pixel(rows, 80, y)[3]),
    biased: at(shoot(stand, wall(), room(gl, 4, 1, columns), { biasM: { value: 0.02 } })),
    // 2 m is 0.4 of the way through a border from 1.8 to 2.3 m.
    soft: pixel(shoot(stand, wall(), room(gl, 1, 1, [1.8]), { softnessM: { value: 0.5 } }), 80, 60),
    error: gl.getError(),
  };
  return result;
}

/** Every kind of material, hidden by the left half of the room; and what it took to compile them. */
export function everyMaterial() {
  const stand = createStand();
  const { gl, backend } = stand;
  const materials: Record<string, Material> = {
    basic: new MeshBasicMaterial(),
    lambert: new MeshLambertMaterial(),
    phong: new MeshPhongMaterial(),
    standard: new MeshStandardMaterial(),
    physical: new MeshPhysicalMaterial({ clearcoat: 1 }),
    glass: new MeshPhysicalMaterial({ transmission: 1, color: 0x808080 }),
    toon: new MeshToonMaterial(),
    matcap: new MeshMatcapMaterial(),
    normal: new MeshNormalMaterial(),
    blended: new MeshBasicMaterial({ transparent: true, opacity: 0.6 }),
    added: new MeshBasicMaterial({ transparent: true, blending: AdditiveBlending }),
  };
  const depth = room(gl, 2, 1, [1, 5]);
  const halves = (list: ObjectList): [number, number] => {
    const pixels = shoot(stand, list, depth);
    const count = (from: number, to: number): number => {
      let seen = 0;
      for (let y = 0; y < HEIGHT; y++) for (let x = from; x < to; x++) if (pixel(pixels, x, y).some((value) => value > 0)) seen++;
      return seen;
    };
    return [count(0, WIDTH / 2), count(WIDTH / 2, WIDTH)];
  };
  const seen: Record<string, [number, number]> = {};
  for (const [name, material] of Object.entries(materials)) seen[name] = halves(objects(item(new Mesh(new PlaneGeometry(9, 9), material))));
  const cross = new BufferGeometry().setAttribute('position', new Float32BufferAttribute([-1, 0, 0, 1, 0, 0], 3));
  seen.lines = halves(objects(item(new Group().add(new LineSegments(cross, new LineBasicMaterial())))));
  seen.points = halves(
    objects(item(new Group().add(new Points(cross.clone().scale(0.5, 1, 1), new PointsMaterial({ size: 8, sizeAttenuation: false }))))),
  );
  // Moving depth, params and objects are no reason to compile.
  const roomDepth: RoomDepthOutput = { views: [depth] };
  const params = { softnessM: { value: 0 }, biasM: { value: 0 } };
  const list = objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshStandardMaterial())));
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: { roomDepth, params } }).createScene({ kind: 'shaded' });
  const programs: number[] = [];
  const compiles = gl.compileShader.bind(gl);
  let compiled = 0;
  gl.compileShader = (shader) => {
    compiled++;
    compiles(shader);
  };
  const perFrame: number[] = [];
  for (let frame = 0; frame < 4; frame++) {
    params.softnessM.value = frame * 0.1;
    roomDepth.views[0] = frame === 2 ? null : depth;
    const before = compiled;
    scene.update([list], [lights(sun([0, 0, 1]))]);
    stand.layer.clear();
    scene.draw(drawView(viewOf(FRONT), stand.layer.framebuffer));
    perFrame.push(compiled - before);
    programs.push(covered(stand.layer.pixels()));
  }
  scene.dispose();
  return { seen, perFrame, covered: programs, error: gl.getError() };
}

/** Two views with different rooms, and shadows hidden as objects are. */
export function viewsAndShadows() {
  const { gl, backend, layer } = createStand();
  const roomDepth: RoomDepthOutput = { views: [room(gl, 1, 1, [1]), room(gl, 1, 1, [5])] };
  const service = backend.serviceFor({ shadowMaps: null, occlusion: { roomDepth, params: {} } });
  const scene = service.createScene({ kind: 'shaded' });
  scene.update([wall()], []);
  layer.clear();
  for (const viewIndex of [0, 1]) {
    const view = viewOf(FRONT, { x: viewIndex * 80, y: 0, widthPx: 80, heightPx: HEIGHT });
    scene.draw(drawView(view, layer.framebuffer, viewIndex));
  }
  const eyes = [40, 120].map((x) => pixel(layer.pixels(), x, 60)[3]);

  const casters = objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial()), { at: translation(0, 0, 5) }));
  const light = lights(sun([0, 0, 1], { shadow: { areaM: 20, mapSizePx: 256, bias: 0, normalBiasM: 0.1 } }));
  const maps = backend.createShadowMaps([casters], [light]);
  const halfRoom: RoomDepthOutput = { views: [room(gl, 2, 1, [1, 5])] };
  const look = { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) } } as const;
  const shadow = backend.serviceFor({ shadowMaps: maps, occlusion: { roomDepth: halfRoom, params: {} } }).createScene(look);
  shadow.update([objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial()), { role: 'phantom' }))], [light]);
  maps.update();
  layer.clear();
  shadow.draw(drawView(viewOf(FRONT), layer.framebuffer));
  const shadows = [40, 120].map((x) => pixel(layer.pixels(), x, 60)[3]);
  return { eyes, shadows, error: gl.getError() };
}
