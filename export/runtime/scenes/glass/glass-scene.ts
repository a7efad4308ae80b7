import {
  type Camera,
  type IUniform,
  type Material,
  Matrix4,
  type MeshPhysicalMaterial,
  OneMinusSrcAlphaFactor,
  type Scene,
  Sphere,
  Vector4,
  ZeroFactor,
} from 'three';
import type { LayerEncoding } from '../../../../nodes/kit/definition.ts';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { Writable } from '../../../../nodes/kit/value-views.ts';
import type { CreateUnder } from '../../scene-backend.ts';
import { createGlassPatch, type GlassPatch } from '../materials/glass-patch.ts';
import { boundsInObject, materialsOf } from '../proxies/drawable.ts';
import type { FlatProxy } from '../proxies/proxy.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { TECHNIQUE_BEHIND } from './behind-chunk.ts';
import { type BehindTarget, createBehindTarget } from './behind-target.ts';
import { arrange, type OrderedItem } from './draw-order.ts';
import { createUnder } from './under.ts';
import { createUnderImage, type UnderImage } from './under-image.ts';

export type CreateGlass = (renderer: SceneRenderer, gl: WebGL2RenderingContext) => Glass;

/** Draws glass for all scenes of a backend, which share the image of what is behind glass. */
export interface Glass {
  forScene(scene: Scene, encoding: LayerEncoding): GlassScene;
  readonly createUnder: CreateUnder;
  dispose(): void;
}

/** Draws a scene with glass (ADR 41). */
export interface GlassScene {
  /** Creates the patch that makes a transmissive material read what is behind it. */
  patch(master: MeshPhysicalMaterial): GlassPatch;
  readonly forTechniques: { readonly text: string; readonly uniforms: Readonly<Record<string, IUniform>> };
  /**
   * Collects the glass and blended surfaces among the proxies of the scene. Called after the proxies were rebuilt.
   *
   * @param lastOrder Render order from which on proxies are drawn after all others and have no visible color.
   */
  collect(proxies: readonly FlatProxy[], lastOrder: number): void;
  /** Whether the scene has glass, visible or hidden. */
  hasGlass(): boolean;
  /** Draws the whole scene. */
  draw(view: DrawView, camera: Camera): void;
  dispose(): void;
}

/** Numbers of three.js layers: what is drawn before all glass, the current batch, later batches, and what is under the scene. */
const [FIRST, CURRENT, LATER, UNDER] = [0, 1, 2, 3] as const;

interface GlassItem extends OrderedItem {
  readonly proxy: FlatProxy;
  readonly materials: readonly Material[];
  /** Whether no material blends: a pixel then shows only what the shader writes, which for glass includes what is behind. */
  readonly isSolid: boolean;
}

// Valid within one call.
const scratchSphere = new Sphere();
const scratchClip = new Vector4();
const scratchClipFromWorld = new Matrix4();

export const createGlass: CreateGlass = (renderer, gl) => {
  const targets = new Map<LayerEncoding, { readonly target: BehindTarget; users: number }>();
  const targetOf = (encoding: LayerEncoding) => {
    const known = targets.get(encoding) ?? { target: createBehindTarget(gl, encoding), users: 0 };
    targets.set(encoding, known);
    return known;
  };
  return {
    createUnder,
    forScene: (scene, encoding) => createGlassScene(renderer, scene, encoding, targetOf(encoding)),
    dispose: () => {
      for (const { target } of targets.values()) target.dispose();
    },
  };
};

