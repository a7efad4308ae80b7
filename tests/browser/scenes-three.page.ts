import {
  BackSide,
  BoxGeometry,
  type BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshNormalMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  type Object3D,
  type PerspectiveCamera,
  PlaneGeometry,
  Points,
  PointsMaterial,
  Scene,
  SphereGeometry,
  SRGBColorSpace,
  TorusKnotGeometry,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import {
  covered,
  createGl,
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
  readPixels,
  sun,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const CAMERA = (): PerspectiveCamera => lookingAt([1.5, 1.2, 4], [0, 0, 0]);

/** The two properties of three that ADR 7 rests on, without any of our code. */
export function properties() {
  const gl = createGl();
  const three = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  three.autoClear = false;
  const target = new WebGLRenderTarget(1, 1, { colorSpace: SRGBColorSpace });
  (target as unknown as { isXRRenderTarget: boolean }).isXRRenderTarget = true;
  const layer = createLayer(gl, WIDTH, HEIGHT);
  const scene = new Scene().add(new Mesh(new PlaneGeometry(100, 100), new MeshBasicMaterial()));
  const material = (scene.children[0] as Mesh).material as MeshBasicMaterial;
  // Mid-gray in linear light: 0.2159 encodes to 128.
  material.color.setRGB(0.2159, 0.2159, 0.2159);
  const draw = (framebuffer: WebGLFramebuffer | null) => {
    layer.clear();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    three.resetState();
    (three as unknown as { setRenderTargetFramebuffer(t: WebGLRenderTarget, f: WebGLFramebuffer | null): void }).setRenderTargetFramebuffer(
      target,
      framebuffer,
    );
    target.viewport.set(WIDTH / 2, 0, WIDTH / 2, HEIGHT);
    three.setRenderTarget(target);
    three.render(scene, lookingAt([0, 0, 1], [0, 0, 0]));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const canvas = readPixels(gl, WIDTH, HEIGHT);
    const inLayer = layer.pixels();
    return [canvas, inLayer].map((pixels) => [pixel(pixels, 10, 60), pixel(pixels, 150, 60)]);
  };
  return { toLayer: draw(layer.framebuffer), toCanvas: draw(null), error: gl.getError() };
}

/** One object of every kind that the proxies know, spread over the picture. */
function zoo(): Group {
  const group = new Group();
  const lit = [new MeshStandardMaterial({ color: 0xcc5533, roughness: 0.4 }), new MeshPhysicalMaterial({ color: 0x4466cc, clearcoat: 1 })];
  const cheap = [new MeshLambertMaterial({ color: 0x33aa55 }), new MeshPhongMaterial({ color: 0xaaaa33, shininess: 60 })];
  const flat = [new MeshToonMaterial({ color: 0xaa33aa }), new MeshNormalMaterial(), new MeshBasicMaterial({ color: 0x808080 })];
  [...lit, ...cheap, ...flat].forEach((material, i) => {
    const mesh = new Mesh(new TorusKnotGeometry(0.22, 0.08, 48, 8), material);
    mesh.position.set((i % 4) * 0.7 - 1.1, i < 4 ? 0.6 : -0.2, 0);
    group.add(mesh);
  });
  const edges = new BufferGeometry().setAttribute(
    'position',
    new Float32BufferAttribute([-1, -0.8, 0, 1, -0.6, 0, 1, -0.6, 0, 1, -1, 0], 3),
  );
  group.add(new LineSegments(edges, new LineBasicMaterial({ color: 0x00ffff })));
  group.add(new Points(edges, new PointsMaterial({ color: 0xff00ff, size: 5, sizeAttenuation: false })));
  const blended = (material: Material, x: number, z: number): void => {
    const mesh = new Mesh(new SphereGeometry(0.4, 24, 16), material);
    mesh.position.set(x, 0, z);
    group.add(mesh);
  };
  blended(new MeshStandardMaterial({ color: 0xffffff, transparent: true, opacity: 0.4, depthWrite: false }), -0.5, 0.7);
  blended(new MeshStandardMaterial({ color: 0x2266ff, transparent: true, opacity: 0.6, side: DoubleSide, depthWrite: false }), 0.6, 0.9);
  blended(new MeshBasicMaterial({ color: 0xff0000, side: BackSide }), 1.5, 0);
  const crowd = new InstancedMesh(new BoxGeometry(0.15, 0.15, 0.15), new MeshStandardMaterial(), 3);
  for (let i = 0; i < 3; i++) {
    crowd.setMatrixAt(i, new Matrix4().makeTranslation(0.9 + i * 0.25, -0.7, 0.4));
    crowd.setColorAt(i, new Color().setHSL(i / 3, 1, 0.5));
  }
  group.add(crowd);
  const sides = ['red', 'lime', 'blue', 'cyan', 'magenta', 'yellow'].map((color) => new MeshLambertMaterial({ color }));
  const dice = new Mesh(new BoxGeometry(0.3, 0.3, 0.3), sides);
  dice.position.set(0.4, -0.75, 0.5);
  dice.rotation.set(0.4, 0.5, 0);
  group.add(dice);
  const swelling = new SphereGeometry(0.15, 24, 16);
  const twice = (swelling.getAttribute('position') as BufferAttribute).clone();
  for (let i = 0; i < twice.array.length; i++) twice.array[i] = (twice.array[i] ?? 0) * 2;
  swelling.morphAttributes.position = [twice];
  const morphed = new Mesh(swelling, new MeshPhongMaterial({ color: 0xff8800 }));
  morphed.morphTargetInfluences = [0.5];
  morphed.position.set(-0.5, -0.8, 0.5);
  group.add(morphed);
  const hidden = new Group();
  hidden.visible = false;
  hidden.add(new Mesh(new BoxGeometry(9, 9, 0.1), new MeshBasicMaterial()));
  group.add(hidden);
  // A nested, mirrored, unevenly scaled branch: the proxies must see through the hierarchy.
  const branch = new Group();
  branch.position.set(-1.4, -0.7, 0.3);
  branch.scale.set(-0.5, 1, 0.5);
  branch.rotation.set(0.3, 0.4, 0.1);
  branch.add(new Mesh(new BoxGeometry(0.6, 0.4, 0.5), new MeshStandardMaterial({ color: 0x999999 })));
  group.add(branch);
  return group;
}

/** The picture that three makes on a transparent canvas by itself. */
function drawPlain(root: Object3D, camera: PerspectiveCamera): Uint8Array {
  const gl = createGl();
  const three = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  three.setClearColor(0, 0);
  const scene = new Scene().add(root);
  const light = new DirectionalLight(0xffffff, Math.PI);
  light.position.set(1, 2, 3);
  scene.add(light);
  three.render(scene, camera);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  three.dispose();
  return pixels;
}

/** Every kind of object and material, drawn by three.js alone on a transparent canvas and by the backend into a layer. */
export function sameAsPlain() {
  const camera = CAMERA();
  const plain = drawPlain(zoo(), camera);
  const { gl, backend, layer } = createStand();
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0 } });
  scene.update([objects(item(zoo()))], [lights(sun([1, 2, 3]))]);
  const draw = (): Uint8Array => {
    layer.clear();
    scene.draw(drawView(viewOf(camera), layer.framebuffer));
    return layer.pixels();
  };
  const ours = draw();
  return { drawn: covered(plain), difference: difference(ours, plain), again: difference(ours, draw(), 0), error: gl.getError() };
}
