import { type Accessor, Document, NodeIO } from '@gltf-transform/core';
import { encode } from 'fast-png';
import { BoxGeometry, type BufferGeometry, ConeGeometry, CylinderGeometry, PlaneGeometry, SphereGeometry } from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { type ModelPart, writeModel } from '../play/write-model.ts';

/** An open page of the book, in meters: its width, height, and the margin around the window in it. */
export const PAGE = { widthM: 0.4, heightM: 0.54, marginM: 0.05 } as const;

/** A turning leaf: strips between hinges, the duration of a turn with the pause after it, the time at which the clip begins, and keyframes. */
const LEAF = { strips: 8, turnS: 3.2, cycleS: 4.5, startS: 1.25, keys: 60, liftM: 0.004 } as const;

/** How far the open book leans back from the vertical, and how far it turns to the visitor, in radians. */
export const LEAN = { backRad: 0.42, yawRad: 0.24 } as const;

/** The lectern on which it lies: the thickness of its board and how far that stands out, and the height of the middle of the book. */
export const LECTERN = { thickM: 0.025, rimM: 0.035, behindM: 0.03, middleM: 1.1 } as const;

/**
 * The paper of an open book that lies in the x–z plane, spine along z: two pages with a printed border around a hole, and one leaf like
 * them that turns from right to left, bending, in the clip `turn`.
 */
export const makePages = (): Promise<Uint8Array> => makeSheets('paper');

/** What fills the holes of the pages and of the leaf, which turns with it. */
export const makePanes = (): Promise<Uint8Array> => makeSheets('panes');

async function makeSheets(what: 'paper' | 'panes'): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const surface = doc.createMaterial(what).setRoughnessFactor(0.9).setMetallicFactor(0).setDoubleSided(true);
  if (what === 'paper') surface.setBaseColorTexture(doc.createTexture('print').setImage(drawPage()).setMimeType('image/png'));
  else surface.setBaseColorFactor([0.35, 0.35, 0.35, 1]);
  const accessor = (type: 'VEC3' | 'VEC2' | 'SCALAR', array: Float32Array | Uint16Array): Accessor =>
    doc.createAccessor().setType(type).setArray(array);
  const sheet = (name: string, geometry: BufferGeometry) => {
    const attribute = (key: string) => new Float32Array(geometry.getAttribute(key).array);
    const primitive = doc
      .createPrimitive()
      .setMaterial(surface)
      .setAttribute('POSITION', accessor('VEC3', attribute('position')))
      .setAttribute('NORMAL', accessor('VEC3', attribute('normal')))
      .setAttribute('TEXCOORD_0', accessor('VEC2', attribute('uv')))
      .setIndices(accessor('SCALAR', Uint16Array.from(geometry.getIndex()?.array ?? [])));
    return doc.createNode(name).setMesh(doc.createMesh(name).addPrimitive(primitive));
  };
  const root = doc.createNode('pages');
  const strips = what === 'paper' ? paperStrips : paneStrips;
  const frame = mergeGeometries(strips().map((strip, i) => strip.translate(((i + 0.5) / LEAF.strips - 0.5) * PAGE.widthM, 0, 0)));
  for (const side of [1, -1]) {
    const page = side > 0 ? frame : frame.clone().rotateY(Math.PI);
    root.addChild(sheet(side > 0 ? 'page.right' : 'page.left', page.clone().translate((side * PAGE.widthM) / 2, 0, 0)));
  }
  const width = PAGE.widthM / LEAF.strips;
  const hinges = strips().map((strip, i) =>
    sheet(`strip.${i}`, strip.translate(width / 2, 0, 0)).setTranslation(i === 0 ? [0, LEAF.liftM, 0] : [width, 0, 0]),
  );
  hinges.reduce((parent, hinge) => parent.addChild(hinge) && hinge, root);
  doc.createScene('scene').addChild(root);

  const clip = doc.createAnimation('turn');
  const times = Float32Array.from({ length: LEAF.keys + 1 }, (_, i) => (i / LEAF.keys) * LEAF.cycleS);
  const input = accessor('SCALAR', times);
  for (const [i, hinge] of hinges.entries()) {
    const values = [...times].flatMap((timeS) => {
      const angle = angleAt((timeS + LEAF.startS) % LEAF.cycleS, i);
      return [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];
    });
    const output = doc.createAccessor().setType('VEC4').setArray(new Float32Array(values));
    const sampler = doc.createAnimationSampler().setInput(input).setOutput(output).setInterpolation('LINEAR');
    clip.addSampler(sampler).addChannel(doc.createAnimationChannel().setTargetNode(hinge).setTargetPath('rotation').setSampler(sampler));
  }
  return new NodeIO().writeBinary(doc);
}

