import {
  BackSide,
  BoxGeometry,
  CubeCamera,
  type CubeTexture,
  HalfFloatType,
  LinearMipmapLinearFilter,
  LinearSRGBColorSpace,
  Mesh,
  NoBlending,
  type PerspectiveCamera,
  ShaderMaterial,
  type Texture,
  WebGLCubeRenderTarget,
  type WebGLRenderer,
} from 'three';

/**
 * A cube map in the layout that three.js' materials read: one level per roughness, from a mirror to roughness 1, which is used for
 * irradiance too (`PMREMGenerator.fromScene`, r187).
 */
export interface PmremTarget {
  readonly texture: Texture;
  /** Draws all levels from `fromLevel` on. `materialFor` returns a material of `createCubeMaterial` for a roughness. */
  draw(three: WebGLRenderer, materialFor: (roughness: number, level: number) => ShaderMaterial, fromLevel?: number): void;
  /** Draws some rows of a face of one level. */
  drawRows(three: WebGLRenderer, material: ShaderMaterial, rows: CubeRows): void;
  /** The levels, from the sharpest on. */
  readonly levels: readonly { readonly facePx: number; readonly roughness: number }[];
  dispose(): void;
}

/** Rows of a face of a cube map, from its first row on. */
export interface CubeRows {
  readonly level: number;
  readonly face: number;
  readonly firstRow: number;
  readonly rows: number;
}

/** Creates a cube map whose levels halve from `facePx` to `roughestFacePx`, both powers of two. */
export function createPmremTarget(facePx: number, roughestFacePx: number): PmremTarget {
  const target = createCubeTarget(facePx, false);
  const sizes: number[] = [];
  for (let size = facePx; size >= roughestFacePx; size /= 2) sizes.push(size);
  // three.js reads only the sizes of a target's levels.
  target.texture.mipmaps = sizes.map((size) => ({ width: size, height: size })) as unknown as CubeTexture[];
  target.texture.isPMREMTexture = true;
  const box = new Mesh(new BoxGeometry(2, 2, 2));
  const camera = new CubeCamera(0.1, 10, target);
  return {
    texture: target.texture,
    levels: sizes.map((size, level) => ({ facePx: size, roughness: roughnessOf(level, sizes.length - 1) })),
    drawRows: (three, material, { level, face, firstRow, rows }) => {
      const size = sizes[level] ?? facePx;
      box.material = material;
      target.viewport.set(0, 0, size, size);
      target.scissor.set(0, firstRow, size, rows);
      target.scissorTest = true;
      three.setRenderTarget(target, face, level);
      three.render(box, faceCamera(three, camera, face));
      target.scissorTest = false;
      target.viewport.set(0, 0, facePx, facePx);
    },
    draw: (three, materialFor, fromLevel = 0) => {
      for (let level = fromLevel; level < sizes.length; level++) {
        const size = sizes[level] ?? facePx;
        box.material = materialFor(roughnessOf(level, sizes.length - 1), level);
        target.viewport.set(0, 0, size, size);
        camera.activeMipmapLevel = level;
        camera.update(three, box);
      }
      target.viewport.set(0, 0, facePx, facePx);
    },
    dispose: () => {
      box.geometry.dispose();
      target.dispose();
    },
  };
}

/** The camera of one face. `CubeCamera.update` sets up the cameras, but draws all faces. */
export function faceCamera(three: WebGLRenderer, cube: CubeCamera, face: number): PerspectiveCamera {
  if (cube.coordinateSystem !== three.coordinateSystem) {
    cube.coordinateSystem = three.coordinateSystem;
    cube.updateCoordinateSystem();
    cube.updateMatrixWorld();
  }
  return cube.children[face] as PerspectiveCamera;
}

/** The roughness of a level, as in `PMREMGenerator.lodToRoughness`, which is not in the published types. */
function roughnessOf(level: number, lastLevel: number): number {
  return 1 - Math.sqrt(1 - level / lastLevel);
}

export function createCubeTarget(facePx: number, generateMipmaps: boolean): WebGLCubeRenderTarget {
  return new WebGLCubeRenderTarget(facePx, {
    type: HalfFloatType,
    colorSpace: LinearSRGBColorSpace,
    minFilter: LinearMipmapLinearFilter,
    generateMipmaps,
    depthBuffer: false,
  });
}

/** Creates a material that draws cube maps; `vDirection` is the direction of the fragment. */
export function createCubeMaterial(name: string, fragmentShader: string, uniforms: ShaderMaterial['uniforms']): ShaderMaterial {
  return new ShaderMaterial({
    name,
    vertexShader: VERTEX,
    fragmentShader,
    uniforms,
    side: BackSide,
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });
}

const VERTEX = /* glsl */ `
varying vec3 vDirection;

void main() {
  vDirection = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;
