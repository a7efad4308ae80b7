import { BufferAttribute, BufferGeometry, ExtrudeGeometry, ShapePath } from 'three';
import type { Glyph, Glyphs } from '../../kit/glyphs.ts';

/** Number of straight segments per curve of an outline: enough to be invisible on a letter that fills a phone's screen. */
const CURVE_SEGMENTS = 4;

/** The geometry of a letter: its origin is on the baseline, a capital letter is one unit high, and it is extruded from z = 0 to z = 1. */
export interface Letter {
  /** Distance to the origin of the next letter. */
  readonly advance: number;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
}

/**
 * Creates a function that returns the letter of a character; null if the font has none. Each letter is built once, when it is first used.
 */
export function createLetters(glyphs: Glyphs): (character: string) => Letter | null {
  const made = new Map<string, Letter>();
  return (character) => {
    const known = made.get(character);
    const glyph = glyphs.byCharacter.get(character);
    if (known || !glyph) return known ?? null;
    const letter = extrude(glyph, 1 / glyphs.capitalHeight);
    made.set(character, letter);
    return letter;
  };
}

/** A letter and the position of its origin. */
export interface PlacedLetter {
  readonly letter: Letter;
  readonly x: number;
  readonly y: number;
}

/** Merges the geometries of all letters into one; the caller disposes it. */
export function mergeLetters(placed: readonly PlacedLetter[]): BufferGeometry {
  const count = placed.reduce((sum, { letter }) => sum + letter.positions.length, 0);
  const positions = new Float32Array(count);
  const normals = new Float32Array(count);
  let at = 0;
  for (const { letter, x, y } of placed) {
    positions.set(letter.positions, at);
    normals.set(letter.normals, at);
    for (const end = at + letter.positions.length; at < end; at += 3) {
      positions[at] = (positions[at] ?? 0) + x;
      positions[at + 1] = (positions[at + 1] ?? 0) + y;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  return geometry;
}

function extrude({ advance, path }: Glyph, scale: number): Letter {
  const shapes = readPath(path, scale).toShapes();
  if (shapes.length === 0) return { advance: advance * scale, positions: new Float32Array(), normals: new Float32Array() };
  const geometry = new ExtrudeGeometry(shapes, { depth: 1, bevelEnabled: false, curveSegments: CURVE_SEGMENTS });
  const positions = geometry.getAttribute('position').array as Float32Array;
  const normals = geometry.getAttribute('normal').array as Float32Array;
  geometry.dispose();
  return { advance: advance * scale, positions, normals };
}

/** Converts SVG path data to a path. `toShapes` decides later which contours are holes. */
function readPath(path: string, scale: number): ShapePath {
  const shape = new ShapePath();
  for (const [, command, numbers = ''] of path.matchAll(/([A-Z])([^A-Z]*)/g)) {
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = numbers.split(' ').map((number) => Number(number) * scale);
    switch (command) {
      case 'M':
        shape.moveTo(a, b);
        break;
      case 'L':
        shape.lineTo(a, b);
        break;
      case 'Q':
        shape.quadraticCurveTo(a, b, c, d);
        break;
      case 'C':
        shape.bezierCurveTo(a, b, c, d, e, f);
        break;
    }
  }
  return shape;
}
