/** The used part of `File`. */
interface FaceFile {
  readonly name: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** Words for the six faces in the order of a strip: right, left, top, bottom, front, back. */
const WORDS: readonly (readonly string[])[] = [
  ['px', 'nx', 'py', 'ny', 'pz', 'nz'],
  ['posx', 'negx', 'posy', 'negy', 'posz', 'negz'],
  ['right', 'left', 'top', 'bottom', 'front', 'back'],
  ['right', 'left', 'up', 'down', 'front', 'back'],
  ['rt', 'lf', 'up', 'dn', 'ft', 'bk'],
];
const PICTURES = /\.(png|jpe?g|webp|avif)$/i;
const RADIANCE = /\.(hdr|exr)$/i;
/** Maximum side of a face in pixels. A strip of larger faces would be wider than most graphics cards allow. */
const MOST_FACE_PX = 1024;

/** Files of the six faces of a cube, in the order of a strip. */
export type Faces = readonly FaceFile[];

/**
 * Separates the six faces of a cube, found by names such as `px.png` or `sky_left.jpg`, from the other files. `faces` is null if there are
 * no six.
 */
export function splitFaces(files: readonly FaceFile[]): { readonly faces: Faces | null; readonly rest: readonly FaceFile[] } {
  const pictures = files.filter(({ name }) => PICTURES.test(name) || RADIANCE.test(name));
  for (const words of WORDS) {
    const found = words.map((word) => pictures.filter(({ name }) => isNamed(name, word)));
    if (found.some((matches) => matches.length !== 1)) continue;
    const faces = found.flat();
    // The faces of one cube have one name but for the face.
    const stems = new Set(faces.map(({ name }, i) => stemOf(name).slice(0, -(words[i] ?? '').length)));
    if (stems.size === 1) return { faces, rest: files.filter((file) => !faces.includes(file)) };
  }
  return { faces: null, rest: files };
}

function stemOf(name: string): string {
  return name.replace(/\.[^.]*$/, '').toLowerCase();
}

function isNamed(name: string, word: string): boolean {
  const stem = stemOf(name);
  return stem === word || (stem.endsWith(word) && /[^a-z]$/.test(stem.slice(0, -word.length)));
}

/**
 * Draws six faces side by side, as one file that the runtime reads as a panorama.
 *
 * @throws Error whose message is text for the user.
 */
export async function joinFaces(faces: Faces): Promise<FaceFile> {
  if (faces.some(({ name }) => RADIANCE.test(name))) {
    throw new Error(
      'Faces in HDR or EXR files cannot be joined here. Join them in an image editor to a cross (4 × 3 faces) or a strip (6 × 1 faces), then import that file.',
    );
  }
  const pictures = await Promise.all(faces.map(decode));
  try {
    const side = pictures[0]?.width ?? 0;
    const odd = pictures.findIndex(({ width, height }) => width !== side || height !== side);
    const wrong = pictures[odd];
    if (wrong) {
      throw new Error(
        `${faces[odd]?.name} has ${wrong.width} × ${wrong.height} pixels. The six faces of a cube have to be squares of one size. Export them again.`,
      );
    }
    const facePx = Math.min(side, MOST_FACE_PX);
    const canvas = new OffscreenCanvas(facePx * 6, facePx);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('The browser has no memory for the faces. Close other windows, then try again.');
    context.imageSmoothingQuality = 'high';
    for (const [i, picture] of pictures.entries()) context.drawImage(picture, i * facePx, 0, facePx, facePx);
    const strip = await canvas.convertToBlob({ type: 'image/png' });
    return { name: 'cube-faces.png', arrayBuffer: () => strip.arrayBuffer() };
  } finally {
    for (const picture of pictures) picture.close();
  }
}

async function decode(file: FaceFile): Promise<ImageBitmap> {
  const bytes = await file.arrayBuffer();
  return createImageBitmap(new Blob([bytes]), { colorSpaceConversion: 'none' }).catch(() => {
    throw new Error(`${file.name} is no image that can be read. Export it again as PNG or JPEG.`);
  });
}
