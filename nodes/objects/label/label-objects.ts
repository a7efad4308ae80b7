import {
  CanvasTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { createMeshItem } from '../../kit/three/mesh-item.ts';
import type { LabelContentView } from './label-content.ts';
import type { LabelPose } from './label-pose.ts';

/** Anisotropic filtering of the texture, because labels are also seen at grazing angles. */
const ANISOTROPY = 8;
/** Pixels with less alpha are discarded, so that the transparent corners of the card hide nothing. */
const ALPHA_TEST = 0.01;

/** A label and its leader line as objects of the scene. */
export interface LabelObjects {
  /** Paints the texture again. */
  paint(content: LabelContentView): void;
  show(pose: LabelPose, opacity: number, isLed: boolean, color: Readonly<Float64Array>): void;
  hide(): void;
  dispose(): void;
}

// Filled and read within one call.
const along = new Vector3();
const across = new Vector3();
const normal = new Vector3();

export function createLabelObjects(list: ObjectList): LabelObjects {
  const geometry = new PlaneGeometry();
  const card = createPart('label', geometry, new MeshBasicMaterial({ transparent: true, alphaTest: ALPHA_TEST, toneMapped: false }));
  const line = createPart('line', geometry, new MeshBasicMaterial({ transparent: true, toneMapped: false }));
  let texture: CanvasTexture<OffscreenCanvas> | null = null;
  let widthPx = 0;
  let heightPx = 0;

  function showItems(hasCard: boolean, hasLine: boolean): void {
    const count = (hasCard ? 1 : 0) + (hasLine ? 1 : 0);
    if (list.items.length === count) return;
    list.items.length = 0;
    if (hasLine) list.items.push(line.item);
    if (hasCard) list.items.push(card.item);
    list.version++;
  }

  /** Writes the leader line as a ribbon that faces the viewer. */
  function layLine({ leaderFrom, leaderTo, leaderM, worldFromLabel }: LabelPose): void {
    along.subVectors(leaderTo, leaderFrom);
    const lengthM = along.length();
    along.divideScalar(lengthM);
    normal.setFromMatrixColumn(worldFromLabel, 2);
    across.crossVectors(normal, along).normalize();
    normal.crossVectors(along, across);
    line.item.worldFromObject.makeBasis(along, across, normal).setPosition(across.addVectors(leaderFrom, leaderTo).multiplyScalar(0.5));
    line.mesh.matrixWorld.makeScale(lengthM, leaderM, 1);
  }

  return {
    paint: (content) => {
      content.paint();
      const { canvas } = content;
      // The size of a texture is fixed once it is on the GPU.
      if (texture && (canvas.width !== widthPx || canvas.height !== heightPx)) {
        texture.dispose();
        texture = null;
      }
      widthPx = canvas.width;
      heightPx = canvas.height;
      if (!texture) {
        texture = createTexture(canvas);
        card.material.needsUpdate = card.material.map === null;
        card.material.map = texture;
        list.version++;
      }
      texture.needsUpdate = true;
    },
    show: (pose, opacity, isLed, color) => {
      const hasLine = isLed && pose.leaderM > 0;
      card.item.worldFromObject.copy(pose.worldFromLabel);
      card.mesh.matrixWorld.makeScale(pose.widthM, pose.heightM, 1);
      card.material.opacity = opacity;
      if (hasLine) layLine(pose);
      line.material.color.fromArray(color as unknown as number[]).convertSRGBToLinear();
      line.material.opacity = opacity * (color[3] ?? 1);
      showItems(true, hasLine);
    },
    hide: () => showItems(false, false),
    dispose: () => {
      texture?.dispose();
      geometry.dispose();
      card.material.dispose();
      line.material.dispose();
    },
  };
}

function createTexture(canvas: OffscreenCanvas): CanvasTexture<OffscreenCanvas> {
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.anisotropy = ANISOTROPY;
  return texture;
}

function createPart(key: string, geometry: PlaneGeometry, material: MeshBasicMaterial) {
  const mesh = new Mesh(geometry, material);
  return { mesh, material, item: createMeshItem(key, mesh) };
}
