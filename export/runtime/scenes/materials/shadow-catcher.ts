import {
  CustomBlending,
  LessDepth,
  type Material,
  type Matrix4,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  type Texture,
  Vector3,
  Vector4,
} from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { LightList, ObjectItem, ObjectList } from '../../../../nodes/kit/scene-lists.ts';
import type { ShadowGlow, ShadowStrokes } from '../../../../nodes/kit/scene-look.ts';
import type { NumberView, VectorView } from '../../../../nodes/kit/value-views.ts';
import { isDirectLight } from '../lights/is-direct-light.ts';
import type { TextureLimits } from '../lights/light-limits.ts';
import { needsFloats, type ShadowMap } from '../lights/light-map.ts';
import type { RenderedShadowMaps } from '../lights/shadow-maps.ts';
import { type Drawable, materialsOf } from '../proxies/drawable.ts';
import { isOpaque } from './layer-blending.ts';
import { createLightUniforms, setLight, setLightCount } from './light-uniforms.ts';
import { createRoomMaterial, ROOM_SURFACE, type RoomUniforms } from './room-surface.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { CATCHER_VERTEX, catcherFragment } from './shadow-catcher-shader.ts';
import type { CubeLight, FlatLight } from './shadow-filter-shader.ts';
import { createStrokeUniforms } from './shadow-strokes.ts';
import type { Twin } from './twins.ts';

/** The materials of one shadow layer, which share lights, strength and color, and differ in what three.js compiles per object. */
export interface ShadowCatcher {
  createTwin(master: Material): Twin;
  /** Applies strength, color, changed lists, and this frame's matrices and lights. */
  update(receivers: readonly ObjectList[], lights: readonly LightList[]): void;
  /** Prepares the materials for a view. Called before the view is drawn; leaves no framebuffer bound. */
  beforeDraw(view: DrawView): void;
  /**
   * Creates a material that catches shadows on the surfaces of room depth, which `room` describes. The caller disposes it. Null if the
   * shadow method does not support room depth.
   */
  createRoomMaterial(room: RoomUniforms): ShaderMaterial | null;
  dispose(): void;
}

export interface MapCatcherOptions {
  readonly strength: NumberView;
  readonly color: VectorView;
  readonly maps: RenderedShadowMaps | null;
  /** Patches that hide fragments behind the room; empty for none. */
  readonly occlusion: readonly ShaderPatch[];
  readonly textureLimits: TextureLimits;
  /** Negative shadow, drawn instead of shadows for displays that cannot darken; null for none. */
  readonly glow: ShadowGlow | null;
  /** Draws shadows as strokes; null draws them evenly. */
  readonly strokes: ShadowStrokes | null;
}

/** Maximum number of texture units of a catcher; the remaining two of sixteen are for room depth. */
const MAX_TEXTURES = 14;

