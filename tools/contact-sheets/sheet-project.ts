import type { ParamValue } from '../../nodes/kit/definition.ts';

/** A model of a sheet, and how it is moved to fill a cell. */
export interface SheetModel {
  readonly file: string;
  /** Center of its bounding box in meters. */
  readonly center: readonly [number, number, number];
  /** Longest side of its bounding box in meters. */
  readonly sideM: number;
}

/** A style: a material, or a filter over the models and a gray wall. */
export interface Style {
  readonly name: string;
  readonly type: string;
  readonly params?: Readonly<Record<string, ParamValue>>;
}

/** Lights, from the top row to the bottom row: by day from the left, low from the right, from behind with little other light. */
export const LIGHTS = [
  { name: 'day', ambient: 0.4, params: { azimuthRad: -0.9, elevationRad: 0.75, intensity: 0.85 } },
  { name: 'side', ambient: 0.12, params: { azimuthRad: 1.5, elevationRad: 0.2, intensity: 1 } },
  { name: 'back', ambient: 0.2, params: { azimuthRad: 2.7, elevationRad: 0.6, intensity: 1.1 } },
] as const;

/** Distance between the centers of cells in meters, and how much of it a model takes. */
export const CELL_M = 1;
const FILL = 0.86;
export const CELL_PX = 320;
/** Distance of the camera from the models: so far that all cells are seen nearly from the front. */
export const AWAY_M = 12;

/** A project that draws each model once per light, in rows, with one style. */
export function sheetProject(models: readonly SheetModel[], { type, params = {} }: Style, version: (type: string) => number): object {
  const isFilter = type.startsWith('filter/');
  const nodes: Record<string, object> = {};
  const wires: string[] = [];
  const add = (id: string, nodeType: string, nodeParams: object = {}) => {
    nodes[id] = { type: nodeType, version: version(nodeType), params: nodeParams };
  };
  add('video-s', 'source/camera-video');
  if (!isFilter) add('style-s', type, params);
  models.forEach((_, i) => {
    add(`model${i}-s`, 'source/model', { model: `model-${i}` });
  });
  let below = 'video-s.layer';
  LIGHTS.forEach((light, row) => {
    add(`light${row}-s`, 'light/directional', light.params);
    add(`scene${row}-s`, 'layer/scene', { ambient: light.ambient });
    wires.push(`light${row}-s.lights -> scene${row}-s.lights`);
    if (!isFilter) {
      add(`apply${row}-s`, 'objects/apply-technique');
      wires.push(`style-s.technique -> apply${row}-s.technique`, `apply${row}-s.objects -> scene${row}-s.objects`);
    }
    models.forEach(({ center, sideM }, column) => {
      const scale = (FILL * CELL_M) / sideM;
      const at = [(column - (models.length - 1) / 2) * CELL_M, ((LIGHTS.length - 1) / 2 - row) * CELL_M, 0];
      // Rotated about the vertical axis by a third of a right angle, so that sides are seen.
      const [cos, sin] = [Math.cos(TURN_RAD), Math.sin(TURN_RAD)];
      const [x, y, z] = center;
      const middle = [cos * x + sin * z, y, cos * z - sin * x];
      // A Transform scales by at most ten, and some models are the size of a coin.
      const first = Math.min(scale, MAX_SCALE);
      const small = `small${row}${column}-s`;
      const id = `at${row}${column}-s`;
      add(small, 'objects/transform', { scale: first });
      add(id, 'objects/transform', {
        positionM: at.map((value, axis) => value - scale * (middle[axis] ?? 0)),
        rotationRad: [0, TURN_RAD, 0],
        scale: scale / first,
      });
      wires.push(`model${column}-s.objects -> ${small}.objects`, `${small}.objects -> ${id}.objects`);
      wires.push(`${id}.objects -> ${isFilter ? 'scene' : 'apply'}${row}-s.objects`);
    });
    add(`over${row}-s`, 'operator/over');
    wires.push(`${below} -> over${row}-s.bottom`, `scene${row}-s.layer -> over${row}-s.top`);
    below = `over${row}-s.layer`;
  });
  if (isFilter) {
    add('style-s', type, params);
    wires.push(`${below} -> style-s.inputImage`);
    below = 'style-s.layer';
  }
  add('screen-s', 'output/screen');
  wires.push(`${below} -> screen-s.layer`);
  return {
    format: 'scrim-project',
    version: 1,
    title: type,
    graphs: { main: { nodes, wires } },
    assets: Object.fromEntries(models.map((_, i) => [`model-${i}`, { path: `assets/${i}.glb`, kind: 'model' }])),
  };
}

const TURN_RAD = 0.5;
const MAX_SCALE = 10;

/** A session of one frame: a camera before the cells, and the image `wall.png` behind them. */
export function sheetSession(columns: number): { readonly session: object; readonly widthPx: number; readonly heightPx: number } {
  const [widthPx, heightPx] = [columns * CELL_PX, LIGHTS.length * CELL_PX];
  const focalPx = (CELL_PX / CELL_M) * AWAY_M;
  const intrinsics = { fxPx: focalPx, fyPx: focalPx, cxPx: widthPx / 2, cyPx: heightPx / 2 };
  return {
    widthPx,
    heightPx,
    session: {
      format: 'scrim-session',
      version: 1,
      title: 'Contact sheet',
      color: { widthPx, heightPx, intrinsics },
      frameRateHz: 10,
      frames: [{ timeS: 0, color: 'wall.png', worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, AWAY_M, 1] }],
    },
  };
}