function createGlassScene(
  renderer: SceneRenderer,
  scene: Scene,
  encoding: LayerEncoding,
  shared: { readonly target: BehindTarget; users: number },
): GlassScene {
  const { target } = shared;
  const behind: IUniform = { value: target.texture };
  const items: GlassItem[] = [];
  let hasGlass = false;
  let under: UnderImage | null = null;
  const viewport: Writable<DrawView['viewport']> = { x: 0, y: 0, widthPx: 1, heightPx: 1 };
  const ofTarget: Writable<DrawView> = {
    view: null as unknown as DrawView['view'],
    viewIndex: 0,
    framebuffer: null,
    viewport,
  };

  function use(wanted: boolean): void {
    if (wanted === hasGlass) return;
    hasGlass = wanted;
    shared.users += wanted ? 1 : -1;
    if (shared.users === 0) target.dispose();
    if (wanted) under = createUnderImage(scene, UNDER);
    else {
      under?.dispose();
      under = null;
    }
  }

  function place(camera: Camera): void {
    const clipFromWorld = scratchClipFromWorld.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    for (const item of items) {
      const { object, master, item: placed } = item.proxy;
      boundsInObject(master, scratchSphere).applyMatrix4(placed.worldFromObject);
      item.isVisible = object.visible && boxOf(scratchSphere, camera, clipFromWorld, item);
    }
  }

  /** Assigns each object to a three.js layer, for drawing `batch`: what is drawn before all glass, this batch, or other batches. */
  function show(batch: number): void {
    for (const { proxy, batch: own } of items) proxy.object.layers.set(own === 0 ? FIRST : own === batch ? CURRENT : LATER);
  }

  /**
   * Sets the blending of glass. Its color already contains what is visible through it, so solid glass replaces the target; with `isOver` it
   * is blended, because the target already has content of other layers.
   */
  function blend(isOver: boolean): void {
    for (const { isGlass, isSolid, materials } of items) {
      if (!isGlass) continue;
      const factor = isSolid && !isOver ? ZeroFactor : OneMinusSrcAlphaFactor;
      for (const material of materials) {
        material.blendDst = factor;
        material.blendDstAlpha = factor;
      }
    }
  }

  function drawBehind(camera: Camera): void {
    ofTarget.framebuffer = target.framebuffer;
    renderer.draw(ofTarget, scene, camera, 'scene');
  }

  function drawAll(view: DrawView, camera: Camera, batches: number): void {
    const isOver = view.under?.isInTarget ?? false;
    under?.show(view.under);
    show(0);
    target.begin(view.viewport.widthPx, view.viewport.heightPx);
    camera.layers.set(FIRST);
    camera.layers.enable(UNDER);
    drawBehind(camera);
    target.publish();
    camera.layers.set(FIRST);
    renderer.draw(view, scene, camera, encoding);
    camera.layers.set(CURRENT);
    for (let batch = 1; batch <= batches; batch++) {
      show(batch);
      blend(isOver);
      renderer.draw(view, scene, camera, encoding);
      if (batch === batches) break;
      blend(false);
      drawBehind(camera);
      target.publish();
    }
  }

  return {
    patch: (master) => createGlassPatch(master, behind),
    forTechniques: { text: TECHNIQUE_BEHIND, uniforms: { scrimBehind: behind } },
    collect: (proxies, lastOrder) => {
      items.length = 0;
      for (const proxy of proxies) {
        const { isGlass, object } = proxy;
        const materials = materialsOf(object);
        if (!isGlass && !materials.some(({ transparent }) => transparent)) continue;
        items.push({
          proxy,
          materials,
          isGlass,
          isSolid: materials.every(({ transparent }) => !transparent),
          isLast: object.renderOrder >= lastOrder,
          renderOrder: object.renderOrder,
          isVisible: false,
          depthM: 0,
          box: { left: 0, right: 0, bottom: 0, top: 0 },
          batch: 0,
        });
      }
      use(items.some(({ isGlass }) => isGlass));
    },
    hasGlass: () => hasGlass,
    draw: (view, camera) => {
      ofTarget.view = view.view;
      ofTarget.viewIndex = view.viewIndex;
      viewport.widthPx = view.viewport.widthPx;
      viewport.heightPx = view.viewport.heightPx;
      if (renderer.isPreparing()) {
        renderer.draw(view, scene, camera, encoding);
        drawBehind(camera);
        return;
      }
      place(camera);
      const batches = arrange(items);
      if (batches > 0) drawAll(view, camera, batches);
      else {
        show(0);
        camera.layers.set(FIRST);
        renderer.draw(view, scene, camera, encoding);
      }
      camera.layers.set(FIRST);
    },
    dispose: () => use(false),
  };
}

/** Sets the screen bounds and depth of an item from its bounding sphere in world space. Returns whether it may be in the view. */
function boxOf({ center, radius }: Sphere, camera: Camera, clipFromWorld: Matrix4, into: GlassItem): boolean {
  const { x, y, w } = scratchClip.set(center.x, center.y, center.z, 1).applyMatrix4(clipFromWorld);
  const { box } = into;
  into.depthM = w;
  if (radius < 0 || w < -radius) return false;
  const nearestM = w - radius;
  if (nearestM <= 0) {
    Object.assign(box, EVERYWHERE);
    return true;
  }
  const [sx = 1, , , , , sy = 1] = camera.projectionMatrix.elements;
  const halfWidth = (Math.abs(sx) * radius) / nearestM;
  const halfHeight = (Math.abs(sy) * radius) / nearestM;
  box.left = x / w - halfWidth;
  box.right = x / w + halfWidth;
  box.bottom = y / w - halfHeight;
  box.top = y / w + halfHeight;
  return box.left < 1 && box.right > -1 && box.bottom < 1 && box.top > -1;
}

const EVERYWHERE = { left: -1, right: 1, bottom: -1, top: 1 };
