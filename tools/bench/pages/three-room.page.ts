import {
  BackSide,
  Color,
  DataTexture,
  DirectionalLight,
  FloatType,
  Group,
  Mesh,
  MeshBasicMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  PMREMGenerator,
  RedFormat,
  Scene,
  ShaderMaterial,
  ShadowMaterial,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { type Drawn, measureFrames } from './frame-ms.ts';
import { countCalls, type GlCalls, startCounting } from './gl-calls.ts';
import {
  AMBIENT,
  CAMERA_SCALE,
  EYE_M,
  FLOOR_M,
  FOV_DEG,
  LOOK_M,
  placesOf,
  type RoomPlan,
  SHADOW_AREA_M,
  SUN_IRRADIANCE,
  TOWARDS_SUN,
} from './room-plan.ts';

/**
 * Opens the scene of the room benches as an experienced developer writes it in three.js: shared geometry, environment, sun, shadows, floor.
 */
export async function open(modelUrl: string, plan: RoomPlan): Promise<void> {
  if (plan.counted) startCounting();
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  renderer.setSize(plan.widthPx, plan.heightPx, false);
  document.body.append(renderer.domElement);
  renderer.shadowMap.enabled = plan.shadow;
  renderer.shadowMap.type = PCFShadowMap;
  const camera = new PerspectiveCamera(FOV_DEG, plan.widthPx / plan.heightPx, 0.05, 100);
  camera.position.set(...EYE_M);
  camera.lookAt(...LOOK_M);
  const scene = new Scene();
  scene.environment = white(renderer);
  const sun = new DirectionalLight(new Color(...SUN_IRRADIANCE), 1);
  sun.position.set(TOWARDS_SUN[0] * 6, TOWARDS_SUN[1] * 6, TOWARDS_SUN[2] * 6);
  sun.castShadow = plan.shadow;
  sun.shadow.mapSize.set(plan.shadowMapPx, plan.shadowMapPx);
  const half = SHADOW_AREA_M / 2;
  Object.assign(sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.1, far: 12 });
  scene.add(sun);
  if (plan.shadow) {
    const floor = new Mesh(new PlaneGeometry(...FLOOR_M), new ShadowMaterial({ opacity: 0.55 }));
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    scene.add(floor);
  }
  if (plan.occlusion) scene.add(roomDepth(camera));
  const gltf = await new GLTFLoader().loadAsync(modelUrl);
  for (const place of placesOf(plan.count)) {
    const model = new Group().add(gltf.scene.clone());
    model.position.set(...place);
    model.scale.setScalar(CAMERA_SCALE);
    model.traverse((part) => {
      part.castShadow = plan.shadow;
      part.receiveShadow = plan.shadow;
    });
    scene.add(model);
  }
  drawn = { gl: renderer.getContext(), draw: () => renderer.render(scene, camera) };
}

/** An environment of constant brightness, filtered by three.js. */
function white(renderer: WebGLRenderer): Scene['environment'] {
  const around = new Scene();
  around.add(new Mesh(new SphereGeometry(10), new MeshBasicMaterial({ color: new Color(AMBIENT, AMBIENT, AMBIENT), side: BackSide })));
  const generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromScene(around);
  generator.dispose();
  return texture;
}

/** Room depth that says 20 m everywhere, drawn before all objects as three.js draws the depth of WebXR: it hides them by the depth test. */
function roomDepth(camera: PerspectiveCamera): Mesh {
  const samples = new DataTexture(new Float32Array(160 * 90).fill(20), 160, 90, RedFormat, FloatType);
  samples.needsUpdate = true;
  const material = new ShaderMaterial({
    uniforms: { depth: { value: samples }, projection: { value: camera.projectionMatrix } },
    vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 1.0, 1.0); }',
    fragmentShader: `uniform sampler2D depth; uniform mat4 projection; varying vec2 at;
      void main() {
        vec4 clip = projection * vec4(0.0, 0.0, -texture2D(depth, at).x, 1.0);
        gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
        gl_FragColor = vec4(0.0);
      }`,
    colorWrite: false,
  });
  const quad = new Mesh(new PlaneGeometry(2, 2), material);
  quad.frustumCulled = false;
  quad.renderOrder = -1;
  return quad;
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!drawn) throw new Error('Nothing is open.');
  return measureFrames(drawn, count);
}

/** Calls of WebGL in one frame, of a counted plan. */
export function glCalls(): GlCalls {
  if (!drawn) throw new Error('Nothing is open.');
  return countCalls(drawn);
}

/** The image as a data URL, for a person to look at. */
export function picture(): string {
  if (!drawn) throw new Error('Nothing is open.');
  drawn.draw(0);
  return (drawn.gl.canvas as HTMLCanvasElement).toDataURL();
}

let drawn: Drawn | null = null;