/** Angle of a hinge about z in radians: the first one turns the leaf, the others bend it against the air. */
function angleAt(timeS: number, hinge: number): number {
  const share = Math.min(timeS / LEAF.turnS, 1);
  const eased = share * share * (3 - 2 * share);
  if (hinge === 0) return 0.012 + (Math.PI - 0.024) * eased;
  return -0.3 * Math.sin(Math.PI * eased) * Math.cos(Math.PI * eased * 0.5 + 0.4) * (hinge < LEAF.strips / 2 ? 1 : 0.5);
}

/** The strips of a page from its spine outwards, each centered, facing +y: whole in the margins, else above and below the hole. */
function paperStrips(): BufferGeometry[] {
  const margin = PAGE.marginM / PAGE.heightM;
  return Array.from({ length: LEAF.strips }, (_, i) => {
    const [from, to] = [i / LEAF.strips, (i + 1) / LEAF.strips];
    const inMargin = i === 0 || i === LEAF.strips - 1;
    return inMargin ? plate(from, to, 0, 1) : mergeGeometries([plate(from, to, 0, margin), plate(from, to, 1 - margin, 1)]);
  });
}

/** The holes of the same strips; in a margin, a sliver without area in place of one. */
function paneStrips(): BufferGeometry[] {
  const margin = PAGE.marginM / PAGE.heightM;
  return Array.from({ length: LEAF.strips }, (_, i) => {
    const inMargin = i === 0 || i === LEAF.strips - 1;
    return plate(i / LEAF.strips, (i + (inMargin ? 0 : 1)) / LEAF.strips, margin, 1 - margin);
  });
}

/** A wooden lectern whose board is behind the book; its origin is the middle of the book, and it stands on the floor. */
export async function makeLectern(): Promise<Uint8Array> {
  const { thickM, rimM, behindM, middleM } = LECTERN;
  const [width, height] = [2 * (PAGE.widthM + rimM), PAGE.heightM + 2 * rimM];
  const lean = (geometry: BufferGeometry) => geometry.rotateX(Math.PI / 2 - LEAN.backRad).rotateY(LEAN.yawRad);
  const board = lean(new BoxGeometry(width, thickM, height).translate(0, -behindM - thickM / 2, 0));
  const ledge = lean(new BoxGeometry(width, 0.08, 0.02).translate(0, -0.02, height / 2));
  const post = new BoxGeometry(0.09, middleM - 0.06, 0.09).rotateY(LEAN.yawRad).translate(0, -0.03 - middleM / 2, -0.1);
  const foot = new BoxGeometry(0.5, 0.04, 0.4).rotateY(LEAN.yawRad).translate(0, 0.02 - middleM, -0.1);
  const wood = { name: 'wood', color: [0.1, 0.045, 0.022], roughness: 0.6 } as const;
  return writeModel([{ name: 'lectern', geometry: merged([board, ledge, post, foot]), paint: wood }]);
}

/** A part of a page between shares of its width and its height; the latter from the foot. */
function plate(left: number, right: number, foot: number, top: number): BufferGeometry {
  const geometry = new PlaneGeometry(PAGE.widthM * (right - left), PAGE.heightM * (top - foot)).rotateX(-Math.PI / 2);
  const uv = geometry.getAttribute('uv');
  for (let i = 0; i < uv.count; i++) uv.setXY(i, left + (right - left) * uv.getX(i), foot + (top - foot) * uv.getY(i));
  return geometry.translate(0, 0, (0.5 - (foot + top) / 2) * PAGE.heightM);
}

/** Paper with a border of two lines, and a row of dots between them, as PNG. */
function drawPage(): Uint8Array {
  const [width, height] = [400, 540];
  const data = new Uint8Array(width * height * 3);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const inM = Math.min(x, y, width - 1 - x, height - 1 - y);
      const along = inM === x || inM === width - 1 - x ? y : x;
      const isLine = Math.abs(inM - 12) < 1.5 || Math.abs(inM - 44) < 2.5;
      const isDot = Math.hypot(inM - 28, (along % 20) - 10) < 4.2;
      data.set(isLine ? [118, 84, 52] : isDot ? [168, 62, 44] : [243, 236, 220], (y * width + x) * 3);
    }
  }
  return encode({ width, height, data, channels: 3, depth: 8 });
}

/** Radius of the meadow and of the sky in meters. */
const MEADOW_M = 9;

