import { Group, Object3D, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { GizmoMode } from '../../preview-protocol.ts';
import type { ViewBox } from './tool.ts';

/** A canvas over the preview that shows only the gizmo. The preview, its screenshots and its videos do not contain it. */
export interface Overlay {
  readonly controls: TransformControls;
  /** Transform of the nodes after the gizmo target; its matrix is `worldFromParent`. */
  readonly parent: Group;
  /** The transform that the gizmo edits, relative to `parent`. */
  readonly object: Object3D;
  /** Copies the camera of the view. */
  setView(view: Pick<ViewFrame, 'clipFromView' | 'worldFromView'>, box: ViewBox): void;
  draw(): void;
  /** Sets `mode` as a data attribute of the canvas, so that tests can wait for it. */
  setShown(mode: GizmoMode | null): void;
  readonly canvas: HTMLCanvasElement;
  dispose(): void;
}

const MAX_PIXEL_RATIO = 2;
/** Size relative to the height of the preview. The default of three.js suits larger canvases. */
const SIZE = 1.15;
/** Colors of the x, y and z axis and of the active one; less saturated than the defaults of three.js. */
const COLORS = ['#f2495c', '#7ac74f', '#4c8dff', '#ffd23f'] as const;

export function createOverlay(parentElement: HTMLElement): Overlay {
  const canvas = parentElement.ownerDocument.createElement('canvas');
  canvas.id = 'gizmo';
  parentElement.append(canvas);
  const renderer = new WebGLRenderer({ canvas, alpha: true, antialias: true });
  renderer.setClearColor(0, 0);
  const camera = new PerspectiveCamera();
  camera.matrixAutoUpdate = false;
  const scene = new Scene();
  const parent = new Group();
  parent.matrixAutoUpdate = false;
  const object = new Object3D();
  parent.add(object);
  const controls = new TransformControls(camera);
  controls.size = SIZE;
  controls.setColors(...COLORS);
  controls.attach(object);
  scene.add(parent, controls.getHelper());
  let box: ViewBox = { left: 0, top: 0, width: 1, height: 1 };

  const resize = () => {
    const { innerWidth: width, innerHeight: height, devicePixelRatio } = window;
    const ratio = Math.min(devicePixelRatio, MAX_PIXEL_RATIO);
    if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
    if (canvas.clientWidth !== width || canvas.clientHeight !== height || canvas.width !== Math.floor(width * ratio)) {
      renderer.setSize(width, height, false);
    }
    return height;
  };
  return {
    controls,
    parent,
    object,
    canvas,
    setView: ({ clipFromView, worldFromView }, at) => {
      box = at;
      camera.matrix.fromArray(worldFromView);
      camera.projectionMatrix.fromArray(clipFromView);
      camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
      // TransformControls computes its size on screen from the field of view.
      camera.fov = (2 * Math.atan(1 / (clipFromView[5] ?? 1)) * 180) / Math.PI;
      camera.updateMatrixWorld(true);
    },
    draw: () => {
      const height = resize();
      const bottom = height - box.top - box.height;
      renderer.setViewport(box.left, bottom, box.width, box.height);
      renderer.setScissor(box.left, bottom, box.width, box.height);
      renderer.setScissorTest(false);
      renderer.clear();
      renderer.setScissorTest(true);
      renderer.render(scene, camera);
    },
    setShown: (mode) => {
      canvas.hidden = mode === null;
      canvas.dataset.mode = mode ?? '';
    },
    dispose: () => {
      controls.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}
