/** Properties of images that hosts provide as uniforms: `_inputImage_imgSize`. */
const PROPERTY = /^_(\w+)_(imgRect|imgSize|flip)$/;

export interface ImageProperty {
  readonly image: string;
  /** `imgRect`: origin and size of the used part, normalized; always all of it. `flip`: whether the image is upside down; always false. */
  readonly property: 'imgRect' | 'imgSize' | 'flip';
}

export const IMAGE_PROPERTY_TYPES = { imgRect: 'vec4', imgSize: 'vec2', flip: 'bool' } as const;

export function imageProperty(name: string): ImageProperty | null {
  const [, image, property] = PROPERTY.exec(name) ?? [];
  return image === undefined ? null : { image, property: property as ImageProperty['property'] };
}