/** A valley at night with trees and a house with lit windows, around the origin; the book stands there and one looks along -z. */
export async function makeValley(): Promise<Uint8Array> {
  const meadow = new PlaneGeometry(2 * MEADOW_M, 2 * MEADOW_M, 56, 56).rotateX(-Math.PI / 2);
  const at = meadow.getAttribute('position');
  for (let i = 0; i < at.count; i++) at.setY(i, heightAt(at.getX(i), at.getZ(i)));
  meadow.computeVertexNormals();
  const trees = Array.from({ length: 46 }, (_, i) => {
    const turn = i * 2.399963;
    const away = 2 + 0.11 * i;
    return [Math.sin(turn) * away * 1.15, -Math.cos(turn) * away, 0.5 + 0.35 * Math.abs(Math.sin(i * 12.9))] as const;
  }).filter(([x, z]) => z < 0 && Math.hypot(x - HOUSE.x, z - HOUSE.z) > 0.9 && !(z > -3.4 && Math.abs(x) < 0.8));
  const onGround = (geometry: BufferGeometry, x: number, z: number, y = 0) => geometry.translate(x, heightAt(x, z) + y, z);
  const crowns = trees.flatMap(([x, z, size]) =>
    [0, 1, 2].map((k) => onGround(new ConeGeometry(size * (0.36 - 0.08 * k), size * 0.6, 14), x, z, size * (0.5 + 0.32 * k))),
  );
  const trunks = trees.map(([x, z, size]) => onGround(new CylinderGeometry(size * 0.06, size * 0.08, size * 0.4, 8), x, z, size * 0.12));
  const { x, z } = HOUSE;
  const panes = [-0.17, 0.17].flatMap((dx) => [onGround(new BoxGeometry(0.14, 0.16, 0.02), x + dx, z + 0.26, 0.3)]);
  const parts: ModelPart[] = [
    { name: 'meadow', geometry: meadow, paint: { name: 'meadow', color: [0.16, 0.3, 0.16], roughness: 1 } },
    { name: 'crowns', geometry: merged(crowns), paint: { name: 'crowns', color: [0.05, 0.17, 0.14], roughness: 1 } },
    { name: 'trunks', geometry: merged(trunks), paint: { name: 'trunks', color: [0.16, 0.1, 0.07], roughness: 1 } },
    {
      name: 'walls',
      geometry: onGround(new BoxGeometry(0.75, 0.5, 0.5), x, z, 0.22),
      paint: { name: 'walls', color: [0.6, 0.5, 0.42], roughness: 1 },
    },
    {
      name: 'roof',
      geometry: onGround(new ConeGeometry(0.62, 0.42, 4).rotateY(Math.PI / 4).scale(1, 1, 0.78), x, z, 0.68),
      paint: { name: 'roof', color: [0.42, 0.12, 0.09], roughness: 1 },
    },
    { name: 'panes', geometry: merged(panes), paint: { name: 'panes', color: [1, 0.75, 0.3], roughness: 1, glow: [1, 0.62, 0.2] } },
  ];
  return writeModel(parts);
}

const HOUSE = { x: 0.72, z: -3.4 } as const;

/** The sky of the valley: a dome that is seen from inside, with a moon. */
export async function makeNight(): Promise<Uint8Array> {
  const dome = new SphereGeometry(MEADOW_M * 1.35, 40, 24).scale(-1, 1, 1);
  const moon = new SphereGeometry(0.5, 32, 20).translate(-0.9, 2.9, -8.6);
  return writeModel([
    { name: 'dome', geometry: dome, paint: { name: 'night', color: [0, 0, 0], roughness: 1, glow: [0.022, 0.045, 0.13] } },
    { name: 'moon', geometry: moon, paint: { name: 'moon', color: [0, 0, 0], roughness: 1, glow: [0.95, 0.93, 0.78] } },
  ]);
}

/** Height of the meadow: level around the book and before it, hills behind. */
function heightAt(x: number, z: number): number {
  const away = Math.min(Math.max((Math.hypot(x, z + 0.8) - 1.9) / 5, 0), 1);
  const rise = away * away * (3 - 2 * away) * Math.min(Math.max(0.2 - z, 0), 1);
  return rise * (0.62 + 0.42 * Math.sin(x * 0.8 + 0.6) * Math.cos(z * 0.6) + 0.2 * Math.sin(z * 1.5 + x * 0.9));
}

function merged(geometries: readonly BufferGeometry[]): BufferGeometry {
  for (const geometry of geometries) geometry.deleteAttribute('uv');
  return mergeGeometries([...geometries]);
}
