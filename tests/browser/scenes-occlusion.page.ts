import {
  AdditiveBlending,
  BoxGeometry,
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
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import type { ObjectList, RoomDepthOutput } from '../../nodes/kit/runtime.ts';
import type { RoomDepth } from '../../nodes/kit/session.ts';
import {
  covered,
  createLayer,
  createStand,
  difference,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  type Stand,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const FRONT = lookingAt([0, 0, 2], [0, 0, 0]);
const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Metres per texel, bottom row first. */
function room(gl: WebGL2RenderingContext, widthPx: number, heightPx: number, metres: number[], uvFromViewUv = IDENTITY): RoomDepth {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, widthPx, heightPx, 0, gl.RED, gl.FLOAT, new Float32Array(metres));
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  return { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(uvFromViewUv), worldFromDepth: new Float32Array(16) };
}

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
  backend.invalidateState();
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

const LAYER_FORM = `#version 300 es
precision highp float;
uniform sampler2D color, depth, room;
uniform mat3 roomUvFromViewUv;
uniform float nearM, farM, softnessM, biasM;
out vec4 result;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 uv = roomUvFromViewUv * vec3(gl_FragCoord.xy / vec2(${WIDTH}, ${HEIGHT}), 1.0);
  float window = texelFetch(depth, at, 0).r;
  float depthM = nearM * farM / (farM - window * (farM - nearM));
  float roomM = texture(room, uv.xy / uv.z).r;
  float behindM = depthM - roomM - biasM;
  float hidden = roomM <= 0.0 ? 0.0 : softnessM > 0.0 ? clamp(behindM / softnessM, 0.0, 1.0) : step(0.0, behindM);
  result = texelFetch(color, at, 0) * (1.0 - hidden);
}`;

/** The layer form, written down a second time: a finished layer times the visibility of its nearest surface. */
function layerForm(stand: Stand, depth: RoomDepth, softnessM: number, biasM: number): Uint8Array {
  const { gl, layer } = stand;
  const program = gl.createProgram();
  const vertex = '#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }';
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex] as const, [gl.FRAGMENT_SHADER, LAYER_FORM] as const]) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error('no shader');
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  const out = createLayer(gl, WIDTH, HEIGHT);
  gl.bindFramebuffer(gl.FRAMEBUFFER, out.framebuffer);
  gl.viewport(0, 0, WIDTH, HEIGHT);
  for (const capability of [gl.BLEND, gl.DEPTH_TEST, gl.CULL_FACE, gl.SCISSOR_TEST]) gl.disable(capability);
  gl.bindVertexArray(null);
  gl.useProgram(program);
  [layer.color, layer.depth, depth.texture].forEach((texture, unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(gl.getUniformLocation(program, ['color', 'depth', 'room'][unit] ?? ''), unit);
  });
  gl.uniformMatrix3fv(gl.getUniformLocation(program, 'roomUvFromViewUv'), false, depth.uvFromViewUv);
  for (const [name, value] of Object.entries({ nearM: 0.1, farM: 50, softnessM, biasM }))
    gl.uniform1f(gl.getUniformLocation(program, name), value);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = out.pixels();
  out.dispose();
  return pixels;
}

/** Overlapping, self-overlapping and intersecting opaque things through a slanted room. */
export function equalForms() {
  const stand = createStand();
  const { gl } = stand;
  const thing = (mesh: Mesh, x: number, y: number, z: number) => item(mesh, { at: translation(x, y, z) });
  const list = objects(
    thing(new Mesh(new TorusKnotGeometry(0.35, 0.12, 96, 12), new MeshStandardMaterial({ color: 0xcc5533 })), -0.3, 0.1, 0),
    thing(new Mesh(new BoxGeometry(0.8, 0.5, 0.5), new MeshPhongMaterial({ color: 0x3355cc })), 0.3, -0.2, -0.2),
    thing(new Mesh(new SphereGeometry(0.4, 32, 24), new MeshLambertMaterial({ color: 0x55cc33 })), 0.2, 0.3, 0.2),
    item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial({ color: 0x888888 })), { at: translation(0, 0, -0.6) }),
    item(new Mesh(new SphereGeometry(0.2), new MeshBasicMaterial()), { role: 'phantom', at: translation(-0.1, -0.2, 0.5) }),
  );
  // From 1.4 m on the left to 2.8 m on the right, with holes, at a coarse resolution.
  const metres = Array.from({ length: 20 * 15 }, (_, i) => (i % 17 === 0 ? 0 : 1.4 + ((i % 20) / 19) * 1.4));
  const depth = room(gl, 20, 15, metres, [0.9, 0.05, 0, -0.05, 0.9, 0, 0.07, 0.02, 1]);
  const compare = (softnessM: number, biasM: number) => {
    const early = shoot(stand, list, depth, { softnessM: { value: softnessM }, biasM: { value: biasM } });
    const whole = shoot(stand, list, null);
    const late = layerForm(stand, depth, softnessM, biasM);
    return { ...difference(early, late), hidden: covered(whole) - covered(late), shown: covered(late) };
  };
  return { hard: compare(0, 0), biased: compare(0, 0.15), soft: compare(0.4, 0), error: gl.getError() };
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
    backend.invalidateState();
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
    backend.invalidateState();
    scene.draw(drawView(view, layer.framebuffer, viewIndex));
  }
  const eyes = [40, 120].map((x) => pixel(layer.pixels(), x, 60)[3]);

  const casters = objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial()), { at: translation(0, 0, 5) }));
  const light = lights(sun([0, 0, 1], { shadow: { areaM: 20, mapSizePx: 256, bias: 0, normalBiasM: 0.1 } }));
  const maps = backend.createShadowMaps([casters], light);
  const halfRoom: RoomDepthOutput = { views: [room(gl, 2, 1, [1, 5])] };
  const look = { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) } } as const;
  const shadow = backend.serviceFor({ shadowMaps: maps, occlusion: { roomDepth: halfRoom, params: {} } }).createScene(look);
  shadow.update([objects(item(new Mesh(new PlaneGeometry(9, 9), new MeshBasicMaterial()), { role: 'phantom' }))], [light]);
  backend.invalidateState();
  maps.update();
  layer.clear();
  backend.invalidateState();
  shadow.draw(drawView(viewOf(FRONT), layer.framebuffer));
  const shadows = [40, 120].map((x) => pixel(layer.pixels(), x, 60)[3]);
  return { eyes, shadows, error: gl.getError() };
}