/** Creates a catcher that finds shadows by shadow maps, with the filter of each light. Edges follow cutouts by alpha. */
export function createMapCatcher({ strength, color, maps, occlusion, textureLimits, glow, strokes }: MapCatcherOptions): ShadowCatcher {
  let lightLists: readonly LightList[] = [];
  const lightUniforms = createLightUniforms();
  const flatMaps: (Texture | null)[] = [];
  const mapFromWorld: Matrix4[] = [];
  const flatBias: Vector3[] = [];
  const flatReach: Vector4[] = [];
  const flatExtras: Texture[] = [];
  const cubeMaps: (Texture | null)[] = [];
  const cubeReach: Vector4[] = [];
  const cubeTranslucent: (Texture | null)[] = [];
  const glowUniforms = {
    glowCount: { value: -1 },
    glowColor: { value: new Vector4() },
    glowBorder: { value: 0 },
    glowPlaces: { value: glow?.places ?? null },
    glowSizes: { value: glow?.sizes ?? null },
  };
  const drawn = strokes ? createStrokeUniforms(strokes) : null;
  if (strokes) maps?.keepLast();
  const uniforms = {
    strength: { value: 0 },
    shadowColor: { value: new Vector4() },
    ...lightUniforms,
    flatMaps: { value: flatMaps },
    mapFromWorld: { value: mapFromWorld },
    flatBias: { value: flatBias },
    flatReach: { value: flatReach },
    flatExtras: { value: flatExtras },
    cubeMaps: { value: cubeMaps },
    cubeReach: { value: cubeReach },
    cubeTranslucent: { value: cubeTranslucent },
    ...glowUniforms,
    ...drawn?.uniforms,
  };
  const flat: FlatLight[] = [];
  const cube: CubeLight[] = [];
  const lights = { flat, cube, plain: 0 };
  let fragmentShader = catcherFragment(lights, undefined, glow !== null, strokes !== null);
  let roomFragment = catcherFragment(lights, ROOM_SURFACE, glow !== null, strokes !== null);
  const written = new Map<ShaderMaterial, 'geometry' | 'room'>();
  /**
   * Numbers of lights and textures in this frame. `textures`: units in use. `softened`, `undimmed`: lights for whose filter or translucent
   * shadow map no unit was left.
   */
  const counts = { flat: 0, cube: 0, plain: 0, extras: 0, cubeTranslucent: 0, textures: 0, softened: 0, undimmed: 0 };
  let outdated = false;

  function countMaps(): number {
    let count = 0;
    for (const list of lightLists) for (const light of list.items) if (maps?.mapOf(light)) count++;
    return count;
  }

  /** Adds a light with a flat map to the shader. The shader is recompiled if its filter or textures differ from those of the last frame. */
  function addFlat(map: ShadowMap): void {
    const i = counts.flat++;
    flatMaps[i] = map.target.depthTexture;
    mapFromWorld[i] = map.mapFromWorld;
    flatBias[i] ??= new Vector3();
    flatBias[i].set(1 / map.target.width, map.bias, map.normalBias);
    flatReach[i] ??= new Vector4();
    flatReach[i].set(map.nearM, map.farM, map.source.x, map.source.y);
    const extra = addExtra(map.depths ?? map.moments);
    // Without its texture, the filters `vsm` and `pcss` fall back to `soft`.
    const filter = extra < 0 && needsFloats(map.filter) ? 'soft' : map.filter;
    if (filter !== map.filter) counts.softened++;
    const translucent = addExtra(map.translucent);
    if (translucent < 0 && map.translucent !== null) counts.undimmed++;
    const last = strokes ? addExtra(map.last) : -1;
    const known = flat[i];
    if (known?.filter === filter && known.extra === extra && known.translucent === translucent && known.last === last) return;
    flat[i] = { filter, extra, translucent, last };
    outdated = true;
  }

  /** Adds a texture of a light with a flat map and returns its index; -1 if the texture is null or no unit is left. */
  function addExtra(texture: Texture | null): number {
    if (texture === null || counts.textures >= MAX_TEXTURES) return -1;
    counts.textures++;
    flatExtras[counts.extras] = texture;
    return counts.extras++;
  }

  function addCube(map: ShadowMap): void {
    const i = counts.cube++;
    cubeMaps[i] = map.target.depthTexture;
    cubeReach[i] ??= new Vector4();
    cubeReach[i].set(map.nearM, map.farM, 2 / map.target.width, map.normalBias);
    const translucent = map.translucent !== null && counts.textures++ < MAX_TEXTURES ? counts.cubeTranslucent++ : -1;
    if (translucent >= 0) cubeTranslucent[translucent] = map.translucent;
    else if (map.translucent !== null) counts.undimmed++;
    if (cube[i]?.filter === map.filter && cube[i]?.translucent === translucent) return;
    cube[i] = { filter: map.filter, translucent };
    outdated = true;
  }

  /**
   * Adds the lights whose map is of the given kind; null: those without a map. Called for each, because the shader groups lights by the
   * kind of their map.
   */
  function addLights(wanted: ShadowMap['kind'] | null): void {
    for (const list of lightLists) {
      for (const light of list.items) {
        if (!isDirectLight(light)) continue;
        const map = maps?.mapOf(light) ?? null;
        if ((map?.kind ?? null) !== wanted) continue;
        setLight(lightUniforms, counts.flat + counts.cube + counts.plain, light);
        if (map === null) counts.plain++;
        else if (map.kind === 'flat') addFlat(map);
        else addCube(map);
      }
    }
  }

  function fitShader(): void {
    if (counts.flat !== flat.length || counts.cube !== cube.length || counts.plain !== lights.plain) outdated = true;
    if (!outdated) return;
    outdated = false;
    lights.plain = counts.plain;
    for (const array of [flat, flatMaps, mapFromWorld, flatBias, flatReach]) array.length = counts.flat;
    for (const array of [cube, cubeMaps, cubeReach]) array.length = counts.cube;
    flatExtras.length = counts.extras;
    cubeTranslucent.length = counts.cubeTranslucent;
    setLightCount(lightUniforms, counts.flat + counts.cube + counts.plain);
    fragmentShader = catcherFragment(lights, undefined, glow !== null, strokes !== null);
    roomFragment = catcherFragment(lights, ROOM_SURFACE, glow !== null, strokes !== null);
    for (const [material, surface] of written) {
      material.fragmentShader = surface === 'room' ? roomFragment : fragmentShader;
      material.needsUpdate = true;
    }
  }

  return {
    createTwin: (master) => {
      const material = createCatcherMaterial(fragmentShader, uniforms, occlusion);
      written.set(material, 'geometry');
      const sync = (): void => followSides(material, master);
      sync();
      return {
        material,
        sync,
        dispose: () => {
          written.delete(material);
          material.dispose();
        },
      };
    },
    createRoomMaterial: (room) => {
      const material = createRoomMaterial(roomFragment, { ...uniforms, ...room });
      written.set(material, 'room');
      return material;
    },
    update: (_receivers, lightsNow) => {
      lightLists = lightsNow;
      uniforms.strength.value = strength.value;
      uniforms.shadowColor.value.fromArray(color.value);
      drawn?.update();
      if (!glow) return;
      uniforms.glowCount.value = glow.on ? glow.count : -1;
      uniforms.glowColor.value.fromArray(glow.color.value);
      uniforms.glowBorder.value = glow.border.value;
    },
    beforeDraw: () => {
      counts.flat = 0;
      counts.cube = 0;
      counts.plain = 0;
      counts.extras = 0;
      counts.cubeTranslucent = 0;
      counts.softened = 0;
      counts.undimmed = 0;
      counts.textures = countMaps();
      addLights('flat');
      addLights('cube');
      addLights(null);
      textureLimits.tell(counts.softened, counts.undimmed);
      fitShader();
    },
    dispose: () => {},
  };
}

/** Whether an object catches shadows. Phantoms and opaque objects do; through transparent materials, shadows reach the surfaces behind. */
export function catchesShadows(master: Drawable, item: ObjectItem): boolean {
  return item.role === 'phantom' || materialsOf(master).every(isOpaque);
}

/** Creates a material that draws a surface as a shadow. */
export function createCatcherMaterial(
  fragmentShader: string,
  uniforms: ShaderMaterial['uniforms'],
  occlusion: readonly ShaderPatch[],
): ShaderMaterial {
  const material = new ShaderMaterial({ name: 'shadow catcher', vertexShader: CATCHER_VERTEX, fragmentShader });
  material.uniforms = uniforms;
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  // Drawn after the depth of all phantoms, which is a little behind, so that each pixel belongs to the nearest phantom.
  material.transparent = true;
  material.depthFunc = LessDepth;
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  patchMaterial(material, null, occlusion);
  return material;
}

/** Copies the properties of the replaced material that decide which sides are visible. */
export function followSides(material: Material, master: Material): void {
  material.side = master.side;
  material.visible = master.visible;
}
