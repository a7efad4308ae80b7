import {
  type AnimationMixer,
  Color,
  DataTexture,
  DirectionalLight,
  FloatType,
  HemisphereLight,
  Matrix4,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  RedFormat,
  RGFormat,
  Scene,
  ShaderMaterial,
  Timer,
  UnsignedByteType,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ARButton } from 'three/addons/webxr/ARButton.js';
import { XREstimatedLight } from 'three/addons/webxr/XREstimatedLight.js';
import { addRobots, createFloor } from './robots-on-floor.ts';

/**
 * The first example as somebody who knows three.js writes it by hand: two animated robots with a shadow on the floor, behind real surfaces
 * and in the estimated light in AR, and to look at from all sides elsewhere. The filter of the example is left out, because three.js has
 * no counterpart for passthrough. Benches compare its bytes and its first image with those of the exported page.
 */

const ROBOTS = [
  { x: -0.32, z: -0.95, turn: 0.35, scale: 1.9 },
  { x: 0.62, z: -0.28, turn: 0.1, scale: 1.1 },
];

const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;
renderer.xr.enabled = true;
document.body.append(renderer.domElement);

const camera = new PerspectiveCamera(50, 1, 0.05, 100);
camera.position.set(0, 1.2, 3);
const controls = new OrbitControls(camera, renderer.domElement);
controls.target.set(0, 0.5, 0);
controls.enableDamping = true;

const scene = new Scene();
const around = new HemisphereLight(0xffffff, 0xffffff, 0.35 * Math.PI);
scene.add(around);
const sun = new DirectionalLight(new Color(1, 0.94, 0.85), 0.85 * Math.PI);
sun.position.set(-2.4, 1.7, 0.6);
castShadow(sun);
scene.add(sun);

const floor = createFloor();
scene.add(floor);

let mixers: readonly AnimationMixer[] = [];
new GLTFLoader().load('robot.glb', (gltf) => {
  mixers = addRobots(scene, gltf, ROBOTS);
  renderer.setAnimationLoop(draw);
});

const estimate = new XREstimatedLight(renderer);
castShadow(estimate.directionalLight);
estimate.addEventListener('estimationstart', () => {
  scene.remove(around, sun);
  scene.add(estimate);
  scene.environment = estimate.environment;
});
estimate.addEventListener('estimationend', () => {
  scene.remove(estimate);
  scene.add(around, sun);
  scene.environment = null;
});

document.body.append(
  ARButton.createButton(renderer, {
    optionalFeatures: ['local-floor', 'depth-sensing', 'light-estimation'],
    depthSensing: { usagePreference: ['gpu-optimized', 'cpu-optimized'], dataFormatPreference: ['luminance-alpha', 'float32'] },
  } as Parameters<typeof ARButton.createButton>[1]),
);
renderer.xr.addEventListener('sessionstart', async () => {
  const space = await renderer.xr.getSession()?.requestReferenceSpace('local-floor');
  if (space) renderer.xr.setReferenceSpace(space);
});
renderer.xr.addEventListener('sessionend', () => {
  room.visible = false;
});

/** Depth of the room on the CPU; three.js itself draws only depth on the GPU. */
const room = new Mesh(
  new PlaneGeometry(2, 2),
  new ShaderMaterial({
    uniforms: {
      depth: { value: null },
      metersPerUnit: { value: 0 },
      uvFromView: { value: new Matrix4() },
      isFloat: { value: false },
    },
    vertexShader: /* glsl */ `
      uniform mat4 uvFromView;
      varying vec2 at;
      void main() {
        at = (uvFromView * vec4(uv.x, 1.0 - uv.y, 0.0, 1.0)).xy;
        gl_Position = vec4(position.xy, 1.0, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform sampler2D depth;
      uniform float metersPerUnit;
      uniform bool isFloat;
      uniform mat4 projection;
      varying vec2 at;
      void main() {
        vec2 bytes = texture2D(depth, at).xy;
        float meters = metersPerUnit * (isFloat ? bytes.x : dot(bytes, vec2(255.0, 65280.0)));
        if (meters <= 0.0) discard;
        vec4 clip = projection * vec4(0.0, 0.0, -meters - 0.06, 1.0);
        gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
        gl_FragColor = vec4(0.0);
      }`,
    colorWrite: false,
  }),
);
room.material.uniforms.projection = { value: camera.projectionMatrix };
room.frustumCulled = false;
room.renderOrder = -1;
room.visible = false;
scene.add(room);

let samples: DataTexture | null = null;

function readRoomDepth(frame: XRFrame): void {
  const session = renderer.xr.getSession();
  const space = renderer.xr.getReferenceSpace();
  const view = space && frame.getViewerPose(space)?.views[0];
  room.visible = false;
  if (!view || !session?.enabledFeatures?.includes('depth-sensing') || session.depthUsage !== 'cpu-optimized') return;
  const info = frame.getDepthInformation?.(view);
  if (!info) return;
  const { width, height, data } = info;
  const isFloat = session.depthDataFormat === 'float32';
  const values = isFloat ? new Float32Array(data) : new Uint8Array(data);
  if (samples?.image.width !== width || samples.image.height !== height) {
    samples?.dispose();
    samples = new DataTexture(values, width, height, isFloat ? RedFormat : RGFormat, isFloat ? FloatType : UnsignedByteType);
  } else {
    samples.image.data?.set(values);
  }
  samples.needsUpdate = true;
  const { uniforms } = room.material;
  Object.assign(uniforms.depth ?? {}, { value: samples });
  Object.assign(uniforms.metersPerUnit ?? {}, { value: info.rawValueToMeters });
  Object.assign(uniforms.isFloat ?? {}, { value: isFloat });
  uniforms.uvFromView?.value.fromArray(info.normDepthBufferFromNormView.matrix);
  Object.assign(uniforms.projection ?? {}, { value: new Matrix4().fromArray(view.projectionMatrix) });
  room.visible = true;
}

const timer = new Timer();
timer.connect(document);

function draw(timeMs: number, frame?: XRFrame): void {
  timer.update(timeMs);
  for (const mixer of mixers) mixer.update(timer.getDelta());
  if (frame) readRoomDepth(frame);
  else controls.update();
  renderer.render(scene, camera);
  document.querySelector('.poster')?.remove();
}

function castShadow(light: DirectionalLight): void {
  light.castShadow = true;
  light.shadow.mapSize.set(2048, 2048);
  Object.assign(light.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.1, far: 8 });
}

function resize(): void {
  if (renderer.xr.isPresenting) return;
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  renderer.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();
